"""The thesis's first figure: spin against the motion bends the path back."""

from __future__ import annotations

from physics import Ball, Shot, World, tables

from .readings import happened, heading, runs, to_cushion, turned
from .shape import Field, Given, Lab, Numbers, Rows

LASTS = 5.0  # s: by then it rolls


def scene(numbers: Numbers) -> World:
    """The massé of `scenes.thesis_1`."""
    world = tables.thesis()
    world.add(Ball("white", at=(-1.0, 0.5)))
    world.strike("white", Shot(numbers["speed"], follow=numbers["follow"], masse=numbers["masse"]))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """Where it turns back, and how it would roll if there were no cushions."""
    first, free = after.log.legs("white")[0], scene(numbers)
    push = first.acceleration
    turn = -first.velocity.real / push.real
    for wall in [*free.walls]:
        free.remove(wall)
    free.run(LASTS)
    rolls = happened(free, "roll").after[0]
    return {
        "turn": turn,
        "farthest": first.place(turn).real - first.position.real,
        "push": turned(heading((push.real, push.imag)), 0.0),
        "friction": abs(push) / after.cloth.gravity,
        "speed": rolls.speed,
        "angle": turned(rolls.heading, 0.0),
    }


def table(after: World, numbers: Numbers) -> Rows:
    """Where it is, from the shot to the cushion."""
    seen = runs(after, "white", (after.time * k / 11.0 for k in range(12)))
    heads = "time (s)", "x (m)", "y (m)", "vx (m/s)", "vy (m/s)"
    rows = [(time, *state.position, *state.velocity) for time, state in seen]
    return Rows(heads, rows[:-1])  # at the very last it has met the cushion


LAB = Lab(
    "thesis-masse",
    (Given("speed", "m/s", 2.0, 1.8, 2.2, 0.05), Given("follow", "m/s", -10.0, -11.0, -9.0, 0.25),
     Given("masse", "m/s", 5.0, 4.0, 5.5, 0.25)),
    (Field("turn", "s", 0.05), Field("farthest", "m", 0.05), Field("push", "°", 0.0, 2.0),
     Field("friction", "", 0.05), Field("speed", "m/s"), Field("angle", "°", 0.0, 2.0)),
    scene, truth, table, to_cushion,
)  # fmt: skip
