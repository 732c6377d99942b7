"""Actions: five numbers from -1 to 1, and the strokes they mean."""

from __future__ import annotations

from typing import Any

import numpy as np

from danggu.players.levels import MISCUE

from .noise import Aims

SIZE = 5
BALL, ABSOLUTE = "ball", "absolute"
AIMS = (BALL, ABSOLUTE)


def checked(actions: Any, count: int) -> Any:
    """(count, 5) numbers, those outside of -1 to 1 brought to its edge; ValueError for a wrong
    shape or what is no number."""
    found = np.asarray(actions, float)
    if found.shape != (count, SIZE):
        raise ValueError(f"actions must be an array ({count}, {SIZE}), not {found.shape}")
    if np.isnan(found).any():
        row = int(np.flatnonzero(np.isnan(found).any(axis=1))[0])
        raise ValueError(f"action {row} must be five numbers, not {found[row].tolist()}")
    return np.clip(found, -1.0, 1.0)


def aims_of(actions: Any, places: Any, on: Any, reach: float, speeds: Any, how: str) -> Aims:
    """What the actions mean, in the order that the docs of `danggu.envs` give.

    places: (strokes, balls, 2) m, the cue ball first.
    on: (strokes, balls), which balls may be chosen; always some.
    reach: between the centres of balls that touch, m.
    speeds: the slowest and the fastest, m/s.
    how: BALL or ABSOLUTE.
    """
    first, second, power = (np.ascontiguousarray(actions[:, k]) for k in range(3))
    if how == BALL:
        way = _towards(first, second, places, on, reach)
    else:
        way = np.arctan2(second, first)
    slow, fast = np.log(speeds)
    speed = np.exp(slow + 0.5 * (power + 1.0) * (fast - slow))
    tip = MISCUE * actions[:, 3:]
    out = np.sqrt(tip[:, 0] ** 2 + tip[:, 1] ** 2)
    tip = tip * (MISCUE / np.maximum(out, MISCUE))[:, None]
    return Aims(np.degrees(way), speed, tip[:, 0], tip[:, 1])


def _towards(choice: Any, offset: Any, places: Any, on: Any, reach: float) -> Any:
    """Directions, radians: which of the balls that are on, and where in the angle under which it is
    hit at all, from its right edge (-1) to its left (1)."""
    count = on.sum(axis=1)
    nth = np.minimum((0.5 * (choice + 1.0) * count).astype(int), count - 1)
    rows = np.arange(len(choice))
    chosen = np.argsort(~on, axis=1, kind="stable")[rows, nth]
    apart = places[rows, chosen] - places[:, 0]
    x, y = np.ascontiguousarray(apart[:, 0]), np.ascontiguousarray(apart[:, 1])
    half = np.arcsin(reach / np.maximum(np.sqrt(x * x + y * y), reach))
    return np.arctan2(y, x) + offset * half
