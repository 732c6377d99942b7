"""Batches that know what happened: their contacts are those of the log, shot by shot."""

from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from math import inf

import numpy as np
import pytest

from physics import Ball, Shot, TimeStepping, Wall, World, scenes, simulate, simulate_many, tables
from tests.support.batches import same

numba = pytest.importorskip("numba", reason="compiled batches need the extra `fast`")


def fan(shots, speed=4.0, climb=0.0):
    return [Shot(speed, 360.0 * k / shots, 0.5, side=1.5, climb=climb) for k in range(shots)]


def pool():
    world = tables.pool_9ft()
    world.add(Ball("cue", at=(-0.8, 0.02)))
    for ball in world.table.rack("9-ball"):
        world.add(ball)
    return world


def pressed():
    """Balls frozen to cushions and to each other: contacts that last, and a tight cluster."""
    world = tables.medium_carom()
    r = 0.03275
    world.add(Ball("0", at=(-0.6, -0.635 + r)))
    for k in range(1, 4):
        world.add(Ball(f"{k}", at=(2 * r * k, 0.635 - r)))
    return world


def round_table():
    """Inside a whole circle, with a post: cushions that are no lines."""
    from physics import Post

    world = World()
    world.add(Wall.arc((0.0, 0.0), 0.8, 0.0, 360.0, "rim"))
    world.add(Post((0.2, 0.3), 0.05, "post"))
    world.add(Ball("0", at=(-0.4, 0.0)))
    world.add(Ball("1", at=(0.4, 0.1)))
    return world


