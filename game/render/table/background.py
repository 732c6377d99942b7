"""The opaque background: floor, wooden rails, cushions, bed and all that never moves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pygame
from numpy.typing import NDArray

from game.render.arrays import Bytes, Floats
from game.render.layout import BORDER, CUSHION, Layout
from game.render.theme import BACKGROUND, CLOTHS, Colour, mix
from physics import tables

from . import bed as cloths
from . import chalk, ground, lines, obstacles, rails
from .finish import FINISHES, Finish
from .ground import Patch
from .patches import cut

SHADOW = 8
"""Width of the table's shadow on the floor, px at s = 1: less than the gap to a focus ring."""
SIDES = ((1.10, 11), (0.96, 23), (1.02, 37), (1.05, 41))
"""Light on the far, near, left and right cushion, and a seed for each board's grain."""


def background(
    layout: Layout,
    cloth: str = "blue",
    table: tables.Table | None = None,
    things: Sequence[obstacles.Thing] = (),
    patches: Sequence[Patch] | None = None,
) -> pygame.Surface:
    """Return the window without cards and balls.

    `cloth` is a key of `theme.CLOTHS`.  `table` says what its rails, pockets and lines are; without
    one they are a carom table's.  `things` stand or gape somewhere else.  `patches` are
    its pockets, if they have been measured.
    """
    surface = pygame.Surface(layout.size, 0, 32)
    surface.fill(BACKGROUND)
    kind = "carom" if table is None else table.kind
    finish = FINISHES[kind]
    pockets = ground.patches(layout, table) if patches is None else patches
    colour = CLOTHS[cloth if kind == "carom" else finish.cloth]
    _floor_shadow(surface, layout)
    _borders(surface, layout, _framed(surface, layout, colour, finish, bool(pockets)))
    nap = cloths.texture(layout, *layout.bed.size)
    _toned(surface, layout.bed, cloths.bed(layout, nap), colour)
    if table is None or kind == "carom":
        _spots(surface, layout, colour)
    else:
        chalk.draw(surface, layout, table, colour)
    cut(surface, layout, finish, pockets, nap)
    for thing in things:
        obstacles.draw(surface, layout, thing, colour)
    return surface


def _borders(surface: pygame.Surface, layout: Layout, picture: Floats) -> None:
    """Copy the rails of a picture of the table: its four borders, the bed is painted apart."""
    box, depth = layout.table, int(BORDER * layout.scale) + 3
    pixels = pygame.surfarray.pixels3d(surface)[box.x : box.right, box.y : box.bottom]
    for part in _sides(depth):
        pixels[part] = (picture[part] + 0.5).clip(0, 255)


def _toned(surface: pygame.Surface, box: pygame.Rect, light: Floats, colour: Colour) -> None:
    """Paint `box` in `colour` times `light` (up to 1.25), through a table of all the shades."""
    levels = np.arange(1024)[:, None] * np.array(colour) * (1.25 / 1023)
    shades = [
        surface.map_rgb(shade) for shade in np.round(levels).clip(0, 255).astype(int).tolist()
    ]
    step = (light * np.float32(1023 / 1.25)).astype(np.int32)
    pixels = pygame.surfarray.pixels2d(surface)
    pixels[box.x : box.right, box.y : box.bottom] = np.array(shades, np.uint32)[step]


def _floor_shadow(surface: pygame.Surface, layout: Layout) -> None:
    """Darken the floor around the table, but not where cards may be wiped with its plain colour."""
    reach, radius = SHADOW * layout.s, rails.CORNER * layout.scale
    box = layout.table.inflate(2 * int(reach), 2 * int(reach))
    gaps = [
        (np.abs(np.arange(n) + 0.5 - n / 2) - side / 2 + radius).clip(0, None)
        for n, side in zip(box.size, layout.table.size, strict=True)
    ]
    for part in _sides(int(reach + radius) + 2):
        across, down = gaps[0][part[0]], gaps[1][part[1]]
        away = ((np.hypot(across[:, None], down[None]) - radius) / reach).clip(0, 1)
        left, top = (p.indices(n)[0] for p, n in zip(part, box.size, strict=True))
        band = pygame.Rect(box.x + left, box.y + top, len(across), len(down))
        _toned(surface, band, 1 - 0.75 * (1 - away) ** 2, BACKGROUND)


def _sides(depth: int) -> list[tuple[slice, slice]]:
    """Return the four borders of any picture, `depth` px deep: far, near, left, right."""
    every, first, last = slice(None), slice(0, depth), slice(-depth, None)
    return [(every, first), (every, last), (first, every), (last, every)]


