"""The order of a method, measured: how the error falls with the step, over many step sizes."""

from collections.abc import Callable
from math import log
from statistics import fmean

from physics import EventDriven, TimeStepping, World

SIZES = 48  # step sizes in each octave: a single one is a lottery


def octave(h: float) -> list[float]:
    """Step sizes from h / sqrt 2 to h sqrt 2, evenly on the logarithm."""
    return [h * 2.0 ** ((k + 0.5) / SIZES - 0.5) for k in range(SIZES)]


def slope(points: list[tuple[float, float]]) -> float:
    """Of the straight line that fits log y over log x best."""
    xs, ys = [log(x) for x, _ in points], [log(y) for _, y in points]
    x, y = fmean(xs), fmean(ys)
    up = sum((a - x) * (b - y) for a, b in zip(xs, ys, strict=True))
    return up / sum((a - x) ** 2 for a in xs)


def order(error: Callable[[float], float], steps: list[float]) -> float:
    """The order of the mean error over the octave about each of the steps."""
    return slope([(h, fmean(error(dt) for dt in octave(h))) for h in steps])


def place_error(make: Callable[[], World], scheme: str, time: float) -> Callable[[float], float]:
    """dt -> distance, m, of the ball that is furthest from where the exact engine has it."""
    exact = make()
    exact.engine = EventDriven()
    exact.run(time)

    def error(dt: float) -> float:
        world = make()
        world.engine = TimeStepping(dt, scheme)
        world.run(time)
        return max(
            abs(complex(*a.position) - complex(*b.position))
            for a, b in zip(world.balls, exact.balls, strict=True)
        )

    return error


def contact_error(make: Callable[[], World], scheme: str, time: float) -> Callable[[float], float]:
    """dt -> lateness, s, of the first contact."""

    def first(world: World) -> float:
        world.run(time)
        return next(event.time for event in world.log if event.kind in ("ball", "cushion"))

    exact = make()
    exact.engine = EventDriven()
    due = first(exact)

    def error(dt: float) -> float:
        world = make()
        world.engine = TimeStepping(dt, scheme)
        return abs(first(world) - due)

    return error
