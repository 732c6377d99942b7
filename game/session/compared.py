"""The shot on show as other laws and the other engine have it, and how far that is from it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from game.aim.preview import FAILS, GLIMPSE, HORIZON, Place, ahead_of, path, rests
from game.table import presets
from physics import Placed, World

from . import equipment
from .equipment import Equipment


class Rival(NamedTuple):
    """How a shot would have gone with other equipment.

    kind  "law" or "engine"
    key   of the law set or the engine
    ways  of the balls that move, by their names, m
    ends  where they end, m
    cue   how far from the shot the cue ball ends, m
    most  how far the ball that ends farthest from it does, m
    ball  its name
    """

    kind: str
    key: str
    ways: dict[str, tuple[Place, ...]]
    ends: dict[str, Place]
    cue: float
    most: float
    ball: str


def lay(world: World, moment: float) -> list[Placed]:
    """How all balls lay or moved at a moment that the log knows, to the last digit."""
    found = []
    for name in world.log.names:
        legs = world.log.legs(name)
        leg = next((leg for leg in reversed(legs) if leg.time <= moment), legs[0])
        at = leg.after(max(0.0, moment - leg.time))
        found.append(Placed(at.position, at.velocity, at.roll, at.side, at.height, at.climb))
    return found


def rivals(
    world: World, cue: str, since: float, law: str, engine: str, edition: int, own: Equipment
) -> tuple[Rival, ...]:
    """The shot that began at `since` with each of the other law sets, and with the other engine.

    law, engine: what it was played with. One that cannot play it is left out.
    """
    played = ahead_of(world)
    if played is None:
        return ()
    begun = lay(world, since)
    found = []
    for kind, key, other in _others(world, law, engine, edition, own):
        try:
            other.recall(begun)
            start = other.time
            other.run(start + (HORIZON if rests(other) else GLIMPSE))
        except FAILS:
            continue
        found.append(_rival(kind, key, played, other, cue))
    return tuple(found)


def _others(
    world: World, law: str, engine: str, edition: int, own: Equipment
) -> Iterator[tuple[str, str, World]]:
    """Copies with an empty log, each with other equipment."""
    for key in presets.LAWS:
        if key != law:
            other = world.fork(world.log.fresh())
            equipment.with_laws(other, key, edition, own)
            yield "law", key, other
    for key in presets.ENGINES:
        other = world.fork(world.log.fresh())
        if key != engine and equipment.with_engine(other, key):
            yield "engine", key, other


def _rival(kind: str, key: str, played: World, other: World, cue: str) -> Rival:
    ways = {name: path(other.log, name, other.log.start, other.time) for name in other.log.names}
    ends = {ball.name: ball.position for ball in other.balls if not ball.gone}
    off = {
        ball.name: abs(complex(*ball.position) - complex(*ends[ball.name]))
        for ball in played.balls
        if ball.name in ends and not ball.gone
    }
    ball = max(off, key=lambda name: off[name], default="")
    moved = {name: way for name, way in ways.items() if way}
    return Rival(kind, key, moved, ends, off.get(cue, 0.0), off.get(ball, 0.0), ball)
