"""What must hold in every world in which balls fly: in space at many moments, and in the ledger."""

from collections.abc import Iterator
from math import dist, hypot, inf
from random import Random

from physics import World
from physics.studies.ledger import ledger

OVERLAP = 1e-12  # m
ROUNDING = 1e-12  # of the energy
MOMENTS = 40  # drawn by lot, and as many events


def flew(world: World) -> bool:
    """Was any ball in the air, or off the table?"""
    return any(event.kind in ("land", "off") for event in world.log)


def faults(world: World) -> list[str]:
    """What went wrong in a world with flights, in words."""
    lost_at = {event.balls[0]: event.time for event in world.log if event.kind == "off"}
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
    rule = world.scene.cushion_rule
    here = [
        (world.ball(name), state, (*state.position, state.height + world.ball(name).body.lift))
        for name, state in world.log.at(time).items()
        if lost_at.get(name, inf) > time
    ]
    for k, (ball, state, place) in enumerate(here):
        yield state.height, f"{ball.name} and cloth"
        for other, _, there in here[k + 1 :]:
            yield dist(place, there) - ball.radius - other.radius, f"{ball.name} and {other.name}"
        for wall in world.walls:
            gap, r = wall.distance(state.position) - ball.radius, ball.radius
            nose = hypot(gap + r * rule.level, r * rule.height - state.height) - r
            yield nose if state.height > 0.0 else gap, f"{ball.name} and {wall.name or wall}"


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
