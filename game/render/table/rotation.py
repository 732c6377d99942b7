"""How a ball has turned: a unit quaternion, so that thousands of small turns leave a rotation."""

from __future__ import annotations

from math import cos, hypot, sin, sqrt

import numpy as np

from game.render.arrays import Floats

Quaternion = tuple[float, float, float, float]
"""Scalar part first."""

RACKED: Quaternion = (0.912, 0.350, -0.078, 0.202)
"""Dots at 42, 53 and 74 degrees from the viewer: none looks out like an eye, no two are level."""


def rotated(q: Quaternion, spin: tuple[float, float, float], dt: float) -> Quaternion:
    """Return `q` after turning about the table's axes with `spin` (rad/s) for `dt` seconds."""
    x, y, z = spin
    rate = hypot(x, y, z)
    if rate * dt == 0.0:
        return q
    k = sin(rate * dt / 2) / rate
    a, b, c, d = cos(rate * dt / 2), k * x, k * y, k * z
    e, f, g, h = q
    return unit(
        (
            a * e - b * f - c * g - d * h,
            a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e,
        )
    )


def unit(q: Quaternion) -> Quaternion:
    """Return `q` scaled to length 1."""
    size = sqrt(sum(part * part for part in q))
    a, b, c, d = (part / size for part in q)
    return a, b, c, d


def matrix(q: Quaternion) -> Floats:
    """Return the rotation matrix (3, 3) from the ball's own axes to the table's."""
    return np.array(rows(q), np.float32).reshape(3, 3)


def rows(q: Quaternion) -> tuple[float, ...]:
    """Return the nine numbers of that matrix, row by row."""
    a, b, c, d = q
    return (
        1 - 2 * (c * c + d * d), 2 * (b * c - a * d), 2 * (b * d + a * c),
        2 * (b * c + a * d), 1 - 2 * (b * b + d * d), 2 * (c * d - a * b),
        2 * (b * d - a * c), 2 * (c * d + a * b), 1 - 2 * (b * b + c * c),
    )  # fmt: skip


UPRIGHT: Quaternion = (0.5, -0.5, -0.5, -0.5)
"""The own x axis to the viewer, the own z axis up: a number is read as it is printed."""


def resting(number: int) -> Quaternion:
    """Return how a ball lies whose number is to be read: a little below the middle, where no lamp
    shines on it, and none quite like its neighbour."""
    jitter = (number * 0.618034) % 1.0, (number * 0.414214) % 1.0
    tilt, way, roll = 0.17 + 0.13 * jitter[0], -1.5708 + 1.2 * (jitter[1] - 0.5), jitter[0] - 0.5
    upright = rotated(UPRIGHT, (0.0, 0.0, 0.4 * roll), 1.0)
    return rotated(upright, (-sin(way), cos(way), 0.0), tilt)


def other_end(q: Quaternion) -> Quaternion:
    """Return `q` with the ball's other number where the first one is."""
    a, b, c, d = q
    return -d, c, -b, a


def between(p: Quaternion, q: Quaternion) -> float:
    """Return the cosine of half the angle by which two orientations differ."""
    return abs(sum(x * y for x, y in zip(p, q, strict=True)))
