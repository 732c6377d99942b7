"""Balls of two sizes that fixed steps left overlapping are parted no further than they touch."""

from math import dist

import pytest

from physics import Ball, EventDriven, TimeStepping, World
from physics.parting import GAP


@pytest.mark.parametrize("discs", [False, True])
def test_overlapping_balls_of_two_sizes_are_moved_as_little_as_it_takes(discs):
    world = World(engine=TimeStepping(1 / 180), discs=discs)
    small = world.add(Ball("small", (0.0, 0.0), (1.0, 0.0), radius=0.02))
    big = world.add(Ball("big", (0.2, 0.0), radius=0.04))
    touching = small.touching_distance(big)
    while dist(small.position, big.position) > touching:
        world.step(1 / 180)
    world.engine = EventDriven()
    world.part()
    apart = dist(small.position, big.position) - touching
    assert 0.0 < apart <= GAP * big.radius
