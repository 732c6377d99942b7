"""The resistance to a rolling ball, from how its speed falls."""

from __future__ import annotations

from dataclasses import replace

from physics import Ball, Shot, World, tables

from .readings import happened, runs, slope
from .shape import Field, Given, Lab, Numbers, Rows

START = (-1.15, 0.0)
POINTS = 12


def scene(numbers: Numbers) -> World:
    """A ball that rolls along the table and stops before the cushion."""
    world = tables.medium_carom()
    world.cloth = replace(world.cloth, roll=numbers["roll"])
    world.add(Ball("white", at=START))
    world.strike("white", Shot(numbers["speed"], follow=numbers["speed"]))
    return world


def _speeds(after: World) -> list[tuple[float, float]]:
    step = happened(after, "rest").time / (POINTS + 1)
    times = (step * k for k in range(POINTS))
    return [(time, state.speed) for time, state in runs(after, "white", times)]


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """The line through the measured speeds, and where it ends."""
    rest = happened(after, "rest")
    brake = -slope(*zip(*_speeds(after), strict=True))
    return {
        "brake": brake,
        "roll": brake / after.cloth.gravity,
        "time": rest.time,
        "length": rest.after[0].position[0] - START[0],
    }


def table(after: World, numbers: Numbers) -> Rows:
    """Its speed at twelve moments."""
    return Rows(("time (s)", "speed (m/s)"), _speeds(after))


LAB = Lab(
    "rolling-resistance",
    (Given("speed", "m/s", 0.5, 0.4, 0.6, 0.02),
     Given("roll", "", 0.01, 0.008, 0.014, 0.0005, True)),
    (Field("brake", "m/s²", 0.05), Field("roll", "", 0.05), Field("time", "s", 0.05),
     Field("length", "m", 0.05)),
    scene, truth, table, axes=("time (s)", "speed (m/s)"),
)  # fmt: skip
