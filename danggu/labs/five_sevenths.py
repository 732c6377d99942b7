"""A ball struck in the middle slides, and rolls in the end at five sevenths of its speed."""

from __future__ import annotations

from dataclasses import replace
from math import hypot

from physics import Ball, Shot, World, tables

from .readings import for_seconds, happened, runs
from .shape import Field, Given, Lab, Numbers, Rows

START = (-1.0, 0.0)


def scene(numbers: Numbers, follow: float = 0.0) -> World:
    """The ball, struck along the table."""
    world = tables.medium_carom()
    world.cloth = replace(world.cloth, slide=numbers["friction"])
    world.add(Ball("white", at=START))
    world.strike("white", Shot(numbers["speed"], follow=follow))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """When it begins to roll, and the draw with which it would stop instead."""
    rolls, white = happened(after, "roll"), after.ball("white")
    begin, then = (leg.energy(white.mass) for leg in after.log.legs("white")[:2])
    x, y = rolls.after[0].position
    return {
        "speed": rolls.after[0].speed,
        "time": rolls.time,
        "length": hypot(x - START[0], y - START[1]),
        "friction": after.cloth.slide,
        "lost": 100.0 * (begin - then) / begin,
        "draw": _stopping(numbers),
    }


def _stopping(numbers: Numbers) -> float:
    """The draw for which the rest is nought, by the line through two shots: the law is linear."""
    draw = numbers["speed"]
    plain, drawn = (_rolls(numbers, follow) for follow in (0.0, -draw))
    return draw * plain / (plain - drawn)


def _rolls(numbers: Numbers, follow: float) -> float:
    """The speed along the table at which it begins to roll."""
    world = scene(numbers, follow)
    for_seconds(2.0)(world)
    return happened(world, "roll").after[0].velocity[0]


def table(after: World, numbers: Numbers) -> Rows:
    """The ball while it slides, and a little longer."""
    step = happened(after, "roll").time / 8.0
    seen = runs(after, "white", (step * k for k in range(12)))
    rows = [(time, state.position[0] - START[0], state.speed) for time, state in seen]
    return Rows(("time (s)", "way (m)", "speed (m/s)"), rows)


LAB = Lab(
    "five-sevenths",
    (Given("speed", "m/s", 1.5, 1.0, 1.8, 0.1), Given("friction", "", 0.2, 0.16, 0.3, 0.01, True)),
    (
        Field("speed", "m/s"), Field("time", "s", 0.05), Field("length", "m", 0.05),
        Field("friction", "", 0.05), Field("lost", "%", 0.05), Field("draw", "m/s"),
    ),
    scene, truth, table, for_seconds(1.0), axes=("time (s)", "speed (m/s)"),
)  # fmt: skip
