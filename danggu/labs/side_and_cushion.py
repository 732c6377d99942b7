"""Side changes the angle at which a ball comes off a cushion."""

from __future__ import annotations

from math import atan2, degrees

from physics import Ball, Event, Shot, World, tables

from .readings import for_seconds, happened, moved, root, unit
from .shape import Field, Figure, Given, Lab, Numbers, Rows

NOSE = (1.2, 0.1)
AWAY = 0.8  # m from the cushion
SHARES = (-1.0, -0.5, 0.0, 0.5, 1.0)  # of the most side that is tried
MOST = 4.0  # m/s of side: more than any worksheet asks for


def scene(numbers: Numbers, side: float | None = None) -> World:
    """A rolling ball on its way to a cushion, with side to the right."""
    world = tables.medium_carom()
    angle, speed = numbers["angle"], numbers["speed"]
    world.add(Ball("white", at=moved(NOSE, unit(angle), -AWAY)))
    spun = numbers["side"] if side is None else side
    world.strike("white", Shot(speed, angle, follow=speed, side=spun))
    return world


def comes_off(numbers: Numbers, side: float) -> World:
    """The scene with another side, played."""
    world = scene(numbers, side)
    LAB.play(world)
    return world


def _off(event: Event) -> float:
    """The angle from the cushion's normal, degrees; less than 0 where the ball comes back."""
    x, y = event.after[0].velocity
    return degrees(atan2(y, -x))


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """Angles right after the cushion, and the side for which the ball leaves straight."""

    def off(side: float) -> float:
        return _off(happened(comes_off(numbers, side), "cushion"))

    side = numbers["side"]
    return {
        "none": off(0.0), "right": off(side), "left": off(-side), "straight": root(off, 0.0, MOST)
    }  # fmt: skip


def table(after: World, numbers: Numbers) -> Rows:
    """Velocities before and after the cushion, for five sides."""
    sides = [share * numbers["side"] for share in SHARES]
    events = [happened(comes_off(numbers, side), "cushion") for side in sides]
    heads = ("side (m/s)", "vx before (m/s)", "vy before (m/s)", "vx after (m/s)",
             "vy after (m/s)")  # fmt: skip
    both = zip(sides, events, strict=True)
    return Rows(heads, [(s, *e.before[0].velocity, *e.after[0].velocity) for s, e in both])


def others(numbers: Numbers) -> Figure:
    """Without side, and with side to the left."""
    return [comes_off(numbers, 0.0), comes_off(numbers, -numbers["side"])]


LAB = Lab(
    "cushion-side",
    (Given("speed", "m/s", 1.5, 1.2, 2.0, 0.1), Given("angle", "°", 14.0, 10.0, 18.0, 1.0),
     Given("side", "m/s", 1.8, 1.8, 2.4, 0.1)),
    (*(Field(name, "°", 0.0, 1.5) for name in ("none", "right", "left")),
     Field("straight", "m/s", 0.1, 0.2)),
    scene, truth, table, for_seconds(1.5), others, ("side (m/s)", "angle (°)"),
)  # fmt: skip
