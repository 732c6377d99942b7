"""The thesis's second figure: with side, the path bends at the cushion."""

from __future__ import annotations

from physics import Ball, Shot, World, tables

from .readings import for_seconds, happened, heading, turned
from .shape import Field, Given, Lab, Numbers, Rows


def scene(numbers: Numbers) -> World:
    """The cushion with side of `scenes.thesis_2`."""
    world = tables.thesis()
    world.add(Ball("white", at=(0.0, 0.0)))
    speed = numbers["speed"]
    world.strike("white", Shot(speed, follow=speed, side=numbers["side"]))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """Around the first cushion."""
    event, white = happened(after, "cushion"), after.ball("white")
    before, then = event.before[0], event.after[0]
    return {
        "angle": turned(then.heading, heading((-before.velocity[0], 0.0))),
        "ratio": abs(then.velocity[0] / before.velocity[0]),
        "side": then.spin[2] * white.radius,
        "lost": 1000.0 * event.energy_lost,
    }


def table(after: World, numbers: Numbers) -> Rows:
    """Velocity and spin around the cushion, as speeds of the ball's surface."""
    event, radius = happened(after, "cushion"), after.ball("white").radius
    moments = ("before", event.before[0]), ("after", event.after[0])
    heads = ("moment", "vx (m/s)", "vy (m/s)", "wx R (m/s)", "wy R (m/s)", "wz R (m/s)")
    return Rows(heads, [(word, *s.velocity, *(w * radius for w in s.spin)) for word, s in moments])


LAB = Lab(
    "thesis-cushion",
    (Given("speed", "m/s", 1.0, 0.8, 1.4, 0.05), Given("side", "m/s", 3.0, 2.0, 4.0, 0.25)),
    (Field("angle", "°", 0.0, 1.5), Field("ratio", "", 0.03), Field("side", "m/s", 0.04),
     Field("lost", "mJ", 0.06, 1.0)),
    scene, truth, table, for_seconds(3.0),
)  # fmt: skip
