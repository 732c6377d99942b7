"""Worlds and shots in files."""

import json
import os
from dataclasses import replace
from math import nan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from physics import (
    Ball,
    EventBudgetError,
    EventDriven,
    Shot,
    TimeStepping,
    World,
    laws,
    scenes,
    simulate,
    store,
    tables,
)
from physics.files.record import PAGE

SHOT = Shot(3.0, 37.0, follow=0.5, side=1.5)


def state(world):
    return [(ball.position, ball.velocity, ball.spin, ball.phase) for ball in world.balls]


def struck() -> World:
    world = scenes.carom()
    world.strike("white", SHOT)
    return world


def crowd() -> World:
    """More balls than the table of meetings is for."""
    world = tables.medium_carom()
    for k in range(40):
        world.add(Ball(f"{k}", at=(-1.0 + 0.1 * (k % 10), -0.4 + 0.11 * (k // 10))))
    world.strike("0", Shot(4.0, 48.0))
    world.strike("39", Shot(4.0, 200.0))
    return world


def springs() -> World:
    world = scenes.cradle()
    world.cluster_law = laws.HertzCluster(gap=1e-7)
    return world


WORLDS = [struck, crowd, springs, scenes.rack15, scenes.thesis_2]
ENGINES = [EventDriven(), TimeStepping(1 / 180), TimeStepping(1 / 90, "rk4"),
           TimeStepping(1 / 200, "rk4-located"), TimeStepping(1 / 180, "literal")]  # fmt: skip


@pytest.mark.parametrize("engine", ENGINES, ids=lambda engine: repr(engine)[:40])
@pytest.mark.parametrize("build", WORLDS, ids=lambda build: build.__name__)
def test_a_world_that_was_loaded_goes_on_in_the_same_bits(build, engine):
    world = build()
    world.engine = engine
    for seconds in (0.0, 0.0913, 0.4):
        world.step(seconds)
        loaded = store.loads(store.dumps(world))
        assert store.dumps(loaded) == store.dumps(world)
        assert state(loaded) == state(world)
        kept = world.copy()
        for w in (kept, loaded):
            # 40 balls in located steps take 15 s
            w.run(until=w.time + (0.1 if build is crowd else 1.0))
        assert loaded.time == kept.time
        assert state(loaded) == state(kept)
        assert loaded.log.at(loaded.time) == kept.log.at(kept.time)


@pytest.mark.parametrize("build", WORLDS, ids=lambda build: build.__name__)
@pytest.mark.parametrize("engine", [EventDriven(), TimeStepping(1 / 180)], ids=["exact", "steps"])
def test_a_world_struck_in_mid_flight_is_saved_with_the_stroke(build, engine):
    world = build()
    world.engine = engine
    world.run(until=0.3)
    world.strike(world.balls[-1], Shot(1.0, 20.0, side=-0.1))
    world.balls[0].velocity = (-0.0, 1e-300)
    loaded = store.loads(store.dumps(world))
    assert store.dumps(loaded) == store.dumps(world)
    assert np.signbit(loaded.balls[0].body.velocity.real)
    for w in (world, loaded):
        w.run(until=1.7)
    assert state(loaded) == state(world)


def test_a_world_at_rest_takes_a_shot_as_it_would_have(tmp_path):
    world = simulate(scenes.carom(), "white", SHOT)
    store.save(world, tmp_path / "table.json")
    loaded = store.load(tmp_path / "table.json")
    again = [simulate(w, "red", replace(SHOT, angle=200.0)) for w in (world, loaded)]
    assert state(again[0]) == state(again[1])
    assert [event.time for event in again[0].log] == [event.time for event in again[1].log]


@given(st.builds(Shot, st.floats(1e-300, 1e50), *[st.floats(-1e9, 1e9)] * 4))
def test_a_shot_comes_back_bit_for_bit(shot):
    loaded = store.loads(store.dumps(shot))
    assert repr(loaded) == repr(shot)


def laws_there_are():
    cushions = [laws.RigidCushion(0.8, 0.2, 1.25), laws.ThesisCushion(), laws.CappedCushion(0.7)]
    balls = [laws.RoughBall(), laws.RoughBall(0.9, 0.06), laws.SmoothBall(1.0), laws.ThesisBall()]
    cushions.append(laws.RigidCushion(0.871, 0.269, 1.2, -0.051, 0.01))
    balls += [laws.SmoothBall(0.9, -0.02), laws.RoughBall(0.95, 0.06, -0.02, -0.01)]
    if hasattr(laws, "MathavanCushion"):
        cushions.append(laws.MathavanCushion())
    return [(cushions[k % len(cushions)], ball) for k, ball in enumerate(balls)]


@pytest.mark.parametrize(("cushion", "ball"), laws_there_are(), ids=repr)
def test_laws_come_back_with_their_coefficients(cushion, ball):
    world = tables.match_carom()
    world.cushion_law, world.ball_law, world.cluster_law = cushion, ball, laws.HertzCluster(0.9)
    world.engine = EventDriven(vmin=1e-4, budget=77)
    loaded = store.loads(store.dumps(world))
    assert (loaded.cushion_law, loaded.ball_law) == (cushion, ball)
    assert loaded.cluster_law == laws.HertzCluster(0.9)
    assert loaded.engine == world.engine
    assert loaded.cloth == world.cloth
    assert loaded.walls == world.walls


def test_what_a_file_cannot_hold_is_refused_by_name(tmp_path):
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: (v, roll, side)
    with pytest.raises(ValueError, match="the cushion law '<lambda>' is a custom one"):
        store.save(world, tmp_path / "table.json")
    assert list(tmp_path.iterdir()) == []
    world = World()
    world.add(Ball(7, at=(0.0, 0.0)))
    with pytest.raises(ValueError, match="ball 7: only names that are text"):
        store.dumps(world)


def test_a_file_is_written_whole_or_not_at_all(tmp_path, monkeypatch):
    path = tmp_path / "table.json"
    store.save(SHOT, path)
    before = path.read_text()

    def full(handle):
        raise OSError("no space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="no space"):
        store.save(struck(), path)
    assert path.read_text() == before
    assert [p.name for p in tmp_path.iterdir()] == ["table.json"]


def places(value, path=()):
    """The ways to every value in plain data."""
    yield path
    if isinstance(value, list):
        value = dict(enumerate(value))
    for key, child in value.items() if isinstance(value, dict) else ():
        yield from places(child, (*path, key))


def stepped() -> World:
    world = springs()
    world.engine = TimeStepping(0.01)
    world.step(0.015)
    return world


GOOD = json.loads(store.dumps(stepped()))
MAY_BE_NULL = {"name", "e", "due", "cluster_law", "page", *PAGE} - {"goal", "partner"}


@pytest.mark.parametrize(
    "path", [p for p in places(GOOD) if p], ids=lambda p: ".".join(map(str, p))
)
def test_a_broken_value_is_refused_with_its_place(path):
    def broken(value):
        data = json.loads(json.dumps(GOOD))
        spot = data
        for key in path[:-1]:
            spot = spot[key]
        if value is KeyError:
            del spot[path[-1]]
        else:
            spot[path[-1]] = value
        return json.dumps(data)

    nonsense = [{"a": 1}, [[]], [nan, 1.0], True]
    nonsense += [] if path[-1] in MAY_BE_NULL else [None]
    nonsense += [KeyError] if path[0] != "balls" or len(path) != 2 else []
    word = str(next(key for key in reversed(path) if isinstance(key, str)))
    if path[-1] in ("version", "discs"):
        nonsense.remove(True)  # JSON's true is Python's 1, and discs may be true
    for value in nonsense:
        with pytest.raises(ValueError, match=word):
            store.loads(broken(value))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "not JSON: Expecting value: line 1 column 1"),
        ('{"danggu": "world",', "not JSON: .*line 1 column 20"),
        ("[" * 100_000, "not JSON.*nested too deep"),
        ("[]", "the whole must be an object"),
        ("3", "the whole must be an object"),
        ('{"danggu": "song", "version": 1}', '\'song\'; it must be "world", "shot" or "scene"'),
        ('{"danggu": "shot", "version": 4}', "version is 4; this program reads versions 1 to 3"),
        ('{"danggu": "shot", "version": 1, "speed": -1}', "angle is missing|Shot.speed"),
    ],
)
def test_a_broken_file_says_what_and_where(text, message, tmp_path):
    with pytest.raises(ValueError, match=message):
        store.loads(text)
    path = tmp_path / "broken.json"
    path.write_text(text)
    with pytest.raises(ValueError, match=r"broken\.json: "):
        store.load(path)


def test_a_file_that_is_not_text_is_refused(tmp_path):
    path = tmp_path / "broken.json"
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(ValueError, match=r"broken\.json: .*utf-8"):
        store.load(path)


@pytest.mark.parametrize(("kind", "message"), [("hole", "'hole'; it must be one of line"),
                                               (3, "must be text")])  # fmt: skip
def test_a_kind_of_wall_that_this_program_does_not_know_is_refused(kind, message):
    data = json.loads(store.dumps(scenes.carom()))
    data["walls"][1]["kind"] = kind
    with pytest.raises(ValueError, match=rf"walls\[1\]\.kind.*{message}"):
        store.loads(json.dumps(data))
    data["walls"][1]["kind"] = "line"
    assert store.loads(json.dumps(data)).walls == scenes.carom().walls


def test_balls_that_overlap_in_a_file_are_refused_by_name():
    data = json.loads(store.dumps(scenes.carom()))
    data["balls"][0]["position"] = data["balls"][1]["position"]
    with pytest.raises(ValueError, match=r"'white'.*'yellow'.*overlap"):
        store.loads(json.dumps(data))
    data = json.loads(store.dumps(scenes.carom()))
    data["balls"][0]["name"] = "red"
    with pytest.raises(ValueError, match="there is a ball 'red' already"):
        store.loads(json.dumps(data))


@pytest.mark.parametrize("engine", [EventDriven(budget=6), TimeStepping(1 / 180, budget=6)])
def test_the_scene_of_a_used_up_budget_is_a_world_that_does_it_again(engine):
    world = struck()
    world.step(0.123)
    world.engine = engine
    world.strike("yellow", Shot(2.0, 170.0))
    start = world.copy()
    start.plan()
    with pytest.raises(EventBudgetError) as caught:
        world.run()
    scene = json.loads(json.dumps(caught.value.scene, allow_nan=False))
    again = store.restore(scene)
    assert state(again) == state(start)
    with pytest.raises(EventBudgetError) as twice:
        again.run()
    assert twice.value.scene["balls"] == scene["balls"]
    assert [e.time for e in again.log] == [e.time for e in world.log][-len(again.log) :]
