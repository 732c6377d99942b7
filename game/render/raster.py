"""The pixels near a stroke and how far they are from it: the one rasteriser behind every line.

A stroke visits, for each column (or row, where it is steep) it crosses, only the few pixels beside
it, so the cost grows with its length and not with its bounding box.  Distances are exact, hence
edges and round joins are smooth at any width.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pygame

from .arrays import Floats, Indices, Points
from .theme import Colour


class Touched(NamedTuple):
    """Pixels beside a stroke, one entry a pixel and segment: all are 1-D and of equal length."""

    x: Indices
    y: Indices
    away: Floats
    """Distance from the stroke's middle line, px."""
    along: Floats
    """Distance from the stroke's beginning, px."""


def touched(points: Points, reach: float, clip: pygame.Rect) -> Touched:
    """Return the pixels within `reach` px of the polyline `points` and inside `clip`."""
    path = np.asarray(points, np.float64).reshape(-1, 2)
    step = np.diff(path, axis=0)
    length = np.hypot(step[:, 0], step[:, 1])
    start = np.concatenate(([0.0], np.cumsum(length)[:-1]))
    keep = length > 1e-9
    path, step, length, start = path[:-1][keep], step[keep], length[keep], start[keep]
    flat = np.abs(step[:, 0]) >= np.abs(step[:, 1])
    x, y, segment = (
        np.concatenate(pair)
        for pair in zip(
            _beside(path[flat], step[flat], np.flatnonzero(flat), reach, (clip.x, clip.right)),
            _transposed(
                path[~flat], step[~flat], np.flatnonzero(~flat), reach, (clip.y, clip.bottom)
            ),
            strict=True,
        )
    )
    inside = (x >= clip.x) & (x < clip.right) & (y >= clip.y) & (y < clip.bottom)
    x, y, segment = x[inside], y[inside], segment[inside]
    unit = (step / length[:, None])[segment]
    dx, dy = x + 0.5 - path[segment, 0], y + 0.5 - path[segment, 1]
    along = np.clip(dx * unit[:, 0] + dy * unit[:, 1], 0, length[segment])
    away = np.hypot(dx - along * unit[:, 0], dy - along * unit[:, 1])
    near = away <= reach
    total = (along + start[segment])[near].astype(np.float32)
    return Touched(x[near], y[near], away[near].astype(np.float32), total)


def _beside(
    path: Floats,
    step: Floats,
    names: Indices,
    reach: float,
    limits: tuple[int, int],
) -> tuple[Indices, Indices, Indices]:
    """Return x, y and segment of the pixels around segments no steeper than 45 degrees."""
    if not len(path):
        none = np.zeros(0, np.intp)
        return none, none, none
    ends = path[:, 0] + step[:, 0]
    first = np.floor(np.minimum(path[:, 0], ends) - reach).clip(*limits).astype(np.intp)
    last = np.ceil(np.maximum(path[:, 0], ends) + reach).clip(*limits).astype(np.intp)
    count = np.maximum(last - first, 0)
    which = np.repeat(np.arange(len(path)), count)
    x = np.arange(count.sum()) - np.repeat(np.cumsum(count) - count, count) + first[which]
    slope = (step[:, 1] / step[:, 0])[which]
    middle = path[which, 1] + (x + 0.5 - path[which, 0]) * slope
    half = int(np.ceil(reach * 1.4143)) + 1
    y = np.floor(middle).astype(np.intp)[:, None] + np.arange(-half, half + 1)
    wide = y.shape[1]
    return np.repeat(x, wide), y.ravel(), np.repeat(names[which], wide)


def _transposed(
    path: Floats,
    step: Floats,
    names: Indices,
    reach: float,
    limits: tuple[int, int],
) -> tuple[Indices, Indices, Indices]:
    """Return the same for segments steeper than 45 degrees."""
    y, x, segment = _beside(path[:, ::-1], step[:, ::-1], names, reach, limits)
    return x, y, segment


_peaks: dict[int, Floats] = {}


def peak(spot: Indices, alpha: Floats, size: int) -> Floats:
    """Return for each entry the largest `alpha` of all entries at the same `spot` (0 to size - 1).

    Segments that share a pixel at a joint then do not paint it twice.
    """
    if size not in _peaks:
        _peaks.clear()
        _peaks[size] = np.zeros(size, np.float32)
    board = _peaks[size]
    np.maximum.at(board, spot, alpha)
    highest = board[spot]
    board[spot] = 0
    return highest


def blend(
    surface: pygame.Surface,
    x: Indices,
    y: Indices,
    alpha: Floats,
    colour: Colour | Floats,
) -> pygame.Rect:
    """Move the pixels (x, y) of an opaque surface towards `colour` by `alpha` (0 to 1).

    `colour` is one colour or an array (n, 3), 0 to 255.  Where a pixel is listed twice the larger
    alpha counts.  Returns the rectangle around the pixels.
    """
    if not len(x):
        return pygame.Rect(0, 0, 0, 0)
    width, height = surface.get_size()
    alpha = peak(x * height + y, alpha, width * height)[:, None]
    pixels = pygame.surfarray.pixels3d(surface)
    old = pixels[x, y].astype(np.float32)
    pixels[x, y] = old + (np.asarray(colour, np.float32) - old) * alpha + 0.5
    left, top = int(x.min()), int(y.min())
    return pygame.Rect(left, top, int(x.max()) - left + 1, int(y.max()) - top + 1)
