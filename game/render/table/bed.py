"""The bed and the cushions: cloth under two lamps, with its nap and the shadow of the noses."""

from __future__ import annotations

import numpy as np

from game.render import noise
from game.render.arrays import Floats
from game.render.layout import CUSHION, Layout


def lamp(x: Floats, y: Floats, layout: Layout) -> Floats:
    """Return the light (len(x), len(y)) at table points in metres, 1 where it is brightest."""
    total = lamps(x, y, layout)
    return np.asarray(total / total.max(), np.float32)


def lamps(x: Floats, y: Floats, layout: Layout) -> Floats:
    """Return the light (len(x), len(y)) of two lamps above the long axis, at +-0.27 of the length.

    Its unit is that of one lamp straight below it.
    """
    across = 1 + (y / (0.62 * layout.width)) ** 2
    total = np.zeros((len(x), len(y)), np.float32)
    for side in (-0.27, 0.27):
        along = ((x - side * layout.length) / (0.42 * layout.length)) ** 2
        reach = np.add.outer(along, across)
        total += 1 / (reach * np.sqrt(np.sqrt(reach)))
    return total


def axes(layout: Layout, left: int, top: int, width: int, height: int) -> tuple[Floats, Floats]:
    """Return the table coordinates (m) of the columns and the rows of a rectangle of pixels."""
    x0, y0 = layout.to_table(left + 0.5, top + 0.5)
    x = x0 + np.arange(width, dtype=np.float32) / np.float32(layout.scale)
    y = y0 - np.arange(height, dtype=np.float32) / np.float32(layout.scale)
    return x.astype(np.float32), y.astype(np.float32)


def shade(distance: Floats) -> Floats:
    """Return the light left at a distance (m) from one nose: its shadow is sharp, then wide."""
    d = distance.clip(0, None)
    return np.asarray(1 - 0.42 * np.exp(-d / 0.010) - 0.16 * np.exp(-d / 0.045), np.float32)


def bed(layout: Layout, nap: Floats) -> Floats:
    """Return the light (width, height) on `layout.bed`: 1 gives the cloth its own colour.

    nap: its `texture`.
    """
    box = layout.bed
    x, y = axes(layout, *box)
    light = 0.60 + 0.49 * lamp(x, y, layout)
    light *= (shade(layout.length / 2 - np.abs(x)))[:, None]
    light *= shade(layout.width / 2 - y) * (0.22 + 0.78 * shade(y + layout.width / 2))
    light *= 1 + nap
    return np.asarray(light, np.float32)


def texture(layout: Layout, width: int, height: int) -> Floats:
    """Return the relative light and dark of the nap, some percent; sized by the window's scale."""
    s = layout.s
    fine = noise.nap(256, (1.6 * s, 0.55 * s), 3) + 0.6 * noise.nap(256, (0.45 * s, 0.45 * s), 5)
    total = noise.tiled(np.float32(0.0135) * fine, width, height)
    # the wide changes are even over two px: half the size, each value four times
    half = (width // 2 + 1, height // 2 + 1)
    wide = noise.smooth(*half, (32 * s, 13 * s), 7)
    wide += np.float32(0.6) * noise.smooth(*half, (9.5 * s, 5.5 * s), 9)
    wide *= np.float32(0.006)
    return np.asarray(total + wide.repeat(2, 0).repeat(2, 1)[:width, :height], np.float32)


def cushion(layout: Layout, count: int, away: Floats, side: float, seed: int) -> Floats:
    """Return the light (count, len(away)) of a cushion at `away` px from its nose line.

    `side` is how much light falls on this one: a dark nose, a lit shoulder, a fall to the wood.
    """
    u = away / np.float32(CUSHION * layout.scale)
    shoulder = 0.27 * np.exp(-(((u - 0.17) / 0.10) ** 2))
    fall = 0.86 - 0.20 * u.clip(0, 1)
    nose = 0.34 * np.exp(-((u.clip(0, None) / 0.07) ** 2))
    crease = 0.34 * np.exp(-(((u - 1.0) / 0.06) ** 2))
    profile = (fall + shoulder - nose - crease).astype(np.float32) * side
    s = layout.s
    grain = noise.smooth(count, len(away), (7 * s, 1.4 * s), seed) * 0.012
    return np.asarray(profile[None] * (1 + grain), np.float32)
