"""The kernel in 50-digit numbers: the same source, bound to mpmath."""

from dataclasses import fields
from functools import cache
from types import ModuleType
from typing import Any

import mpmath

from physics import World
from physics.binding import load
from physics.kernel.subset import room

DIGITS = 50


ELEMENTARY = {
    "direction": lambda degrees: mpmath.expjpi(exact(degrees) / 180),
    "exp": mpmath.exp,
}


def _custom(*_: Any) -> Any:
    raise NotImplementedError("custom laws are not run in 50 digits")


@cache
def kernel() -> ModuleType:
    """The kernel package whose numbers may be mpf and mpc."""
    mpmath.mp.dps = DIGITS
    subset = ModuleType("physics.fifty_digit_kernel.subset")
    vars(subset).update(
        kernel=lambda function: function, inf=mpmath.inf, nan=mpmath.nan, sqrt=mpmath.sqrt,
        elementary=lambda function: ELEMENTARY[function.__name__],
        complex=mpmath.mpc, custom_ball=_custom, custom_cushion=_custom,
        whole=lambda function: function, room=room,
    )  # fmt: skip
    package: Any = load("physics.fifty_digit_kernel", subset)
    package.contact.NEAR = mpmath.mpf("1e-26")  # the gap left behind is its square
    package.contact.ROUNDS = 200
    package.impulses.AGREES = mpmath.mpf("1e-45")
    return package


def exact(value: Any) -> Any:
    if isinstance(value, complex):
        return mpmath.mpc(value)
    return mpmath.mpf(value) if isinstance(value, float) else value


def record(item: Any) -> Any:
    copy = object.__new__(type(item))
    for field in fields(item):
        setattr(copy, field.name, exact(getattr(item, field.name)))
    if hasattr(copy, "level"):
        copy.level = mpmath.sqrt(1 - copy.height * copy.height)
    return copy


def scene(world: World) -> Any:
    """The scene of a world at time 0, planned, for this kernel."""
    package: Any = kernel()
    world.plan()
    scene = world.scene
    mine = scene._replace(
        balls=[record(ball) for ball in scene.balls], meetings=[mpmath.inf] * len(scene.meetings),
        walls=[record(wall) for wall in scene.walls], cloth=record(scene.cloth),
        ball_rule=record(scene.ball_rule), cushion_rule=record(scene.cushion_rule),
        rules=[record(rule) for rule in scene.rules],
        openings=[record(side) for side in scene.openings],
        ties=package.body.ties(len(scene.balls)), grid=package.body.no_grid(len(scene.balls)),
    )  # fmt: skip
    package.calendar.plan(mine)
    return mine


def rest(world: World, until: float = float("inf")) -> tuple[list[Any], int]:
    """Where the balls of a world at time 0 come to rest, as mpc, and after how many events."""
    mine = scene(world)
    events, _ = kernel().calendar.advance(until, 10**5, mine)
    return [ball.position for ball in mine.balls], events
