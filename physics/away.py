"""How far a ball gets from a cushion before it meets it again: exact, as legs are parabolas."""

from collections.abc import Sequence
from itertools import pairwise
from math import inf
from typing import Any

from .kernel.kinds import CUSHION
from .wall import Obstacle

Raw = tuple[Any, ...]  # a leg or an event as the log keeps it
EPOCH, SINCE, POSITION, VELOCITY, ACCELERATION, RADIUS = 0, 1, 2, 3, 4, 8  # in a leg
KIND, WALL, BALL, LEG = 2, 3, 4, 5  # in an event


class Departures:
    """For every event the greatest gap, m, between ball and cushion since they last touched.

    Each is computed once, on first use: rules ask for all of them again and again.
    """

    def __init__(self) -> None:
        self._gaps: list[float] = []
        self._met: dict[tuple[int, int], int] = {}
        """By ball and wall: the leg that began when they last touched."""

    def before(
        self,
        event: int,
        events: Sequence[Raw],
        legs: Sequence[Sequence[Raw]],
        walls: list[Obstacle],
    ) -> float:
        """The gap before that event, for a first touch since the first leg; inf for no touch."""
        for raw in events[len(self._gaps) : event + 1]:
            self._gaps.append(self._gap(raw, legs, walls) if raw[KIND] == CUSHION else inf)
        return self._gaps[event]

    def clear(self) -> None:
        """Forget all gaps: events or legs have changed."""
        self._gaps.clear()
        self._met.clear()

    def _gap(self, raw: Raw, legs: Sequence[Sequence[Raw]], walls: list[Obstacle]) -> float:
        ball, last, wall = raw[BALL], raw[LEG], raw[WALL]
        first = self._met.get((ball, wall), 0)
        self._met[ball, wall] = last
        return farthest(legs[ball][first : last + 1], walls[wall])


def farthest(legs: Sequence[Raw], wall: Obstacle) -> float:
    """The greatest gap, m, between a ball and a wall from its first leg's start to the last's."""
    most = -inf
    for leg, after in pairwise(legs):
        t = (after[EPOCH] - leg[EPOCH]) + (after[SINCE] - leg[SINCE])
        far = wall.farthest(leg[POSITION], leg[VELOCITY], leg[ACCELERATION], t)
        if far > most:
            most = far
    return max(0.0, float(most - legs[0][RADIUS]))
