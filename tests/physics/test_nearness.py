"""No contact is missed: until a ball meets an obstacle it is clear of it, on paths of all kinds.

The clearance on a path (benchmarks/nearness.py) shares nothing with the kernel's search for
contacts but what a clearance is.
"""

from cmath import rect
from math import inf, pi
from random import Random

import numpy as np
import pytest

from benchmarks.nearness import least
from physics import Pocket, Post, Wall
from physics.kernel import obstacle
from physics.kernel.leg import travelled
from tests.support.any_shape import R

THINGS = {
    "line": Wall.line(0.6, 0.8, 0.1),
    "segment": Wall.segment((-0.3, 0.1), (0.2, -0.05)),
    "short segment": Wall.segment((0.0, 0.0), (0.01, 0.0)),
    "quarter": Wall.arc((0.0, 0.0), 0.3, 20.0, 110.0),
    "bay": Wall.arc((0.1, 0.0), 0.2, -80.0, 80.0),
    "nearly a ring": Wall.arc((0.0, 0.0), 0.3, 20.0, 350.0),
    "ring": Wall.arc((0.0, 0.0), 0.4, 0.0, 360.0),
    "small arc": Wall.arc((0.0, 0.0), 0.5 * R, -60.0, 100.0),
    "post": Post((0.05, 0.0), 0.05),
    "point": Post((0.05, 0.0), 0.0),
    "pocket": Pocket((0.05, 0.0), 0.06),
}


def paths(thing, count: int):
    """Towards it and past it, slow and fast, straight and bent, from afar and from beside it."""
    dice = Random(11)
    while count:
        p = rect(dice.choice((0.05, 0.3, 0.6)) * (dice.random() + 0.3), dice.uniform(-pi, pi))
        v = rect(dice.choice((0.0, 0.1, 1.0)), dice.uniform(-pi, pi)) - dice.choice((0.0, 1.0)) * p
        a = rect(dice.choice((0.0, 1.0, 4.0)), dice.uniform(-pi, pi))
        radius = R if thing.pushes else 0.0
        if obstacle.clearance(thing.shape, p, radius) >= 0.0:
            count -= 1
            yield (p, v, a), dice.choice((0.05, 0.3, 1.0)), radius


@pytest.mark.parametrize("name", THINGS)
def test_until_a_ball_meets_an_obstacle_it_is_clear_of_it(name):
    thing, met = THINGS[name], 0
    for path, horizon, radius in paths(thing, 150):
        time = obstacle.touch(thing.shape, *path, R, horizon)
        assert least(thing.shape, path, min(time, horizon), radius) > -1e-12
        if time < horizon:
            met += 1
            assert abs(obstacle.clearance(thing.shape, travelled(*path, time), radius)) < 1e-12
    assert met > 3


def test_a_ball_that_swings_in_past_the_end_of_an_arc_meets_it_from_inside():
    """On its way along a stadium's straight wall it is farther from the middle of the round one
    than it may be, where there is no round wall yet."""
    thing = Wall.arc((0.5, 0.0), 0.5, -90.0, 90.0).shape
    p, v, a = 0.348356809 - 0.46725j, 0.302729013 + 0.034174515j, 1.948050241 - 0.216102303j
    time = obstacle.touch(thing, p, v, a, 0.03275, 0.2989)
    assert time == pytest.approx(0.2969, abs=1e-4)
    assert abs(obstacle.clearance(thing, travelled(p, v, a, time), 0.03275)) < 1e-13


def test_a_ball_is_met_by_an_arc_smaller_than_itself_from_outside_and_at_its_ends():
    small = Wall.arc((0.0, 0.0), 0.5 * R, -90.0, 90.0).shape
    assert obstacle.touch(small, 0.5 + 0j, -1 + 0j, 0j, R, inf) == pytest.approx(0.5 - 1.5 * R)
    onto_both_ends = obstacle.touch(small, -0.5 + 0j, 1 + 0j, 0j, R, inf)
    assert onto_both_ends == pytest.approx(0.5 - R * 0.75**0.5)
    assert obstacle.touch(small, -0.5 + 0.6j * R, 1 + 0j, 0j, R, inf) < 0.5


def test_the_least_clearance_is_that_of_a_fine_march():
    for thing in THINGS.values():
        for path, lasts, radius in paths(thing, 8):
            times = np.linspace(0.0, lasts, 400)
            march = min(obstacle.clearance(thing.shape, travelled(*path, t), radius) for t in times)
            assert march - 6.0 * lasts / 400 < least(thing.shape, path, lasts, radius) <= march
