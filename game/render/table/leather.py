"""The hole of a pocket and the leather around it: a crown, stitches, a wall that is lit, the dark.

Everything is in the sense of the north-eastern quarter (see `ground`).
"""

from __future__ import annotations

import numpy as np

from game.render.arrays import Floats

from .finish import Finish
from .ground import Ground
from .light import smooth
from .plan import LINER

SHEEN = (74, 69, 64)
FLOOR, WALL, LIP = (7, 8, 9), (58, 50, 43), (150, 138, 122)
TILT = 0.20
"""How far the floor is seen off towards the table's middle, in radii: the lens is above that."""
STITCH = 0.0058
"""Length of a stitch, m."""


def cover(distance: Floats, scale: float) -> Floats:
    """How much of a pixel lies on the positive side of an edge that is `distance` m away."""
    return np.asarray((distance * np.float32(scale) + np.float32(0.5)).clip(0, 1), np.float32)


def lay(picture: Floats, colour: Floats | tuple[int, int, int], share: Floats) -> None:
    """Cover a share of each pixel with a colour."""
    picture += (np.asarray(colour, np.float32) - picture) * share[..., None]


def line(
    picture: Floats, ground: Ground, finish: Finish, scale: float, nap: Floats, sy: int
) -> None:
    """Lay leather around the hole where the wood is cut, and its shadow on the wood."""
    outer = ground.rim - np.float32(LINER)
    beyond = cover(-ground.wood, scale)
    back = np.maximum(beyond, cover(ground.behind, scale) * cover(ground.cushion, scale))
    cast = 0.42 * np.exp(-outer.clip(0, None) / 0.006) * beyond
    picture *= (1 - cast * cover(outer, scale))[..., None]
    lay(picture, _hide(ground, finish, scale, nap, sy), cover(-outer, scale) * back)
    if finish.brass:
        _brass(picture, ground, finish, scale, back * sy)


def _hide(ground: Ground, finish: Finish, scale: float, nap: Floats, sy: int) -> Floats:
    """The leather's colour: a crown between its edges, a sheen where it faces the lamps."""
    v = (ground.rim / np.float32(LINER)).clip(0, 1)
    crown = 0.62 + 0.85 * np.exp(-(((v - 0.52) / 0.26) ** 2))
    crown -= 0.45 * smooth(0.80, 1.0, v) + 0.35 * smooth(-0.25, 0.0, -v)
    x, y = ground.way
    faces = 0.75 * y + (0.55 * sy * x if ground.hole.corner else 0.0)
    sheen = np.exp(-(((v - 0.40) / 0.13) ** 2)) * (0.22 + 0.42 * smooth(-0.2, 0.95, faces))
    hide = np.asarray(finish.leather, np.float32) * (crown * (1 + 3 * nap))[..., None]
    hide += np.asarray(SHEEN, np.float32) * sheen[..., None]
    turns = np.arctan2(y, x) * np.float32(2 * (ground.hole.width + LINER) / STITCH)
    sewn = (np.cos(turns) > -0.1) * np.exp(-(((v - 0.80) / 0.07) ** 2))
    lay(hide, np.asarray(finish.stitch, np.float32) * 1.9, sewn * (0.55 * min(1.0, scale / 330)))
    return hide


def _brass(picture: Floats, ground: Ground, finish: Finish, scale: float, side: Floats) -> None:
    """Lay a bright lip between leather and wood; `side` is negative on the near rail."""
    width = 0.8 / scale + 0.0009
    outer = ground.rim - np.float32(LINER - 0.001)
    lip = np.exp(-((outer / width) ** 2)) * np.abs(side)
    lay(picture, finish.stitch, lip * 0.75)
    far = np.where(side > 0, 1.0, 0.2)
    hot = lip * smooth(0.1, 0.9, ground.way[1] * far + 0.1)
    picture += hot[..., None] * np.array((70, 58, 34), np.float32)


def hole(picture: Floats, ground: Ground, scale: float) -> None:
    """Sink the hole: its wall is seen beyond the far edge, and cushions hang over it."""
    corner, width = ground.hole.corner, ground.hole.width
    to = (-0.7071, -0.7071) if corner else (0.0, -1.0)
    x, y = ground.way
    lit = 0.5 - 0.5 * (x * np.float32(to[0]) + y * np.float32(to[1]))
    away = (ground.rim + np.float32(width)) / np.float32(width)
    deep = np.hypot(x * away - np.float32(to[0] * TILT), y * away - np.float32(to[1] * TILT))
    wall = smooth(0.62, 1.12, deep)
    bright = wall * (0.16 + 0.84 * lit * np.sqrt(lit))
    well = np.asarray(FLOOR, np.float32) + bright[..., None] * np.asarray(WALL, np.float32)
    folds = 1 + 0.16 * np.cos(np.arctan2(y, x) * 13) * wall
    edge = 0.72 * np.exp(-(-ground.drop).clip(0, None) / 0.0040) * (0.35 + 0.65 * (1 - lit))
    under = 0.75 * np.exp(-ground.cushion.clip(0, None) / 0.010)
    well *= (folds * (1 - edge) * (1 - under))[..., None]
    lay(picture, well, mask(ground, scale))
    shine = np.exp(-((ground.rim * np.float32(scale / 0.9)) ** 2)) * lit * lit
    lay(picture, LIP, 0.30 * shine * cover(-ground.wood, scale))


def mask(ground: Ground, scale: float) -> Floats:
    """How much of each pixel is hole that can be seen, 0 to 1."""
    return cover(-ground.drop, scale) * cover(ground.cushion, scale)
