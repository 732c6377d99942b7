"""Noise that is the same everywhere: from integer hashes, so no generator has to be imported."""

from __future__ import annotations

import numpy as np

from .arrays import Floats


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

    Two matrix products: a full rail or bed costs about a millisecond.
    """
    across, down = _weights(width, cell[0]), _weights(height, cell[1])
    grid = white(across.shape[1], down.shape[1], seed)
    return np.asarray(across @ grid @ down.T * np.float32(1.3), np.float32)


def _weights(count: int, cell: float) -> Floats:
    """Return (count, knots): how much each pixel takes of each knot, quadratic B-splines."""
    place = (np.arange(count, dtype=np.float32) + 0.5) / np.float32(cell) + 1.0
    knots = int(place[-1]) + 3
    away = np.abs(place[:, None] - np.arange(knots, dtype=np.float32)[None] - 0.5)
    inner = 0.75 - away * away
    outer = 0.5 * (1.5 - away).clip(0, None) ** 2
    return np.where(away < 0.5, inner, outer).astype(np.float32)


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
