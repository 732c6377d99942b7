"""The clock of the loop: frames as the screen has time for, or at once and all of one length."""

from __future__ import annotations

import pygame

from game.session.ticks import TICKS

LONGEST = TICKS // 10
"""A frame that took longer counts as this: after a hitch the game is late, but does not race."""
AWAKE = 60
"""Frames at full rate after the last change, before the loop slows down."""
IDLE_FPS = 20


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
