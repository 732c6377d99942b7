"""The colours of a ball with dots or bands, by one coordinate of a direction on it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from game.render.theme import BallLook

SHADES = 2048
"""Steps from the middle of a mark's axis to its side: enough for a smooth edge at 4K."""


def shades(look: BallLook, radius: float) -> NDArray[np.uint32]:
    """Return the colour (BGRA packed) for each step of the coordinate that `look.marks` cuts."""
    t = np.arange(SHADES, dtype=np.float64) / (SHADES - 1)
    painted = np.zeros(SHADES)
    for low, high in look.marks:
        ends = [
            (np.sqrt(max(0.0, 1 - e * e)) if not look.banded else 1.0) / radius for e in (low, high)
        ]
        rise = ((t - low) / max(ends[0], 1e-6) + 0.5).clip(0, 1)
        fall = ((high - t) / max(ends[1], 1e-6) + 0.5).clip(0, 1)
        painted = np.maximum(painted, np.minimum(rise, fall))
    body, mark = np.array(look.body), np.array(look.mark)
    r, g, b = np.round(body + (mark - body) * painted[:, None]).astype(np.uint32).T
    return np.asarray(np.uint32(255) << 24 | r << 16 | g << 8 | b, np.uint32)
