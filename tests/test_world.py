"""The world: its time, its state from outside, and what it refuses."""

import gc
from math import inf, nan, pi

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics import (
    Ball,
    Cloth,
    EventBudgetError,
    EventDriven,
    Shot,
    Wall,
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


def test_side_spin_decays_on_its_own():  # C10
    world = World(Cloth(spin_decay=10.0))
    ball = world.add(Ball("white", at=(0, 0), velocity=(1, 0), spin=(0, 1 / 0.03275, 91.6)))
    world.step(9.15)
    assert ball.spin[2] == pytest.approx(0.1, abs=1e-6)
    world.step(0.02)
    assert ball.spin[2] == 0.0
    assert ball.position[1] == pytest.approx(0.0, abs=1e-15)


@pytest.mark.parametrize("roll", [-2.5, -1.0, 0.0, 1.0, 2.5])
def test_a_ball_ends_up_rolling_at_five_sevenths_and_two_sevenths_of_its_spin(roll):  # C2
    world = World()
    world.add(Ball("white", at=(0, 0), velocity=(1, 0), spin=(0, roll / 0.03275, 0)))
    world.run()
    rolls = [event for event in world.log if event.kind == "roll"]
    expected = (5.0 + 2.0 * roll) / 7.0
    if roll == -2.5:
        assert [event.kind for event in world.log] == ["rest"]
    elif roll == 1.0:
        assert rolls == []
    else:
        assert rolls[0].after[0].velocity[0] == pytest.approx(expected, abs=1e-15)


def test_a_stun_ball_slides_as_long_and_as_far_as_coriolis_says():  # C1
    world = World(Cloth(slide=0.2, gravity=9.81))
    world.add(Ball("white", at=(0, 0), velocity=(2, 0)))
    world.run()
    roll = world.log[0]
    assert roll.time == pytest.approx(2 * 2 / (7 * 0.2 * 9.81), rel=1e-15)
    assert roll.point[0] == pytest.approx(12 * 4 / (49 * 0.2 * 9.81), rel=1e-15)
    assert roll.after[0].velocity[0] == pytest.approx(10 / 7, rel=1e-15)


def test_the_thesis_masse_leaves_at_225_degrees():  # C3
    world = World(Cloth(0.2, 0.0, 10.0, 9.8))
    r = 0.03275
    world.add(Ball("white", at=(-1, 0.5), velocity=(2, 0), spin=(5 / r, -10 / r, 0)))
    world.run(until=10)
    roll = world.log[0]
    assert roll.time == pytest.approx(26 / (7 * 1.96), rel=1e-14)
    assert roll.point == pytest.approx((-0.4585589, -0.8536027), rel=1e-6)
    assert roll.after[0].velocity == pytest.approx((-10 / 7, -10 / 7), rel=1e-14)
    mass = world.balls[0].mass
    assert roll.energy_lost == pytest.approx(0.0, abs=1e-15)
    begin, end = world.log.legs("white")[:2]
    assert begin.energy(mass) - end.energy(mass) == pytest.approx(mass * 169 / 7, rel=1e-14)


def test_a_rolling_ball_slows_down_and_stops():  # C5, C6
    world = World(Cloth(roll=0.0045, gravity=9.81))
    r = 0.03275
    ball = world.add(Ball("white", at=(0, 0), velocity=(1, 0), spin=(0, 1 / r, 50)))
    world.run()
    assert world.time == pytest.approx(22.652622, rel=1e-6)
    assert ball.position[0] == pytest.approx(11.326311, rel=1e-6)
    assert abs(ball.position[1]) < 1e-9


def test_a_rolling_ball_meets_another_when_the_quadratic_says():  # N1
    world = World(Cloth(roll=0.01, gravity=9.81), laws.SmoothBall(1.0))
    r = 0.03075
    world.add(Ball("white", at=(0, 0), velocity=(1, 0), spin=(0, 1 / r, 0), radius=r))
    world.add(Ball("red", at=(1, 0), radius=r))
    world.run(until=2)
    hit = world.log[0]
    assert hit.time == pytest.approx(0.9862062, abs=1e-7)
    assert hit.closing == pytest.approx(0.9032532, abs=1e-7)


@pytest.mark.parametrize("offset", [0.0, 0.5, 0.9, 0.99, 0.999])
def test_a_fast_ball_hits_what_is_in_its_way(offset):  # M6
    world = World(ball_law=laws.SmoothBall(1.0))
    r = 0.03275
    world.add(Ball("white", at=(-1.0, 0.0), velocity=(8, 0)))
    world.add(Ball("red", at=(0.0, offset * 2 * r)))
    world.run(until=0.5)
    hit = next(event for event in world.log if event.kind == "ball")
    (x1, y1), (x2, y2) = (state.position for state in hit.before)
    assert ((x2 - x1) ** 2 + (y2 - y1) ** 2) ** 0.5 == pytest.approx(2 * r, abs=1e-14)
    assert (y2 - y1) == pytest.approx(offset * 2 * r, abs=1e-15)


def test_the_thesis_cushion_does_what_the_thesis_says():  # K7
    world = World(cushion_law=laws.ThesisCushion(0.9, 0.1))
    r = 0.03275
    world.add(Wall.line(-1, 0, 0, "east"))
    world.add(Ball("white", at=(-r, 0), velocity=(1, 0), spin=(0, 1 / r, 3 / r)))
    world.run(until=1e-9)
    state = world.log[0].after[0]
    assert state.velocity == pytest.approx((-0.9, -0.19), abs=1e-12)
    side = 3 - 2.5 * (21**0.5 / 5) * 0.19  # printed as 2.56467, which is 1.5e-5 too much
    assert [r * w for w in state.spin] == pytest.approx([0, -0.9, side], abs=1e-12)


def test_the_thesis_balls_swap_their_turning_and_not_their_surface_speeds():
    """(ω₁·t)' = e ω₂·t in rad/s, t across the line of centres: with unlike radii it shows."""
    world = World(ball_law=laws.ThesisBall(0.9))
    one = world.add(Ball("one", (0.0, 0.0), (1.0, 0.2), (3.0, 50.0, 7.0), radius=0.02, mass=0.1))
    two = world.add(Ball("two", (0.06, 0.0), (-0.5, 0.1), (-4.0, 20.0, 9.0), radius=0.04))
    world.run(until=1e-12)
    assert one.velocity == pytest.approx((0.9 * -0.5, 0.2), abs=1e-10)
    assert two.velocity == pytest.approx((0.9 * 1.0, 0.1), abs=1e-10)
    assert one.spin == pytest.approx((3.0, 0.9 * 20.0, 7.0), abs=1e-8)
    assert two.spin == pytest.approx((-4.0, 0.9 * 50.0, 9.0), abs=1e-8)


# -- what it refuses ---------------------------------------------------------------------------


@pytest.mark.parametrize("bad", [nan, inf, -inf, "x", None])
def test_numbers_that_are_none_are_refused_by_name(bad):
    world = scenes.carom()
    white = world.balls[0]
    before = states(world)
    for what, value in (("position", (bad, 0)), ("velocity", (0, bad)), ("spin", (0, 0, bad))):
        with pytest.raises(ValueError, match=f"'white': {what} must be"):
            setattr(white, what, value)
    with pytest.raises(ValueError, match=r"Shot\.angle"):
        Shot(1.0, bad)
    with pytest.raises(ValueError, match="radius"):
        Ball("x", at=(0, 0), radius=bad)
    with pytest.raises(ValueError, match=r"Cloth\.slide"):
        Cloth(slide=bad)
    assert states(world) == before


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
    world = moving()
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
