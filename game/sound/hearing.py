"""What is to be heard of a frame: the loudest few of its events, and how the balls roll."""

from __future__ import annotations

from bisect import bisect_right
from math import hypot, sqrt
from typing import NamedTuple

from physics import Ball, Event, World

from .synth import loudness

LOUDEST = 4
"""Sounds that begin in one frame: more are one noise."""
LOOKED_AT = 8
"""Events of one frame that are looked at, at some 15 µs each."""
JUMP = 1.0
"""Seconds of a shot in one frame that are a leap over it, which is silent."""
FULL = {"click": 1.2, "thud": 1.6, "stroke": 1.6, "jaw": 1.6, "drop": 6.0, "chain": 1.2}
"""Impulses that are as loud as it gets, N s: a full hit, a cushion and a stroke at 6 to 8 m/s. Of
a ball that drops, its speed, m/s."""
FALLS = 1.2
"""Speed with which a ball that hardly moves arrives in a pocket, m/s."""
JAWS = ("facing", "nose")
"""How the names of walls end that are the ends of cushions, at pockets."""
LOUDNESS = 0.6
"""Power of the impulse that the gain follows, so that a touch is heard beside a break."""
FAINTEST = 0.03
ROLLING = 0.10
"""Gain of balls that roll with ROLLS_FULL m/s together."""
ROLLS_FULL = 8.0


class Sound(NamedTuple):
    """A sound to begin: a kind of `synth`, level in the bank, gain 0..1, pan -1..1."""

    kind: str
    loudness: int
    gain: float
    pan: float


class Heard(NamedTuple):
    """A frame: the sounds that begin, loudest first, and how loud the rolling is, 0..1."""

    sounds: tuple[Sound, ...]
    rolling: float


SILENCE = Heard((), 0.0)


class Ear:
    """Follows the moment on show, of a shot played or looked at again; says what is new."""

    def __init__(self, half: float) -> None:
        self.half = half
        """Half the table's length, m: where a sound is fully left or right."""
        self._shot: object = None
        self._time, self._seen = 0.0, 0

    def listen(
        self,
        world: World,
        shot: object,
        struck: tuple[Ball, float] | None = None,
        now: float | None = None,
    ) -> Heard:
        """Return what is to be heard since the last time.

        `shot` is equal while the same shot runs; `struck`: the ball that the cue has met since the
        last time, and the speed it got, m/s; `now`: the world time on show, s, if that is in the
        past. A way back, and a leap of more than JUMP seconds, are silent.
        """
        time, log = world.time if now is None else now, world.log
        passed, first = time - self._time, 0 if shot != self._shot else self._seen
        if passed == 0.0 and struck is None:
            return SILENCE
        count = len(log) if now is None else bisect_right(log, time, key=lambda e: e.time)
        self._shot, self._time, self._seen = shot, time, count
        if not 0.0 <= passed <= JUMP:
            return SILENCE
        found = [_of_event(e, self.half) for e in log[first : min(count, first + LOOKED_AT)]]
        if struck is not None:
            found.append(_stroke(*struck, self.half))
        heard = sorted((s for s in found if s and s.gain >= FAINTEST), key=lambda s: -s.gain)
        missed = max(0, count - first - LOOKED_AT)
        return Heard(tuple(_few(heard, missed)), _rolling(world, now))


def _few(heard: list[Sound], missed: int) -> list[Sound]:
    """The loudest of a frame's sounds, loudest first; hits of balls beyond these become a chain.

    missed: how many more events there were; they count as the softest of those that were heard.
    """
    if len(heard) <= LOUDEST:
        return heard
    few, rest = heard[: LOUDEST - 1], [s for s in heard[LOUDEST - 1 :] if s.kind == "click"]
    if len(rest) < 2:
        return heard[:LOUDEST]
    soft = rest[-1].gain
    together = sqrt(sum(s.gain**2 for s in rest) + missed * soft * soft)
    pan = sum(s.pan for s in rest) / len(rest)
    chain = Sound("chain", max(s.loudness for s in rest), min(1.0, together), pan)
    return sorted([*few, chain], key=lambda s: -s.gain)


def _stroke(ball: Ball, speed: float, half: float) -> Sound:
    return _sound("stroke", speed, ball.mass * speed, ball.position[0], half)


def _of_event(event: Event, half: float) -> Sound | None:
    if event.kind == "ball":
        return _sound("click", event.closing, event.impulse, event.point[0], half)
    if event.kind == "cushion":
        kind = "jaw" if (event.wall or "").endswith(JAWS) else "thud"
        return _sound(kind, event.closing, event.impulse, event.point[0], half)
    if event.kind == "pocket":
        speed = hypot(FALLS, *event.before[0].velocity)
        return _sound("drop", speed, speed, event.point[0], half)
    return None


def _sound(kind: str, speed: float, impulse: float, x: float, half: float) -> Sound:
    gain = min(1.0, abs(impulse) / FULL[kind]) ** LOUDNESS
    return Sound(kind, loudness(abs(speed)), gain, max(-1.0, min(1.0, x / half)))


def _rolling(world: World, now: float | None) -> float:
    balls = world.balls if now is None else world.log.at(now).values()
    speed = sum(hypot(*ball.velocity) for ball in balls)
    return ROLLING * min(1.0, speed / ROLLS_FULL)
