"""The cue ball in hand: where it may be placed, and what forbids a place."""

from __future__ import annotations

from collections.abc import Iterator
from math import dist
from typing import NamedTuple

from danggu.rules.state import ANYWHERE, HOUSE, KITCHEN, D
from physics import World

Point = tuple[float, float]

SPOTS = {ANYWHERE: "head", KITCHEN: "head", D: "brown", HOUSE: "front"}
ASIDE = 0.15  # m: from the middle of the D, where the brown may lie
GRID = 0.02  # m: between the places that are tried
GAP = 1e-6  # m: kept free between balls, more than rounding


class Hindrance(NamedTuple):
    """Why a ball cannot be placed.

    why: "region" (outside of where it may be), "ball" (one is in the way) or "cushion".
    ball: the name of that ball, or "".
    """

    why: str
    ball: str = ""


def hindrance(world: World, name: str, at: Point, region: str) -> Hindrance | None:
    """What forbids a ball to be placed there (m); None if it may be. `region` as in the rules."""
    table = world.table
    if not table.regions[region].contains(at):
        return Hindrance("region")
    own = world.ball(name)
    for ball in world.balls:
        near = own.touching_distance(ball) + GAP
        if ball.name != name and not ball.gone and dist(ball.position, at) < near:
            return Hindrance("ball", ball.name)
    if any(wall.distance(at) < own.radius for wall in world.walls if wall.pushes):
        return Hindrance("cushion")
    return None


def usual(world: World, name: str, region: str) -> Point:
    """The usual place of the ball in that region, or the free one nearest to it, m."""
    table = world.table
    spots = table.spots
    x, y = spots.get(SPOTS[region], (-0.25 * table.length, 0.0))
    y -= ASIDE * (region == D)
    for at in _around((x, y), max(table.length, table.width)):
        if hindrance(world, name, at, region) is None:
            return at
    raise ValueError(f"there is no room for {name!r} in the region {region!r}")


def _around(middle: Point, far: float) -> Iterator[Point]:
    """Places on a grid, the nearest rings first."""
    yield middle
    for ring in range(1, int(far / GRID)):
        steps = [k * GRID for k in range(-ring, ring + 1)]
        edge = ring * GRID
        places = [(x, y) for x in steps for y in steps if max(abs(x), abs(y)) >= edge - GRID / 2]
        for x, y in sorted(places, key=lambda p: (p[0] * p[0] + p[1] * p[1], p)):
            yield middle[0] + x, middle[1] + y
