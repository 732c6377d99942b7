"""A ball without spin along its way leaves the hit at right angles to the other: what e changes."""

from __future__ import annotations

from math import sqrt

from physics import Ball, Shot, World, laws, tables

from .readings import happened, hit, moved, parting, to_cushion, turned, unit
from .shape import Field, Given, Lab, Numbers, Rows

AWAY = 0.4  # m that the cue ball has to go
SPOT = (0.1, 0.1)


def scene(numbers: Numbers) -> World:
    """A cut whose cue ball has just lost its draw when it meets the other."""
    world = tables.medium_carom()
    world.ball_law = laws.SmoothBall(numbers["e"])
    red = world.add(Ball("red", at=SPOT))
    ghost = moved(SPOT, unit(numbers["cut"]), -2.0 * red.radius)
    world.add(Ball("white", at=moved(ghost, (1.0, 0.0), -AWAY)))
    brake, speed = world.cloth.slide * world.cloth.gravity, numbers["speed"]
    time = (speed - sqrt(speed * speed - 2.0 * brake * AWAY)) / brake
    world.strike("white", Shot(speed, follow=-2.5 * brake * time))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """The hit, right after it."""
    event = happened(after, "ball")
    white, red = event.after["white"], event.after["red"]
    return {
        "angle": turned(white.heading, red.heading),
        "white": white.speed,
        "red": red.speed,
        "e": parting(event),
    }


def table(after: World, numbers: Numbers) -> Rows:
    """The hit."""
    return hit(after, happened(after, "ball"))


LAB = Lab(
    "right-angle",
    (Given("speed", "m/s", 2.0, 1.8, 3.0, 0.1), Given("cut", "°", 40.0, 25.0, 50.0, 1.0),
     Given("e", "", 0.92, 0.85, 0.98, 0.01, True)),
    (
        Field("angle", "°", 0.0, 1.5), Field("white", "m/s"), Field("red", "m/s"),
        Field("e", "", 0.02),
    ),
    scene, truth, table, to_cushion,
)  # fmt: skip
