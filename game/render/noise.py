"""Noise that is the same everywhere: from integer hashes, so no generator has to be imported."""

from __future__ import annotations

import numpy as np

from .arrays import Floats, Indices


def white(width: int, height: int, seed: int) -> Floats:
    """Return (width, height) independent values of mean 0 and variance 1, about normal."""
    n = np.arange(width * height, dtype=np.uint32) + np.uint32((seed * 0x9E3779B1) & 0xFFFFFFFF)
    total = np.zeros(n.shape, np.float32)
    for _ in range(2):
        n = (n ^ (n >> np.uint32(16))) * np.uint32(0x7FEB352D)
        n = (n ^ (n >> np.uint32(15))) * np.uint32(0x846CA68B)
        n ^= n >> np.uint32(16)
        total += (n & np.uint32(0xFFFF)).astype(np.float32) + (n >> np.uint32(16))
    return ((total - 131070.0) / 37837.0).reshape(width, height)


def smooth(width: int, height: int, cell: tuple[float, float], seed: int) -> Floats:
    """Return (width, height) px of noise that changes over `cell` px; interpolated from a grid.

    Rows are gathered and not multiplied as matrices: a threaded product stalls on a busy machine.
    """
    across, down = _knots(width, cell[0]), _knots(height, cell[1])
    grid = white(int(across[0][-1]) + 3, int(down[0][-1]) + 3, seed) * np.float32(1.3)
    return _spread(_spread(grid.T, *down).T, *across)


def _knots(count: int, cell: float) -> tuple[Indices, Floats]:
    """Return each pixel's first knot and its shares of three (3, count): quadratic B-splines."""
    place = (np.arange(count, dtype=np.float32) + np.float32(0.5)) / np.float32(cell)
    first = place.astype(np.intp)
    t = place - first
    return first, np.stack((0.5 * (1 - t) ** 2, 0.5 + t - t * t, 0.5 * t * t))


def _spread(grid: Floats, first: Indices, shares: Floats) -> Floats:
    """Return the rows of `grid` interpolated at the pixels `first` and `shares` stand for."""
    total = grid[first] * shares[0][:, None]
    for k in (1, 2):
        total += grid[first + k] * shares[k][:, None]
    return np.asarray(total, np.float32)


def nap(size: int, sigma: tuple[float, float], seed: int) -> Floats:
    """Return a periodic (size, size) tile of noise blurred by a Gaussian, variance 1."""
    tile = white(size, size, seed)
    for axis, width in enumerate(sigma):
        reach = max(1, round(3 * width))
        weights = [np.float32(np.exp(-0.5 * (k / width) ** 2)) for k in range(reach + 1)]
        total = tile * weights[0]
        for k in range(1, reach + 1):
            total += weights[k] * (np.roll(tile, k, axis) + np.roll(tile, -k, axis))
        tile = total
    return np.asarray(tile / tile.std(), np.float32)


def tiled(tile: Floats, width: int, height: int) -> Floats:
    """Return `tile` repeated over (width, height)."""
    repeat = (-(-width // tile.shape[0]), -(-height // tile.shape[1]))
    return np.tile(tile, repeat)[:width, :height]
