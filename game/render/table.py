"""The opaque background: floor, wooden rails, cushions, bed and everything that never moves on it."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pygame

from . import cloth as cloths
from . import lines, rails
from .arrays import Floats, Points
from .layout import BORDER, CUSHION, Layout
from .theme import BACKGROUND, CLOTHS, Colour, mix

SIDES = ((1.06, 11), (0.90, 23), (0.97, 37), (1.0, 41))
"""Light on the far, near, left and right cushion, and a seed for each board's grain."""


def background(layout: Layout, cloth: str = "blue", walls: Sequence[Points] = ()) -> pygame.Surface:
    """Return the window without cards and balls.

    `cloth` is a key of `theme.CLOTHS`.  `walls` are walls inside the bed, each a line of points in
    metres, drawn as strips of cushion.
    """
    surface = pygame.Surface(layout.size)
    surface.fill(BACKGROUND)
    colour = CLOTHS[cloth]
    _floor_shadow(surface, layout)
    _blit(surface, layout.table, _framed(layout, colour))
    _blit(surface, layout.bed, cloths.bed(layout, colour))
    _spots(surface, layout, colour)
    for wall in walls:
        _wall(surface, layout, wall, colour)
    return surface


def _blit(surface: pygame.Surface, box: pygame.Rect, picture: Floats) -> None:
    pixels = pygame.surfarray.pixels3d(surface)
    pixels[box.x : box.right, box.y : box.bottom] = (picture + 0.5).clip(0, 255)


def _floor_shadow(surface: pygame.Surface, layout: Layout) -> None:
    """Darken the floor around the table; worked out at a quarter of the size, as it is so soft."""
    reach = 40 * layout.s
    box = layout.table.inflate(2 * reach, 2 * reach).move(0, round(5 * layout.s))
    small = (max(2, box.w // 4), max(2, box.h // 4))
    x = (np.arange(small[0]) + 0.5) * box.w / small[0] - box.w / 2
    y = (np.arange(small[1]) + 0.5) * box.h / small[1] - box.h / 2
    gap = [
        (np.abs(a) - side / 2 + 6).clip(0, None)
        for a, side in ((x, layout.table.w), (y, layout.table.h))
    ]
    away = np.hypot(gap[0][:, None], gap[1][None])
    shade = pygame.Surface(small, pygame.SRCALPHA, 32)
    fall = (1 - away / reach).clip(0, 1)
    pygame.surfarray.pixels_alpha(shade)[:] = np.round(200 * fall**2.2)
    surface.blit(pygame.transform.smoothscale(shade, box.size), box)


def _framed(layout: Layout, colour: Colour) -> Floats:
    """Return the table's rectangle (width, height, 3) with rails and cushions, the bed left black."""
    box = layout.table
    picture = np.zeros((box.w, box.h, 3), np.float32)
    depth = int(np.ceil(BORDER * layout.scale)) + 1
    far, near, left, right = (_side(layout, i, colour, depth) for i in range(4))
    picture[:, :depth] = far[:, ::-1]
    picture[:, -depth:] = near
    for strip, corner in ((left[:, ::-1], 0), (right, box.w - depth)):
        target = picture[corner : corner + depth]
        mask = (
            _mitre(layout, depth)[..., None]
            if corner == 0
            else _mitre(layout, depth)[::-1, :, None]
        )
        target += (strip.transpose(1, 0, 2) - target) * mask
    _corners(picture, layout, depth)
    rails.inlay(picture, layout, box.x, box.y)
    _round(picture, layout)
    return picture


def _side(layout: Layout, index: int, colour: Colour, depth: int) -> Floats:
    """Return one side (count, depth, 3): cushion and rail from the nose outwards, lit by the lamps."""
    light, seed = SIDES[index]
    long = index < 2
    count = layout.table.w if long else layout.table.h
    soft = round(CUSHION * layout.scale) + 1
    cushion = cloths.cushion(layout, count, soft, light, seed)[..., None] * np.array(
        colour, np.float32
    )
    wood = rails.board(layout, count, depth - soft, seed)
    strip = np.concatenate((cushion, wood), axis=1)
    x, y = cloths.axes(layout, *layout.table)
    edge = np.array([(layout.width if long else layout.length) / 2], np.float32)
    lamp = cloths.lamp(x, edge, layout) if long else cloths.lamp(edge, y, layout).T
    return np.asarray(strip * (0.80 + 0.34 * lamp)[..., None], np.float32)


def _mitre(layout: Layout, depth: int) -> Floats:
    """Return (depth, height): 1 where the left side is seen, 0 where the far and near ones are."""
    i = np.arange(depth, dtype=np.float32)[:, None]
    j = np.arange(layout.table.h, dtype=np.float32)[None]
    j = np.minimum(j, layout.table.h - 1 - j)
    return np.asarray((j - i + 0.5).clip(0, 1), np.float32)


def _corners(picture: Floats, layout: Layout, depth: int) -> None:
    """Draw the joints of the mitres: darker in wood than in cloth."""
    i = np.arange(depth, dtype=np.float32)
    away = np.abs(i[:, None] - i[None]) / np.float32(1.4142)
    line = (0.5 + 0.55 * layout.s - away).clip(0, 1)
    wood = np.minimum(i[:, None], i[None]) < (BORDER - CUSHION) * layout.scale
    keep = (1 - line * np.where(wood, 0.42, 0.30))[..., None].astype(np.float32)
    for patch in _four(picture, depth):
        patch *= keep


def _four(picture: Floats, depth: int) -> list[Floats]:
    """Return views of the four corners, each with its outermost pixel first."""
    flips = ((1, 1), (-1, 1), (1, -1), (-1, -1))
    return [picture[::a, ::b][:depth, :depth] for a, b in flips]


def _round(picture: Floats, layout: Layout) -> None:
    """Cut the outer corners round; the floor under them is near the window's own colour."""
    radius = rails.CORNER * layout.scale
    size = int(radius) + 1
    i = radius - np.arange(size, dtype=np.float32) - 0.5
    away = np.hypot(i[:, None].clip(0, None), i[None].clip(0, None)) - radius
    inside = (0.5 - away).clip(0, 1)[..., None]
    bevel = 1 - 0.35 * (1 + away / (0.007 * layout.scale)).clip(0, 1)[..., None]
    floor = np.array(mix(BACKGROUND, (0, 0, 0), 0.7), np.float32)
    for patch in _four(picture, size):
        patch *= bevel
        patch += (floor - patch) * (1 - inside)


def _spots(surface: pygame.Surface, layout: Layout, colour: Colour) -> None:
    """Mark the three spots on the long axis."""
    for x in (-layout.length / 4, 0.0, layout.length / 4):
        centre = layout.to_screen(x, 0)
        lines.dot(
            surface, centre, max(1.1, 0.0045 * layout.scale), mix(colour, (0, 0, 0), 0.6), 0.7
        )


def _wall(surface: pygame.Surface, layout: Layout, wall: Points, colour: Colour) -> None:
    """Draw a wall inside the bed: its shadow, its cloth and its lit nose."""
    points = [layout.to_screen(*p) for p in wall]
    width = 0.030 * layout.scale
    below = [(x, y + 0.010 * layout.scale) for x, y in points]
    lines.polyline(surface, below, (0, 0, 0), width, 0.40, soft=0.012 * layout.scale)
    lines.polyline(surface, points, mix(colour, (0, 0, 0), 0.45), width)
    lines.polyline(surface, points, mix(colour, (255, 255, 255), 0.06), width * 0.72)
    lines.polyline(surface, points, mix(colour, (255, 255, 255), 0.22), width * 0.22, 0.8, soft=1.5)
