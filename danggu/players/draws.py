"""Aims that may be worth trying, many at once: at any thickness of a ball that is on, or anywhere.

As `candidates` draws them one by one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .candidates import Style
from .errors import SPIN

ROOT = 1.11277568427870547  # of x⁷ = x + 1
INWARD = 0.25  # power of an even number that is the tip's distance from the centre


def draws(
    cue: Any, targets: Any, radius: float, style: Style, count: int, rng: np.random.Generator
) -> Any:
    """(n, count, 6) shots, as `simulate_many` takes them, from each of n positions.

    cue: (n, 2) m, where the cue ball lies.
    targets: (n, balls, 2) m, the balls that may be hit first; NaN for one that is not there.
    radius: of all balls, m.
    rng: one draw of six for each position.
    """
    even = spread(len(cue), count, rng)
    angle, straight = 360.0 * even[..., 0] - 180.0, even[..., 1] >= style.bank
    if targets.shape[1]:
        found = _cuts(cue, targets, 2 * radius, even[..., 0], even[..., 2])
        angle = np.where(straight & np.isfinite(found), found, angle)
    speed = style.slow * (style.fast / style.slow) ** even[..., 3]
    # the best strokes have the tip far out: three in four of these are beyond half of it
    out, around = style.tip * even[..., 4] ** INWARD, 2.0 * np.pi * even[..., 5]
    none = np.zeros(speed.shape)
    up, right = SPIN * speed * out * np.sin(around), SPIN * speed * out * np.cos(around)
    return np.stack([speed, angle, up, none, right, none], axis=2)


def spread(rows: int, count: int, rng: np.random.Generator) -> Any:
    """(rows, count, 6) numbers from 0 to 1 that fill the space evenly, in each row shifted by
    chance (the additive recurrence of Roberts, 2018)."""
    steps = np.arange(count)[:, None] * ROOT ** -np.arange(1.0, 7.0)
    return (rng.random((rows, 1, 6)) + steps) % 1.0


def _cuts(cue: Any, targets: Any, reach: float, thick: Any, which: Any) -> Any:
    """Directions, degrees, of hits on targets at these thicknesses."""
    chosen = (which * targets.shape[1]).astype(int)
    apart = targets[np.arange(len(cue))[:, None], chosen] - cue[:, None]
    x, y = apart[..., 0], apart[..., 1]
    widest = reach / np.maximum(np.hypot(x, y), reach)
    return np.degrees(np.arctan2(y, x) + np.arcsin(widest * (2.0 * thick - 1.0)))
