"""What must hold in every world in which balls fly: in space at many moments, and in the ledger."""

from collections.abc import Iterator
from math import dist, hypot, inf
from random import Random

from physics import World
from physics.kernel.kinds import AIRBORNE, OFF
from physics.kernel.laws import law_at
from physics.kernel.obstacle import LINE, nose
from physics.log import State
from physics.studies.ledger import ledger

OVERLAP = 1e-12  # m
ROUNDING = 1e-12  # of the energy
MOMENTS = 40  # drawn by lot, and as many events
GONE = ("off", "pocket")


def flew(world: World) -> bool:
    """Was any ball in the air, or off the table?"""
    legs = (leg for ball in world.balls for leg in world.log.legs(ball.name))
    return any(leg.phase in (AIRBORNE, OFF) for leg in legs)


def faults(world: World) -> list[str]:
    """What went wrong in a world with flights, in words."""
    lost_at = {event.balls[0]: event.time for event in world.log if event.kind in GONE}
    dice, end = Random(len(world.log)), min(world.time, 1.5)
    moments = [dice.uniform(0.0, end) for _ in range(MOMENTS)]
    moments += [event.time for event in world.log[:MOMENTS]]
    found = []
    for time in moments:
        least, what = min(gaps(world, time, lost_at), default=(0.0, ""))
        if least < -OVERLAP:
            found.append(f"at {time!r} s {what} overlap by {-least:.2e} m")
    return found + unbalanced(world)


def gaps(world: World, time: float, lost_at: dict[str, float]) -> Iterator[tuple[float, str]]:
    """Of all pairs, of balls and the cloth, and of balls and noses, at a moment, m."""
    here = [
        (world.ball(name), state, (*state.position, state.height + world.ball(name).body.lift))
        for name, state in world.log.at(time).items()
        if lost_at.get(name, inf) > time
    ]
    for k, (ball, state, place) in enumerate(here):
        yield state.height, f"{ball.name} and cloth"
        for other, _, there in here[k + 1 :]:
            yield dist(place, there) - ball.radius - other.radius, f"{ball.name} and {other.name}"
        for n, wall in enumerate(world.walls):
            if wall.pushes:
                yield clear(world, n, state, ball.radius), f"{ball.name} and {wall.name or wall}"


def clear(world: World, n: int, state: State, radius: float) -> float:
    """How far a ball is from a wall's cushion, m.

    In the air it is only known of lines: where a segment ends, or stands upright what is round, a
    ball that flies may come down in it.
    """
    shape, p = world.scene.walls[n], complex(*state.position)
    if state.height == 0.0:
        return world.walls[n].distance(state.position) - radius
    if shape.kind != LINE:
        return 0.0
    rule = law_at(n, world.scene.rules, world.scene.cushion_rule)
    return hypot(*nose(shape, p, radius, state.height, rule)) - radius


def unbalanced(world: World) -> list[str]:
    """Where the ledger does not add up to what there was in the beginning."""
    masses = dict(zip(world.log.names, world.log.masses, strict=True))
    start = sum(world.log.legs(name)[0].energy(mass) for name, mass in masses.items())
    lost, found = 0.0, []
    for entry in ledger(world.log):
        lost += entry.energy_lost + entry.cloth_lost
        if abs(lost + entry.energy - start) > ROUNDING * start:
            off = (lost + entry.energy) / start - 1.0
            found.append(f"at {entry.time!r} s the ledger is {off:.1e} of the energy off")
    return found[:3]
