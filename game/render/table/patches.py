"""Pockets, painted over the picture of a table without them: nothing beside them changes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pygame

from game.render.arrays import Floats
from game.render.layout import CUSHION, Layout
from game.render.theme import CLOTHS

from . import bed, leather
from .finish import Finish
from .ground import FEATHER, Ground, Patch
from .leather import cover, lay
from .light import smooth


def cut(
    surface: pygame.Surface,
    layout: Layout,
    finish: Finish,
    patches: Sequence[Patch],
    nap: Floats,
) -> None:
    """Paint the pockets of a table; `nap` is the texture of the bed (see `bed.texture`)."""
    for patch in patches:
        box = patch.box
        pixels = pygame.surfarray.pixels3d(surface)[box.x : box.right, box.y : box.bottom]
        turned = patch.turned(pixels)
        picture = turned.astype(np.float32)
        _paint(picture, layout, patch, finish, patch.turned(_nap(layout, box, nap)))
        turned[:] = (picture + 0.5).clip(0, 255)


def _nap(layout: Layout, box: pygame.Rect, nap: Floats) -> Floats:
    """The texture in a rectangle; beyond the bed it goes on mirrored."""
    spots = []
    for first, count, start, size in zip(
        box.topleft, box.size, layout.bed.topleft, layout.bed.size, strict=True
    ):
        place = np.abs(np.arange(count) + (first - start))
        spots.append(np.where(place >= size, 2 * size - 2 - place, place))
    return np.asarray(nap[spots[0][:, None], spots[1][None]], np.float32)


def _paint(picture: Floats, layout: Layout, patch: Patch, finish: Finish, nap: Floats) -> None:
    """Paint one pocket into (width, height, 3), turned into the north-east."""
    ground, scale = patch.ground, layout.scale
    cloth = np.asarray(CLOTHS[finish.cloth], np.float32)
    inside, fabric = cover(ground.wood, scale), cover(ground.cushion, scale)
    light = _cloth(ground, _lamp(layout, patch), patch.sy) * (1 + nap)
    lay(picture, cloth * light[..., None], inside * fabric)
    light = _cushion(ground, _side(layout, patch)) * (1 + 0.3 * nap)
    covered = cover(-ground.cushion, scale)
    lay(picture, cloth * light[..., None], covered * _feather(picture.shape, scale))
    picture *= (1 - 0.40 * _facing(ground) * covered)[..., None]
    leather.line(picture, ground, finish, scale, nap, patch.sy)
    leather.hole(picture, ground, scale)


def _lamp(layout: Layout, patch: Patch) -> Floats:
    """The lamps' light on the patch, as over the whole bed, turned."""
    x, y = bed.axes(layout, *patch.box)
    along, across = bed.axes(layout, *layout.bed)
    middle = across[np.abs(across).argmin()][None]
    brightest = bed.lamps(along, middle, layout).max()
    return patch.turned(np.asarray(bed.lamps(x, y, layout) / brightest))


def _side(layout: Layout, patch: Patch) -> Floats:
    """What falls on the long cushion and, where that is nearer, on the short one, turned."""
    x, y = bed.axes(layout, *patch.box)
    along, across = bed.axes(layout, *layout.table)
    far, end = (np.array([side / 2], np.float32) for side in (layout.width, layout.length))
    ground = patch.ground
    long = bed.lamps(x, far, layout) / bed.lamps(along, far, layout).max()
    light = np.broadcast_to(long, ground.north.shape)
    light = (0.78 + 0.24 * patch.turned(light)) * (1.10 if patch.sy > 0 else 0.96)
    if not ground.hole.corner:
        return np.asarray(light, np.float32)
    short = bed.lamps(end, y, layout) / bed.lamps(end, across, layout).max()
    other = patch.turned(np.broadcast_to(short, ground.north.shape))
    other = (0.78 + 0.24 * other) * (1.05 if patch.sx > 0 else 1.02)
    return np.asarray(np.where(ground.long < ground.short, light, other), np.float32)


def _cloth(ground: Ground, lamp: Floats, sy: int) -> Floats:
    """Light on bed and shelf: the shadow is that of the real cushions, the rails take the light
    out of the mouth, and at the slate's edge the cloth rolls over."""
    near = np.float32(1.0 if sy > 0 else 0.78)
    light = (0.60 + 0.49 * lamp) * (1 + near * (bed.shade(ground.long) - 1))
    into = ground.north + np.float32(0.012)
    if ground.hole.corner:
        light *= bed.shade(ground.short)
        into = np.maximum(ground.east, ground.north) + np.float32(0.020)
    light *= 1 - 0.34 * smooth(0.0, 0.05, into)
    edge = ground.drop
    fold = 0.30 * np.exp(-(((edge - 0.006) / 0.0028) ** 2))
    light *= 1 - 0.55 * np.exp(-edge.clip(0, None) / 0.0035) + fold
    return np.asarray(light, np.float32)


def _cushion(ground: Ground, side: Floats) -> Floats:
    """Light on the cushions: nose and shoulder bend with a round jaw, the fall and the crease at
    the wood are the straight rail's."""
    out = np.where(ground.long < ground.short, ground.north, ground.east)
    u = out / np.float32(CUSHION)
    bent = (-ground.rubber).clip(0, None) / np.float32(CUSHION)
    fall = 0.86 - 0.20 * u.clip(0, 1)
    shoulder = 0.27 * np.exp(-(((bent - 0.17) / 0.10) ** 2))
    nose = 0.34 * np.exp(-((bent / 0.07) ** 2))
    crease = 0.34 * np.exp(-(((u - 1) / 0.06) ** 2))
    return np.asarray((fall + shoulder - nose - crease) * side, np.float32)


def _facing(ground: Ground) -> Floats:
    """How dark a cushion's end is: it looks away from the lamps."""
    out = np.where(ground.long < ground.short, ground.north, ground.east)
    bent = -ground.rubber
    return np.asarray(np.exp(-bent.clip(0, None) / 0.006) * (out > bent + 0.0008), np.float32)


def _feather(shape: tuple[int, ...], scale: float) -> Floats:
    """1 in the middle of a patch, falling to 0 at its edge."""
    ends = [np.minimum(np.arange(n), n - 1 - np.arange(n)) for n in shape[:2]]
    return np.asarray((np.minimum.outer(*ends) / (FEATHER * scale)).clip(0, 1), np.float32)
