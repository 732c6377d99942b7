"""What callers hand in: made plain numbers, or refused by name before anything changes."""

from dataclasses import fields, replace
from functools import partial
from math import inf, nan

import numpy as np
import pytest

from physics import (
    Ball,
    Cloth,
    CueStroke,
    EventDriven,
    Shot,
    TimeStepping,
    Wall,
    World,
    laws,
    scenes,
    simulate,
    simulate_many,
    store,
    tables,
    trace,
)

R = 0.03275


def sized(**sizes):
    """A table of these sizes."""
    return replace(tables.MATCH_CAROM, **sizes)


KEPT = [
    (Cloth, {"slide": 0.25}), (EventDriven, {"vmin": 0.5}), (TimeStepping, {"dt": 0.125}),
    (CueStroke, {"speed": 3.0, "side": 0.25}), (laws.RigidCushion, {"e": 0.75, "nose": 1.25}),
    (laws.MathavanCushion, {"mu": 0.25}), (laws.ThesisCushion, {"mu": 0.25}),
    (laws.CappedCushion, {"mu": 0.25}), (laws.SmoothBall, {"e": 0.75}),
    (laws.RoughBall, {"e": 0.75, "mu": 0.25}), (laws.ThesisBall, {"e": 0.75}),
    (laws.HertzCluster, {"e": 0.75, "gap": 0.25}), (Shot, {"speed": 3.0, "angle": 37.0}),
    (partial(Wall, -1j), {"offset": 0.25}), (sized, {"length": 2.5, "mass": 0.25}),
]  # fmt: skip


@pytest.mark.parametrize("number", [np.float64, np.float32, np.float16, int])
def test_a_shot_in_numpys_numbers_has_the_digits_of_plain_ones(number):
    """Half a degree in 32 bits is half a degree: the engine must not go on in 32 bits."""
    plain, other = (
        simulate(scenes.carom(), "white", Shot(kind(3), kind(37), kind(1), kind(-1), kind(2)))
        for kind in (float, number)
    )
    assert [ball.position for ball in plain.balls] == [ball.position for ball in other.balls]
    assert all(type(x) is float for ball in other.balls for x in ball.position)


@pytest.mark.parametrize(("kind", "values"), KEPT, ids=lambda x: getattr(x, "__name__", ""))
def test_what_is_kept_is_plain(kind, values):
    kept = kind(**{name: np.float32(value) for name, value in values.items()})
    assert kept == kind(**values)
    assert all(type(getattr(kept, name)) is float for name in values)


@pytest.mark.parametrize(("kind", "values"), KEPT, ids=lambda x: getattr(x, "__name__", ""))
@pytest.mark.parametrize(
    "bad", [nan, inf, -inf, 1e51, -1.0, "0.1", "\uff10", b"0.1", [0.1], 1j, True]
)
def test_what_is_no_number_or_too_large_is_refused_by_name(kind, values, bad):
    kept = kind(**values)
    for name in values:
        if bad == -1.0 and name in ("side", "angle", "offset"):
            continue
        with pytest.raises(ValueError, match=rf"{type(kept).__name__}\.{name}"):
            kind(**{**values, name: bad})
    assert {field.name for field in fields(kept)} >= set(values)


def spoil(world, name, value):
    setattr(world, name, value)


REFUSED = [
    (lambda world: spoil(world, "cloth", 0.2), "Cloth"),
    (lambda world: spoil(world, "cloth", None), "Cloth"),
    (lambda world: spoil(world, "engine", "exact"), "engine"),
    (lambda world: spoil(world, "engine", EventDriven), "engine"),
    (lambda world: spoil(world, "engine", None), "engine"),
    (lambda world: spoil(world, "ball_law", laws.RigidCushion()), "ball law"),
    (lambda world: spoil(world, "ball_law", laws.SmoothBall), "ball law"),
    (lambda world: spoil(world, "cushion_law", laws.SmoothBall()), "cushion law"),
    (lambda world: spoil(world, "cushion_law", laws.ThesisBall()), "cushion law"),
    (lambda world: spoil(world, "cluster_law", laws.SmoothBall()), "cluster law"),
    (lambda world: world.strike("white", 3.0), "Shot"),
    (lambda world: world.strike(0, Shot(3.0)), "no ball 0"),
    (lambda world: world.strike("blue", Shot(3.0)), "'blue'"),
    (lambda world: world.run("1"), "until must be a number"),
    (lambda world: world.run(None), "until must be a number"),
    (lambda world: world.run(-inf), "until"),
    (lambda world: world.step("0.1"), "dt must be a number"),
    (lambda world: world.add("ball"), "Ball or a Wall"),
    (lambda world: spoil(world.balls[0], "position", "12"), "'white': position"),
    (lambda world: spoil(world.balls[0], "position", (1e60, 0.0)), "'white': position"),
]


