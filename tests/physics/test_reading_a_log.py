"""What is read of a log: states by name, first events, and balls at many moments at once."""

import pickle

import numpy as np
import pytest

from physics import Ball, Shot, heights, scenes, simulate, tables, trace


@pytest.fixture(scope="module")
def after():
    return simulate(scenes.carom(), "white", Shot(3.0, 1.0, follow=1.5, masse=0.7, side=0.5))


@pytest.fixture(scope="module")
def jump():
    return simulate(scenes.carom(), "white", Shot(2.0, 40.0, side=-1.0, climb=1.0))


def test_a_state_of_an_event_is_found_by_the_name_of_its_ball(after):
    hit = after.log.first("ball")
    for number, name in enumerate(hit.balls):
        assert hit.before[name] == hit.before[number]
        assert hit.after[name] == hit.after[number]
    assert hit.after == tuple(hit.after) == hit.after[:]


def test_a_ball_that_is_not_in_the_event_is_refused_by_name(after):
    with pytest.raises(KeyError, match="no ball 'red' in this event, only white, yellow"):
        _ = after.log.first("ball", "yellow").after["red"]


def test_an_event_can_be_pickled_with_the_names_of_its_balls(after):
    hit = pickle.loads(pickle.dumps(after.log.first("ball")))
    assert hit == after.log.first("ball")
    assert hit.after[hit.balls[1]] == hit.after[1]


def test_speed_and_heading_of_a_state_are_those_of_its_velocity(after):
    for event in after.log:
        for state in (*event.before, *event.after):
            assert state.speed == pytest.approx(np.hypot(*state.velocity), rel=1e-15)
            turned = np.degrees(np.arctan2(state.velocity[1], state.velocity[0]))
            assert state.heading == pytest.approx(turned, abs=1e-12)


def test_the_phase_of_a_state_is_that_of_the_ball_at_that_moment(after, jump):
    for world in (after, jump):
        assert {s.phase for s in world.log.at(world.time).values()} == {"resting"}
    begun = jump.log.at(0.0)
    assert (begun["white"].phase, begun["red"].phase) == ("airborne", "resting")
    landing = jump.log.first("land", "white")
    assert landing.before["white"].phase == "airborne"
    roll = after.log.first("roll", "white")
    assert (roll.before[0].phase, roll.after[0].phase) == ("sliding", "rolling")


def test_the_first_event_is_the_first_of_those_that_a_loop_finds(after):
    for kind, *names in (
        ["ball"], ["cushion"], ["cushion", "white"], ["roll", "yellow"], ["cushion", "east"],
        ["ball", "yellow", "white"], ["cushion", "white", "north"], ["land"],
    ):  # fmt: skip
        found = [e for e in after.log if e.kind == kind and {*names} <= {*e.balls, e.wall}]
        assert after.log.all(kind, *names) == found
        assert after.log.first(kind, *names) == (found[0] if found else None)


@pytest.mark.parametrize(
    ("asked", "words"),
    [(["balls"], "no event 'balls': there are roll, rest"),
     (["ball", "blue"], "no ball or wall 'blue'"), (["cushion", "up"], "no ball or wall 'up'")],
)  # fmt: skip
def test_an_event_that_can_never_be_is_refused(after, asked, words):
    with pytest.raises(ValueError, match=words):
        after.log.first(*asked)


def test_balls_at_many_moments_are_where_they_are_at_each(after, jump):
    for world in (after, jump):
        times = np.random.default_rng(0).uniform(-0.1, world.time + 0.1, 300)
        many, singly = world.log.at(times), [world.log.at(time) for time in times]
        for name, motion in many.items():
            states = [at[name] for at in singly]
            for field in ("position", "velocity", "spin", "height", "climb", "speed"):
                one_by_one = np.array([getattr(state, field) for state in states])
                assert np.abs(getattr(motion, field) - one_by_one).max() < 1e-12
            assert motion.phase.tolist() == [state.phase for state in states]
            fast = motion.speed > 0.0
            turned = motion.heading - [state.heading for state in states]
            assert np.abs((turned[fast] + 180.0) % 360.0 - 180.0).max(initial=0.0) < 1e-10


def test_a_trace_at_given_times_is_what_the_log_says(after, jump):
    for world in (after, jump):
        times, paths = trace(world, times=[0.5, 0.1, 2.0])
        assert times.tolist() == [0.5, 0.1, 2.0]
        at = world.log.at(times)
        for k, ball in enumerate(world.balls):
            assert (paths[:, k] == at[ball.name].position).all()
            assert (heights(world, times=times)[:, k] == at[ball.name].height).all()
    assert (trace(after, 50.0)[1] == trace(after, times=trace(after, 50.0)[0])[1]).all()


@pytest.mark.parametrize("times", [["a"], [[0.0, 1.0]], [float("nan")], [True]])
def test_times_that_are_none_are_refused(after, times):
    with pytest.raises(ValueError, match="must be"):
        after.log.at(times)
    with pytest.raises(ValueError, match="trace times must be"):
        trace(after, times=times)


def test_events_and_states_are_short_to_look_at(after):
    hit, state = after.log[1], after.log[1].after["white"]
    assert repr(hit).startswith(f"<ball at {hit.time:.6g} s: white, yellow, closing at ")
    assert repr(state).startswith(f"<({state.position[0]:.6g}, ")
    assert repr(state).endswith(f" {state.speed:.4g} m/s at {state.heading:.4g}°, sliding>")
    assert max(len(repr(thing)) for e in after.log for thing in (e, *e.before, *e.after)) < 80


def test_a_ball_added_later_is_on_its_first_leg_before_that():
    world = tables.medium_carom()
    world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0)))
    world.step(0.5)
    world.add(Ball("red", at=(0.0, 0.3)))
    world.run()
    assert (world.log.at([0.0, 1.0])["red"].position == [(0.0, 0.3)] * 2).all()
