"""Scenes of any number of balls, at the same density, from one to ten thousand."""

from math import ceil, pi, sqrt
from random import Random

from physics import Ball, Cloth, TimeStepping, World, laws, tables

RADIUS = 0.01


def _box(world: World, side: float) -> None:
    from physics import Wall

    for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        world.add(Wall.line(a, b, 0.5 * side))


def _spots(balls: int, pitch: float) -> list[tuple[float, float]]:
    """A square lattice about the origin."""
    lines = ceil(sqrt(balls))
    return [
        (pitch * (k % lines - 0.5 * (lines - 1)), pitch * (k // lines - 0.5 * (lines - 1)))
        for k in range(balls)
    ]


def gas(balls: int, seed: int = 1) -> World:
    """Discs that lose nothing, in a box that they fill to 30 %, each on its way."""
    pitch = RADIUS * sqrt(pi / 0.3)
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    _box(world, pitch * ceil(sqrt(balls)))
    chance = Random(seed)
    for k, at in enumerate(_spots(balls, pitch)):
        v = (chance.uniform(-1.0, 1.0), chance.uniform(-1.0, 1.0))
        world.add(Ball(f"{k}", at, v, radius=RADIUS, mass=0.1))
    return world


def field(balls: int) -> World:
    """Balls at rest on a cloth, three diameters apart, a little off the lattice."""
    ball = tables.MEDIUM_CAROM
    pitch = 6.0 * ball.radius
    world = World(ball.cloth, ball.ball_law, ball.cushion_law)
    _box(world, pitch * (ceil(sqrt(balls)) + 1))
    chance = Random(2)
    for k, (x, y) in enumerate(_spots(balls, pitch)):
        dx, dy = (chance.uniform(-0.5, 0.5) * ball.radius for _ in "xy")
        world.add(Ball(f"{k}", (x + dx, y + dy), radius=ball.radius, mass=ball.mass))
    return world


def program(world: World) -> World:
    """The same scene for the thesis's program, at its 180 substeps a second."""
    world.engine = TimeStepping(1 / 180, "literal", budget=10**9)
    return world
