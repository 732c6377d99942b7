"""How balls lie: which of them touch, and whether the cue ball is snookered."""

from __future__ import annotations

from cmath import phase, rect
from collections.abc import Collection, Iterable, Mapping
from itertools import combinations, pairwise
from math import asin, dist, inf, sqrt

Point = tuple[float, float]

# m.  Two balls no farther apart than this touch: a tenth of what a referee can see, and far above
# the rounding of places at rest.
CLOSE = 1e-5


def touching(
    places: Mapping[str, Point], diameter: float, slack: float = CLOSE
) -> tuple[tuple[str, str], ...]:
    """The pairs of balls that touch; places and diameter in m."""
    pairs = combinations(places.items(), 2)
    return tuple((a, b) for (a, at), (b, other) in pairs if dist(at, other) <= diameter + slack)


def snookered(cue: Point, on: Iterable[Point], others: Collection[Point], diameter: float) -> bool:
    """Whether no ball on can be hit in a straight line at both of its edges (WPBSA 2.17).

    cue: where the cue ball is, (x, y) in m.
    on, others: where the balls on are, and those that are not on.
    diameter: of every ball, m.
    """
    return all(any(_hides(cue, ball, other, diameter) for other in others) for ball in on)


def _hides(cue: Point, ball: Point, other: Point, diameter: float) -> bool:
    """Whether on some straight line that would reach the ball the other one is in the way."""
    a, b = _from(cue, ball), _from(cue, other)
    if abs(a) <= diameter:
        return False
    wide = asin(diameter / abs(a))
    b /= a / abs(a)  # seen along the straight line to the ball
    across, aside = asin(min(diameter / abs(b), 1.0)), phase(b)
    # which is met first changes only at their edges, and where both would be met at once
    bends = {-wide, wide, aside - across, aside + across, *_both(abs(a), b, diameter)}
    ways = sorted(way for way in bends if -wide <= way <= wide)
    return any(
        _reach(b, (low + high) / 2, diameter) < _reach(complex(abs(a)), (low + high) / 2, diameter)
        for low, high in pairwise(ways)
    )


def _from(start: Point, end: Point) -> complex:
    return complex(end[0] - start[0], end[1] - start[1])


def _reach(ball: complex, way: float, diameter: float) -> float:
    """How far the cue ball goes in that direction until it meets the ball, m; inf if never."""
    along = ball * rect(1.0, -way)
    if along.real <= 0 or abs(along.imag) >= diameter:
        return inf
    return along.real - sqrt(diameter**2 - along.imag**2)


def _both(far: float, other: complex, diameter: float) -> list[float]:
    """The directions in which a cue ball would touch both at once."""
    apart = other - far
    half = diameter**2 - abs(apart) ** 2 / 4
    if half < 0 or not apart:
        return []
    middle, off = far + apart / 2, sqrt(half) * 1j * apart / abs(apart)
    return [phase(middle + off), phase(middle - off)]
