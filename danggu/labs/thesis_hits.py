"""The thesis's third figure, in two labs: balls that swap velocities, and lose momentum."""

from __future__ import annotations

from math import hypot

from physics import Ball, Shot, World, tables

from .readings import happened, hit, masses, momentum, moving, to_cushion
from .shape import Field, Given, Lab, Numbers, Rows


def scene(numbers: Numbers) -> World:
    """The two balls of `scenes.thesis_3a` and `scenes.thesis_3b`."""
    world = tables.thesis()
    world.add(Ball("red", at=(-0.5, 0.3)))
    world.add(Ball("yellow", at=(0.62, -0.48)))
    world.strike("red", Shot(numbers["red_speed"], numbers["angle"]))
    world.strike("yellow", Shot(numbers["yellow_speed"], 150.0))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """What the thesis's law, by which the speeds along the line of centres swap, makes of them."""
    event = happened(after, "ball")
    weights = masses(after, event)
    (x, y), (u, v) = (momentum(states, weights) for states in (event.before, event.after))
    before = moving(event.before, weights)
    return {
        "red": event.after["red"].speed,
        "yellow": event.after["yellow"].speed,
        "momentum": hypot(u - x, v - y),
        "lost": 100.0 * (before - moving(event.after, weights)) / before,
    }


def table(after: World, numbers: Numbers) -> Rows:
    """The hit."""
    return hit(after, happened(after, "ball"))


FIELDS = (
    Field("red", "m/s"), Field("yellow", "m/s"), Field("momentum", "kg m/s", 0.05),
    Field("lost", "%", 0.06, 0.3),
)  # fmt: skip


def _lab(name: str, angle: float) -> Lab:
    given = (
        Given("red_speed", "m/s", 1.0, 0.98, 1.02, 0.01),
        Given("yellow_speed", "m/s", 2.0, 1.96, 2.04, 0.01),
        Given("angle", "°", angle, angle - 0.5, angle + 0.5, 0.25),
    )
    return Lab(name, given, FIELDS, scene, truth, table, to_cushion)


LABS = (_lab("thesis-swap", -45.0), _lab("thesis-oblique", -50.0))
