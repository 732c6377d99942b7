"""Game time in ticks of 2^-16 s: they add up exactly, so the frame rate leaves no trace."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import pygame

TICKS = 1 << 16
"""Ticks in a second."""
LONGEST = TICKS // 10
"""A frame that took longer counts as this: after a hitch the game is late, but does not race."""
AWAKE = 60
"""Frames at full rate after the last change, before the loop slows down."""
IDLE_FPS = 20


def seconds(ticks: int) -> float:
    """Return ticks in seconds; exact."""
    return ticks / TICKS


def shares(ticks: int, parts: int) -> Iterator[int]:
    """Split `ticks` into at most `parts` whole numbers above zero that differ by one at most."""
    edges = [ticks * i // parts for i in range(parts + 1)]
    return (b - a for a, b in pairwise(edges) if b > a)


class RealClock:
    """Frames as the screen has time for: it sleeps, and more when nothing happens."""

    def __init__(self, fps: int) -> None:
        self.fps = fps
        self._clock = pygame.time.Clock()
        self._left = 0.0
        self._quiet = 0

    def frame(self, busy: bool) -> int:
        """Wait for the next frame; return the ticks since the last one, at most LONGEST."""
        self._quiet = 0 if busy else self._quiet + 1
        rate = self.fps if self._quiet <= AWAKE else min(self.fps, IDLE_FPS)
        exact = self._clock.tick(rate) * TICKS / 1000 + self._left
        ticks = int(exact)
        self._left = exact - ticks
        return min(ticks, LONGEST)


class VirtualClock:
    """Frames without waiting, each exactly one `fps`-th of a second in the long run."""

    def __init__(self, fps: int) -> None:
        self.fps = fps
        self._frames = 0

    def frame(self, busy: bool) -> int:
        """Return the ticks of the next frame; `busy` makes no difference here."""
        self._frames += 1
        return self._frames * TICKS // self.fps - (self._frames - 1) * TICKS // self.fps
