"""Placing balls by hand: a ball that is dragged slides along cushions and other balls."""

from __future__ import annotations

from cmath import exp
from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise
from math import acos

from physics import Placed, World

Place = tuple[float, float]
GAP = 1e-6
"""Metres kept free between balls that slide along each other: more than rounding, and unseen."""
Circle = tuple[complex, float]
Side = tuple[complex, float]
"""A line along which a ball slides: its normal n, and n·p for all of its points p."""


def lying_at(at: Place) -> Placed:
    """A ball that lies still there, m."""
    return Placed(complex(*at))


def inside(world: World, at: Place) -> bool:
    """Is a point (m) within the edge of the cushions?  Where a table has pockets a rail ends, so
    what is behind it is not known by its distance."""
    table = world.table
    if table is None or table.pockets is None:
        return True
    edge, p = table.outline, complex(*at)
    odd = False
    for a, b in pairwise([*edge, edge[0]]):
        if (a.imag > p.imag) != (b.imag > p.imag):
            odd ^= p.real < a.real + (p.imag - a.imag) * (b.real - a.real) / (b.imag - a.imag)
    return odd


def fits(world: World, at: Place, radius: float) -> bool:
    """Does a ball of that radius (m) lie free of all that stands there, and not in a pocket?"""
    free = all(wall.distance(at) >= (radius if wall.pushes else 0.0) for wall in world.walls)
    return free and inside(world, at)


def slid(world: World, name: str, to: Place) -> Place:
    """The place nearest to `to` (metres) where the ball overlaps nothing: there it is laid down.

    Where it is now, if there is no such place.
    """
    own = world.ball(name)
    circles = [
        (complex(*ball.position), own.touching_distance(ball) + GAP)
        for ball in world.balls
        if ball.name != name and not ball.gone
    ]
    circles += [circle for wall in world.walls for circle in wall.circles(own.radius, GAP)]
    sides = [line for wall in world.walls for line in wall.lines(own.radius, GAP)]

    wanted, reach = complex(*to), own.radius + GAP
    near = [p for p in _candidates(wanted, circles, sides) if _free(p, circles, world, reach)]
    if not near:
        return own.position
    best = min(near, key=lambda p: abs(p - wanted))
    return best.real, best.imag


def _candidates(
    wanted: complex, circles: Sequence[Circle], sides: Sequence[Side]
) -> Iterator[complex]:
    """Where the nearest free place can be: the place itself, an edge's nearest point, a corner."""
    yield wanted
    for centre, reach in circles:
        away = wanted - centre
        yield centre + reach * (away / abs(away) if away else 1.0)
    for normal, least in sides:
        yield wanted + (least - _along(normal, wanted)) * normal
    for (m, a), (n, b) in combinations(sides, 2):
        cross = (m.conjugate() * n).imag
        if abs(cross) > 1e-9:
            yield (a * n - b * m) * -1j / cross
    for first in circles:
        for normal, least in sides:
            yield from _on_line(first, normal, least)
    for first, second in combinations(circles, 2):
        yield from _on_both(first, second)


def _along(normal: complex, p: complex) -> float:
    return (normal.conjugate() * p).real


def _on_line(circle: Circle, normal: complex, least: float) -> Iterator[complex]:
    """Where a circle crosses the line along which a ball touches a wall."""
    centre, reach = circle
    foot = centre + (least - _along(normal, centre)) * normal
    rest = reach * reach - abs(foot - centre) ** 2
    if rest >= 0.0:
        yield foot + 1j * normal * rest**0.5
        yield foot - 1j * normal * rest**0.5


def _on_both(first: Circle, second: Circle) -> Iterator[complex]:
    """Where two circles cross."""
    (p, a), (q, b) = first, second
    gap = abs(q - p)
    if gap and abs(a - b) <= gap <= a + b:
        turn = acos(min(max((a * a + gap * gap - b * b) / (2 * a * gap), -1.0), 1.0))
        for way in (turn, -turn):
            yield p + a * (q - p) / gap * exp(1j * way)


def _free(p: complex, circles: Sequence[Circle], world: World, reach: float) -> bool:
    """Is a place free?  What was found on an edge may lie half the gap behind it."""
    slack = GAP / 2
    apart = all(abs(p - centre) >= far - slack for centre, far in circles)
    return apart and fits(world, (p.real, p.imag), reach - slack)
