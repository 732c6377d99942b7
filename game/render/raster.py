"""The pixels near a stroke and how far they are from it: the one rasteriser behind every line.

A stroke visits, for each column (or row, where it is steep) it crosses, only the few pixels beside
it, so the cost grows with its length and not with its bounding box.  Distances are exact, hence
edges and round joins are smooth at any width.
"""

from __future__ import annotations

from math import ceil, floor, hypot
from sys import byteorder
from typing import NamedTuple

import numpy as np
import pygame

from .arrays import Floats, Indices, Points
from .theme import Colour


class Touched(NamedTuple):
    """Pixels beside a stroke, one entry a pixel and segment: all are 1-D and of equal length.

    x, y   of the pixel
    away   distance from the stroke's middle line, px
    along  distance from the stroke's beginning, px
    """

    x: Indices
    y: Indices
    away: Floats
    along: Floats


def touched(points: Points, reach: float, clip: pygame.Rect) -> Touched:
    """Return the pixels within `reach` px of the polyline `points` and inside `clip`.

    Each column a segment crosses is given a short run of pixels around its middle line; a segment
    steeper than 45 degrees has x and y exchanged on the way in and out.
    """
    path = np.asarray(points, np.float32).reshape(-1, 2)
    step = path[1:] - path[:-1]
    length = np.hypot(step[:, 0], step[:, 1])
    start = np.cumsum(length, dtype=np.float32) - length
    some = length > 1e-6
    path, step, length, start = path[:-1][some], step[some], length[some], start[some]
    steep = np.abs(step[:, 1]) > np.abs(step[:, 0])
    path[steep], step[steep] = path[steep, ::-1], step[steep, ::-1]
    edges = np.where(steep, clip.y, clip.x), np.where(steep, clip.bottom, clip.right)
    name, u = _columns(path[:, 0], step[:, 0], reach, edges)
    sides = np.where(steep, clip.x, clip.y), np.where(steep, clip.right, clip.bottom)
    own = np.column_stack((step / length[:, None], path, length, start, *sides, steep))
    # what each column needs to know of its segment, looked up in one go
    own = own.astype(np.float32).take(name, 0)
    dx, dy, x, y, size, first, least, most, turned = own.T[..., None]
    half = ceil(reach * 1.4143)
    du = u[:, None].astype(np.float32) + (np.float32(0.5) - x)
    v = np.floor(y + du * (dy / dx)) + np.arange(-half, half + 1, dtype=np.float32)
    dv = v + (np.float32(0.5) - y)
    line = du * dx + dv * dy
    along = np.minimum(np.maximum(line, 0), size)
    square = (du * dy - dv * dx) ** 2 + (line - along) ** 2
    spot = np.flatnonzero((square <= reach * reach) & (v >= least) & (v < most))
    row, away = spot // (2 * half + 1), np.sqrt(square.reshape(-1).take(spot))
    u, v = u.take(row), v.reshape(-1).take(spot).astype(np.intp)
    along, flip = (along + first).reshape(-1).take(spot), turned.reshape(-1).take(row) > 0
    return Touched(np.where(flip, v, u), np.where(flip, u, v), away, along)


def _columns(
    begin: Floats, step: Floats, reach: float, edges: tuple[Indices, Indices]
) -> tuple[Indices, Indices]:
    """Return segment and column of every column that segments come within `reach` of."""
    end = begin + step
    first = np.floor(np.minimum(begin, end) - reach).astype(np.intp).clip(*edges)
    last = np.ceil(np.maximum(begin, end) + reach).astype(np.intp).clip(*edges)
    count = last - first
    name = np.repeat(np.arange(len(begin)), count)
    return name, np.arange(len(name)) + (first - np.cumsum(count) + count)[name]


class Beside(NamedTuple):
    """Pixels beside one straight stroke, each once: all are 1-D and of equal length.

    x, y    of the pixel
    away    distance from the stroke, px: its ends are round
    along   distance from the stroke's beginning to the nearest point of the stroke, px
    across  distance from the endless line, px; positive on the side that is clockwise on screen
    """

    x: Indices
    y: Indices
    away: Floats
    along: Floats
    across: Floats


