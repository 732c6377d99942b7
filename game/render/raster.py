"""The pixels near a stroke and how far they are from it: the one rasteriser behind every line.

A stroke visits, for each column (or row, where it is steep) it crosses, only the few pixels beside
it, so the cost grows with its length and not with its bounding box.  Distances are exact, hence
edges and round joins are smooth at any width.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

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
    path = np.asarray(points, np.float32).reshape(-1, 2)
    step = path[1:] - path[:-1]
    length = np.hypot(step[:, 0], step[:, 1])
    start = np.cumsum(length, dtype=np.float32) - length
    long = length > 1e-6
    flat = np.abs(step[:, 0]) >= np.abs(step[:, 1])
    columns, rows = (clip.x, clip.right), (clip.y, clip.bottom)
    x, y, away, along = _beside(path, step, length, start, flat & long, reach, columns, rows)
    v, u, *rest = _beside(
        path[:, ::-1], step[:, ::-1], length, start, ~flat & long, reach, rows, columns
    )
    return Touched(
        np.concatenate((x, u)),
        np.concatenate((y, v)),
        np.concatenate((away, rest[0])),
        np.concatenate((along, rest[1])),
    )


def _beside(
    path: Floats,
    step: Floats,
    length: Floats,
    start: Floats,
    chosen: NDArray[np.bool_],
    reach: float,
    across: tuple[int, int],
    down: tuple[int, int],
) -> Touched:
    """Return the same for the `chosen` segments, none steeper than 45 degrees.

    Each column a segment crosses is given a short run of pixels around its middle line.
    """
    names = np.flatnonzero(chosen)
    ends = path[names, 0], path[names, 0] + step[names, 0]
    first = np.floor(np.minimum(*ends) - reach).clip(*across).astype(np.intp)
    last = np.ceil(np.maximum(*ends) + reach).clip(*across).astype(np.intp)
    count = np.maximum(last - first, 0)
    name = np.repeat(names, count)
    x = np.arange(count.sum()) + np.repeat(first - np.cumsum(count) + count, count)
    ux, uy = (step[name, axis] / length[name] for axis in (0, 1))
    dx = (x + np.float32(0.5) - path[name, 0]).astype(np.float32)
    middle = path[name, 1] + dx * uy / ux
    half = int(np.ceil(reach * 1.4143))
    y = np.floor(middle).astype(np.intp)[:, None] + np.arange(-half, half + 1)
    dy = (y + np.float32(0.5) - path[name, 1][:, None]).astype(np.float32)
    along = (dx * ux)[:, None] + dy * uy[:, None]
    beyond = along - along.clip(0, length[name][:, None])
    away = np.hypot(dx[:, None] * uy[:, None] - dy * ux[:, None], beyond)
    along += start[name][:, None] - beyond
    near = (away <= reach) & (y >= down[0]) & (y < down[1])
    return Touched(np.repeat(x, near.sum(axis=1)), y[near], away[near], along[near])


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
