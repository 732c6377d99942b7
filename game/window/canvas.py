"""What is drawn on: the window, or for a small one a larger picture that is scaled down to it."""

from __future__ import annotations

from math import ceil

import pygame

from game.render.theme import BACKGROUND

LEAST = 960, 540
"""A window for which text has its least size, 11 px: smaller ones show the same, only smaller."""
SHAPE = 4
"""How many times longer than wide, or wider than long, a small window is filled at most."""

Place = tuple[int, int]


class Canvas:
    """A picture with room for all that is drawn, and the part of the window it is shown in."""

    def __init__(self, window: pygame.Surface) -> None:
        self.window = self.surface = window
        self.size = window.get_size()
        """The window's when this was made: its surface changes with it."""
        self.part = window.get_rect()
        self.scale = 1.0
        """Px of the picture for each px of the window: 1, or more in a small window."""
        if self.size[0] < LEAST[0] or self.size[1] < LEAST[1]:
            self._enlarge()

    def _enlarge(self) -> None:
        width, height = self.size
        self.part.size = min(width, SHAPE * height), min(height, SHAPE * width)
        self.part.center = width // 2, height // 2
        self.scale = max(most / size for most, size in zip(LEAST, self.part.size, strict=True))
        size = [ceil(side * self.scale) for side in self.part.size]
        self.surface = pygame.Surface(size, 0, self.window)

    def at(self, place: Place) -> Place:
        """Return the point of the picture at a point of the window."""
        x, y = place[0] - self.part.x, place[1] - self.part.y
        return int((x + 0.5) * self.scale), int((y + 0.5) * self.scale)

    def translated(self, event: pygame.event.Event) -> pygame.event.Event:
        """Return an event of the mouse with its place in the picture."""
        if self.surface is self.window:
            return event
        return pygame.event.Event(event.type, {**event.dict, "pos": self.at(event.pos)})

    def show(self, dirty: list[pygame.Rect]) -> list[pygame.Rect]:
        """Bring what has changed in the picture into the window; returns what changed there."""
        if self.surface is self.window or not dirty:
            return dirty
        whole = self.surface.get_rect() in dirty
        if whole:  # beside the part there may be what the window showed in another shape
            self.window.fill(BACKGROUND)
        part = self.window.subsurface(self.part)
        pygame.transform.smoothscale(self.surface, part.get_size(), part)
        return [self.window.get_rect() if whole else self.part]
