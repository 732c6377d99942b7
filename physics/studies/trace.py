"""The paths that balls have taken, and how high, as arrays for plots."""

from math import ceil
from typing import TYPE_CHECKING, Any

from physics.checks import positive
from physics.engines.engine import Movable

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

    from physics.moments import Course

    Array = npt.NDArray[np.float64]


def trace(
    world: Movable, rate: float = 60.0, times: "npt.ArrayLike | None" = None
) -> "tuple[Array, Array]":
    """times (T,) s and paths (T, balls, 2) m over the whole log, `rate` samples a second; or at
    these `times`, s, in any order.

    Exact at every sample. By rate, the last sample is the first at or after now: at rest, where the
    balls lie. Before the log began the balls lie as it began.
    """
    import numpy as np

    found = _times(world, rate, times, np)
    paths = np.empty((len(found), len(world.balls), 2))
    for i, course in enumerate(_courses(world, found)):
        place = course.place()
        paths[:, i, 0], paths[:, i, 1] = place.real, place.imag
    return found, paths


def heights(world: Movable, rate: float = 60.0, times: "npt.ArrayLike | None" = None) -> "Array":
    """heights (T, balls) m above the cloth, at the times of `trace`; 0 once a ball is off."""
    import numpy as np

    found = _times(world, rate, times, np)
    high = np.empty((len(found), len(world.balls)))
    for i, course in enumerate(_courses(world, found)):
        high[:, i] = course.height()
    return np.maximum(high, 0.0)


def _times(world: Movable, rate: float, times: Any, np: Any) -> Any:
    """Those given, or from the log's start to now, or a little later."""
    world.plan()  # a ball that was just placed is on a leg, too
    if times is not None:
        from physics.moments import moments

        return moments("trace times", times)
    rate = positive("trace rate", rate)
    samples = ceil((world.time - world.log.start) * rate) + 1
    return world.log.start + np.arange(samples) / rate


def _courses(world: Movable, times: Any) -> "list[Course]":
    from physics.moments import Course

    return [Course(world.log.legs(ball.name), times) for ball in world.balls]
