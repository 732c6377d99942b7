"""The wooden rails: grain along each board, a satin bevel, diamonds of pearl."""

from __future__ import annotations

import numpy as np

from game.render import noise
from game.render.arrays import Floats
from game.render.layout import CUSHION, Layout
from game.render.layout import WOOD as WOOD_WIDTH
from game.render.theme import DIAMOND, DIAMOND_EDGE, DIAMOND_SHADE, WOOD

CORNER = 0.050
"""Outer radius of the table's corners, m."""


def grain(layout: Layout, count: int, depth: int, seed: int) -> Floats:
    """Return the relative light and dark (count, depth) of wood whose fibres run along `count`.

    Growth rings are even in a coordinate that wanders along the board; pores are short dark lines.
    """
    s = layout.s
    wander = noise.smooth(count, depth, (150 * s, 13 * s), seed) * 1.5
    wander += noise.smooth(count, depth, (46 * s, 7 * s), seed + 1) * 0.45
    across = np.arange(depth, dtype=np.float32)[None] / np.float32(4.6 * s)
    rings = np.sin(across * 2.1 + wander * 2.0) + 0.5 * np.sin(across * 4.7 + wander * 3.1 + 1.3)
    fibres = noise.smooth(count, depth, (26 * s, 1.1 * s), seed + 2)
    broad = noise.smooth(count, depth, (90 * s, 3.5 * s), seed + 3)
    pores = noise.smooth(count, depth, (9 * s, 0.8 * s), seed + 4).clip(1.1, None) - 1.1
    total = 0.040 * rings + 0.048 * fibres + 0.045 * broad - 0.12 * pores
    return np.asarray(total, np.float32)


def satin(v: Floats) -> Floats:
    """Return the light of the rail's section at `v`: 0 at the cushion, 1 at the outer edge."""
    crown = 0.90 + 0.20 * np.exp(-(((v - 0.40) / 0.34) ** 2))
    inner = -0.45 * np.exp(-((v / 0.04) ** 2)) + 0.12 * np.exp(-(((v - 0.09) / 0.03) ** 2))
    bevel = 0.22 * np.exp(-(((v - 0.90) / 0.030) ** 2))
    outer = -0.50 * ((v - 0.93) / 0.07).clip(0, 1)
    return np.asarray(crown + inner + bevel + outer, np.float32)


def board(layout: Layout, count: int, away: Floats, seed: int) -> Floats:
    """Return a board (count, len(away), 3), 0 to 255, at `away` px from the cushion's back.

    Lit parts are warmer than shaded ones, as varnish is.
    """
    v = (away / np.float32(WOOD_WIDTH * layout.scale)).clip(0, 1)
    relief = satin(v)[None] * (1 + grain(layout, count, len(away), seed))
    warm = np.log(np.array((1.01, 0.985, 0.955), np.float32))
    return np.asarray(
        relief[..., None] * np.array(WOOD, np.float32) * np.exp(warm * (relief[..., None] * 2 - 1)),
        np.float32,
    )


def diamond_places(layout: Layout, *, pockets: bool = False) -> list[tuple[float, float, bool]]:
    """Return the diamonds' centres (m) and whether each lies on a long rail.

    With pockets there is none at the middle of a long rail.
    """
    middle = CUSHION + WOOD_WIDTH / 2
    x, y = layout.length / 2 + middle, layout.width / 2 + middle
    long = [(i * layout.length / 8, side * y, True) for i in _eighths(pockets) for side in (-1, 1)]
    short = [(side * x, i * layout.width / 4, False) for i in (-1, 0, 1) for side in (-1, 1)]
    return long + short


def _eighths(pockets: bool) -> list[int]:
    return [i for i in range(-3, 4) if i or not pockets]


def inlay(
    picture: Floats, layout: Layout, left: int, top: int, *, pockets: bool = False
) -> None:
    """Lay the diamonds into `picture` (width, height, 3), whose corner is the pixel (left, top)."""
    for x, y, long in diamond_places(layout, pockets=pockets):
        px, py = layout.to_screen(x, y)
        half = (0.0090 * layout.scale, 0.0145 * layout.scale)
        _diamond(picture, px - left, py - top, half if long else half[::-1], layout.s)


def _diamond(picture: Floats, x: float, y: float, half: tuple[float, float], s: float) -> None:
    """Blend one diamond: dark edge, light half, shaded half."""
    reach = int(max(half) + 3 * s + 2)
    i, j = int(x) - reach, int(y) - reach
    patch = picture[max(i, 0) : i + 2 * reach, max(j, 0) : j + 2 * reach]
    dx = (np.arange(patch.shape[0]) + max(i, 0) + 0.5 - x)[:, None]
    dy = (np.arange(patch.shape[1]) + max(j, 0) + 0.5 - y)[None]
    slant = float(np.hypot(1 / half[0], 1 / half[1]))
    away = (np.abs(dx) / half[0] + np.abs(dy) / half[1] - 1) / slant
    edge = (0.5 + 0.9 * s - away).clip(0, 1)[..., None] * 0.55
    inside = (0.5 - away).clip(0, 1)[..., None]
    lit = (0.5 - (dx / half[0] + dy / half[1]) * max(half) * 0.5).clip(0, 1)[..., None]
    pearl = np.array(DIAMOND_SHADE) + lit * (np.array(DIAMOND) - np.array(DIAMOND_SHADE))
    patch += (np.array(DIAMOND_EDGE) - patch) * edge
    patch += (pearl - patch) * inside
