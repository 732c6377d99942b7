"""Where fixed steps break: balls passed through, overlaps, walls left, energy made; against exact.

Nothing here fails: it is the measured price of stepping, printed by `python -m benchmarks stress`.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import hypot
from random import Random

from physics import Ball, EventDriven, Shot, TimeStepping, World, scenes, tables

SCHEMES = ("thesis", "literal", "euler", "rk4", "rk4-located")
STEPS = (1 / 60, 1 / 180, 1 / 1000)
SPEEDS = (1.0, 3.0, 8.0)
OFFSETS = (0.0, 0.3, 0.5, 0.7, 0.9, 0.99, 0.999)
LOOK = 1 / 500  # s: how often a stepped world is looked at
LASTS = 4.0  # s


@dataclass
class Damage:
    """The worst of what was seen: metres, and parts of the energy that was given."""

    aimed: int = 0
    missed: int = 0
    overlap: float = 0.0
    outside: float = 0.0
    gain: float = 0.0
    stuck: int = 0

    def row(self) -> str:
        deep, out = 1e3 * self.overlap, 1e3 * self.outside
        through = f"{self.missed} of {self.aimed}"
        return f"{through} | {deep:.2g} | {out:.2g} | {100 * self.gain:.2g} | {self.stuck}"


def energy(world: World) -> float:
    """J"""
    return sum(
        ball.mass
        * (0.5 * hypot(*ball.velocity) ** 2 + 0.2 * (ball.radius * hypot(*ball.spin)) ** 2)
        for ball in world.balls
    )


def look(world: World, damage: Damage) -> bool:
    """Take note of overlaps and of balls outside; is any pair deep in each other?"""
    deepest = 0.0
    for i, ball in enumerate(world.balls):
        p = ball.position
        for other in world.balls[:i]:
            q = other.position
            deepest = max(deepest, ball.touching_distance(other) - hypot(p[0] - q[0], p[1] - q[1]))
        for wall in world.walls:
            damage.outside = max(damage.outside, ball.radius - wall.distance(p))
    damage.overlap = max(damage.overlap, deepest)
    return deepest > 1e-3


def aimed(engine: EventDriven | TimeStepping, damage: Damage) -> None:
    """At a resting ball, from full to 1/1000 of a ball beside it, at every speed: is it moved?"""
    for speed in SPEEDS:
        for offset in OFFSETS:
            world = tables.medium_carom()
            world.engine = engine
            world.add(Ball("cue", at=(-0.4, 0.0)))
            target = world.add(Ball("target", at=(0.1, offset * 2.0 * world.balls[0].radius)))
            world.strike("cue", Shot(speed, follow=speed))
            at = target.position
            world.run(0.75 / speed)  # past the target, before the cushion sends it back
            damage.aimed += 1
            damage.missed += target.position == at


def played(engine: EventDriven | TimeStepping, damage: Damage, shots: int) -> None:
    """Carom shots with spin, looked at all the while."""
    dice = Random(0)
    for _ in range(shots):
        world = scenes.carom()
        world.engine = engine
        speed = dice.choice(SPEEDS)
        follow, masse, side = (dice.uniform(-1.0, 1.0) * speed for _ in range(3))
        world.strike("white", Shot(speed, dice.uniform(0.0, 360.0), follow, masse, side))
        given = last = energy(world)
        deep = 0
        for _ in range(int(LASTS / LOOK)):
            world.step(LOOK)
            deep = deep + 1 if look(world, damage) else 0
            now = energy(world)
            damage.gain = max(damage.gain, (now - last) / given)
            last = now
            damage.stuck += deep == int(0.1 / LOOK)


def rows(shots: int) -> Iterator[str]:
    """Lines of the table, the exact engine first."""
    engines: list[tuple[str, EventDriven | TimeStepping]] = [("exact", EventDriven())]
    engines += [
        (f"{scheme}, dt = 1/{1 / dt:.0f} s", TimeStepping(dt, scheme))
        for scheme in SCHEMES
        for dt in STEPS
        if scheme != "literal" or dt == STEPS[1]  # the printed program has its own step
    ]
    for name, engine in engines:
        damage = Damage()
        aimed(engine, damage)
        played(engine, damage, shots)
        yield f"| {name} | {damage.row()} |"


def table(shots: int) -> str:
    """What stepping breaks, as a table."""
    head = "| engine | passed through | overlap, mm | outside, mm | energy made, % | stuck 0.1 s |"
    return "\n".join([head, "|---|---|---|---|---|---|", *rows(shots)])
