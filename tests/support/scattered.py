"""Random shots in random positions of any game, as a batch."""

from functools import cache

import numpy as np

from danggu.rules import GAMES, RACKS
from physics import Ball, simulate_many, tables

LIMIT = 20_000  # shots drawn and played at once: their contacts fill 50 MB
POCKETS = {"snooker": tables.snooker_12ft, "pyramid": tables.pyramid_12ft}


@cache
def world_of(game):
    """The table of a game with its balls on it, wherever there is room."""
    balls = GAMES[game]().balls
    if game in RACKS:
        world = POCKETS.get(RACKS[game], tables.pool_9ft)()
        world.add(Ball("cue", at=(-0.25 * world.table.length, 0.0)))
        for ball in world.table.rack(RACKS[game]):
            world.add(ball)
        return world
    world = tables.medium_carom() if game == "four-ball" else tables.match_carom()
    for k, name in enumerate(balls):
        world.add(Ball(name, at=(-0.6 + 0.4 * k, 0.1 * k)))
    return world


def places(world, shots, rng):
    """(shots, balls, 2) m: all balls scattered on a carom table; on one with pockets the first and
    a few others, NaN for those that are down."""
    table, count = world.table, len(world.balls)
    half = 0.5 * np.array([table.length, table.width]) - table.radius - 0.03 * bool(table.pockets)
    found = rng.uniform(-half, half, (shots, count, 2))
    if table.pockets:
        found[:, 1:][rng.random((shots, count - 1)) > rng.random((shots, 1))] = np.nan
    first, second = np.triu_indices(count, 1)
    while True:
        apart = np.hypot(*np.moveaxis(found[:, first] - found[:, second], 2, 0))
        close = (apart < 2 * table.radius + 1e-4).any(axis=1)
        if not close.any():
            return found
        again = rng.uniform(-half, half, (close.sum(), count, 2))
        found[close] = np.where(np.isnan(found[close]), np.nan, again)


def shots_at(found, rng):
    """(shots, 6): struck in all directions, half of them towards some ball."""
    shots = len(found)
    table = np.zeros((shots, 6))
    table[:, 0] = np.exp(rng.uniform(np.log(0.5), np.log(7.0), shots))
    aimed = found[np.arange(shots), rng.integers(1, found.shape[1], shots)] - found[:, 0]
    angle = np.degrees(np.arctan2(aimed[:, 1], aimed[:, 0])) + rng.normal(0.0, 2.0, shots)
    free = np.isnan(angle) | (rng.random(shots) < 0.5)
    table[:, 1] = np.where(free, rng.uniform(-180.0, 180.0, shots), angle)
    tip = rng.uniform(-0.35, 0.35, (shots, 2))
    table[:, [2, 4]] = 2.5 * table[:, :1] * tip
    table[:, 5] = np.where(rng.random(shots) < 0.1, 1.0, 0.0)  # some fly, and leave the table
    return table


def played(game, shots, rng, contacts=400):
    """The outcomes of random shots of the game at its first ball."""
    world = world_of(game)
    found = places(world, shots, rng)
    return simulate_many(
        world, world.balls[0], shots_at(found, rng), positions=found, contacts=contacts
    )
