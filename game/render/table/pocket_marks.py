"""Marks at pockets: one that a ball is going to is lit in the ball's colour, and may have a label.

All lengths are px of the window; surfaces must be opaque, and their clip is respected.
"""

from __future__ import annotations

import numpy as np
import pygame

from game.render.font import Type
from game.render.layout import CUSHION, WOOD, Layout
from game.render.parts import shapes
from game.render.theme import TEXT, WHITE, Colour, mix

from . import lines
from .plan import LINER, Hole

GLOW = 1.9
"""How far the light of a pocket reaches, in radii of its hole."""
INSIDE, OUTSIDE = (0.34, 0.56), (0.22, 0.38)
"""In how many radii the glow falls off, and how strong it is at the edge."""
DARK = (12, 15, 20)
SIZE, PAD, HEIGHT = 13, 7, 20
"""Of a label: its text, the room beside it, and its height; px at s = 1."""
ASIDE = 66
"""How far a label is from the middle of a hole, px at s = 1."""


def lit(surface: pygame.Surface, layout: Layout, hole: Hole, colour: Colour) -> pygame.Rect:
    """Light a pocket with a ring and a glow; `colour` is the one of the ball's path."""
    (x, y), s = layout.to_screen(hole.rim.real, hole.rim.imag), layout.s
    radius = hole.width * layout.scale
    reach = int(radius * GLOW) + 1
    box = pygame.Rect(int(x) - reach, int(y) - reach, 2 * reach + 1, 2 * reach + 1)
    box = box.clip(layout.table).clip(surface.get_clip())
    across, down = (np.arange(n, dtype=np.float32) + 0.5 for n in box.size)
    away = np.hypot(across[:, None] + (box.x - x), down[None] + (box.y - y)) / radius - 1
    inside = INSIDE[1] * np.exp(away / INSIDE[0])
    outside = OUTSIDE[1] * np.exp(-away / OUTSIDE[0])
    share = np.where(away < 0, inside, outside)[..., None].astype(np.float32)
    if box.w and box.h:
        pixels = pygame.surfarray.pixels3d(surface)[box.x : box.right, box.y : box.bottom]
        old = pixels.astype(np.float32)
        pixels[:] = old + (np.array(colour, np.float32) - old) * share + np.float32(0.5)
    bright = mix(colour, WHITE, 0.35)
    clip = surface.get_clip()
    surface.set_clip(clip.clip(layout.table))
    ring = lines.ring(surface, (x, y), radius - 0.6 * s, bright, 2.0 * s, 0.95)
    surface.set_clip(clip)
    return box.union(ring)


def called(surface: pygame.Surface, layout: Layout, hole: Hole, colour: Colour) -> pygame.Rect:
    """Ring the pocket that is called, on its leather: the light of `lit` stays for the preview."""
    centre, s = layout.to_screen(hole.rim.real, hole.rim.imag), layout.s
    radius = (hole.width + 0.5 * LINER) * layout.scale
    clip = surface.get_clip()
    surface.set_clip(clip.clip(layout.table))
    ring = lines.ring(surface, centre, radius, colour, 2.5 * s, 0.95)
    surface.set_clip(clip)
    return ring


def pill(
    surface: pygame.Surface,
    type_: Type,
    text: str,
    centre: tuple[float, float],
    ink: Colour = TEXT,
) -> pygame.Rect:
    """Draw a label in a dark pill: on the wood or beside the table, never on the cloth."""
    s = type_.s
    box = pygame.Rect(0, 0, round(type_.width(text, SIZE) + 2 * PAD * s), round(HEIGHT * s))
    box.center = round(centre[0]), round(centre[1])
    shapes.box(surface, box, s, DARK, mix(DARK, ink, 0.55), radius=HEIGHT // 2)
    middle = box.centery + type_.cap(SIZE) / 2
    type_.draw(surface, text, (box.centerx, middle), SIZE, ink, "centre")
    return box


def pill_spot(layout: Layout, hole: Hole) -> tuple[float, float]:
    """Where a label beside a pocket has its middle: on the long rail, towards the table's middle,
    or right of a side pocket."""
    out = 0.5 * layout.width + CUSHION + 0.5 * WOOD
    x, y = layout.to_screen(hole.rim.real, out if hole.rim.imag > 0 else -out)
    inward = -1 if hole.corner and hole.rim.real > 0 else 1
    return x + inward * ASIDE * layout.s, y