@pytest.mark.parametrize(("act", "message"), REFUSED)
def test_what_is_refused_leaves_a_world_in_mid_flight_as_it_was(act, message):
    world, untouched = scenes.carom(), scenes.carom()
    for each in (world, untouched):
        each.strike("white", Shot(3.0, 37.0, follow=0.5, side=1.5))
        each.run(until=0.7)
    with pytest.raises(ValueError, match=message):
        act(world)
    for each in (world, untouched):
        each.run()
    assert list(world.log) == list(untouched.log)
    assert [ball.position for ball in world.balls] == [ball.position for ball in untouched.balls]


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: World(cloth=0.2), "Cloth"),
        (lambda: World(engine="exact"), "engine"),
        (lambda: World(ball_law=laws.RigidCushion()), "ball law"),
        (lambda: Wall(2 + 0j, 0.0), "Wall.normal"),
        (lambda: Wall(complex(nan, 0), 0.0), "Wall.normal"),
        (lambda: Wall("1", 0.0), "Wall.normal must be a complex number, not '1'"),
        (lambda: Wall(None, 0.0), "Wall.normal must be a complex number, not None"),
        (lambda: Wall(1 + 0j, inf), "Wall.offset"),
        (lambda: Wall.line(1e60, 0.0, 0.0), "Wall.line a"),
        (lambda: Wall.line(1e-60, 0.0, 1.0), "Wall.offset"),
        (lambda: laws.MathavanCushion(mu=1.5), "MathavanCushion.mu"),
        (lambda: laws.MathavanCushion(slide=1.5), "MathavanCushion.slide"),
        (lambda: store.dumps(3.0), "World or a Shot"),
    ],
)
def test_things_that_cannot_be_are_not_made(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    "shots",
    [
        Shot(3.0), [[3.0, 10.0, 0.5]], np.ones((5, 10)), np.ones(5), np.ones((2, 5, 1)),
        ["fast"], [None], 3.0, [["3.0", "10", "0.5", "0", "1.5"]], [[True] * 5],
        np.full((2, 5), "1"), np.ones((2, 5), complex),
    ],
)  # fmt: skip
def test_shots_of_the_wrong_shape_are_not_taken_for_others(shots):
    with pytest.raises(ValueError, match="shots must be"):
        simulate_many(scenes.carom(), "white", shots)


@pytest.mark.parametrize("wrong", [{"executor": 2}, {"progress": 10}, {"progress": "bar"}])
def test_who_cannot_help_with_a_batch_is_refused_before_it_begins(wrong):
    (name, value), = wrong.items()
    with pytest.raises(ValueError, match=f"simulate_many {name} must .* {value!r}"):
        simulate_many(scenes.carom(), "missing", [Shot(3.0)], **wrong)


def test_a_ball_keeps_its_name():
    with pytest.raises(AttributeError):
        Ball("white", at=(0.0, 0.0)).name = "red"


@pytest.mark.parametrize("name", ["cushionlaw", "cushion_laws", "Engine", "gravity"])
def test_a_misspelt_name_is_an_error(name):
    with pytest.raises(AttributeError, match=name):
        setattr(scenes.carom(), name, "mathavan")


def test_a_phase_can_be_assigned_in_mid_flight():
    world = scenes.carom()
    white = world.ball("white")
    world.strike(white, Shot(3.0, 37.0, side=1.5))
    world.run(until=0.1)
    white.phase = "sliding"
    assert world.next_event < 1.0
    white.phase = "rolling"
    (vx, vy), (wx, wy, wz) = white.velocity, white.spin
    assert (wy * R, -wx * R) == pytest.approx((vx, vy), rel=1e-15)
    with pytest.raises(ValueError, match="'white': phase"):
        white.phase = "sliding"
    with pytest.raises(ValueError, match="'white': phase must be one of resting, rolling, sliding"):
        white.phase = "flying"
    world.step(0.01)
    assert white.phase == "rolling"
    white.phase = "resting"
    world.step(0.01)
    assert (white.phase, white.velocity) == ("resting", (0.0, 0.0))
    assert white.spin[:2] == (0.0, 0.0)
    assert white.spin[2] == pytest.approx(wz - 10.0 * 0.02, abs=1e-9)


def test_a_wall_of_numpys_numbers_is_a_plain_one():
    """A wall in 32 bits would have the engine go on in 32 bits."""
    wall = Wall(np.complex64(1j), np.float32(-0.5))
    assert wall == Wall(1j, -0.5)
    assert (type(wall.normal), type(wall.offset)) == (complex, float)


