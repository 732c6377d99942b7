"""Two balls and a wall count out the digits of π by how often they collide (Galperin 2003)."""

from __future__ import annotations

from math import atan, degrees, sqrt

from physics import Ball, Cloth, EventDriven, Wall, World, laws

from .shape import Field, Given, Lab, Numbers, Rows

DIGITS = 1_000_000.0  # the ratio of masses that gives four digits
SHOWN = 10  # collisions in the table
LIGHT, HEAVY = 0.3, 0.9  # m from the wall
RADIUS = 0.03275


def scene(numbers: Numbers) -> World:
    """A heavy ball drives a light one into a wall; nothing is lost and nothing rubs."""
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    ratio = numbers["ratio"]
    world.engine = EventDriven(vmin=0.0, budget=int(8.0 * sqrt(ratio)) + 100)
    world.add(Wall.line(1.0, 0.0, 0.0, "wall"))
    world.add(Ball("light", (LIGHT, 0.0), radius=RADIUS, mass=1.0))
    world.add(Ball("heavy", (HEAVY, 0.0), (-1.0, 0.0), radius=RADIUS, mass=ratio))
    return world


def truth(after: World, numbers: Numbers) -> dict[str, float]:
    """How many collisions there are, and where the heavy ball turned back."""
    more = scene({"ratio": DIGITS})
    more.run()
    return {
        "count": len(after.log),
        "angle": degrees(atan(1.0 / sqrt(numbers["ratio"]))),
        "digits": len(more.log),
        "speed": after.ball("heavy").velocity[0],
        "nearest": min(leg.position.real for leg in after.log.legs("heavy")),
    }


def table(after: World, numbers: Numbers) -> Rows:
    """Both velocities after each of the first collisions."""
    rows = []
    for count, event in enumerate(after.log[:SHOWN], 1):
        then = after.log.at(event.time)
        rows.append((count, *(then[name].velocity[0] for name in ("light", "heavy"))))
    return Rows(("collision", "light vx (m/s)", "heavy vx (m/s)"), rows)


LAB = Lab(
    "pi",
    (Given("ratio", "", 100, 20, 400, 1),),
    (Field("angle", "°", 0.01), Field("count", "", 0.0), Field("digits", "", 0.0),
     Field("speed", "m/s", 0.02), Field("nearest", "m", 0.05)),
    scene, truth, table,
)  # fmt: skip
