"""Scenes that tests, benchmarks, the game and the command line share; a new one is one function."""

from collections.abc import Callable
from math import sqrt

from . import laws, tables
from .ball import Ball
from .checks import whole
from .cloth import Cloth
from .engines.exact import EventDriven
from .post import Post
from .shot import Shot, direction
from .wall import Wall
from .world import World

__all__ = [
    "SCENES", "carom", "cradle", "pi_collisions", "rack15", "single", "thesis_1", "thesis_2",
    "thesis_3a", "thesis_3b",
]  # fmt: skip

R = tables.THESIS.radius


def thesis_1() -> World:
    """The thesis's massé: spin against the motion bends the path back (V 2, WxR -10, WyR 5)."""
    world = tables.thesis()
    world.add(Ball("white", at=(-1.0, 0.5)))
    world.strike("white", Shot(2.0, follow=-10.0, masse=5.0))
    return world


def thesis_2() -> World:
    """The thesis's cushion with side: the path bends at the cushion (V 1, WxR 1, WzR 3)."""
    world = tables.thesis()
    world.add(Ball("white", at=(0.0, 0.0)))
    world.strike("white", Shot(1.0, follow=1.0, side=3.0))
    return world


def _thesis_3(angle: float) -> World:
    world = tables.thesis()
    world.add(Ball("red", at=(-0.5, 0.3)))
    world.add(Ball("yellow", at=(0.62, -0.48)))
    world.strike("red", Shot(1.0, angle))
    world.strike("yellow", Shot(2.0, 150.0))
    return world


def thesis_3a() -> World:
    """The thesis's two balls, nearly head-on: they swap their velocities."""
    return _thesis_3(-45.0)


def thesis_3b() -> World:
    """The thesis's two balls, oblique."""
    return _thesis_3(-50.0)


def single() -> World:
    """One ball around the table, with side."""
    world = tables.thesis()
    world.add(Ball("white", at=(-0.6, 0.0)))
    world.ball_law, world.cushion_law = "rough", laws.RigidCushion(0.9, 0.1, 1.4)
    world.strike("white", Shot(3.0, 25.0, follow=0.5, side=1.5))
    return world


def carom() -> World:
    """Four balls, all at rest, waiting for a shot at the white."""
    world = tables.medium_carom()
    for name, at in (
        ("white", (-0.6, 0.0)), ("yellow", (0.6, 0.01)), ("red", (-0.2, 0.3)), ("red 2", (0.3,
    -0.3)) ):  # fmt: skip
        world.add(Ball(name, at=at))
    return world


def rack15(gap: float = 1e-5, speed: float = 8.0) -> World:
    """Fifteen balls in a triangle, gaps in metres, and a cue ball on its way at `speed` m/s."""
    world = tables.thesis()
    world.ball_law, world.cushion_law = "rough", laws.RigidCushion(0.9, 0.1, 1.4)
    world.add(Ball("cue", at=(-0.6, 0.0)))
    pitch = 2.0 * R + gap
    for row in range(5):
        for place in range(row + 1):
            y = (place - 0.5 * row) * pitch
            world.add(Ball(f"{len(world.balls)}", at=(0.5 + row * pitch * sqrt(0.75), y)))
    world.strike("cue", Shot(speed))
    return world


def cradle(balls: int = 5, angle: float = 0.0) -> World:
    """Newton's cradle: on ice, a ball runs at 1 m/s, at `angle` degrees, into a row that touches.

    ValueError unless balls is a whole number from 1 to 10 000.
    """
    balls = whole("cradle balls", balls, 1, 10_000)
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0))
    line = direction(angle)
    for k in range(balls):
        p = (2.0 * R * k - (0.1 if k == 0 else 0.0)) * line
        world.add(Ball(f"{k}", at=(p.real, p.imag)))
    world.strike("0", Shot(1.0, angle))
    return world


def pi_collisions(digits: int = 3) -> World:
    """A heavy ball drives a light one into a wall: their collisions count out the digits of π.

    Nothing is lost and nothing rubs; the masses are as 100^(digits - 1) to 1 (Galperin 2003).
    ValueError unless digits is a whole number from 1 to 26: no ball is heavier than 1e50 kg.
    """
    digits = whole("pi_collisions digits", digits, 1, 26)
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    world.engine = EventDriven(vmin=0.0, budget=4 * 10**digits)
    world.add(Wall.line(1.0, 0.0, 0.0, "wall"))
    world.add(Ball("light", at=(0.5, 0.0), mass=1.0))
    world.add(Ball("heavy", at=(1.0, 0.0), mass=float(100 ** (digits - 1)), velocity=(-1.0, 0.0)))
    return world


def sinai() -> World:
    """Sinai's billiard: on ice, a ball among mirrors around a post, which spreads paths apart."""
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    for p, q, name in (
        ((-0.5, -0.5), (0.5, -0.5), "south"), ((0.5, -0.5), (0.5, 0.5), "east"),
        ((0.5, 0.5), (-0.5, 0.5), "north"), ((-0.5, 0.5), (-0.5, -0.5), "west"),
    ):  # fmt: skip
        world.add(Wall.segment(p, q, name))
    world.add(Post((0.0, 0.0), 0.2, "post"))
    world.add(Ball("white", at=(-0.4, 0.1)))
    world.strike("white", Shot(1.0, 20.0))
    return world


def stadium() -> World:
    """Bunimovich's stadium: on ice, a ball among mirrors, two straight and two round, which make
    paths meet and then part."""
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    world.add(Wall.segment((-0.5, -0.5), (0.5, -0.5), "south"))
    world.add(Wall.arc((0.5, 0.0), 0.5, -90.0, 90.0, "east"))
    world.add(Wall.segment((0.5, 0.5), (-0.5, 0.5), "north"))
    world.add(Wall.arc((-0.5, 0.0), 0.5, 90.0, 270.0, "west"))
    world.add(Ball("white", at=(-0.4, 0.1)))
    world.strike("white", Shot(1.0, 35.0))
    return world


SCENES: dict[str, Callable[[], World]] = {
    scene.__name__: scene
    for scene in (
        thesis_1, thesis_2, thesis_3a, thesis_3b, single, carom, rack15, cradle, pi_collisions,
        sinai, stadium,
    )
}


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
