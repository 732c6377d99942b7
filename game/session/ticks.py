"""Game time in ticks of 2^-16 s: they add up exactly, so the frame rate leaves no trace."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

TICKS = 1 << 16
"""Ticks in a second."""


def seconds(ticks: int) -> float:
    """Return ticks in seconds; exact."""
    return ticks / TICKS


def shares(ticks: int, parts: int) -> Iterator[int]:
    """Split `ticks` into at most `parts` whole numbers above zero that differ by one at most."""
    edges = [ticks * i // parts for i in range(parts + 1)]
    return (b - a for a, b in pairwise(edges) if b > a)
