"""A ball between two walls that are hardly farther apart than it is wide rolls on along them."""

from cmath import rect
from itertools import product
from math import pi

import numpy as np
import pytest

from physics import Ball, EventDriven, Shot, Wall, World, simulate_many
from tests.support.batches import same

R = 0.03275
PLAYS = (0.0, 1e-15, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 6e-5, 1e-4)
ANGLES, SIDES = (0.0, 0.01, 1.0, 30.0, 90.0), (0.0, 3.0)


def lines(width: float) -> list[Wall]:
    return [Wall.line(0, 1, 0, "south"), Wall.line(0, -1, width, "north")]


def segments(width: float) -> list[Wall]:
    return [Wall.segment((-9, 0), (9, 0)), Wall.segment((9, width), (-9, width))]


def turned(width: float) -> list[Wall]:
    """Walls at an odd angle, whose normals cancel but for rounding."""
    return [Wall.line(-0.6, 0.8, 0.1), Wall.line(0.6, -0.8, width - 0.1)]


def lane(walls, play: float, balls: int = 1) -> World:
    """Balls in the middle of a lane, 3 mm apart, which is wider than they are by `play`."""
    world = World(engine=EventDriven(budget=20_000), walls=walls(2.0 * R + play))
    across = {turned: -0.6 + 0.8j}.get(walls, 1j)
    along, start = -1j * across, (R + 0.5 * play - (0.1 if walls is turned else 0.0)) * across
    for k in range(balls):
        p = start + k * (2.0 * R + 3e-3) * along
        world.add(Ball(f"{k}", (p.real, p.imag), radius=R))
    return world


@pytest.mark.parametrize(
    ("walls", "play"),
    [*product((lines, segments), PLAYS), *product((turned,), PLAYS[1:])],  # 0 rounds to overlaps
)
def test_a_ball_in_a_lane_of_its_own_width_comes_to_rest(walls, play):
    """No impulse made it part from both walls at once, or it hit them in turn until the budget."""
    for angle, side in product(ANGLES, SIDES):
        world = lane(walls, play)
        world.strike("0", Shot(1.0, angle, side=side))
        world.run()
        assert world.at_rest
        for wall in world.walls:
            assert wall.distance(world.ball("0").position) >= R - 1e-12
        floor = 0.5 * 0.25 * world.engine.vmin**2  # what a cushion may give
        assert min(event.energy_lost for event in world.log) > -2.0 * floor


@pytest.mark.parametrize("play", PLAYS)
def test_so_do_several_that_meet_there(play):
    world = lane(segments, play, balls=4)
    world.strike("0", Shot(2.0, 0.3, side=2.0, follow=1.0))
    world.run()
    assert world.at_rest
    for ball in world.balls:
        for wall in world.walls:
            assert wall.distance(ball.position) >= R - 1e-12


def test_along_the_lane_it_keeps_what_it_has():
    world = lane(lines, 1e-8)
    world.strike("0", Shot(1.0))
    world.run()
    assert world.ball("0").position[0] == pytest.approx(rolled(1.0), rel=1e-3)


def rolled(speed: float) -> float:
    """How far it gets on the open cloth."""
    world = World(balls=[Ball("0", (0.0, 0.0), radius=R)])
    world.strike("0", Shot(speed))
    world.run()
    return world.ball("0").position[0]


LEANS = [(lean, play) for lean in (1e-7, 1e-6, 5e-6) for play in (1e-10, 1e-9, 1e-7, 1e-6, 1e-5)]


@pytest.mark.parametrize(("lean", "play"), LEANS)
def test_in_a_lane_that_narrows_it_rolls_to_where_it_is_as_wide_as_the_lane(lean, play):
    """It stopped within a millimetre, or hit the walls in turn until the budget."""
    north = rect(1.0, lean - 0.5 * pi)
    for angle in (180.0, 179.0, 181.0):
        world = World(engine=EventDriven(budget=1000))
        world.add(Wall.line(0.0, 1.0, R + 0.5 * play))
        world.add(Wall.line(north.real, north.imag, R + 0.5 * play))
        world.add(Ball("0", (0.0, 0.0), radius=R))
        world.strike("0", Shot(1.0, angle))
        world.run()
        reach = min(play / lean, rolled(1.0))
        assert world.ball("0").position[0] == pytest.approx(-reach, rel=1e-3)


def test_both_kernels_agree_in_a_lane():
    pytest.importorskip("numba")
    world = lane(segments, 1e-8, balls=3)
    shots = np.array([[1.5, angle, 0.5, 0.1, 1.0] for angle in range(0, 360, 12)])
    plain, fast = (simulate_many(world, "0", shots, compiled=c) for c in (False, True))
    assert same(plain, fast)
