"""Contacts of one ball in nearly the same direction: small balls side by side under a large one."""

from math import asin, cos, sin
from random import Random

import pytest

from physics import Ball, Wall, World


@pytest.mark.parametrize("seed", range(40))
def test_balls_down_to_a_fiftieth_of_a_size_side_by_side_are_parted(seed):
    """They touch the large one in directions as little as 2 degrees apart, and lie on a rail."""
    dice, big = Random(seed), 0.03275
    small, mass = big * 10 ** dice.uniform(-1.7, -0.3), 0.25 * 10 ** dice.uniform(-3.0, 1.0)
    world = World(discs=True)
    world.add(Ball("big", at=(0.0, 0.0), radius=big, mass=0.25))
    turn, balls = 2.0 * asin(small / (big + small)), dice.randint(2, 4)
    for k in range(balls):
        angle = (k - 0.5 * (balls - 1)) * turn
        at = ((big + small) * sin(angle), -(big + small) * cos(angle))
        world.add(Ball(f"{k}", at, radius=small, mass=mass))
    world.add(Wall.line(0.0, 1.0, big + 2.0 * small + 1e-9))
    world.ball("big").velocity = (dice.uniform(-0.3, 0.3), -dice.uniform(0.01, 3.0))
    world.ball("big").spin = (dice.uniform(-90.0, 90.0), dice.uniform(-60.0, 60.0), 0.0)
    world.run()
    assert world.at_rest
