"""Momentum and energy before and after two moving balls hit each other in the plane."""

from __future__ import annotations

from physics import Ball, Shot, World, laws, tables

from .readings import (
    happened,
    hit,
    masses,
    momentum,
    moved,
    moving,
    parting,
    to_cushion,
    unit,
)
from .shape import Field, Given, Lab, Numbers, Rows

BEFORE = 0.3  # s until they hit


def scene(numbers: Numbers) -> World:
    """Two balls without spin that meet in the middle."""
    world = tables.medium_carom()
    world.ball_law = laws.SmoothBall(numbers["e"])
    shots = (
        ("white", -1.0, numbers["white_speed"], numbers["white_angle"]),
        ("red", 1.0, numbers["red_speed"], numbers["red_angle"]),
    )
    brake, across = world.cloth.slide * world.cloth.gravity, unit(numbers["line"])
    for name, sign, speed, angle in shots:
        ball = Ball(name, (0.0, 0.0), radius=world.table.radius, mass=numbers[f"{name}_mass"])
        touching = moved((0.0, 0.0), across, sign * ball.radius)
        way = speed * BEFORE - 0.5 * brake * BEFORE * BEFORE
        ball.position = moved(touching, unit(angle), -way)
        world.add(ball)
        world.strike(name, Shot(speed, angle))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """Sums over both balls, right before and right after the hit."""
    event = happened(after, "ball")
    weights = masses(after, event)
    x, y = momentum(event.before, weights)
    return {
        "px": x,
        "py": y,
        "before": moving(event.before, weights),
        "after": moving(event.after, weights),
        "e": parting(event),
    }


def table(after: World, numbers: Numbers) -> Rows:
    """The hit."""
    return hit(after, happened(after, "ball"))


LAB = Lab(
    "momentum-energy",
    (
        Given("white_mass", "kg", 0.25, 0.2, 0.3, 0.01),
        Given("red_mass", "kg", 0.2, 0.16, 0.24, 0.01),
        Given("white_speed", "m/s", 2.0, 1.6, 2.4, 0.1),
        Given("white_angle", "°", -20.0, -35.0, -5.0, 1.0),
        Given("red_speed", "m/s", 1.5, 1.2, 1.8, 0.1),
        Given("red_angle", "°", 150.0, 135.0, 160.0, 1.0),
        Given("line", "°", 20.0, 5.0, 30.0, 1.0, True),
        Given("e", "", 0.9, 0.8, 0.98, 0.01, True),
    ),
    (
        Field("px", "kg m/s", 0.03, 0.005), Field("py", "kg m/s", 0.03, 0.005),
        Field("before", "J"), Field("after", "J"), Field("e", "", 0.04),
    ),
    scene, truth, table, to_cushion,
)  # fmt: skip
