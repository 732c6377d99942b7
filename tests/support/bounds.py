"""Play compiled what the interpreter has played, each index checked: see test_bounds.

numba checks them if NUMBA_BOUNDSCHECK=1 is set before it compiles.
"""

import os
from collections.abc import Iterator
from math import isqrt
from random import Random

import numpy as np

from physics import Ball, Shot, World, laws, scenes, simulate_many, tables
from physics.world import FEW
from tests.support.batches import same


def crowd(balls: int) -> World:
    """More balls than a table of all pairs is kept for, each on its way; some in the air."""
    world, chance = tables.match_carom(), Random(1)
    lines = isqrt(balls) + 1
    for k in range(balls):
        at = (0.18 * (k % lines - lines / 2), 0.1 * (k // lines - lines / 2))
        ball = world.add(Ball(f"{k}", at, (chance.gauss(0, 1), chance.gauss(0, 1)), radius=0.03))
        ball.climb = max(0.0, chance.gauss(-0.5, 0.5))
    world.plan()
    assert world.scene.celled == (balls > FEW)
    return world


def cases() -> Iterator[tuple[str, World, list[Shot]]]:
    """What is played: its name, the world and the shots at its first ball."""
    fan = [Shot(4.0, 45.0 * k, follow=0.5, side=1.5) for k in range(8)]
    yield "carom", scenes.carom(), fan
    accurate = scenes.carom()
    accurate.ball_law, accurate.cushion_law = laws.RoughBall(), laws.MathavanCushion()
    yield "mathavan", accurate, fan
    rack = scenes.rack15(gap=0.0)
    rack.stop()
    yield "clusters", rack, [Shot(8.0, angle) for angle in (0.0, 0.3)]
    yield "cells", crowd(2 * FEW), [Shot(3.0)]
    yield "jumps", scenes.carom(), [Shot(2.0, 40.0 * k, climb=0.4 * k - 1.0) for k in range(9)]
    yield "jumps in a crowd", crowd(12), [Shot(3.0, 90.0, climb=1.0)]


def overrun() -> None:
    """A table of outcomes that is too short for its shots is written over its end."""
    from physics.batch.compiled import kernel, near, packed
    from physics.batch.outcomes import contact_type
    from physics.batch.shots import before_of

    world = scenes.carom()
    world.plan()
    shots, notes = np.ones((2, 6)), np.zeros((0, 0), contact_type())
    kept = kernel().body.Notes(0, notes, np.zeros(0, np.int64), *near(4, len(world.walls)))
    places, rests = np.empty((0, 4, 2)), np.empty((1, 4, 2))
    times, counts = np.empty(2), np.empty(2, np.int64)
    kernel().calendar.many(
        before_of(world), places, shots, 0, rests, times, counts, 100, packed(world.scene), kept
    )


def main() -> None:
    for name, world, shots in cases():
        ball = world.balls[0]
        compiled, plain = (
            simulate_many(world, ball, shots, compiled=c, contacts=20) for c in (True, False)
        )
        assert same(compiled, plain), name
        print(name, int(plain.events.sum()))
    if os.environ.get("NUMBA_BOUNDSCHECK") != "1":
        return  # unchecked, it would crash
    try:
        overrun()
    except IndexError:
        print("checked")


if __name__ == "__main__":
    main()
