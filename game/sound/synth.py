"""Sounds worked out from what makes them: a push of some length, and what rings and radiates.

A sound is a push convolved with a response. The push between two balls is Hertz's, shorter the
harder they meet, so hard clicks are brighter. A ball radiates as a sphere jerked aside: a damped
wave at c/a, about 1.8 kHz for a carom ball (Koss & Alfredson, J. Sound Vib. 27, 1973). Its own
lowest mode lies near 14.5 kHz, hardly heard, so what else rings is table, rail and cue.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

Wave = npt.NDArray[np.float64]

RATE = 44_100
"""Samples a second."""
SPEEDS = tuple(0.05 * 2**k for k in range(8))
"""Closing speeds of the eight clicks, m/s: each twice the one before."""
TRAVEL = 0.031 / 343.0
"""Seconds that sound needs from a ball's centre to its edge."""
APART = 1.3e-4
"""Seconds between the two balls' waves, heard from 45 degrees beside their line: 2 a cos(45°)/c."""
FADE = 0.006
"""Seconds over which a sound is led to zero at its end."""


@dataclass(frozen=True, slots=True)
class Timbre:
    """What answers a push.

    contact  seconds a push takes at 1 m/s
    shape    power of the half sine that it follows
    modes    (Hz, strength, seconds to fall to 1/e) of what rings
    air      strength of the ball's own wave
    room     strength of the room's answer and where it is cut off, Hz
    length   s
    """

    contact: float
    shape: float
    modes: tuple[tuple[float, float, float], ...]
    air: float
    room: tuple[float, float]
    length: float


CLICK = Timbre(
    # 2.87 (m²/R E² v)^(1/5) for two phenolic balls of 0.21 kg, 61.5 mm and E = 5.8 GPa
    contact=4.2e-4,
    shape=1.5,
    modes=((14_500, 0.5, 0.0006), (1_150, 0.014, 0.005), (480, 0.005, 0.012), (215, 0.003, 0.025)),
    air=1.0,
    room=(0.05, 6_000),
    length=0.14,
)
THUD = Timbre(
    contact=1.3e-3,
    shape=2.0,
    modes=((112, 0.45, 0.040), (184, 0.8, 0.030), (317, 0.9, 0.018), (590, 1.0, 0.010)),
    air=0.8,
    room=(0.10, 1_400),
    length=0.20,
)
STROKE = Timbre(
    contact=1.1e-3,
    shape=2.0,
    modes=((248, 0.12, 0.018), (640, 0.30, 0.010), (1_750, 0.60, 0.004)),
    air=1.5,
    room=(0.05, 2_500),
    length=0.12,
)
JAW = Timbre(
    # the end of a cushion: thinner rubber, and wood right behind it
    contact=8e-4,
    shape=2.0,
    modes=((184, 0.3, 0.024), (317, 0.6, 0.014), (640, 1.0, 0.008), (1_150, 0.5, 0.004)),
    air=0.9,
    room=(0.10, 2_000),
    length=0.16,
)
DROP = Timbre(
    # leather gives way slowly, and the cabinet below answers
    contact=3.0e-3,
    shape=2.0,
    modes=((74, 0.9, 0.045), (118, 1.0, 0.034), (196, 0.7, 0.020), (342, 0.4, 0.010)),
    air=0.3,
    room=(0.14, 800),
    length=0.26,
)
BODIES = {"click": CLICK, "thud": THUD, "stroke": STROKE, "jaw": JAW, "drop": DROP}
CHAIN = 12
"""Clicks of a "chain": what a pack of balls sounds like that a ball runs into."""
RATTLE = 0.030
"""Seconds over which they are spread, the first ones louder and closer together."""


def push(seconds: float, shape: float) -> Wave:
    """Return a push of that length, of area 1: a half sine to the power `shape`."""
    n = max(3, round(seconds * RATE))
    wave = np.sin(np.pi * (np.arange(n) + 0.5) / n) ** shape
    return np.asarray(wave / wave.sum())