def _framed(
    surface: pygame.Surface, layout: Layout, colour: Colour, finish: Finish, has_pockets: bool
) -> Floats:
    """Return the table's rectangle (width, height, 3) without its bed."""
    box = layout.table
    picture = np.zeros((box.w, box.h, 3), np.float32)
    far, near, left, right = (_side(layout, i, colour) for i in range(4))
    depth = min(far.shape[1], left.shape[1])
    picture[:, : far.shape[1]] = far
    picture[:, -far.shape[1] :] = near[:, ::-1]
    mitre = _mitre(layout, depth)[..., None]
    for strip, target in ((left, picture[:depth]), (right, picture[::-1][:depth])):
        target += (strip[:, :depth].transpose(1, 0, 2) - target) * mitre
    _joints(picture, layout, depth)
    if finish.diamonds:
        rails.inlay(picture, layout, box.x, box.y, pockets=has_pockets)
    floor = pygame.surfarray.pixels3d(surface)[box.x : box.right, box.y : box.bottom]
    _round(picture, floor, layout)
    return picture


def _side(layout: Layout, index: int, colour: Colour) -> Floats:
    """Return one side (count, depth, 3) from the outer edge inwards, lit by the lamps."""
    light, seed = SIDES[index]
    long = index < 2
    count, across = (layout.table.w, layout.table.h) if long else (layout.table.h, layout.table.w)
    nose = (across - (layout.width if long else layout.length) * layout.scale) / 2
    away = nose - np.arange(int(np.ceil(nose)), dtype=np.float32) - np.float32(0.5)
    back = away - np.float32(CUSHION * layout.scale)
    cushion = cloths.cushion(layout, count, away, light, seed)[..., None]
    wood = rails.board(layout, count, back, seed)
    strip = cushion * np.array(colour, np.float32)
    strip += (wood - strip) * (back + 0.5).clip(0, 1)[:, None]
    x, y = cloths.axes(layout, *layout.table)
    edge = np.array([(layout.width if long else layout.length) / 2], np.float32)
    lamp = cloths.lamp(x, edge, layout) if long else cloths.lamp(edge, y, layout).T
    return np.asarray(strip * (0.78 + 0.24 * lamp)[..., None], np.float32)


def _mitre(layout: Layout, depth: int) -> Floats:
    """Return (depth, height): 1 where the left side is seen, 0 where the far and near ones are."""
    i = np.arange(depth, dtype=np.float32)[:, None]
    j = np.arange(layout.table.h, dtype=np.float32)[None]
    j = np.minimum(j, layout.table.h - 1 - j)
    return np.asarray((j - i + 0.5).clip(0, 1), np.float32)


def _joints(picture: Floats, layout: Layout, depth: int) -> None:
    """Draw the joints of the mitres: darker in wood than in cloth."""
    i = np.arange(depth, dtype=np.float32)
    away = np.abs(i[:, None] - i[None]) / np.float32(1.4142)
    line = (0.5 + 0.55 * layout.s - away).clip(0, 1)
    wood = np.minimum(i[:, None], i[None]) < (BORDER - CUSHION) * layout.scale
    keep = (1 - line * np.where(wood, 0.42, 0.30))[..., None].astype(np.float32)
    for patch in _four(picture, depth):
        patch *= keep


def _four(picture: NDArray[Any], depth: int) -> list[NDArray[Any]]:
    """Return views of the four corners, each with its outermost pixel first."""
    flips = ((1, 1), (-1, 1), (1, -1), (-1, -1))
    return [picture[::a, ::b][:depth, :depth] for a, b in flips]


def _round(picture: Floats, floor: Bytes, layout: Layout) -> None:
    """Cut the outer corners round, down to the floor."""
    radius = rails.CORNER * layout.scale
    size = int(radius) + 1
    i = radius - np.arange(size, dtype=np.float32) - 0.5
    away = np.hypot(i[:, None].clip(0, None), i[None].clip(0, None)) - radius
    inside = (0.5 - away).clip(0, 1)[..., None]
    bevel = 1 - 0.30 * (1 + away / (0.007 * layout.scale)).clip(0, 1)[..., None]
    for patch, below in zip(_four(picture, size), _four(floor, size), strict=True):
        patch *= bevel
        patch += (below - patch) * (1 - inside)


def _spots(surface: pygame.Surface, layout: Layout, colour: Colour) -> None:
    """Mark the three spots on the long axis."""
    for x in (-layout.length / 4, 0.0, layout.length / 4):
        centre = layout.to_screen(x, 0)
        lines.dot(
            surface, centre, max(1.1, 0.0045 * layout.scale), mix(colour, (0, 0, 0), 0.6), 0.7
        )
