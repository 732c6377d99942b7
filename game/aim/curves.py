"""A shot as curves over time: the speed of each ball, momentum and energy of all together."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from physics import World

from .preview import ahead_of, story

if TYPE_CHECKING:
    import numpy.typing as npt

    Array = npt.NDArray[Any]


@dataclass(frozen=True, slots=True, eq=False)
class Curves:
    """Numbers at moments that are equally far apart, from the shot on.

    times     s
    speeds    m/s, of each ball that moves
    momentum  kg m/s, along x and along y
    energy    J, of moving and turning, and what gravity has stored
    moving    J, of moving along the table alone
    """

    times: Array
    speeds: dict[str, Array]
    momentum: tuple[Array, Array]
    energy: Array
    moving: Array

    @property
    def duration(self) -> float:
        """Seconds."""
        return float(self.times[-1])


def curves(world: World, since: float, count: int) -> Curves | None:
    """Follow the shot that began at `since` to its end, at so many moments.

    None where no engine can go on, or nothing has happened.
    """
    ahead = ahead_of(world)
    if ahead is None:
        return None
    end = max(story(ahead.log, since, ahead.time).duration, world.time - since)
    return _curves(ahead, since, end, count) if end > 0.0 else None


def _curves(ahead: World, since: float, end: float, count: int) -> Curves:
    import numpy as np

    times = np.linspace(0.0, end, count)
    speeds: dict[str, Array] = {}
    px, py, moving, energy = (np.zeros(count) for _ in range(4))
    for ball, motion in zip(ahead.balls, ahead.log.at(since + times).values(), strict=True):
        (vx, vy), mass, spin = motion.velocity.T, ball.mass, motion.spin
        px, py = px + mass * vx, py + mass * vy
        own = 0.5 * mass * (vx * vx + vy * vy)
        turning = 0.2 * mass * ball.radius**2 * (spin * spin).sum(axis=1)
        lift = mass * (0.5 * motion.climb**2 + ahead.cloth.gravity * motion.height)
        moving, energy = moving + own, energy + own + turning + lift
        if motion.speed.any():
            speeds[ball.name] = motion.speed
    return Curves(times, speeds, (px, py), energy, moving)
