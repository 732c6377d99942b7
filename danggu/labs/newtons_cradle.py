"""Newton's cradle: as many balls leave the row as have run into it."""

from __future__ import annotations

from physics import Ball, Cloth, World, laws

from .readings import for_seconds, momentum, moving
from .shape import Field, Given, Lab, Numbers, Rows

GAP = 0.1  # m between the balls that run and the row
MASS, RADIUS = 0.25, 0.03275


def scene(numbers: Numbers) -> World:
    """On ice, balls that touch run into a row that touches; nothing is lost."""
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0))
    count, running = int(numbers["balls"]), int(numbers["running"])
    middle = 0.5 * (count - 1)
    for k in range(count):
        runs = k < running
        at = 2.0 * RADIUS * (k - middle) - (GAP if runs else 0.0)
        speed = numbers["speed"] if runs else 0.0
        world.add(Ball(f"{k + 1}", (at, 0.0), (speed, 0.0), radius=RADIUS, mass=MASS))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """The balls that move after the hit, and what they carry."""
    states = [*after.log.at(after.time).values()]
    leave = [state for state in states if state.speed > 1e-6]
    weights = [ball.mass for ball in after.balls]
    carried, energy = momentum(states, weights)[0], moving(states, weights)
    return {
        "leave": len(leave),
        "speed": states[-1].speed,
        "momentum": carried,
        "energy": energy,
        "factor": carried * carried / (2.0 * MASS) / energy,
    }


def table(after: World, numbers: Numbers) -> Rows:
    """The speed of each ball before and after."""
    begin, end = after.log.at(after.log.start), after.log.at(after.time)
    rows = [(int(name), begin[name].velocity[0], end[name].velocity[0]) for name in begin]
    return Rows(("ball", "vx before (m/s)", "vx after (m/s)"), rows)


LAB = Lab(
    "cradle",
    (Given("balls", "", 6, 5, 8, 1), Given("running", "", 2, 2, 3, 1),
     Given("speed", "m/s", 1.0, 0.6, 1.4, 0.1)),
    (Field("leave", "", 0.0), Field("speed", "m/s"), Field("momentum", "kg m/s"),
     Field("energy", "J"), Field("factor", "")),
    scene, truth, table, for_seconds(0.5),
)  # fmt: skip
