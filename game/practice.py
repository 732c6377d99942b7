"""Placing balls by hand: a ball that is dragged slides along cushions and other balls."""

from __future__ import annotations

from cmath import exp
from collections.abc import Iterator, Sequence
from itertools import combinations
from math import acos

from physics import Wall, World

Place = tuple[float, float]
GAP = 1e-6
"""Metres kept free between balls that slide along each other: more than rounding, and unseen."""
Circle = tuple[complex, float]


def slid(world: World, name: str, to: Place) -> Place:
    """The place nearest to `to` (metres) where the ball overlaps nothing: there it is laid down.

    Where it is now, if there is no such place.
    """
    own = world.ball(name)
    circles = [
        (complex(*ball.position), own.touching_distance(ball) + GAP)
        for ball in world.balls
        if ball.name != name
    ]
    sides = [wall.moved(-own.radius).moved(-GAP) for wall in world.walls]
    wanted = complex(*to)
    near = [p for p in _candidates(wanted, circles, sides) if _free(p, circles, sides)]
    if not near:
        return own.position
    best = min(near, key=lambda p: abs(p - wanted))
    return best.real, best.imag


def _candidates(
    wanted: complex, circles: Sequence[Circle], sides: Sequence[Wall]
) -> Iterator[complex]:
    """Where the nearest free place can be: the place itself, an edge's nearest point, a corner."""
    yield wanted
    for centre, reach in circles:
        away = wanted - centre
        yield centre + reach * (away / abs(away) if away else 1.0)
    for side in sides:
        yield side.nearest(wanted)
    for side, other in combinations(sides, 2):
        yield from side.corner(other)
    for centre, reach in circles:
        for side in sides:
            yield from side.crossings(centre, reach)
    for first, second in combinations(circles, 2):
        yield from _on_both(first, second)


def _on_both(first: Circle, second: Circle) -> Iterator[complex]:
    """Where two circles cross."""
    (p, a), (q, b) = first, second
    gap = abs(q - p)
    if gap and abs(a - b) <= gap <= a + b:
        turn = acos(min(max((a * a + gap * gap - b * b) / (2 * a * gap), -1.0), 1.0))
        for way in (turn, -turn):
            yield p + a * (q - p) / gap * exp(1j * way)


def _free(p: complex, circles: Sequence[Circle], sides: Sequence[Wall]) -> bool:
    """Is a place free?  What was found on an edge may lie half the gap behind it."""
    slack = GAP / 2
    apart = all(abs(p - centre) >= reach - slack for centre, reach in circles)
    return apart and all(side.distance((p.real, p.imag)) >= -slack for side in sides)
