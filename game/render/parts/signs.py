"""The signs on the strip's buttons: undo, redo, to the ends, play and pause; drawn once, kept."""

from __future__ import annotations

from functools import lru_cache
from math import cos, pi, sin

import pygame

from game.render.theme import Colour

FINER = 4
"""Times the size at which they are drawn before averaging."""
SIDE = 18
"""Width and height of a sign, px at s = 1."""
Points = list[tuple[float, float]]
SHAPES: dict[str, list[Points]] = {
    "first": [[(3, -5), (3, 5), (-4, 0)], [(-5.4, -4.8), (-3.8, -4.8), (-3.8, 4.8), (-5.4, 4.8)]],
    "last": [[(-3, -5), (-3, 5), (4, 0)], [(5.4, -4.8), (3.8, -4.8), (3.8, 4.8), (5.4, 4.8)]],
    "play": [[(5.5, 0), (-4, -6), (-4, 6)]],
    "pause": [
        [(x - 1.3, -5), (x + 1.3, -5), (x + 1.3, 5), (x - 1.3, 5)] for x in (-2.8, 2.8)
    ],
    "slower": [[(2, -4), (2, 4), (-2.5, 0)]],
    "here": [[(0, -3), (4, 3), (-4, 3)]],
    "faster": [[(-2, -4), (-2, 4), (2.5, 0)]],
}
"""Polygons around the middle, px at s = 1."""


def draw(
    surface: pygame.Surface, rect: pygame.Rect, name: str, s: float, ink: Colour
) -> pygame.Rect:
    """Draw the sign in the middle of `rect`."""
    picture = _sign(name, s, ink)
    return surface.blit(picture, picture.get_rect(center=rect.center))


@lru_cache(maxsize=64)
def _sign(name: str, s: float, ink: Colour) -> pygame.Surface:
    side = round(SIDE * s)
    large = pygame.Surface((side * FINER, side * FINER), pygame.SRCALPHA)
    large.fill((*ink, 0))
    k, middle = FINER * s, side * FINER / 2
    for shape in SHAPES.get(name) or _hook(-1 if name == "undo" else 1):
        points = [(middle + k * x, middle + k * y) for x, y in shape]
        pygame.draw.polygon(large, (*ink, 255), points)
    return pygame.transform.smoothscale(large, (side, side))


def _hook(way: int) -> list[Points]:
    """An arrow that goes round, back (-1) or ahead (1)."""
    turn = [pi * (0.62 - 1.12 * i / 16) for i in range(17)]
    outer = [(-way * (0.6 - 4.9 * sin(a)), 0.8 - 4.9 * cos(a)) for a in turn]
    inner = [(-way * (0.6 - 3.3 * sin(a)), 0.8 - 3.3 * cos(a)) for a in reversed(turn)]
    tip = [(way * 5.6, -3.3), (-way * 0.4, -7.0), (-way * 0.4, 0.4)]
    return [outer + inner, tip]
