"""Light on a ball seen from above, as two overlays: what the lamps take and what they add.

All numbers are for a unit ball.  Light is worked out linearly and stored as 8-bit sRGB, where a
product of light and colour stays a product and highlights are added.
"""

from __future__ import annotations

import numpy as np

from game.render.arrays import Bytes, Floats
from game.render.theme import Colour

LAMPS = ((0.62, 0.42, 0.95), (-0.62, 0.42, 0.95))
"""Two lamps relative to the middle of the table, m: behind it, so balls are lit from above."""
GAMMA = 2.2


def normals(
    side: int, radius: float, centre: float, half: tuple[int, int] = (0, 0)
) -> tuple[Floats, Floats]:
    """Return the outward normals (3, side, side) and coverage (side, side) of a disc.

    `half` moves its centre by so many halves of a pixel to the right and down.

    Axes: x right, y up, z to the viewer.  Pixels outside the disc take the normal at the rim, so
    that averaging with them leaves the edge clean.
    """
    right, down = (
        (np.arange(side, dtype=np.float32) + 0.5 - centre - h / 2) / radius for h in half
    )
    x, y = np.meshgrid(right, -down, indexing="ij")
    away = np.hypot(x, y)
    reach = np.maximum(away, 1e-6)
    shrink = np.minimum(1.0, 0.995 / reach)
    x, y = x * shrink, y * shrink
    z = np.sqrt(np.maximum(0.0, 1 - x * x - y * y))
    cover = ((1 - away) * radius + 0.5).clip(0, 1)
    return np.stack((x, y, z)).astype(np.float32), cover.astype(np.float32)


def smooth(low: float, high: float, value: Floats) -> Floats:
    """Return 0 below `low`, 1 above `high`, and an even way between."""
    t = ((value - low) / (high - low)).clip(0, 1)
    return np.asarray(t * t * (3 - 2 * t), np.float32)


def _lamps(x: float, y: float) -> list[Floats]:
    """Return the vectors from a ball at (x, y) metres to the two lamps."""
    return [np.array((sx - x, sy - y, h), np.float32) for sx, sy, h in LAMPS]


def diffuse(normal: Floats, x: float, y: float) -> Floats:
    """Return linear light, about 0 to 1, falling on each normal of a ball at (x, y) metres."""
    total = 0.03 + 0.19 * smooth(-0.3, 1.0, normal[2])
    for lamp in _lamps(x, y):
        far = float(np.sqrt(lamp @ lamp))
        facing = np.tensordot(lamp / far, normal, 1)
        nearness = (1.15 / far) ** 0.5
        total += 0.62 * nearness * (0.94 * facing + 0.06).clip(0, None) ** 1.6
    return np.asarray(total, np.float32)


def rim(normal: Floats) -> Floats:
    """Return 0 in the middle to 1 at the edge."""
    return np.asarray((1 - normal[2]) ** 2.6, np.float32)


def highlight(normal: Floats, x: float, y: float) -> Floats:
    """Return linear light mirrored to the viewer by two soft rectangular lamps.

    A rectangle, not a round dot, is what says billiard hall.
    """
    mirrored = 2 * normal[2] * normal
    mirrored[2] -= 1
    total = np.zeros(normal.shape[1:], np.float32)
    up = mirrored[2]
    for lamp in _lamps(x, y):
        u = mirrored[0] / np.maximum(up, 0.05) - lamp[0] / lamp[2]
        v = mirrored[1] / np.maximum(up, 0.05) - lamp[1] / lamp[2]
        inside = smooth(-0.17, 0.17, 0.50 - np.abs(u)) * smooth(-0.17, 0.17, 0.32 - np.abs(v))
        total += 0.52 * inside * (up > 0.05)
    return total


def overlays(
    normal: Floats, cover: Floats, x: float, y: float, cloth: Colour
) -> tuple[Bytes, Bytes]:
    """Return the multiply overlay (side, side, 4) and the add overlay (side, side, 3).

    The fourth channel of the first is the ball's coverage.
    """
    edge = rim(normal)
    kept = (diffuse(normal, x, y) * (1 - 0.55 * edge)).clip(0, 1) ** (1 / GAMMA)
    times = np.stack((kept, kept, kept, cover), axis=-1)
    green = np.array(cloth, np.float32) / 255
    below = smooth(0.1, -0.9, normal[1])
    bounce = (0.30 * edge * (0.45 + 0.55 * below))[..., None] * green**GAMMA
    added = (bounce + highlight(normal, x, y)[..., None]).clip(0, 1) ** (1 / 1.8)
    return np.round(times * 255).astype(np.uint8), np.round(added * 255).astype(np.uint8)