def beside(
    start: tuple[float, float], end: tuple[float, float], reach: float, clip: pygame.Rect
) -> Beside:
    """Return the pixels inside `clip` and within `reach` px of a straight stroke.

    What `touched` does for many segments, for one: a third of the time.
    """
    (x, y), (dx, dy) = start, (end[0] - start[0], end[1] - start[1])
    size, steep = max(hypot(dx, dy), 1e-6), abs(dy) > abs(dx)
    x, y, dx, dy = (y, x, dy / size, dx / size) if steep else (x, y, dx / size, dy / size)
    sides = (clip.y, clip.bottom, clip.x, clip.right)
    low, high, least, most = sides if steep else (*sides[2:], *sides[:2])
    far = sorted((x, x + dx * size))
    first, last = max(floor(far[0] - reach), low), min(ceil(far[1] + reach), high)
    u = np.arange(first, max(first, last))
    du = u.astype(np.float32) + np.float32(0.5 - x)
    half = ceil(reach / max(abs(dx), 0.5) + 0.5)
    row = np.floor(du * np.float32(dy / dx if dx else 0.0) + np.float32(y))
    v = row[:, None] + np.arange(-half, half + 1, dtype=np.float32)
    dv = v + np.float32(0.5 - y)
    across = dv * np.float32(dx) - (du * np.float32(dy))[:, None]
    spot = np.flatnonzero((np.abs(across) <= reach) & (v >= least) & (v < most))
    u, v = u[spot // (2 * half + 1)], v.reshape(-1)[spot].astype(np.intp)
    across = across.reshape(-1)[spot]
    line = (dv * np.float32(dy) + (du * np.float32(dx))[:, None]).reshape(-1)[spot]
    along = line.clip(0, size)
    away = np.sqrt(across * across + (line - along) ** 2)
    return Beside(v, u, away, along, -across) if steep else Beside(u, v, away, along, across)


BOARDS = 4
"""Sizes kept at once: a window, a fan, and those of a window just resized."""
_peaks: dict[int, Floats] = {}


def peak(spot: Indices, alpha: Floats, size: int) -> Floats:
    """Return for each entry the largest `alpha` of all entries at the same `spot` (0 to size - 1).

    Segments that share a pixel at a joint then do not paint it twice.
    """
    if size not in _peaks:
        if len(_peaks) >= BOARDS:
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
    once: bool = False,
) -> pygame.Rect:
    """Move the pixels (x, y) of an opaque surface of 32 bits towards `colour` by `alpha` (0 to 1).

    `colour` is one colour or an array (n, 3), 0 to 255.  Where a pixel is listed twice the larger
    alpha counts; `once` says that none is.  Returns the rectangle around the pixels.
    """
    if not len(x):
        return pygame.Rect(0, 0, 0, 0)
    width, height = surface.get_size()
    if not once:
        alpha = peak(x * height + y, alpha, width * height)
    pixels = pygame.surfarray.pixels2d(surface)  # a pixel as one number: a fifth of the time
    old = pixels[x, y]
    channels = old.view(np.uint8).reshape(-1, 4)
    for place, wanted in zip(_places(surface), np.asarray(colour, np.float32).T, strict=True):
        was = channels[:, place].astype(np.float32)
        channels[:, place] = was + (wanted - was) * alpha + np.float32(0.5)
    pixels[x, y] = old
    left, top = int(x.min()), int(y.min())
    return pygame.Rect(left, top, int(x.max()) - left + 1, int(y.max()) - top + 1)


def _places(surface: pygame.Surface) -> list[int]:
    """Return which bytes of a pixel are red, green and blue."""
    shifts = (shift // 8 for shift in surface.get_shifts()[:3])
    return [shift if byteorder == "little" else 3 - shift for shift in shifts]
