"""The loudspeaker: plays what the ear has heard, and is silent where there is none.

The mixer opens with the first sound, and closes when it is muted or nothing has been heard for a
while: its thread costs as much as the rest of an idle game. Where opening fails, or SDL loses the
device, all that follows is silence, and nothing is said about it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from math import cos, pi, sin

import numpy as np
import pygame

from . import synth
from .hearing import Heard

BUFFER = 512
"""Samples in the mixer's buffer: 12 ms, less than a frame."""
VOICES = 16
HEADROOM = 0.7
"""Peak of a sound at full gain; in the middle it is 0.5 on either side, so that two fit."""
MOST = 2.0
"""Gains of the sounds of a frame together: more are scaled down, so that nothing clips."""
SIDES = 0.7
"""How far to the side a sound at the end of the table is: 1 would leave the other ear nothing."""
STEP = 0.01
"""Least change of the rolling's gain that is passed on."""
FADE = 80
"""Milliseconds in which the rolling dies away."""
PATIENCE = 60_000
"""Milliseconds without a sound after which the mixer closes."""
Bank = dict[tuple[str, int], pygame.mixer.Sound]


class Audio:
    """A loudspeaker with a volume (0..1) and a mute switch."""

    def __init__(self, volume: float = 0.8, muted: bool = False) -> None:
        self.volume, self.muted = volume, muted
        self.broken = False
        self._bank: Bank = {}
        self._rolling: pygame.mixer.Channel | None = None
        self._rolls = 0.0
        self._heard = 0
        """When something was heard last, milliseconds."""

    @property
    def silent(self) -> bool:
        """Will nothing be heard whatever is played?"""
        return self.muted or self.broken or self.volume <= 0.0

    def play(self, heard: Heard, now: int) -> None:
        """Begin the sounds of a frame at `now`, milliseconds; the first one opens the mixer."""
        if heard.sounds or heard.rolling:
            self._heard = now
        if self.silent or now - self._heard > PATIENCE:
            self.close()
            return
        if not (heard.sounds or self._bank) or not self._open():
            return
        try:
            share = self._gain() * min(1.0, MOST / max(sum(s.gain for s in heard.sounds), 1e-9))
            for kind, loudness, gain, pan in heard.sounds:
                channel = pygame.mixer.find_channel()
                if channel is not None:
                    channel.play(self._bank[kind, loudness])
                    channel.set_volume(*sides(gain * share, pan))
            self._roll(heard.rolling)
        except pygame.error:
            self.broken = True

    def close(self) -> None:
        """Give the device back."""
        if self._bank:
            self._bank, self._rolling, self._rolls = {}, None, 0.0
            pygame.mixer.quit()

    def _gain(self) -> float:
        """Ears count in ratios: half way along the slider is a quarter of the pressure."""
        return self.volume**2

    def _open(self) -> bool:
        if self._bank:
            return True
        try:
            with _quiet():
                pygame.mixer.init(synth.RATE, -16, 2, BUFFER, allowedchanges=0)
            pygame.mixer.set_num_channels(VOICES)
            pygame.mixer.set_reserved(1)
            self._rolling = pygame.mixer.Channel(0)
            self._bank = {key: pygame.mixer.Sound(buffer=data) for key, data in _samples().items()}
        except (pygame.error, NotImplementedError, ImportError):
            self.broken = True  # no device, or a pygame built without the mixer
        return not self.broken

    def _roll(self, gain: float) -> None:
        small = abs(gain - self._rolls) < STEP and bool(gain) == bool(self._rolls)
        if self._rolling is None or small:
            return
        if not gain:
            self._rolling.fadeout(FADE)
        elif not self._rolls:
            self._rolling.play(self._bank["rumble", 0], loops=-1)
        if gain:
            self._rolling.set_volume(gain * self._gain())
        self._rolls = gain


def bank() -> Iterator[tuple[tuple[str, int], synth.Wave]]:
    """Work out every sound: (kind, level) and its wave, peak 1."""
    for number, speed in enumerate(synth.SPEEDS):
        for kind in (*synth.BODIES, "chain"):
            yield (kind, number), synth.sound(kind, speed)
    yield ("rumble", 0), synth.rumble()


def sides(gain: float, pan: float) -> tuple[float, float]:
    """Return the gains of the left and the right side: equal power wherever the sound is."""
    angle = (1.0 + SIDES * pan) * pi / 4
    return gain * cos(angle), gain * sin(angle)


@cache
def _samples() -> dict[tuple[str, int], bytes]:
    """Every sound as the mixer takes it: 16 bit, left and right."""
    waves = ((key, np.round(wave * HEADROOM * 32767).astype(np.int16)) for key, wave in bank())
    return {key: np.repeat(wave, 2).tobytes() for key, wave in waves}


@contextmanager
def _quiet() -> Iterator[None]:
    """Keep what the system's sound library has to say about missing devices off the terminal."""
    kept = os.dup(2)
    try:
        with open(os.devnull, "wb") as nowhere:
            os.dup2(nowhere.fileno(), 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
