"""What is printed on a ball with a number: its stripe and two discs, seen along the number's axis.

A ball's own axes: x through both numbers, z up in the digits and across the stripe.
"""

from __future__ import annotations

from functools import lru_cache
from math import ceil, sin

import numpy as np
import pygame
from numpy.typing import NDArray

import assets
from game.render.theme import BallLook

SIZE = 64
"""Texels of a print, across the ball."""
LARGE = 192
"""Pixels at which it is drawn."""
BAND = 0.58
"""Half the width of a stripe, radii."""
DISC, BLANK, PLATE = 0.60, 0.40, 0.80
"""Radians from a disc's middle to its edge: with digits, without, and on a portrait."""
LEAST, UNDERLINED = 8.5, 12.0
"""Radius, px, from which digits can be read, and 6 and 9 are told apart by a line."""
INK = (12, 13, 16)
FINE = 1.6
"""Texels that remain for a pixel of the ball, before they are enlarged: no edge is a staircase."""


def disc_of(radius: float) -> float:
    """How large the discs are of a ball that is `radius` px large."""
    return DISC if radius >= LEAST else BLANK


@lru_cache(maxsize=128)
def printed(look: BallLook, radius: float, disc: float, finer: int = 1) -> NDArray[np.uint32]:
    """Return the print (SIZE * SIZE, columns first), BGRA packed, of a ball `radius` px large.

    `finer`: how many times larger it is painted than shown.
    """
    large = pygame.Surface((LARGE, LARGE), 0, 32)
    large.fill(look.mark if look.striped else look.body)
    if look.striped:
        half = round(BAND * LARGE / 2)
        large.fill(look.body, (0, LARGE // 2 - half, LARGE, 2 * half))
    reach = sin(disc) * LARGE / 2
    pygame.draw.circle(large, look.mark, (LARGE / 2, LARGE / 2), reach)
    if disc > BLANK:
        _digits(large, look.number, reach, line=radius >= UNDERLINED)
    small = min(SIZE, ceil(2 * radius * finer * FINE))
    kept = pygame.transform.smoothscale(large, (small, small))
    texels = pygame.surfarray.array3d(pygame.transform.smoothscale(kept, (SIZE, SIZE)))
    r, g, b = texels.astype(np.uint32).transpose(2, 0, 1)
    return np.asarray(np.uint32(255) << 24 | r << 16 | g << 8 | b, np.uint32).ravel()


def _digits(large: pygame.Surface, number: str, reach: float, *, line: bool) -> None:
    """Draw a number into the middle disc; the only face there is regular: it is made bolder."""
    size = round(reach * (1.85 if len(number) == 1 else 1.42))
    ink = _font(size).render(number, True, INK)
    ink = ink.subsurface(ink.get_bounding_rect())
    x, y = ((LARGE - side) / 2 for side in ink.get_size())
    bold = max(1, round(reach / 27))
    for dx in range(-bold, bold + 1):
        for dy in (-bold // 2, 0, bold // 2):
            large.blit(ink, (x + dx, y + dy))
    if line and number in ("6", "9"):
        below = pygame.Rect(0, 0, round(0.53 * reach), max(2, round(0.10 * reach)))
        below.center = LARGE // 2, round(LARGE / 2 + 0.78 * reach)
        large.fill(INK, below)


@lru_cache(maxsize=8)
def _font(size: int) -> pygame.font.Font:
    pygame.font.init()
    return pygame.font.Font(assets.stream(assets.FONT), size)
