"""Lines on the cloth: paths, dashes, arrows, rings, dots and ticks with smooth edges.

All points are screen points and all widths px of the window, so callers multiply by `Layout.s`.
Surfaces must be opaque (a window or a copy of the background); the surface's clip is respected.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin

import numpy as np
import pygame

from game.render import raster
from game.render.arrays import Floats, Points
from game.render.theme import HALO, Colour

HALO_ALPHA = 0.38
SHORT = 48
"""Pixels up to which a straight line is drawn by looking at its whole square."""
SHARES = (1 / 32, 1 / 32, 1 / 16, 1 / 8, 1 / 4, 1 / 2)
"""What each round of `decimated` may spend: dropping every second point costs four times more."""


def decimated(points: Points, tolerance: float = 0.25) -> list[tuple[float, float]]:
    """Return the points of a path that matter: dropping the others moves it less than `tolerance`.

    Every second point goes if it is near the line between its neighbours, again and again; each
    round may move the path by its share of the tolerance.  In px 0.25 cannot be seen.
    """
    path = np.asarray(points, np.float64).reshape(-1, 2)
    for share in SHARES:
        odd = path[1:-1:2]
        away = _distances(odd, path[:-2:2], path[2::2])
        keep = np.ones(len(path), bool)
        keep[1:-1:2] = away > tolerance * share
        path = path[keep]
    return [(x, y) for x, y in path.tolist()]


def _distances(points: Floats, first: Floats, last: Floats) -> Floats:
    """Return the distance of each point from its own segment first-last."""
    step = last - first
    square = np.maximum((step * step).sum(axis=1), 1e-12)
    share = (((points - first) * step).sum(axis=1) / square).clip(0, 1)
    gap = points - first - share[:, None] * step
    return np.asarray(np.hypot(gap[:, 0], gap[:, 1]), np.float64)


def length(points: Points) -> float:
    """Return the length of a path, px."""
    return sum(hypot(q[0] - p[0], q[1] - p[1]) for p, q in pairwise(points))


def polyline(
    surface: pygame.Surface,
    points: Points,
    colour: Colour,
    width: float,
    alpha: float = 1.0,
    fade: tuple[float, float] | None = None,
    dashes: Sequence[float] = (),
    soft: float = 0.5,
) -> pygame.Rect:
    """Draw a path `width` px wide with round joins and ends.

    `fade` multiplies alpha: from its first value at the beginning to its second at the end.
    `dashes` are px on, off, ...; `soft` is half the width of the edge in px (more for shadows).
    """
    if len(points) < 2:
        return pygame.Rect(0, 0, 0, 0)
    if len(points) == 2 and not fade and not dashes and 1e-6 < length(points) < SHORT:
        return _short(surface, points, colour, width, alpha, soft)
    reach, clip = width / 2 + soft, surface.get_clip()
    if len(points) == 2 and points[0] != points[1]:
        near: raster.Touched | raster.Beside = raster.beside(points[0], points[1], reach, clip)
    else:
        near = raster.touched(points, reach, clip)
    cover = ((reach - near.away) / (2 * soft)).clip(0, min(1.0, width)) * alpha
    if fade:
        cover *= fade[0] + (fade[1] - fade[0]) * near.along / max(length(points), 1e-6)
    if dashes:
        cover *= _dashed(near.along, dashes)
    return raster.blend(surface, near.x, near.y, cover.astype(np.float32), colour)


def _short(
    surface: pygame.Surface, points: Points, colour: Colour, width: float, alpha: float, soft: float
) -> pygame.Rect:
    """Draw one short segment: all pixels of its square cost less than finding those near it."""
    (x0, y0), (x1, y1) = points
    reach, (x, y) = width / 2 + soft, ((x0 + x1) / 2, (y0 + y1) / 2)
    ahead, half = ((x1 - x0) / 2, (y1 - y0) / 2), length(points) / 2
    square, dx, dy = _around(surface, x, y, half + reach)
    share = ((dx * ahead[0] + dy * ahead[1]) / np.float32(max(half * half, 1e-9))).clip(-1, 1)
    away = np.hypot(dx - share * np.float32(ahead[0]), dy - share * np.float32(ahead[1]))
    cover = ((reach - away) / (2 * soft)).clip(0, min(1.0, width)) * alpha
    return _painted(surface, square, cover, colour)


def _dashed(along: Floats, dashes: Sequence[float]) -> Floats:
    """Return 1 on a dash and 0 between, with edges one px wide."""
    phase = along % sum(dashes)
    cover, start = np.zeros_like(along), 0.0
    for on, off in zip(dashes[::2], dashes[1::2], strict=True):
        cover += (phase - start + 0.5).clip(0, 1) * (start + on - phase + 0.5).clip(0, 1)
        start += on + off
    return cover


def trace(
    surface: pygame.Surface,
    points: Points,
    colour: Colour,
    s: float,
    alpha: float = 0.88,
    dashes: Sequence[float] = (),
) -> pygame.Rect:
    """Draw the path a ball has run, on the dark halo without which ball colours drown in cloth.

    `dashes` are px at s = 1.
    """
    if len(points) < 2:
        return pygame.Rect(0, 0, 0, 0)
    near = raster.touched(points, 2.6 * s, surface.get_clip())
    halo = ((2.6 * s - near.away) / (1.6 * s)).clip(0, 1) * np.float32(HALO_ALPHA)
    dirty = raster.blend(surface, near.x, near.y, halo, HALO)
    cover = (0.9 * s + 0.5 - near.away).clip(0, 1) * np.float32(alpha)
    if dashes:
        cover *= _dashed(near.along, [d * s for d in dashes])
    some = cover > 0
    raster.blend(surface, near.x[some], near.y[some], cover[some], colour)
    return dirty


def _around(
    surface: pygame.Surface, x: float, y: float, reach: float
) -> tuple[pygame.Rect, Floats, Floats]:
    """Return a square of pixels around (x, y) and its columns' and rows' offsets from the point."""
    edge = int(reach + 2)
    square = pygame.Rect(int(x) - edge, int(y) - edge, 2 * edge + 1, 2 * edge + 1)
    square = square.clip(surface.get_clip())
    dx = np.arange(square.x, square.right, dtype=np.float32)[:, None] + np.float32(0.5 - x)
    dy = np.arange(square.y, square.bottom, dtype=np.float32)[None] + np.float32(0.5 - y)
    return square, dx, dy


def _painted(
    surface: pygame.Surface, square: pygame.Rect, cover: Floats, colour: Colour
) -> pygame.Rect:
    if square.size != (0, 0) and cover.size:
        pixels = pygame.surfarray.pixels3d(surface)
        patch = pixels[square.x : square.right, square.y : square.bottom]
        old = patch.astype(np.float32)
        patch[:] = old + (np.array(colour, np.float32) - old) * cover[..., None] + np.float32(0.5)
    return square


def ring(
    surface: pygame.Surface,
    centre: tuple[float, float],
    radius: float,
    colour: Colour,
    width: float = 1.4,
    alpha: float = 0.95,
    fill: float = 0.0,
) -> pygame.Rect:
    """Draw a circle whose line is centred on `radius`; `fill` is the alpha inside it."""
    square, dx, dy = _around(surface, *centre, radius + width)
    away = np.hypot(dx, dy)
    line = (width / 2 + 0.5 - np.abs(away - radius)).clip(0, 1) * alpha
    inside = (radius + 0.5 - away).clip(0, 1) * fill
    return _painted(surface, square, np.maximum(line, inside), colour)


def dot(
    surface: pygame.Surface,
    centre: tuple[float, float],
    radius: float,
    colour: Colour,
    alpha: float = 1.0,
) -> pygame.Rect:
    """Draw a disc."""
    square, dx, dy = _around(surface, *centre, radius)
    return _painted(surface, square, (radius + 0.5 - np.hypot(dx, dy)).clip(0, 1) * alpha, colour)


def ghost(
    surface: pygame.Surface, centre: tuple[float, float], radius: float, s: float
) -> pygame.Rect:
    """Draw the cue ball where it will be at the first contact."""
    return ring(surface, centre, radius, (255, 255, 255), 1.4 * s, 0.95, 0.16)


def polygon(
    surface: pygame.Surface, points: Points, colour: Colour, alpha: float = 1.0
) -> pygame.Rect:
    """Draw a convex polygon with smooth edges."""
    corners = np.asarray(points, np.float64)
    x, y = corners[:, 0], corners[:, 1]
    ahead = np.roll(corners, -1, axis=0) - corners
    turn = 1 if float(x @ np.roll(y, -1) - y @ np.roll(x, -1)) > 0 else -1
    middle = (float(x.min() + x.max()) / 2, float(y.min() + y.max()) / 2)
    reach = max(float(np.ptp(x)), float(np.ptp(y))) / 2
    square, dx, dy = _around(surface, *middle, reach)
    cover = np.full((dx.size, dy.size), alpha, np.float32)
    for corner, step in zip(corners, ahead, strict=True):
        across = (dx + middle[0] - corner[0]) * step[1] - (dy + middle[1] - corner[1]) * step[0]
        cover = np.minimum(
            cover, alpha * (0.5 - turn * across / max(hypot(*step), 1e-9)).clip(0, 1)
        )
    return _painted(surface, square, cover, colour)


def arrow(
    surface: pygame.Surface,
    start: tuple[float, float],
    end: tuple[float, float],
    colour: Colour,
    width: float,
    head: float,
    alpha: float = 1.0,
) -> pygame.Rect:
    """Draw an arrow whose point lies at `end`; `head` is the length of its head."""
    angle = atan2(end[1] - start[1], end[0] - start[0])
    c, s = cos(angle), sin(angle)
    base = (end[0] - head * c, end[1] - head * s)
    half = 0.52 * head
    wings = [(base[0] + k * half * s, base[1] - k * half * c) for k in (1, -1)]
    rect = polyline(surface, [start, base], colour, width, alpha)
    return rect.union(polygon(surface, [end, *wings], colour, alpha))


def departure(
    surface: pygame.Surface,
    centre: tuple[float, float],
    angle: float,
    radius: float,
    colour: Colour,
    s: float,
) -> pygame.Rect:
    """Draw the arrow of a ball leaving `centre`; `angle` is on screen, radians."""
    reach = 3.4 * radius
    ahead = (cos(angle), sin(angle))
    start = (centre[0] + ahead[0] * radius * 1.1, centre[1] + ahead[1] * radius * 1.1)
    end = (centre[0] + ahead[0] * reach, centre[1] + ahead[1] * reach)
    return arrow(surface, start, end, colour, 2.2 * s, 0.68 * radius)


def bounce(
    surface: pygame.Surface,
    centre: tuple[float, float],
    outward: tuple[float, float],
    radius: float,
    colour: Colour,
    s: float,
    alpha: float = 1.0,
) -> pygame.Rect:
    """Mark a cushion contact: a dot on the ball's centre and a tick on the nose.

    `outward` is the unit vector on screen from the bed into the cushion.
    """
    rect = dot(surface, centre, 2.6 * s, colour, alpha)
    nose = (centre[0] + outward[0] * radius, centre[1] + outward[1] * radius)
    half = 0.55 * radius
    ends = [(nose[0] + k * half * outward[1], nose[1] - k * half * outward[0]) for k in (1, -1)]
    return rect.union(polyline(surface, ends, colour, 2 * s, alpha))


def collision(
    surface: pygame.Surface, point: tuple[float, float], s: float, alpha: float = 1.0
) -> pygame.Rect:
    """Mark where two balls touched."""
    rect = dot(surface, point, 3.6 * s, HALO, 0.85 * alpha)
    return rect.union(dot(surface, point, 2.7 * s, (255, 255, 255), alpha))


def turned(angle: float) -> float:
    """Return the screen angle of a table angle (radians, y up): the screen's y points down."""
    return -angle % (2 * pi)
