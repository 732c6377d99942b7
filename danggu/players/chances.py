"""What a player sees of a table: ways of balls into pockets, and how likely each pot is."""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import asin, erf, radians, sqrt
from typing import NamedTuple

from physics import tables

from .levels import Level
from .mouths import Gauge, Hole, gauge, holes, window

THINNEST = 0.2  # cosine of the thinnest cut that is tried, 78°
EDGE = 1.0  # rad: of a thin hit, on the ball
NARROWEST = 1e-3  # rad: windows below this are none
# The side spin of an error of the tip throws the object ball: degrees for each mm (0.15 of a
# rolling ball, 0.5 of any other)
THROWN = 0.4
STEADIEST = Level("steadiest", 0.02, 0.005, 0.2)  # no player is seen as better than that

Lie = Mapping[str, complex]
"""Where balls lie, by name, m."""


class Opening(NamedTuple):
    """A way into a pocket.

    hole: the pocket.
    way: unit vector along the middle of what drops.
    half: how far a ball may err to either side, radians.
    """

    hole: Hole
    way: complex
    half: float


class Route(NamedTuple):
    """A pot.

    ball: its name.
    opening: its way into the pocket.
    ghost: where the cue ball has to come, m.
    run: how far that is, m.
    cut: cosine of the cut angle.
    chance: how many of such strokes pot it, 0 to 1, as far as aiming decides.
    """

    ball: str
    opening: Opening
    ghost: complex
    run: float
    cut: float
    chance: float


class Eye:
    """The eye of a player of some level for one table."""

    def __init__(self, table: tables.Table, level: Level) -> None:
        seen = level.or_more(STEADIEST)
        self.table, self.width, self.holes = table, 2 * table.radius, holes(table)
        self._gauge: Gauge | None = None
        self._aim = radians(seen.angle)
        self._throw = radians(THROWN * seen.tip)

    @property
    def gauge(self) -> Gauge:
        """How wide the pockets are; measured on first use."""
        if self._gauge is None:
            self._gauge = gauge(self.table)
        return self._gauge

    def usual(self, run: float = 0.8) -> float:
        """The chance of a pot as lies usually offer one: a metre from a pocket, cut by 30 degrees,
        with the cue ball `run` m away."""
        sides = [edge for kind in self.gauge.values() for edge in kind[2] or ()]
        half = sum(abs(edge) for edge in sides) / max(1, len(sides))
        return self._chance(half, run, 0.87)

    def ways(self, cue: complex, balls: Lie, targets: Iterable[str]) -> Iterator[Route]:
        """The pots that there are from a place of the cue ball; `balls` are all others."""
        for name in targets:
            at = balls[name]
            others = [place for ball, place in balls.items() if ball != name]
            for opening in self.openings(at, others, at - cue):
                way = self.way(cue, name, at, opening, others)
                if way is not None:
                    yield way

    def openings(
        self, at: complex, others: Sequence[complex], line: complex = 0j
    ) -> Iterator[Opening]:
        """The pockets that are open to a ball there, as far as others do not stand in the way.

        line: along which the cue ball would come, m: pockets behind are left out; 0 for any.
        """
        for hole in self.holes:
            if line and (line.conjugate() * (hole.middle - at)).real < 0.0:
                continue
            found = window(self.gauge, hole, at)
            if found is None:
                continue
            to, right, left = found
            far = abs(hole.middle - at)
            for other in others:
                right, left = self._shaded((other - at) * to.conjugate(), far, right, left)
                if left - right < NARROWEST:
                    break
            else:
                yield Opening(hole, to * rect(1.0, 0.5 * (right + left)), 0.5 * (left - right))

    def way(
        self, cue: complex, ball: str, at: complex, opening: Opening, others: Sequence[complex]
    ) -> Route | None:
        """The pot into that opening, None where it is too thin or a ball is in the way."""
        ghost = at - self.width * opening.way
        line = ghost - cue
        run = abs(line)
        if run < 1e-6:
            return None
        cut = (line.conjugate() * opening.way).real / run
        if cut < THINNEST or not self.free(cue, ghost, others):
            return None
        return Route(ball, opening, ghost, run, cut, self._chance(opening.half, run, cut))

    def free(self, start: complex, end: complex, others: Iterable[complex]) -> bool:
        """Whether a ball comes from one place to the other and meets none of the others."""
        line = end - start
        far = abs(line)
        if not far:
            return True
        along = line.conjugate() / far
        for other in others:
            seen = (other - start) * along
            if abs(seen.imag) < self.width and 0.0 < seen.real < far + self.width:
                near = sqrt(self.width**2 - seen.imag**2)
                if seen.real - near < far:
                    return False
        return True

    def hittable(self, cue: complex, balls: Lie, targets: Iterable[str]) -> tuple[str, ...]:
        """Those of the targets that can be hit straight, full or near one of their edges."""
        found = []
        for name in targets:
            at = balls[name]
            others = [place for ball, place in balls.items() if ball != name]
            line = at - cue
            line /= max(abs(line), 1e-9)
            # where the cue ball is as it hits
            ghosts = (at - self.width * line * rect(1.0, turn) for turn in (0.0, EDGE, -EDGE))
            if any(self.free(cue, ghost, others) for ghost in ghosts):
                found.append(name)
        return tuple(found)

    def _chance(self, half: float, run: float, cut: float) -> float:
        # an error of the aim turns the object ball's way by run / (2R cos cut) times as much
        error = sqrt((self._aim * run / (self.width * cut)) ** 2 + self._throw**2)
        return erf(half / (error * sqrt(2.0)))

    def _shaded(self, seen: complex, far: float, right: float, left: float) -> tuple[float, float]:
        """The greater part of a window that a ball, seen along the way, leaves open."""
        if seen.real <= 0.0 or seen.real > far + self.width:
            return right, left
        half = asin(min(1.0, self.width / abs(seen)))
        middle = phase(seen)
        low, high = middle - half, middle + half
        if high <= right or low >= left:
            return right, left
        return (high, left) if left - high > low - right else (right, low)
