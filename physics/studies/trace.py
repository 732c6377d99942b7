"""The paths that balls have taken, and how high, as arrays for plots."""

from math import ceil
from typing import TYPE_CHECKING, Any

from physics.ball import Ball
from physics.checks import positive
from physics.kernel.leg import travelled
from physics.world import World

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt


def trace(
    world: World, rate: float = 60.0
) -> "tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]":
    """times (T,) s and paths (T, balls, 2) m over the whole log, `rate` samples a second.

    Exact at every sample. The last sample is the first at or after now: at rest, where the balls
    lie.
    """
    import numpy as np

    times = _times(world, rate, np)
    paths = np.empty((len(times), len(world.balls), 2))
    for i, ball in enumerate(world.balls):
        t, (p, v, a) = _legs(world, ball, times, ("position", "velocity", "acceleration"), np)
        place = travelled(p, v, a, t)
        paths[:, i, 0], paths[:, i, 1] = place.real, place.imag
    return times, paths


def heights(world: World, rate: float = 60.0) -> "npt.NDArray[np.float64]":
    """heights (T, balls) m above the cloth, at the times of `trace`; 0 once a ball is off."""
    import numpy as np

    times = _times(world, rate, np)
    high = np.empty((len(times), len(world.balls)))
    for i, ball in enumerate(world.balls):
        t, (h, climb, fall) = _legs(world, ball, times, ("height", "climb", "fall"), np)
        high[:, i] = travelled(h, climb, -fall, t)
    return np.maximum(high, 0.0)


def _times(world: World, rate: float, np: Any) -> Any:
    """From the log's start to now, or a little later."""
    rate = positive("trace rate", rate)
    world.plan()  # a ball that was just placed is on a leg, too
    samples = ceil((world.time - world.log.start) * rate) + 1
    return world.log.start + np.arange(samples) / rate


def _legs(world: World, ball: Ball, times: Any, what: tuple[str, ...], np: Any) -> Any:
    """How far into its leg the ball is at those times, and these numbers of the leg."""
    legs = world.log.legs(ball.name)
    begins = np.array([leg.time for leg in legs])
    k = np.maximum(np.searchsorted(begins, times, side="right") - 1, 0)
    numbers = [np.array([getattr(leg, name) for leg in legs])[k] for name in what]
    return np.maximum(times - begins[k], 0.0), numbers
