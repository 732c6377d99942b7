"""How wide a pocket is for a ball that comes at some angle: found by the engine on the table."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import lru_cache
from math import hypot, sqrt
from typing import NamedTuple

from physics import Ball, Shot, World, direction, heading, simulate, tables

STEP = 7.5  # degrees between the angles at which a mouth is measured
WIDEST = {"corner": 6, "side": 10}  # steps: along the rail, and as flat as a side pocket takes
AWAY = 0.4  # m: how far from the mouth the ball is sent off
PACE = 1.2  # m/s: of the rolling ball
TRIED, HALVED = 12, 5  # ways across a mouth, and how often the edges between them are halved
NEAREST = 0.02  # m from the middle of the mouth: a ball nearer than that is as good as down

Edges = tuple[float, float]


class Hole(NamedTuple):
    """A pocket as players see it.

    name: as events have it.
    kind: "corner" or "side".
    middle: of the mouth, m.
    axis: the unit vector into the pocket.
    """

    name: str
    kind: str
    middle: complex
    axis: complex


@lru_cache(maxsize=16)
def holes(table: tables.Table) -> tuple[Hole, ...]:
    """The pockets of a table; ValueError for a table without any."""
    if table.pockets is None:
        raise ValueError(f"{table.name} has no pockets")
    x, y = 0.5 * table.length, 0.5 * table.width
    deep = 0.5 * table.pockets.corner.width * sqrt(0.5)
    found = [
        Hole(f"{up}-{along} pocket", "corner", complex(sx * (x - deep), sy * (y - deep)),
             complex(sx, sy) * sqrt(0.5))
        for sy, up in ((1, "north"), (-1, "south"))
        for sx, along in ((1, "east"), (-1, "west"))
    ]  # fmt: skip
    for sy, up in ((1, "north"), (-1, "south")):
        found.append(Hole(f"{up} pocket", "side", complex(0.0, sy * y), complex(0.0, sy)))
    return tuple(found)


@lru_cache(maxsize=256)
def edges(table: tables.Table, kind: str, step: int) -> Edges | None:
    """How far to the right (below 0) and to the left of the mouth's middle a ball may be aimed that
    comes `step` STEPs anticlockwise of the pocket's axis, m; None if it never drops."""
    hole = next(hole for hole in holes(table) if hole.kind == kind)
    along = hole.axis * direction(STEP * step)
    start = hole.middle - AWAY * along
    if not table.regions["anywhere"].contains((start.real, start.imag)):
        return None
    world = table.world()
    ball = world.add(Ball("ball", (start.real, start.imag)))

    def drops(aside: float) -> bool:
        return _drops(world, ball, hole, heading(along * complex(AWAY, aside)))

    mouth = getattr(table.pockets, kind).width
    ways = [mouth * (k / TRIED - 0.5) for k in range(TRIED + 1)]
    run = _longest([drops(way) for way in ways])
    if not run:
        return None
    right = _edge(drops, ways[run[0]], ways[max(run[0] - 1, 0)])
    left = _edge(drops, ways[run[-1]], ways[min(run[-1] + 1, TRIED)])
    return right, left


def measured(table: tables.Table) -> Iterator[Edges | None]:
    """All edges of a table, one after the other; they are kept."""
    for kind, widest in WIDEST.items():
        for step in range(widest + 1):
            yield edges(table, kind, step)


Gauge = dict[str, tuple[Edges | None, ...]]
"""All edges of a table, by the kind of the pocket and the step."""


@lru_cache(maxsize=16)
def gauge(table: tables.Table) -> Gauge:
    """All that `measured` finds."""
    return {
        kind: tuple(edges(table, kind, step) for step in range(widest + 1))
        for kind, widest in WIDEST.items()
    }


def window(known: Gauge, hole: Hole, at: complex) -> tuple[complex, float, float] | None:
    """The unit vector from a ball to the mouth, and the angles to its right and its left between
    which the ball drops, radians; None if there are none.  Other balls are left out."""
    way = hole.middle - at
    far = hypot(way.real, way.imag)
    if far < NEAREST:
        return None
    way /= far
    turn = way * hole.axis.conjugate()
    angle = heading(turn)
    k, share = divmod(abs(angle) / STEP, 1.0)
    if k >= WIDEST[hole.kind]:
        return None
    near, next_one = known[hole.kind][int(k)], known[hole.kind][int(k) + 1]
    if near is None or next_one is None:
        return None
    right, left = (a + share * (b - a) for a, b in zip(near, next_one, strict=True))
    if angle < 0.0:  # a pocket is its own mirror image
        right, left = -left, -right
    return way, right / far, left / far


def _drops(world: World, ball: Ball, hole: Hole, angle: float) -> bool:
    """Whether a ball that rolls off at that angle goes down without meeting a rail."""
    after = simulate(world, ball, Shot(PACE, angle, follow=PACE))
    # where it bounces: at a nose it is nearer to the mouth than anywhere at a rail
    bends = [leg.position - hole.middle for leg in after.log.legs(ball.name)[1:]]
    deep = -0.8 * ball.radius
    return after.ball(ball).gone and all((p * hole.axis.conjugate()).real > deep for p in bends)


def _longest(drop: list[bool]) -> list[int]:
    """The numbers of the longest run of what drops."""
    best: list[int] = []
    run: list[int] = []
    for k, down in enumerate(drop):
        run = [*run, k] if down else []
        best = run if len(run) > len(best) else best
    return best


def _edge(drops: Callable[[float], bool], inside: float, outside: float) -> float:
    """Where a ball ceases to drop, as far inside as halving leaves it."""
    for _ in range(HALVED if inside != outside else 0):
        middle = 0.5 * (inside + outside)
        inside, outside = (middle, outside) if drops(middle) else (inside, middle)
    return inside
