"""Balls that fall into holes: seen through the opening alone, darker the deeper they are."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pygame

from game.render.arrays import Floats
from game.render.layout import Layout

from . import leather
from .ground import Patch
from .obstacles import Thing

DEEP = 0.14
"""How far below the cloth a ball is in the dark, m."""
DARKEST, SMALLER = 0.22, 0.6
"""Light that is left there, and how much a ball shrinks with each metre."""
SINKS = (0.3, 1.2)
"""Depths in radii between which what is over the cloth disappears."""


class Wells:
    """The openings of all holes of one table at one size."""

    def __init__(
        self, layout: Layout, patches: Sequence[Patch] = (), things: Sequence[Thing] = ()
    ) -> None:
        self._layout, self._patches = layout, patches
        self._round_holes = [thing for thing in things if thing.kind == "pocket"]
        self._openings: list[tuple[pygame.Rect, Floats]] | None = None

    @property
    def openings(self) -> list[tuple[pygame.Rect, Floats]]:
        """Rectangles of the window, and how much of each pixel is open; made when first needed."""
        if self._openings is None:
            scale = self._layout.scale
            masks = [patch.turned(leather.mask(patch.ground, scale)) for patch in self._patches]
            boxes = [patch.box for patch in self._patches]
            round_ones = [self._round(hole) for hole in self._round_holes]
            self._openings = [*zip(boxes, masks, strict=True), *round_ones]
            self._patches = ()
        return self._openings

    def _round(self, hole: Thing) -> tuple[pygame.Rect, Floats]:
        """The opening of a hole that is just a circle."""
        (x, y), radius = self._layout.to_screen(*hole.points[0]), hole.radius * self._layout.scale
        reach = int(radius) + 2
        box = pygame.Rect(int(x) - reach, int(y) - reach, 2 * reach + 1, 2 * reach + 1)
        across, down = (np.arange(n) + 0.5 for n in box.size)
        away = np.hypot(across[:, None] + (box.x - x), down[None] + (box.y - y))
        return box, np.asarray((radius + 0.5 - away).clip(0, 1), np.float32)

    def sink(
        self,
        surface: pygame.Surface,
        picture: pygame.Surface,
        centre: tuple[float, float],
        radius: float,
        depth: float,
    ) -> pygame.Rect:
        """Draw a ball's picture in a hole, `depth` m below the cloth; `radius` is the ball's, m."""
        side = max(2, round(picture.get_width() * (1 - SMALLER * depth)))
        small = pygame.transform.smoothscale(picture, (side, side))
        light = round(255 * (1 - (1 - DARKEST) * min(1.0, depth / DEEP)))
        small.fill((light, light, light, 255), special_flags=pygame.BLEND_RGBA_MULT)
        box = small.get_rect(topleft=(round(centre[0] - side / 2), round(centre[1] - side / 2)))
        low, high = (share * radius for share in SINKS)
        over = 1 - min(1.0, max(0.0, (depth - low) / (high - low)))
        alpha = pygame.surfarray.pixels_alpha(small)
        alpha[:] = alpha * (over + (1 - over) * self._seen(box))
        del alpha  # it locks the surface
        return surface.blit(small, box)

    def _seen(self, box: pygame.Rect) -> Floats:
        """How much of each pixel of a rectangle is open."""
        seen = np.zeros(box.size, np.float32)
        for where, opening in self.openings:
            both = where.clip(box)
            if both.w and both.h:
                x, y = both.x - where.x, both.y - where.y
                left, top = both.x - box.x, both.y - box.y
                part = opening[x : x + both.w, y : y + both.h]
                seen[left : left + both.w, top : top + both.h] = part
        return seen