def crowd():
    """More balls than a table of all pairs is kept for."""
    world = tables.match_carom()
    for k in range(36):
        world.add(Ball(f"{k}", at=(-1.2 + 0.2 * (k % 12), -0.5 + 0.5 * (k // 12))))
    return world


def heard(world, ball, shot):
    """The contacts of a shot by itself, with no more of `away` than a batch keeps."""
    contacts = simulate(world, ball, shot).log.contacts()
    return [c._replace(away=inf if c.away > 1e-3 else 0.0) for c in contacts]


SCENES = {
    "carom": (scenes.carom, fan(24)),
    "jumps": (scenes.carom, fan(24, climb=1.2)),
    "break": (pool, fan(12, 8.0) + [Shot(8.0, angle) for angle in (0.0, 0.4)]),
    "pressed": (pressed, [Shot(2.0, angle, side=3.0) for angle in range(-60, 241, 12)]),
    "round": (round_table, fan(12)),
    "cells": (crowd, fan(4)),
}


@pytest.mark.parametrize("name", SCENES)
def test_the_contacts_of_a_batch_are_those_of_the_log(name):
    scene, shots = SCENES[name]
    world = scene()
    ball = world.balls[0]
    fast, plain = (simulate_many(world, ball, shots, contacts=400, compiled=c) for c in (True, 0))
    assert same(fast, plain)
    for k, shot in enumerate(shots):
        assert fast.log(k) == heard(world, ball, shot)
    assert not fast.dropped.any()


def test_scenes_have_contacts_of_all_kinds():
    kinds = set()
    for scene, shots in SCENES.values():
        world = scene()
        contacts = simulate_many(world, world.balls[0], shots, contacts=400).contacts
        kinds |= {(kind, again) for kind, again, *_ in contacts.ravel().tolist()}
    assert kinds == {(0, False), (1, False), (2, False), (2, True), (3, False), (4, False)}


@pytest.mark.parametrize("compiled", [True, False])
def test_what_there_is_no_room_for_is_counted(compiled):
    world, shots = scenes.carom(), fan(6)
    whole = simulate_many(world, "white", shots, contacts=100, compiled=compiled)
    few = simulate_many(world, "white", shots, contacts=3, compiled=compiled)
    none = simulate_many(world, "white", shots, compiled=compiled)
    counts = (whole.contacts["kind"] > 0).sum(axis=1)
    assert np.array_equal(few.contacts, whole.contacts[:, :3])
    assert np.array_equal(few.dropped, np.maximum(counts - 3, 0))
    assert none.contacts.shape == (6, 0)
    assert not none.dropped.any()
    assert np.array_equal(none.positions, whole.positions)


def test_engines_without_batches_keep_contacts_too():
    world, shots = scenes.carom(), fan(3)
    world.engine = TimeStepping(0.002)
    outcomes = simulate_many(world, "white", shots, contacts=4)
    for k, shot in enumerate(shots):
        contacts = heard(world, "white", shot)
        assert outcomes.log(k) == contacts[:4]
        assert outcomes.dropped[k] == max(0, len(contacts) - 4)


def test_a_ball_that_has_left_the_table_is_nowhere():
    world = scenes.carom()
    outcomes = simulate_many(world, "white", [Shot(6.0, 180.0, climb=2.0)], contacts=9)
    assert outcomes.contacts["kind"][0, 0] == 4
    assert np.isnan(outcomes.positions[0, 0]).all()


def spread(world, shots, seed):
    """(shots, balls, 2): places at random that do not overlap."""
    rng, n = np.random.default_rng(seed), len(world.balls)
    places = np.empty((shots, n, 2))
    for places_of_shot in places:
        while True:
            spots = rng.uniform((-1.1, -0.55), (1.1, 0.55), (n, 2))
            gaps = np.hypot(*(spots[:, None] - spots[None]).T) + 9.0 * np.eye(n)
            if gaps.min() > 0.08:
                places_of_shot[:] = spots
                break
    return places


@pytest.mark.parametrize("compiled", [True, False])
def test_each_shot_may_begin_from_places_of_its_own(compiled):
    world, shots = scenes.carom(), fan(8)
    places = spread(world, 8, seed=1)
    outcomes = simulate_many(world, "red", shots, positions=places, contacts=60, compiled=compiled)
    for k, shot in enumerate(shots):
        own = scenes.carom()
        for ball, place in zip(own.balls, places[k], strict=True):
            ball.position = place
        own.stop()
        after = simulate(own, "red", shot)
        assert [tuple(p) for p in outcomes.positions[k]] == [ball.position for ball in after.balls]
        assert outcomes.log(k) == heard(own, "red", shot)


def test_the_outcomes_of_a_batch_are_places_for_the_next():
    world = pool()
    first = simulate_many(world, "cue", fan(60, 7.0))
    down = np.isnan(first.positions[:, :, 0])
    assert down[:, 1:].any()
    stays = first.positions[~down[:, 0]]
    shots = fan(len(stays), 1.0)
    second = simulate_many(world, "cue", shots, positions=stays, compiled=True)
    plain = simulate_many(world, "cue", shots, positions=stays, compiled=False)
    assert np.isnan(second.positions[np.isnan(stays)]).all()
    assert np.array_equal(second.positions, plain.positions, equal_nan=True)


def test_balls_that_roll_in_the_world_lie_still_at_places_that_are_given():
    world, still = scenes.carom(), scenes.carom()
    places = [[ball.position for ball in world.balls]]
    world.ball("red").velocity = (1.0, 0.5)
    shot = [Shot(2.0, 30.0)]
    rolling = simulate_many(world, "white", shot, positions=places)
    assert same(rolling, simulate_many(still, "white", shot))


@pytest.mark.parametrize("executor", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_an_executor_brings_places_and_contacts_back_in_order(executor, monkeypatch):
    monkeypatch.setattr("physics.batch.many.CHUNK", 7)
    world, shots = scenes.carom(), fan(30)
    given = {"positions": spread(world, 30, seed=2), "contacts": 12, "compiled": False}
    alone = simulate_many(world, "white", shots, **given)
    with executor(2) as pool:
        shared = simulate_many(world, "white", shots, executor=pool, **given)
    assert same(alone, shared)


def test_numbers_by_name_are_spread_over_the_shots():
    world, angles = scenes.carom(), np.arange(0.0, 90.0, 10.0)
    shots = [Shot(3.0, angle, follow=0.5, climb=0.1) for angle in angles]
    by_name = simulate_many(world, "white", speed=3.0, angle=angles, follow=[0.5], climb=0.1)
    assert same(by_name, simulate_many(world, "white", shots))
    assert len(simulate_many(world, "white", speed=2.0).times) == 1
    places = spread(world, 4, seed=3)
    assert len(simulate_many(world, "white", speed=2.0, positions=places).times) == 4


def at(*places):
    """Where four balls lie on the carom table of the scene, for two shots: the second is wrong."""
    good = [(-0.9, 0.0), (-0.3, 0.0), (0.3, 0.0), (0.9, 0.0)]
    return [good, [*places, *good[len(places) :]]]


NAN = float("nan")
REFUSED = [
    ({"shots": None}, "needs shots, or at least speed="),
    ({"shots": None, "angle": 3.0}, "needs shots, or at least speed="),
    ({"speed": 3.0, "side": 1.0}, "takes shots or speed=, side=, not both"),
    ({"shots": None, "speed": [1.0, 2.0], "angle": [1.0, 2.0, 3.0]}, r"speed= \(2,\), angle= \(3,"),
    ({"shots": None, "speed": [[1.0]]}, r"arrays \(shots,\) of one length, not speed= \(1, 1\)"),
    ({"shots": None, "speed": [1.0, -2.0]}, "shot 1: Shot.speed must be above zero, not -2.0"),
    ({"shots": None, "speed": "fast"}, "speed must be numbers, not 'fast'"),
    ({"shots": None, "speed": [1.0] * 3, "positions": at()}, r"speed= \(3,\) for 2 positions"),
    ({"contacts": -1}, "contacts must be a whole number from 0 to 10000, not -1"),
    ({"contacts": 2.5}, "contacts must be a whole number .* not 2.5"),
    ({"positions": at()[:1]}, "there are 2 shots, but positions for 1"),
    ({"positions": [[0.0, 0.0]]}, r"positions must be an array \(shots, 4, 2\), not \(1, 2\)"),
    ({"positions": "here"}, "positions must be numbers, not 'here'"),
    ({"positions": at((NAN, 0.0))}, "positions of shot 1: ball 'white' must be at two finite"),
    ({"positions": at((inf, 0.0))}, r"two NaN if it is not on the table, not \(inf, 0.0\)"),
    ({"positions": at((1e60, 0.0))}, "positions of shot 1: ball 'white' must be at two finite"),
    ({"positions": at((NAN, NAN))}, "positions of shot 1: ball 'white' is not on the table"),
    ({"positions": at((-0.35, 0.0))}, r"positions of shot 1: Ball\('white', .*'yellow', .*overlap"),
    ({"positions": at((-1.3, 0.0))}, r"positions of shot 1: Ball\('white', at=\(-1.3, .*outside"),
]


@pytest.mark.parametrize(("given", "message"), REFUSED)
def test_what_cannot_be_played_is_refused_by_name(given, message):
    given = {"shots": [Shot(1.0)] * 2, **given}
    with pytest.raises(ValueError, match=message):
        simulate_many(scenes.carom(), "white", **given)


def test_a_misspelt_number_is_an_error():
    with pytest.raises(TypeError, match="simulate_many has no argument 'spin'"):
        simulate_many(scenes.carom(), "white", speed=1.0, spin=2.0)


def test_a_ball_placed_over_a_hole_or_in_a_rail_is_refused():
    world = pool()
    pocket = next(wall for wall in world.walls if not wall.pushes)
    rail = next(wall for wall in world.walls if wall.kind == "segment")
    lies = np.array([[ball.position for ball in world.balls]])
    for place, noun in ((pocket.at, "in the pocket"), (rail.p, "in the wall")):
        lies[0, 3] = place
        with pytest.raises(ValueError, match=f"positions of shot 0: Ball.* is {noun}"):
            simulate_many(world, "cue", [Shot(1.0)], positions=lies)


def test_a_ball_in_a_mouth_lies_behind_the_rails_line_and_is_not_refused():
    world = pool()
    lies = np.array([[ball.position for ball in world.balls]])
    side = next(wall for wall in world.walls if not wall.pushes and abs(wall.at[0]) < 0.1)
    lies[0, 3] = side.at[0], side.at[1] * (1.0 - (side.radius + 1e-3) / abs(side.at[1]))
    outcomes = simulate_many(world, "cue", [Shot(0.1, 90.0)], positions=lies)
    assert outcomes.positions[0, 3].tolist() == lies[0, 3].tolist()
