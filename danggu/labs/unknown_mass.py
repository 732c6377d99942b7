"""The mass of a ball, from how another one is thrown off its way by it."""

from __future__ import annotations

from physics import Ball, Shot, World, laws, tables

from .readings import happened, hit, masses, moved, moving, parting, to_cushion, unit
from .shape import Field, Given, Lab, Numbers, Rows

AWAY = 0.3  # m that the cue ball has to go
SPOT = (0.0, 0.0)


def scene(numbers: Numbers) -> World:
    """A ball of known mass meets one of unknown mass that lies still."""
    world = tables.medium_carom()
    world.ball_law = laws.SmoothBall(numbers["e"])
    radius = world.table.radius
    ghost = moved(SPOT, unit(numbers["cut"]), -2.0 * radius)
    world.add(Ball("white", moved(ghost, (1.0, 0.0), -AWAY), mass=numbers["known"]))
    world.add(Ball("red", SPOT, mass=numbers["mass"]))
    world.strike("white", Shot(numbers["speed"]))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """The mass that was weighed by the hit."""
    event = happened(after, "ball")
    weights = masses(after, event)
    before = moving(event.before, weights)
    return {
        "mass": after.ball("red").mass,
        "e": parting(event),
        "lost": 100.0 * (before - moving(event.after, weights)) / before,
    }


def table(after: World, numbers: Numbers) -> Rows:
    """The hit, without the masses."""
    heads, rows = hit(after, happened(after, "ball"))
    return Rows((heads[0], *heads[2:]), [(row[0], *row[2:]) for row in rows])


LAB = Lab(
    "unknown-mass",
    (Given("known", "kg", 0.25, 0.2, 0.3, 0.01), Given("speed", "m/s", 2.0, 1.5, 3.0, 0.1),
     Given("cut", "°", 25.0, 10.0, 40.0, 1.0), Given("mass", "kg", 0.17, 0.12, 0.4, 0.01, True),
     Given("e", "", 0.95, 0.85, 0.98, 0.01, True)),
    (Field("mass", "kg", 0.04), Field("e", "", 0.03), Field("lost", "%", 0.06, 0.5)),
    scene, truth, table, to_cushion,
)  # fmt: skip