@pytest.mark.parametrize("time", [nan, inf, -inf, "1", None])
def test_a_log_knows_nothing_of_a_time_that_is_none(time):
    with pytest.raises(ValueError, match=f"Log.at time must be .* not {time!r}"):
        simulate(scenes.carom(), "white", Shot(3.0)).log.at(time)


def test_a_world_that_has_not_run_yet_has_a_trace_of_one_moment():
    times, paths = trace(scenes.carom())
    assert times.tolist() == [0.0]
    assert [tuple(p) for p in paths[0]] == [ball.position for ball in scenes.carom().balls]


@pytest.mark.parametrize("bad", [nan, inf, -inf, "x", None])
def test_numbers_that_are_none_are_refused_by_name(bad):
    world = scenes.carom()
    white = world.balls[0]
    before = [(ball.position, ball.velocity, ball.spin) for ball in world.balls]
    for what, value in (("position", (bad, 0)), ("velocity", (0, bad)), ("spin", (0, 0, bad))):
        with pytest.raises(ValueError, match=f"'white': {what} must be"):
            setattr(white, what, value)
    with pytest.raises(ValueError, match=r"Shot\.angle"):
        Shot(1.0, bad)
    if bad is not None:  # which is not to say a size
        with pytest.raises(ValueError, match="radius"):
            Ball("x", at=(0, 0), radius=bad)
    with pytest.raises(ValueError, match=r"Cloth\.slide"):
        Cloth(slide=bad)
    assert [(ball.position, ball.velocity, ball.spin) for ball in world.balls] == before


@pytest.mark.parametrize("value", [0.0, -1.0])
def test_what_must_be_positive_is(value):
    with pytest.raises(ValueError, match="radius must be above zero"):
        Ball("x", at=(0, 0), radius=value)
    with pytest.raises(ValueError, match="mass must be above zero"):
        Ball("x", at=(0, 0), mass=value)
    with pytest.raises(ValueError, match=r"Shot\.speed must be above zero"):
        Shot(value)


def test_overlapping_and_outside_balls_are_refused_and_the_world_stays_as_it_was():
    world = scenes.carom()
    world.balls[0].position = (0.6, 0.05)
    with pytest.raises(ValueError, match=r"'(white|yellow)'.*'(white|yellow)'.* overlap"):
        world.run()
    assert world.time == 0.0
    assert world.balls[0].position == (0.6, 0.05)
    world.balls[0].position = (1.26, 0.0)
    with pytest.raises(ValueError, match=r"'white'.*outside the wall 'east'"):
        world.step(0.1)
    world.balls[0].position = (0.0, 0.0)
    world.run()


def test_time_runs_forward_only():
    world = scenes.carom()
    world.strike("white", Shot(3.0, 37.0))
    world.run(until=1.0)
    for bad in (nan, 0.5, -inf):
        with pytest.raises(ValueError, match="until"):
            world.run(until=bad)
    for bad in (nan, -1e-9, inf):
        with pytest.raises(ValueError, match="dt"):
            world.step(bad)
    assert world.time == 1.0


def test_names_are_unique_and_balls_live_in_one_world():
    world = scenes.carom()
    with pytest.raises(ValueError, match="'white'"):
        world.add(Ball("white", at=(0.5, 0.5)))
    with pytest.raises(ValueError, match="'red' is in a world already"):
        World().add(world.ball("red"))
    with pytest.raises(ValueError, match="no ball 'blue'"):
        world.strike("blue", Shot(1.0))


def test_unknown_laws_are_refused_with_the_names_there_are():
    world = World()
    with pytest.raises(ValueError, match="rigid"):
        world.cushion_law = "bouncy"
    with pytest.raises(ValueError, match="ball law"):
        world.ball_law = 3
    with pytest.raises(ValueError, match=r"RoughBall\.mu"):
        laws.RoughBall(0.9, "smooth")
    with pytest.raises(ValueError, match=r"SmoothBall\.e must be from 0 to 1"):
        laws.SmoothBall(1.1)


@pytest.mark.parametrize("value", [0, -1, 2.5, "3", None, True, 10**6])
@pytest.mark.parametrize(
    ("scene", "name"), [(scenes.cradle, "cradle balls"), (scenes.pi_collisions, "pi_coll.* digits")]
)
def test_a_scene_of_no_or_half_a_ball_or_digit_is_refused_by_name(scene, name, value):
    with pytest.raises(ValueError, match=f"{name} must be a whole number from 1 to .*{value!r}"):
        scene(value)


def test_no_zero_of_a_spin_shows_a_sign():
    world = tables.medium_carom()
    white = world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0)))
    white.phase = "rolling"
    after = simulate(world, white, Shot(2.0, 30.0))
    assert "-0.0" not in repr((white.spin, [ball.spin for ball in after.balls]))
    assert "-0.0" not in repr([state.spin for e in after.log for state in (*e.before, *e.after)])
