"""Stars in a row: those that have been earned are full."""

from __future__ import annotations

from functools import lru_cache
from math import cos, pi, sin

import pygame

from game.render.theme import GOLD, PANEL, TEXT_FAINT, Colour, mix

FINER = 4
"""Times the size at which a star is drawn before it is averaged."""
INNER = 0.45
"""Radius of a star's inner corners, of its outer ones."""
GAP = 0.25
"""Between two stars, of their side."""


def draw(
    surface: pygame.Surface, at: tuple[float, float], side: float, earned: int, most: int = 3
) -> pygame.Rect:
    """Draw so many stars from a left middle on, each `side` px large; returns their rectangle."""
    size, step = max(round(side), 7), max(round(side * (1 + GAP)), 8)
    rect = pygame.Rect(round(at[0]), round(at[1] - size / 2), step * most, size)
    for place in range(most):
        ink = GOLD if place < earned else mix(PANEL, TEXT_FAINT, 0.45)
        surface.blit(_star(size, ink), (rect.x + place * step, rect.y))
    return rect


@lru_cache(maxsize=32)
def _star(size: int, ink: Colour) -> pygame.Surface:
    large = pygame.Surface((size * FINER, size * FINER), pygame.SRCALPHA)
    large.fill((*ink, 0))
    middle, reach = size * FINER / 2, size * FINER / 2
    corners = [
        (
            middle + (reach if k % 2 == 0 else INNER * reach) * sin(k * pi / 5),
            middle - (reach if k % 2 == 0 else INNER * reach) * cos(k * pi / 5),
        )
        for k in range(10)
    ]
    pygame.draw.polygon(large, ink, corners)
    return pygame.transform.smoothscale(large, (size, size))
