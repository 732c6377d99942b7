"""Do the balls fit where they were placed: inside the walls, and not into one another?"""

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from math import hypot
from operator import itemgetter
from typing import Any

from .ball import Ball
from .kernel.body import Rule
from .kernel.motion import length
from .kernel.obstacle import Shape, clearance, nose
from .laws import cushion_rule
from .wall import Obstacle

Spot = tuple[float, float, float, float, float, Ball]  # west end, place in space, radius

OVERLAP = 1e-9  # m: how far things may overlap, by rounding, in a scene typed by hand


def check_places(
    balls: Sequence[Ball],
    walls: Sequence[Obstacle],
    fresh: Sequence[Obstacle],
    rule: Rule,
    dt: float,
) -> None:
    """ValueError, naming the ball, if one that was placed lies outside the walls, in a post, over a
    pocket or in another ball, or if any lies so at a new one of these.

    Overlaps left by an engine of fixed steps are not the caller's fault. rule: the cushions'.
    dt: the engine's step, s, or 0.
    """
    # fixed steps notice a contact when things overlap by what they move in a step
    slack = OVERLAP + (2.0 * dt * max(map(_speed, balls), default=0.0) if dt else 0.0)
    spots = _spots(ball for ball in balls if not ball.gone)
    for _, x, y, _, radius, ball in spots:
        p, level = complex(x, y), ball.on_cloth
        for wall in walls if ball.put else fresh:
            if not _beside(wall.shape, x, y, radius):
                continue
            depth = -clearance(wall.shape, p, radius) if level else _depth(ball, wall, rule)
            if depth > slack:
                where = "outside" if wall.kind == "line" else "in"
                raise ValueError(f"{ball!r} is {where} the {wall.noun} {wall.name or wall!r}")
    for ball, other in _pairs(spots, slack):
        if ball.put or other.put:
            raise ValueError(f"{ball!r} and {other!r} overlap")


def check_table(balls: Iterable[Ball], walls: Sequence[Obstacle], table: Any) -> None:
    """ValueError, naming the ball, if one that was placed on the cloth lies behind the rails of a
    table with pockets, which end: no line tells there."""
    if getattr(table, "pockets", None) is None or len(walls) < len(table.obstacles):
        return  # a custom table, or one that was opened
    for ball in balls:
        if ball.put and ball.on_cloth and not ball.gone:
            p = complex(*ball.position)
            if off_bed(p, table) and not within(table.outline, p):
                raise ValueError(f"{ball!r} is outside the table {table.name!r}")


def off_bed(p: Any, table: Any) -> Any:
    """Is the point, or each of an array, beyond the noses: in a mouth, or behind a cushion?"""
    return (abs(p.real) > 0.5 * table.length) | (abs(p.imag) > 0.5 * table.width)


def within(corners: Sequence[complex], p: complex) -> bool:
    """Is the point in the polygon?"""
    inside = False
    for a, b in pairwise([*corners, corners[0]]):
        if (a.imag > p.imag) != (b.imag > p.imag):
            across = a.real + (p.imag - a.imag) / (b.imag - a.imag) * (b.real - a.real)
            inside ^= p.real < across
    return inside


def _speed(ball: Ball) -> float:
    return float(length(complex(*ball.velocity)))


def overlapping(balls: Iterable[Ball], slack: float) -> Iterator[tuple[Ball, Ball]]:
    """The pairs that overlap by more than slack, m."""
    return _pairs(_spots(balls), slack)


def _spots(balls: Iterable[Ball]) -> list[Spot]:
    """Where the balls are."""
    return [
        (x - ball.radius, x, y, ball.height + ball.body.lift, ball.radius, ball)
        for ball in balls
        for x, y in (ball.position,)
    ]


def _pairs(spots: list[Spot], slack: float) -> Iterator[tuple[Ball, Ball]]:
    """Those that overlap; from west to east, so that most pairs are never looked at."""
    spots = sorted(spots, key=itemgetter(0))
    for i, (_, x, y, z, r, ball) in enumerate(spots):
        for west, u, v, w, s, other in spots[i + 1 :]:
            if west > x + r:
                break
            if hypot(u - x, v - y, w - z) < r + s - slack:
                yield ball, other


def _beside(shape: Shape, x: float, y: float, r: float) -> bool:
    """Do the boxes around it and a ball touch?  On a table with pockets they seldom do."""
    across = shape.west <= x + r and shape.east >= x - r
    return across and shape.south <= y + r and shape.north >= y - r


def _depth(ball: Ball, wall: Obstacle, rule: Rule) -> float:
    """How far the ball is in the wall, m; in the air only the wall's nose is in its way."""
    if not wall.pushes:
        return -wall.distance(ball.position) if ball.height == 0.0 else 0.0
    if wall.own_law is not None:
        rule = cushion_rule(wall.own_law, rule.parting, rule)
    across, above = nose(wall.shape, complex(*ball.position), ball.radius, ball.height, rule)
    if ball.height > 0.0 and across > 0.0:
        return ball.radius - hypot(across, above)
    return ball.radius - wall.distance(ball.position)
