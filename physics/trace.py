"""The paths that balls have taken, as arrays for plots."""

from math import ceil
from typing import TYPE_CHECKING, Any

from .checks import positive
from .world import World

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

    rate = positive("trace rate", rate)
    world.plan()  # what has just been put there is on a leg, too
    start = world.log.start
    samples = ceil((world.time - start) * rate) + 1
    times = start + np.arange(samples) / rate
    paths = np.empty((samples, len(world.balls), 2))
    for i, ball in enumerate(world.balls):
        paths[:, i] = _path(world.log.legs(ball.name), times, np)
    return times, paths


def _path(legs: Any, times: Any, np: Any) -> Any:
    begins = np.array([leg.time for leg in legs])
    k = np.maximum(np.searchsorted(begins, times, side="right") - 1, 0)
    p, v, a = (
        np.array([getattr(leg, what) for leg in legs])[k]
        for what in ("position", "velocity", "acceleration")
    )
    t = np.maximum(times - begins[k], 0.0)
    place = p + t * (v + 0.5 * t * a)
    return np.stack((place.real, place.imag), axis=1)
