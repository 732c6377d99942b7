"""How far a ball gets from a cushion before it meets it again: exact, as legs are parabolas."""

from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from math import inf
from typing import Any, Generic, TypeVar

from .kernel.gap import LEFT
from .kernel.kinds import CUSHION
from .kernel.leg import travelled
from .kernel.obstacle import clearance
from .wall import Obstacle

T = TypeVar("T")

Raw = tuple[Any, ...]  # a leg or an event as the log keeps it
EPOCH, SINCE, POSITION, VELOCITY, ACCELERATION, RADIUS = 0, 1, 2, 3, 4, 8  # in a leg
KIND, WALL, BALL, LEG = 2, 3, 4, 5  # in an event


class Departures:
    """What is to be known of every event about ball and cushion since they last touched.

    gap: the greatest, m; inf at what is no cushion.
    left: was it ever more than LEFT?  True at what is no cushion.
    """

    def __init__(self) -> None:
        self.gap = Looks(farthest, inf)
        self.left = Looks(left, True)

    def clear(self) -> None:
        """Forget everything: events or legs have changed."""
        self.gap.clear()
        self.left.clear()


class Looks(Generic[T]):
    """Something of that kind, for every event.

    Each is computed once, on first use: rules ask for all of them again and again.
    """

    def __init__(self, seen: Callable[[Sequence[Raw], Obstacle], T], none: T) -> None:
        """seen: of the legs in between and the wall; none: at what is no cushion."""
        self._seen = seen
        self._none = none
        self._found: list[T] = []
        self._met: dict[tuple[int, int], int] = {}
        """By ball and wall: the leg that began when they last touched."""

    def before(
        self,
        event: int,
        events: Sequence[Raw],
        legs: Sequence[Sequence[Raw]],
        walls: list[Obstacle],
    ) -> T:
        """What was seen before that event; for a first touch, since the first leg."""
        for raw in events[len(self._found) : event + 1]:
            touched = raw[KIND] == CUSHION
            self._found.append(self._look(raw, legs, walls) if touched else self._none)
        return self._found[event]

    def clear(self) -> None:
        self._found.clear()
        self._met.clear()

    def _look(self, raw: Raw, legs: Sequence[Sequence[Raw]], walls: list[Obstacle]) -> T:
        ball, last, wall = raw[BALL], raw[LEG], raw[WALL]
        first = self._met.get((ball, wall), 0)
        self._met[ball, wall] = last
        return self._seen(legs[ball][first : last + 1], walls[wall])


def farthest(legs: Sequence[Raw], wall: Obstacle) -> float:
    """The greatest gap, m, between a ball and a wall from its first leg's start to the last's."""
    radius = legs[0][RADIUS]
    far = max((wall.farthest(*path) for path in _paths(legs)), default=radius)
    return max(0.0, float(far - radius))


def left(legs: Sequence[Raw], wall: Obstacle) -> bool:
    """Was that gap ever more than LEFT?  Nearly always the start or the end of a leg says so."""
    radius, shape = legs[0][RADIUS], wall.shape
    return any(
        clearance(shape, path[0], radius) > LEFT
        or clearance(shape, travelled(*path), radius) > LEFT
        or wall.farthest(*path) - radius > LEFT
        for path in _paths(legs)
    )


def _paths(legs: Sequence[Raw]) -> Iterator[tuple[complex, complex, complex, float]]:
    """Where each leg but the last begins, m, its velocity and acceleration, and its time, s."""
    for leg, after in pairwise(legs):
        t = (after[EPOCH] - leg[EPOCH]) + (after[SINCE] - leg[SINCE])
        yield leg[POSITION], leg[VELOCITY], leg[ACCELERATION], t
