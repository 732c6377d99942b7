"""The world: its time, its state as callers see it, and what it says of what happened."""

import gc
from math import pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics import (
    EventBudgetError,
    EventDriven,
    Shot,
    World,
    laws,
    scenes,
    simulate,
    tables,
    trace,
)


def moving() -> World:
    world = scenes.carom()
    world.strike("white", Shot(3.0, 37.0, follow=0.5, side=1.5))
    return world


def states(world):
    return [(ball.position, ball.velocity, ball.spin) for ball in world.balls]


@pytest.mark.parametrize("n", [1, 2, 6, 7])
def test_any_number_of_steps_a_frame_ends_in_the_same_bits(n):
    once, often = moving(), moving()
    once.run()
    while not often.at_rest:
        for _ in range(n):
            often.step(1 / 60 / n)
    assert [ball.position for ball in often.balls] == [ball.position for ball in once.balls]
    assert len(often.log) == len(once.log)
    assert [e.time for e in often.log] == [e.time for e in once.log]


def test_looking_changes_nothing():
    seen, unseen = moving(), moving()
    while not seen.at_rest:
        seen.step(1 / 60)
        states(seen), seen.log.at(seen.time), seen.next_event, [b.phase for b in seen.balls]
    unseen.run()
    assert [ball.position for ball in seen.balls] == [ball.position for ball in unseen.balls]


def test_three_runs_are_bitwise_equal():  # N3
    runs = []
    for _ in range(3):
        world = scenes.rack15()
        world.run()
        runs.append((states(world), [event.time for event in world.log]))
        assert world.at_rest
        assert all(ball.velocity == (0.0, 0.0) for ball in world.balls)
    assert runs[0] == runs[1] == runs[2]


@pytest.mark.parametrize("seed", range(40))
def test_every_shot_comes_to_rest_within_a_minute(seed):  # N3
    world = scenes.carom()
    world.strike("white", Shot(0.3 + 0.2 * seed, 9.1 * seed, seed % 5 - 2, seed % 3, seed % 7 - 3))
    world.run()
    assert world.at_rest
    assert world.time < 60.0
    assert all(ball.velocity == (0.0, 0.0) for ball in world.balls)


def test_the_same_shot_has_the_same_digits_whenever_it_is_played():
    now, later = scenes.carom(), scenes.carom()
    later.step(1234.56789)
    for world in (now, later):
        world.strike("white", Shot(3.0, 37.0))
        world.run()
    assert [ball.position for ball in now.balls] == [ball.position for ball in later.balls]
    assert later.time - 1234.56789 == pytest.approx(now.time, abs=1e-9)


def test_simulate_is_what_strike_and_run_do_and_leaves_the_world_alone():
    world = scenes.carom()
    before = states(world)
    after = simulate(world, world.balls[0], Shot(3.0, 37.0))
    assert states(world) == before
    assert world.time == 0.0
    world.strike("white", Shot(3.0, 37.0))
    world.run()
    assert states(world) == states(after)
    assert list(world.log) == list(after.log)


def test_a_copy_goes_on_in_the_same_bits():
    world = moving()
    world.run(until=1.0)
    other = world.copy()
    world.run()
    assert other.time == 1.0
    other.run()
    assert states(other) == states(world)
    assert list(other.log) == list(world.log)


def test_state_can_be_assigned_between_any_two_steps():
    world = moving()
    world.run(until=0.5)
    white = world.balls[0]
    assert white.phase != "resting"
    white.velocity = (0.0, 0.0)
    white.spin = (0.0, 0.0, 0.0)
    white.position = (0.9, 0.4)
    assert white.phase == "resting"
    world.step(0.1)
    assert white.position == (0.9, 0.4)
    white.velocity = (1.0, 0.0)
    assert white.phase == "sliding"
    world.run()
    assert white.position != (0.9, 0.4)


def test_an_event_at_the_very_end_of_a_run_has_happened():
    world = moving()
    world.run()
    times = [event.time for event in world.log]
    for time in times:
        again = moving()
        again.run(until=time)
        assert again.log[-1].time == time
        assert len(again.log) == sum(t <= time for t in times)


def test_stop_stops_everything_where_it_is():
    world = moving()
    world.run(until=0.4)
    where = [ball.position for ball in world.balls]
    world.stop()
    assert world.at_rest
    assert [ball.position for ball in world.balls] == where
    world.run()
    assert [ball.position for ball in world.balls] == where


def test_a_cushion_law_by_name_keeps_the_nose_of_the_table():
    world = tables.medium_carom()
    nose = world.cushion_law.nose
    assert nose == 0.039 / 0.03275  # 39 mm, not the match table's 37
    world.cushion_law = "mathavan"
    assert world.cushion_law == laws.MathavanCushion(nose=nose)
    world.cushion_law = laws.RigidCushion()
    assert world.cushion_law.nose == 1.203


def test_too_many_events_are_an_error_that_carries_the_scene():
    world = moving()
    world.engine = EventDriven(budget=4)
    with pytest.raises(EventBudgetError) as caught:
        world.run()
    assert caught.value.scene


# -- trace -------------------------------------------------------------------------------------


def test_a_trace_passes_through_every_event_and_ends_at_rest():
    world = moving()
    world.run()
    times, paths = trace(world, rate=240)
    assert paths.shape == (len(times), 4, 2)
    assert times[0] == 0.0
    for k, ball in enumerate(world.balls):
        assert tuple(paths[-1, k]) == ball.position
    again = moving()
    for k in range(0, 480, 60):
        again.run(until=times[k])
        for i, ball in enumerate(again.balls):
            assert paths[k, i] == pytest.approx(ball.position, abs=1e-14)


def test_the_log_knows_every_ball_at_any_time():
    world = moving()
    world.run()
    again = moving()
    for k in range(60):
        again.run(until=k / 10)
        then = world.log.at(k / 10)
        for ball in again.balls:
            assert then[ball.name].position == pytest.approx(ball.position, abs=1e-14)
            assert then[ball.name].velocity == pytest.approx(ball.velocity, abs=1e-14)


@settings(max_examples=60, deadline=None)
@given(st.floats(-pi, pi), st.floats(0.1, 8.0), st.floats(-5, 5), st.floats(-5, 5))
def test_energy_never_grows_in_a_shot(angle, speed, follow, side):
    world = scenes.carom()
    after = simulate(world, "white", Shot(speed, angle * 180 / pi, follow, 0.0, side))
    for event in after.log:
        assert event.energy_lost > -1e-9 * speed * speed


def test_worlds_leave_no_garbage_behind():
    world = scenes.carom()
    simulate(world, "white", Shot(3.0, 10))
    gc.collect()
    before = len(gc.get_objects())
    for _ in range(50):
        simulate(world, "white", Shot(3.0, 10))
    gc.collect()
    assert len(gc.get_objects()) - before < 50