@cache
def response(body: Timbre) -> Wave:
    """Return what is heard of a push that takes no time."""
    t = np.arange(round(body.length * RATE)) / RATE
    heard = body.air * _air(t)
    for hertz, strength, decay in body.modes:
        heard += strength * np.exp(-t / decay) * np.sin(2 * np.pi * hertz * t)
    strength, cut = body.room
    return np.asarray(heard + strength * _hiss(t.size, cut) * _room(t, body.length))


def _air(t: Wave) -> Wave:
    """The far wave of one sphere jerked aside, less that of the other one, which moves against it.

    A sphere of radius a answers with s / (s² + 2 s + 2), s in units of c/a.
    """

    def one(t: Wave) -> Wave:
        s = np.clip(t, 0.0, None) / TRAVEL
        return np.where(t < 0.0, 0.0, np.exp(-s) * (np.cos(s) - np.sin(s)))

    return np.asarray(one(t) - 0.8 * one(t - APART))


def _room(t: Wave, length: float) -> Wave:
    """How loud the room is: bed and rails answer at once, walls 16 dB down; -60 dB at the end."""
    near = np.exp(-t / 0.007) + 0.15 * np.exp(-6.9 * t / length)
    return np.asarray(near * np.clip(t / 0.0015, 0.0, 1.0))


def _hiss(n: int, cut: float) -> Wave:
    """Noise of spread 1 that repeats itself after n samples, above 90 Hz and below `cut`."""
    hertz = np.fft.rfftfreq(n, 1 / RATE)
    # a hash for phases: numpy.random would cost 40 ms to import
    phase = 2 * np.pi * np.modf(np.sin(12.9898 * np.arange(1, hertz.size + 1)) * 43758.5453)[0]
    size = (hertz / (hertz + 90.0)) ** 2 / (1.0 + (hertz / cut) ** 4)
    noise = np.fft.irfft(size * np.exp(1j * phase), n)
    return np.asarray(noise / noise.std())


def sound(kind: str, speed: float) -> Wave:
    """Return one of BODIES or a "chain" at a closing speed, m/s: peak 1, from and to silence."""
    if kind == "chain":
        return _chain(speed)
    body = BODIES[kind]
    # a Hertzian push is shorter by the fifth root of the speed
    wave = np.convolve(push(body.contact * speed**-0.2, body.shape), response(body))
    wave = wave[: round(body.length * RATE)]
    wave -= wave.mean()
    n = round(FADE * RATE)
    wave[-n:] *= np.linspace(1.0, 0.0, n)
    return np.asarray(wave / np.abs(wave).max())


def _chain(speed: float) -> Wave:
    """Many clicks in a row, each softer than the one before and at a place of its own."""
    click = sound("click", speed)
    wave = np.zeros(click.size + round(RATTLE * RATE) + 1)
    for k in range(CHAIN):
        late = np.modf(np.sin(12.9898 * (k + 1)) * 43758.5453)[0]
        start = round(RATTLE * RATE * ((k + 0.4 * late) / CHAIN) ** 1.5) if k else 0
        wave[start : start + click.size] += click * (1.0 - 0.8 * k / CHAIN)
    return np.asarray(wave / np.abs(wave).max())


def rumble(seconds: float = 1.0) -> Wave:
    """Return the noise of a ball rolling on cloth, peak 1: its end runs on into its beginning."""
    wave = _hiss(round(seconds * RATE), 420.0)
    return np.asarray(wave / np.abs(wave).max())


def loudness(speed: float, speeds: Sequence[float] = SPEEDS) -> int:
    """Return which of `speeds` is nearest to a closing speed by its ratio."""
    if speed <= speeds[0]:
        return 0
    return min(len(speeds) - 1, round(float(np.log2(speed / speeds[0]))))
