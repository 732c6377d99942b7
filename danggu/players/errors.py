"""Shots as a level carries them out, many at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .levels import MISCUE, SLOWEST, Attempt

if TYPE_CHECKING:
    import numpy.typing as npt

    from .levels import Level

SPIN = 2.5  # times speed and offset of the tip in radii: the surface speed of the spin


def missed(
    shots: npt.ArrayLike, level: Level, copies: int, radius: float, rng: np.random.Generator
) -> npt.NDArray[np.float64]:
    """Copies of each shot, with the errors of that level: (shots * copies, 6), those of a shot
    together, from shots (shots, 6) as `simulate_many` takes them.

    radius: of the ball, m.
    rng: four draws for each copy.

    As in `Level.missed`: errors of the direction, the speed and the tip, which stays where it does
    not slip, unless the shot itself has it farther out. Massé and climb change with the speed.
    """
    exact: Any = np.repeat(np.asarray(shots, float), copies, axis=0)
    errors = rng.standard_normal((len(exact), 4))
    speed = np.maximum(SLOWEST, exact[:, 0] * (1.0 + level.speed * errors[:, 1]))
    spin = SPIN * exact[:, 0]
    up, right = exact[:, 2] / spin, exact[:, 4] / spin
    limit = np.maximum(MISCUE, np.hypot(up, right))
    tip = 1e-3 * level.tip / radius
    up, right = up + tip * errors[:, 2], right + tip * errors[:, 3]
    within = np.minimum(1.0, limit / np.maximum(np.hypot(up, right), limit))
    exact[:, 3] *= speed / exact[:, 0]
    exact[:, 5] *= speed / exact[:, 0]
    exact[:, 0], exact[:, 1] = speed, exact[:, 1] + level.angle * errors[:, 0]
    exact[:, 2], exact[:, 4] = SPIN * speed * up * within, SPIN * speed * right * within
    return np.asarray(exact, float)


def attempt(shot: npt.NDArray[np.float64]) -> Attempt:
    """The aim of a shot (6,) without massé and climb."""
    speed, angle, follow, _, side, _ = shot.tolist()
    return Attempt(angle, speed, side / (SPIN * speed), follow / (SPIN * speed))
