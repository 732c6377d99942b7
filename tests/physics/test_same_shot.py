"""The same shot from the same place: the same digits, the hundredth time as the first."""

import pytest

from physics import Ball, Shot, simulate, simulate_many, tables


def corner_shot():
    world = tables.medium_carom()
    world.add(Ball("a", (1.27 - 0.03275, 0.635 - 0.03275)))
    return world, Shot(0.5, angle=45.0)


@pytest.mark.parametrize("compiled", [False, True])
def test_two_hundred_equal_shots_into_a_corner_are_equal(compiled):
    if compiled:
        pytest.importorskip("numba")
    world, shot = corner_shot()
    after = simulate(world, "a", shot)
    many = simulate_many(world, "a", [shot] * 200, compiled=compiled)
    assert set(map(tuple, many.positions[:, 0].tolist())) == {after.ball("a").position}


def test_the_fortieth_shot_into_a_corner_is_the_first():
    world, shot = corner_shot()
    rests, start = set(), world.ball("a").position
    for _ in range(40):
        world.ball("a").position = start
        world.strike("a", shot)
        world.run()
        rests.add(world.ball("a").position)
    assert len(rests) == 1
