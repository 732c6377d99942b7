"""Aims that may be worth trying, many at once: at any thickness of a ball that is on, or anywhere.

As `candidates` draws them one by one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .candidates import Style
from .errors import SPIN


def draws(
    cue: Any, targets: Any, radius: float, style: Style, count: int, rng: np.random.Generator
) -> Any:
    """(n, count, 6) shots, as `simulate_many` takes them, from each of n positions.

    cue: (n, 2) m, where the cue ball lies.
    targets: (n, balls, 2) m, the balls that may be hit first; NaN for one that is not there.
    radius: of all balls, m.
    """
    shape = len(cue), count
    angle = rng.uniform(-180.0, 180.0, shape)
    straight = rng.random(shape) >= style.bank
    if targets.shape[1]:
        found = _cuts(cue, targets, 2 * radius, shape, rng)
        angle = np.where(straight & np.isfinite(found), found, angle)
    speed = np.exp(rng.uniform(np.log(style.slow), np.log(style.fast), shape))
    out, around = style.tip * np.sqrt(rng.random(shape)), 2.0 * np.pi * rng.random(shape)
    none = np.zeros(shape)
    up, right = SPIN * speed * out * np.sin(around), SPIN * speed * out * np.cos(around)
    return np.stack([speed, angle, up, none, right, none], axis=2)


def _cuts(cue: Any, targets: Any, reach: float, shape: Any, rng: np.random.Generator) -> Any:
    """Directions, degrees, of hits on random targets at random thicknesses."""
    chosen = rng.integers(0, targets.shape[1], shape)
    apart = targets[np.arange(shape[0])[:, None], chosen] - cue[:, None]
    x, y = apart[..., 0], apart[..., 1]
    widest = reach / np.maximum(np.hypot(x, y), reach)
    return np.degrees(np.arctan2(y, x) + np.arcsin(widest * rng.uniform(-1.0, 1.0, shape)))
