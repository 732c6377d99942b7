"""What a stress family is made of: trials, a world and what is done to it, and dice for them."""

from cmath import rect
from collections.abc import Callable
from math import inf, pi
from random import Random
from typing import NamedTuple

from physics import Ball, Cloth, EventBudgetError, EventDriven, Wall, World, laws

from . import aloft
from .invariants import faults

BUDGET = 100_000  # events: contacts that are driven touch 1 000 times a second
RADIUS = 0.03275


class Finding(Exception):  # noqa: N818 - it is a finding, no error
    """What a drive saw go wrong."""


class Trial(NamedTuple):
    """A world, and what is done to it before the log is checked: by default it runs to rest."""

    world: World
    drive: Callable[[World], None] = World.run
    pushed: bool = False  # on the way, by the caller


Family = Callable[[int, Random], Trial]


def outcome(trial: Trial) -> tuple[list[str], int]:
    """(what went wrong, how many events there were)."""
    world = trial.world
    try:
        trial.drive(world)
    except EventBudgetError as error:
        return [str(error)], len(world.log)
    except (Finding, ValueError, ArithmeticError) as error:
        return [f"{type(error).__name__}: {error}"], len(world.log)
    found = aloft.faults(world) if aloft.flew(world) else faults(world, trial.pushed)
    return found, len(world.log)


def engine(vmin: float = 1e-3) -> EventDriven:
    return EventDriven(vmin=vmin, budget=BUDGET)


def box(length: float = 2.54, width: float = 1.27, tilt: float = 0.0) -> list[Wall]:
    """Four walls around the origin, turned by `tilt` radians."""
    sides = ((1, 0.5 * length), (1j, 0.5 * width), (-1, 0.5 * length), (-1j, 0.5 * width))
    return [
        Wall.line(n.real, n.imag, d, name)
        for name, n, d in (
            (name, side * rect(1.0, tilt), d)
            for name, (side, d) in zip(("west", "south", "east", "north"), sides, strict=True)
        )
    ]


BALL_LAWS: tuple[laws.BallLaw, ...] = (
    laws.SmoothBall(), laws.SmoothBall(1.0), laws.SmoothBall(0.0), laws.RoughBall(),
    laws.RoughBall(0.95, 0.06), laws.RoughBall(1.0, 1.0), laws.ThesisBall(),
)  # fmt: skip
CUSHION_LAWS: tuple[laws.CushionLaw, ...] = (
    laws.RigidCushion(), laws.RigidCushion(0.9, 0.1, 1.4), laws.RigidCushion(1.0, 0.0, 1.0),
    laws.RigidCushion(0.0, 0.5, 1.2), laws.ThesisCushion(), laws.CappedCushion(),
    laws.MathavanCushion(), laws.MathavanCushion(0.98, 0.14, 0.212, 1.4),
)  # fmt: skip


def world_of(dice: Random, walls: bool = True) -> World:
    """An empty world with laws drawn by lot, walls at an odd angle half of the time."""
    world = World(
        Cloth(dice.uniform(0.1, 0.4), dice.uniform(0.004, 0.02), dice.uniform(0.0, 15.0)),
        dice.choice(BALL_LAWS), dice.choice(CUSHION_LAWS), engine(),
    )  # fmt: skip
    if walls:
        for wall in box(tilt=dice.choice((0.0, dice.uniform(0.0, pi)))):
            world.add(wall)
    return world


def push(ball: Ball, dice: Random, speed: float) -> None:
    """A velocity of up to `speed`, m/s, and spin with up to twice that at the surface."""
    v = rect(dice.uniform(0.0, speed), dice.uniform(-pi, pi))
    ball.velocity = (v.real, v.imag)
    ball.spin = tuple(dice.uniform(-2.0, 2.0) * speed / ball.radius for _ in range(3))


def apart(world: World, ball: Ball, new: Ball) -> float:
    """How far from a ball of the world one that is not in it yet will touch it, metres."""
    return ball.radius + new.radius if world.discs else ball.touching_distance(new)


def gap(ball: Ball, world: World) -> float:
    """From a ball to the nearest thing in its world, metres."""
    p = complex(*ball.position)
    near = min(
        (wall.distance(ball.position) - wall.pushes * ball.radius for wall in world.walls),
        default=inf,
    )
    return min(
        [near] + [abs(complex(*b.position) - p) - apart(world, b, ball) for b in world.balls]
    )


def spot(dice: Random, world: World, ball: Ball, freely: bool) -> complex:
    """Anywhere; unless freely, often touching a ball or one or two of the walls."""
    kind = 0.5 if freely else dice.random()
    if kind < 0.3 and world.balls:
        other = dice.choice(world.balls)
        return complex(*other.position) + rect(apart(world, other, ball), dice.uniform(-pi, pi))
    p = complex(dice.uniform(-1.24, 1.24), dice.uniform(-1.24, 1.24))
    for _ in range(0 if kind < 0.7 else 1 if kind < 0.9 else 2):
        wall = dice.choice(world.walls)
        p -= (wall.distance((p.real, p.imag)) - ball.radius) * wall.normal
    return p


def scatter(
    world: World, balls: int, dice: Random, alike: bool = True, freely: bool = False
) -> None:
    """Put balls where there is room; rounding decides by how little those that touch overlap."""
    for k in range(balls):
        radius, mass = (
            (RADIUS, 0.25) if alike else (dice.uniform(0.01, 0.05), dice.uniform(0.01, 1.0))
        )
        for _ in range(30):
            ball = Ball(f"{k}", at=(0.0, 0.0), radius=radius, mass=mass)
            p = spot(dice, world, ball, freely)
            ball.position = (p.real, p.imag)
            if gap(ball, world) > -1e-15:
                world.add(ball)
                break
