"""Invariants at every event, over scenes made to break the engine (benchmarks/families.py)."""

from math import pi

import pytest

from benchmarks.families import FAMILIES
from benchmarks.invariants import faults
from benchmarks.stress import failures
from physics import Ball, Cloth, EventDriven, Shot, Wall, World, laws, scenes, simulate_many


@pytest.mark.parametrize("family", [name for name in FAMILIES if FAMILIES[name][2]])
def test_a_family_of_scenes_keeps_every_invariant(family):
    ks = range(FAMILIES[family][2])
    assert [(k, found) for k, found, _ in failures(family, ks, seed=0) if found] == []


@pytest.mark.stress
@pytest.mark.parametrize("family", FAMILIES)
def test_a_family_of_scenes_keeps_every_invariant_for_long(family):
    ks = range(FAMILIES[family][1])
    assert [(k, found) for k, found, _ in failures(family, ks, seed=1) if found] == []


def test_four_digits_of_pi_are_counted_by_collisions():
    world = scenes.pi_collisions(4)
    world.run()
    assert len(world.log) == 3141


@pytest.mark.stress
def test_seven_digits_of_pi_are_counted_by_collisions_compiled():
    world = scenes.pi_collisions(7)
    outcome = simulate_many(world, "heavy", [Shot(1.0, 180.0)], compiled=True)
    assert outcome.events[0] == int(pi * 10**6)


# -- the checker itself: it must see what is wrong


def two_balls(gap: float = 0.3) -> World:
    world = World(Cloth(), laws.SmoothBall(1.0), "rigid")
    world.add(Wall.line(-1.0, 0.0, 2.0, "east"))
    world.add(Ball("left", at=(0.0, 0.0), velocity=(2.0, 0.0)))
    world.add(Ball("right", at=(gap, 0.0)))
    return world


def test_a_world_that_went_right_has_no_faults():
    world = two_balls()
    world.run()
    assert faults(world) == []


def test_a_ball_that_went_through_another_is_noticed(monkeypatch):
    monkeypatch.setattr("physics.kernel.calendar.meeting", lambda a, b: float("inf"))
    world = two_balls()
    world.run()
    assert any("overlap" in fault for fault in faults(world))


def test_a_ball_that_went_through_a_wall_is_noticed():
    world = two_balls()
    world.run()
    world.add(Wall.line(-1.0, 0.0, 0.5, "where nothing was"))
    assert any("outside" in fault for fault in faults(world))


@pytest.mark.filterwarnings("ignore:the ball law")
def test_a_law_that_makes_energy_is_noticed():
    world = two_balls()
    world.ball_law = lambda v, roll, side, mass: (2.2 * mass * v.real, 0j)
    world.run()
    assert any("energy grows" in fault for fault in faults(world))


def test_a_ball_that_jumps_is_noticed(monkeypatch):
    def jump(ball, *_):
        ball.position -= 1e-11
        ball.velocity = -0.5 * ball.velocity

    monkeypatch.setattr("physics.kernel.calendar.hit_wall", jump)
    world = two_balls()
    world.run()
    assert any("jumps" in fault for fault in faults(world))


def test_momentum_that_is_lost_is_noticed(monkeypatch):
    def stop(a, b, rule):
        a.velocity = b.velocity = 0.1 + 0j
        b.velocity = 0.2 + 0j
        return 1.0

    monkeypatch.setattr("physics.kernel.calendar.hit_ball", stop)
    world = two_balls()
    world.engine = EventDriven(budget=1000)
    world.run()
    assert any("momentum" in fault for fault in faults(world))
