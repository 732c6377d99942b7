"""Layouts that fixed steps leave overlapping: kept to the last digit, and parted before they move.

No caller has put those balls into each other, so nothing refuses them.
"""

import json
import random
from itertools import combinations
from math import dist

import pytest

from physics import (
    Ball,
    EventDriven,
    Placed,
    Shot,
    TimeStepping,
    Wall,
    scenes,
    simulate,
    simulate_many,
    store,
    tables,
)
from physics.engines.stepping import SCHEMES

ENGINES = [EventDriven(), *(TimeStepping(1 / 180, scheme) for scheme in SCHEMES)]


def stopped(after=0.18, scheme="thesis"):
    """A rack that fixed steps have broken, stopped while its balls overlap."""
    world = scenes.rack15()
    world.engine = TimeStepping(1 / 180, scheme)
    world.step(after)
    world.stop()
    world.step(0.0)
    assert overlaps(world)
    return world


def overlaps(world, beyond=1e-9):
    pairs = combinations(world.balls, 2)
    return [
        (a.name, b.name)
        for a, b in pairs
        if dist(a.position, b.position) < a.radius + b.radius - beyond
    ]


def outside(world):
    return [b for b in world.balls for w in world.walls if w.distance(b.position) < b.radius - 1e-9]


def heap(count, spread, seed):
    """A world with a heap of balls that lie in each other, some of them behind a cushion."""
    rng, world = random.Random(seed), tables.medium_carom()
    for k in range(count):
        world.add(Ball(f"{k}", at=(0.0, 0.0)))
    at = rng.choice((0j, 1.2 + 0.6j, 1.3 + 0j))
    world.recall(
        [Placed(at + complex(rng.gauss(0, spread), rng.gauss(0, spread))) for _ in range(count)]
    )
    return world


@pytest.mark.parametrize("engine", ENGINES, ids=repr)
def test_a_layout_is_recalled_to_the_last_digit_and_played_on(engine):
    world = stopped()
    layout = world.layout()
    world.strike("cue", Shot(3.0, 20.0))
    world.step(0.5)
    world.engine = engine
    world.recall(layout)
    world.plan()
    assert world.layout() == layout
    world.strike("cue", Shot(3.0, 20.0))
    world.step(1.0)
    assert all(abs(x) < 10.0 for ball in world.balls for x in ball.position)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_layout_in_motion_is_recalled_to_the_last_digit(scheme):
    world = scenes.carom()
    world.engine = TimeStepping(1 / 180, scheme)
    world.strike("white", Shot(3.0, 20.0, follow=1.3, masse=0.7, side=0.9))
    for _ in range(40):
        world.step(0.01)
        layout = world.layout()
        world.stop()
        world.recall(layout)
        world.plan()
        assert world.layout() == layout


def test_a_ball_of_a_layout_that_flies_or_is_off_the_table_is_so_again():
    world = tables.medium_carom()
    for k, name in enumerate(("flies", "off", "lies")):
        world.add(Ball(name, at=(0.0, 0.2 * k)))
    world.strike("off", Shot(8.0, 0.0, climb=3.0))
    world.run()
    world.strike("flies", Shot(2.0, 180.0, climb=2.0))
    world.step(0.1)
    assert [ball.phase for ball in world.balls] == ["airborne", "off", "resting"]
    layout, state = world.layout(), [(b.height, b.climb, b.velocity) for b in world.balls]
    for name in ("flies", "off"):
        world.ball(name).position = (-0.5, 0.0 if name == "off" else 0.3)
    world.run()
    world.recall(layout)
    assert [ball.phase for ball in world.balls] == ["airborne", "off", "resting"]
    assert [(b.height, b.climb, b.velocity) for b in world.balls] == state
    assert world.layout() == layout


def test_a_layout_of_other_balls_is_refused_and_changes_nothing():
    world = scenes.carom()
    layout = world.layout()
    with pytest.raises(ValueError, match="of 3 balls, not of 4"):
        world.recall(layout[:3])
    assert world.layout() == layout


@pytest.mark.parametrize("moved", range(0, 16, 5))
@pytest.mark.parametrize("engine", [EventDriven(), TimeStepping(1 / 180)], ids=repr)
def test_a_ball_put_must_fit_but_those_left_overlapping_are_no_fault_of_its(engine, moved):
    world = stopped()
    world.engine = engine
    ball = world.balls[moved]
    ball.position = (-0.9, 0.5)
    world.add(Ball("one more", at=(-0.9, -0.5)))
    world.add(Wall.line(1.0, 0.0, 1.0, "new"))
    world.plan()
    ball.position = (-0.9, -0.46)
    with pytest.raises(ValueError, match=r"'one more'.*overlap"):
        world.plan()
    ball.position = (-0.99, 0.5)
    with pytest.raises(ValueError, match="outside the wall 'new'"):
        world.plan()
    world.recall((*stopped().layout(), Placed(-0.9 - 0.5j)))
    world.plan()


def test_a_new_wall_refuses_every_ball_behind_it():
    world = stopped()
    world.add(Wall.line(-1.0, 0.0, 0.3, "through the table"))
    with pytest.raises(ValueError, match="outside the wall 'through the table'"):
        world.plan()


# -- an exact engine takes over


@pytest.mark.parametrize("seed", range(30))
def test_an_exact_engine_parts_every_overlap_and_moves_no_ball_far(seed):
    count, spread = [(2, 0.01), (4, 0.03), (16, 0.05), (22, 0.02)][seed % 4]
    world = heap(count, spread, seed)
    before = [ball.position for ball in world.balls]
    world.part()
    assert not overlaps(world)
    assert not outside(world)
    farthest = max(dist(a, ball.position) for a, ball in zip(before, world.balls, strict=True))
    assert farthest < 0.0655 * (1 + count**0.5)  # the size of a heap
    again = heap(count, spread, seed)
    again.part()
    assert again.layout() == world.layout()


def test_two_balls_are_parted_by_half_of_what_they_overlap_each():
    world = tables.medium_carom()
    for name in "ab":
        world.add(Ball(name, at=(0.0, 0.0)))
    world.recall([Placed(0j), Placed(0.06 + 0j)])
    world.part()
    a, b = (ball.position for ball in world.balls)
    assert a == pytest.approx((-0.00275, 0.0), abs=1e-6)
    assert b == pytest.approx((0.06275, 0.0), abs=1e-6)


def test_balls_in_the_very_same_place_are_parted_too():
    world = tables.medium_carom()
    for k in range(16):
        world.add(Ball(f"{k}", at=(0.0, 0.0)))
    world.recall([Placed(0j)] * 16)
    world.part()
    assert not overlaps(world)
    assert not outside(world)


def test_overlaps_stay_as_they_are_until_something_moves():
    world = stopped()
    layout, lapped = world.layout(), overlaps(world)
    world.engine = EventDriven()
    world.step(1.0)
    assert world.layout() == layout
    world.strike("cue", Shot(1.0, 180.0))
    world.step(0.0)
    assert overlaps(world)
    world.step(1e-9)
    assert not overlaps(world)
    assert {name for pair in lapped for name in pair} >= {
        ball.name
        for ball, was in zip(world.balls, layout, strict=True)
        if abs(complex(*ball.position) - was.position) > 2e-9
    }


def test_an_exact_engine_that_takes_over_in_motion_parts_them_at_once():
    world = scenes.rack15()
    world.engine = TimeStepping(1 / 180)
    world.step(0.18)
    assert overlaps(world)
    world.engine = EventDriven()
    world.step(1e-9)
    assert not overlaps(world)
    world.run()
    assert not overlaps(world)
    assert not outside(world)


def test_balls_that_only_touch_stay_where_they_are():
    world = scenes.rack15(gap=0.0)
    world.engine = TimeStepping(1 / 180)
    world.engine = EventDriven()
    layout = world.layout()
    world.plan()
    assert world.layout() == layout


def test_shots_in_a_batch_part_them_as_a_shot_does():
    world = stopped()
    world.engine = EventDriven()
    shots = [Shot(2.0, 10.0 * k) for k in range(5)]
    rests = simulate_many(world, "cue", shots).positions
    for shot, rest in zip(shots, rests, strict=True):
        after = simulate(world, "cue", shot)
        assert [ball.position for ball in after.balls] == [tuple(p) for p in rest.tolist()]


@pytest.mark.parametrize("engine", ENGINES[:2], ids=repr)
def test_a_world_with_overlaps_is_saved_and_read_back(engine):
    world = stopped()
    world.engine = engine
    again = store.loads(store.dumps(world))
    assert again.layout() == world.layout()
    assert json.loads(store.dumps(again)) == json.loads(store.dumps(world))
    for one in (world, again):
        one.strike("cue", Shot(2.0, 10.0))
        one.step(2.0)
    assert again.layout() == world.layout()
