"""Fixed steps: the grid they keep, what they notice, and how wrong they are."""

from math import cos, inf, nan

import pytest

from physics import (
    Ball,
    Cloth,
    EventBudgetError,
    EventDriven,
    Shot,
    TimeStepping,
    Wall,
    World,
    laws,
    scenes,
    simulate,
    tables,
)
from physics.engines.naive import Variables, euler, rk4
from tests.support.convergence import contact_error, order, place_error, slope

R = tables.THESIS.radius
RESTING = ["thesis", "euler", "rk4", "rk4-located"]  # schemes that come to rest
SCHEMES = [*RESTING, "literal"]
DT = 0.0059  # s: no frame ends at a grid time, where rounding would decide which side it is on


def carom(scheme: str, dt: float = DT) -> World:
    world = scenes.carom()
    world.engine = TimeStepping(dt, scheme)
    world.strike("white", Shot(2.0, 23.0, follow=0.5, side=1.5))
    return world


def history(world: World) -> list[object]:
    return [*world.log, *(world.log.legs(ball.name) for ball in world.balls)]


# -- what is refused -----------------------------------------------------------------------------


@pytest.mark.parametrize("dt", [0.0, -1e-3, nan, inf, "fast"])
def test_a_step_that_is_none_is_refused_by_its_value(dt):
    with pytest.raises(ValueError, match=f"TimeStepping.dt .*{dt!r}"):
        TimeStepping(dt)


def test_an_unknown_scheme_is_refused_with_the_names_that_there_are():
    with pytest.raises(ValueError, match="'verlet': one of thesis, literal, euler, rk4"):
        TimeStepping(0.01, "verlet")


@pytest.mark.parametrize("cloth", [Cloth(slide=0.0), Cloth(roll=0.0), Cloth(gravity=0.0)])
def test_a_run_to_rest_without_friction_is_refused(cloth):
    world = World(cloth, engine=TimeStepping(DT))
    world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0)))
    with pytest.raises(ValueError, match="nothing rests on Cloth"):
        world.run()
    world.run(1.0)
    assert world.time == 1.0


def test_more_events_than_allowed_end_the_run():
    world = carom("thesis")
    world.engine = TimeStepping(DT, budget=3)
    with pytest.raises(EventBudgetError):
        world.run()


# -- the grid --------------------------------------------------------------------------------------


@pytest.mark.parametrize("scheme", SCHEMES)
def test_any_number_of_steps_a_frame_gives_the_same_bits(scheme):
    histories = []
    for n in (1, 2, 6, 7):
        world = carom(scheme)
        for _ in range(60 * n):
            world.step(1 / 60 / n)
        histories.append(history(world))
    assert histories[0] == histories[1] == histories[2] == histories[3]
    assert any(event.kind == "cushion" for event in world.log)


@pytest.mark.parametrize("scheme", RESTING)
def test_every_scheme_but_the_literal_one_comes_to_rest(scheme):
    world = carom(scheme)
    world.run()
    assert world.at_rest
    assert world.next_event == inf
    assert world.time == pytest.approx(world.log[-1].time, abs=1e-12)
    assert world.log[-1].kind == "rest"
    resting = [ball.position for ball in world.balls]
    world.step(10.0)
    assert [ball.position for ball in world.balls] == resting


def test_a_copy_goes_on_as_the_world_itself_does():
    for scheme in SCHEMES:
        world = carom(scheme)
        world.run(0.5)
        twin = world.copy()
        world.run(2.0)
        twin.run(2.0)
        assert history(twin) == history(world)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_between_grid_times_a_ball_is_on_its_way(scheme):
    world = World(engine=TimeStepping(0.01, scheme))
    ball = world.add(Ball("white", at=(0.0, 0.0), velocity=(2.0, 0.0)))
    a = 0.2 * 9.8
    if scheme == "literal":
        a += 0.01 * 9.8 * 7 / 2.0  # its rolling friction at 2 m/s, also on a sliding ball
    world.run(0.005)
    assert ball.position[0] == pytest.approx(0.01 - 0.5 * a * 0.005**2)
    assert ball.velocity[0] == pytest.approx(2.0 - a * 0.005)
    assert world.next_event == 0.01


def test_a_push_starts_a_new_grid():
    world = World(engine=TimeStepping(0.01))
    ball = world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0)))
    world.add(Ball("red", at=(0.0, 1.0), velocity=(1.0, 0.0)))
    world.run(0.013)
    ball.velocity = (0.0, 1.0)
    world.step(0.001)
    assert world.next_event == pytest.approx(0.023, abs=1e-15)


@pytest.mark.parametrize("scheme", RESTING)
def test_the_log_knows_every_ball_at_every_time(scheme):
    world = carom(scheme, 1 / 5000)  # so fine that legs are left out
    for _ in range(40):
        world.step(0.0213)
        for ball in world.balls:
            x, y = world.log.at(world.time)[ball.name].position
            assert complex(x, y) == pytest.approx(complex(*ball.position), abs=2e-6)


@pytest.mark.parametrize("scheme", SCHEMES)
def test_a_push_leaves_the_other_balls_on_their_way(scheme):
    """A new grid costs a smooth step's error; a lost part of a step would be 3 mm."""
    places = []
    for push in (False, True):
        world = World(engine=TimeStepping(0.01, scheme))
        ball = world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0)))
        other = world.add(Ball("red", at=(0.0, 1.0)))
        world.run(0.113)
        if push:
            other.velocity = (0.0, 1.0)
        world.run(0.2)
        places.append(ball.position[0])
    assert places[1] == pytest.approx(places[0], abs=3e-4)


@pytest.mark.parametrize("scheme", RESTING)
def test_spin_about_the_vertical_fades_as_the_cloth_has_it(scheme):
    world = World(Cloth(spin_decay=7.0), engine=TimeStepping(DT, scheme))
    ball = world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0), spin=(0.0, 0.0, -30.0)))
    world.run(1.0)
    assert ball.spin[2] == pytest.approx(-23.0)


@pytest.mark.parametrize("scheme", RESTING)
def test_a_contact_does_not_move_a_ball(scheme):
    """Before and after it the log has the very place, also where it leaves out legs."""
    world = carom(scheme, 1 / 5000)
    world.run(2.0)
    hits = [event for event in world.log if event.kind in ("ball", "cushion")]
    assert len(hits) > 1
    for event in hits:
        for before, after in zip(event.before, event.after, strict=True):
            assert before.position == pytest.approx(after.position, abs=1e-15)


def test_an_engine_can_be_changed_while_balls_roll():
    world = carom("euler")
    for scheme in SCHEMES:
        world.run(world.time + 0.3)
        world.engine = TimeStepping(DT, scheme)
    world.run(world.time + 0.3)
    world.engine = EventDriven()
    world.run()
    assert world.at_rest


def test_a_simulated_shot_leaves_the_world_as_it_is():
    world = scenes.carom()
    world.engine = TimeStepping(DT)
    after = simulate(world, "white", Shot(2.0, 23.0))
    assert after.at_rest
    assert world.time == 0.0
    assert len(world.log) == 0


# -- what is noticed -------------------------------------------------------------------------------


@pytest.mark.parametrize("scheme", RESTING)
def test_only_things_that_approach_collide(scheme):
    world = scenes.rack15(gap=1e-3, speed=4.0)
    world.engine = TimeStepping(DT, scheme)
    world.run(1.0)
    hits = [event for event in world.log if event.kind in ("ball", "cushion")]
    assert len(hits) > 20
    assert min(event.closing for event in hits) > 0.0


@pytest.mark.parametrize("scheme", RESTING)
def test_lossy_laws_never_add_energy(scheme):
    """But for the parting speed of 1e-3 m/s: 3e-8 J for a ball of 0.25 kg with its spin."""
    world = scenes.rack15(gap=1e-3, speed=4.0)
    world.engine = TimeStepping(DT, scheme)
    world.run(1.0)
    assert min(event.energy_lost for event in world.log) > -3e-7


def test_a_contact_is_noticed_at_the_first_grid_time_after_it():
    exact, world = scenes.thesis_2(), scenes.thesis_2()
    exact.run()
    world.engine = TimeStepping(0.01)
    world.run()
    due, noticed = exact.log[0].time, world.log[0].time
    assert noticed - 0.01 < due < noticed
    assert noticed == pytest.approx(round(noticed / 0.01) * 0.01, abs=1e-15)


def test_a_fast_ball_passes_through_another_but_never_through_a_wall():
    """At 30 m/s and 180 a second it moves 5 R a substep."""
    world = tables.thesis()
    world.engine = TimeStepping(1 / 180)
    fast = world.add(Ball("white", at=(-0.05, 0.0), velocity=(30.0, 0.0)))
    slow = world.add(Ball("red", at=(0.1166, 0.0)))
    world.run(0.04)
    assert slow.velocity == (0.0, 0.0)
    world.run(3.0)
    assert all(abs(v) < 1.224 for v in (fast.position[0], slow.position[0]))
    assert any(event.kind == "cushion" for event in world.log)


def test_all_laws_of_the_world_hold():
    world = World(engine=TimeStepping(DT))
    world.ball_law = lambda v, roll, side, mass: (1.5 * mass * v.real, 0j)
    world.cushion_law = lambda v, roll, side: (complex(-0.25 * v.real, v.imag), 0j, 0.0)
    world.add(Wall.line(-1.0, 0.0, 1.0, "east"))
    white = world.add(Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.0)))
    red = world.add(Ball("red", at=(0.3, 0.0)))
    world.run(0.5)
    hit = next(event for event in world.log if event.kind == "ball")
    assert hit.impulse == pytest.approx(1.5 * 0.125 * hit.closing)
    world.strike(red, Shot(3.0))
    world.run(world.time + 0.4)
    bounce = next(event for event in world.log if event.kind == "cushion")
    assert bounce.after[0].velocity[0] == -0.25 * bounce.closing
    assert white.position[0] < red.position[0]


# -- how wrong it is -------------------------------------------------------------------------------


def cushion() -> World:
    world = tables.thesis()
    world.add(Ball("white", at=(0.3, 0.1)))
    world.strike("white", Shot(1.3, 20.0, follow=1.3))
    return world


def three_balls() -> World:
    world = tables.thesis()
    for name, at in (("white", (-0.3, 0.0)), ("red", (0.0, 0.03)), ("yellow", (0.2, 0.11))):
        world.add(Ball(name, at=at))
    world.strike("white", Shot(0.6, follow=0.6))
    return world


def stun() -> World:  # C1
    world = World(Cloth(gravity=9.81))
    world.add(Ball("white", at=(0.0, 0.0)))
    world.strike("white", Shot(2.0))
    return world


def masse() -> World:  # C3
    world = World(Cloth(roll=0.0))
    world.add(Ball("white", at=(-1.0, 0.5)))
    world.strike("white", Shot(2.0, follow=-10.0, masse=5.0))
    return world


def run_to_contact() -> World:  # N1
    world = World(Cloth(gravity=9.81))
    for name, at in (("white", (0.0, 0.0)), ("red", (1.0, 0.0))):
        world.add(Ball(name, at=at, radius=0.03075))
    world.strike("white", Shot(1.0, follow=1.0))
    return world


COARSE = [1 / 100, 1 / 200, 1 / 400]


@pytest.mark.parametrize("dt", [0.1, 1 / 30, 1 / 180])
@pytest.mark.parametrize("make", [stun, masse])
def test_the_thesis_scheme_is_exact_where_nothing_touches(make, dt):  # C1, C3
    exact, world = make(), make()
    world.engine = TimeStepping(dt)
    exact.run(2.0)
    world.run(2.0)
    assert list(world.log) == list(exact.log)
    assert world.balls[0].position == exact.balls[0].position


@pytest.mark.parametrize(
    ("make", "time"), [(cushion, 1.2), (run_to_contact, 1.2), (three_balls, 1.4)]
)
def test_the_thesis_scheme_is_of_first_order_where_something_touches(make, time):  # N5
    assert order(contact_error(make, "thesis", time), COARSE) == pytest.approx(1.0, abs=0.2)
    assert order(place_error(make, "thesis", time), COARSE) == pytest.approx(1.0, abs=0.2)


def test_euler_is_of_first_order_while_a_ball_slides():
    """It moves with each step's first velocity: a dt t / 2 too far."""
    error = place_error(stun, "euler", 0.2)
    for dt in (0.2 / 8, 0.2 / 64):
        assert error(dt) == pytest.approx(0.5 * 0.2 * 9.81 * dt * 0.2, rel=1e-9)


@pytest.mark.parametrize("scheme", ["rk4", "rk4-located"])
def test_runge_kutta_is_exact_while_a_ball_slides(scheme):
    error = place_error(stun, scheme, 0.2)
    assert max(error(0.2 / n) for n in (1, 8, 64)) < 1e-14


@pytest.mark.parametrize(("method", "claim"), [(euler, 1), (rk4, 4)])
def test_the_integrators_have_the_order_that_they_claim(method, claim):
    """On a force that bends: a ball on a spring, for a second."""

    def spring(now: Variables) -> Variables:
        return Variables(now.velocity, -now.position, 0j)

    def error(steps: int) -> float:
        now = Variables(1 + 0j, 0j, 0j)
        for _ in range(steps):
            now = method(now, 1.0 / steps, spring)
        return abs(now.position - cos(1.0))

    assert slope([(1 / n, error(n)) for n in (64, 128, 256)]) == pytest.approx(claim, abs=0.2)


@pytest.mark.parametrize("scheme", ["euler", "rk4"])
def test_naive_schemes_are_of_first_order_through_the_onset_of_rolling(scheme):  # C1
    assert order(place_error(stun, scheme, 0.5), COARSE) == pytest.approx(1.0, abs=0.2)


def test_a_located_contact_is_exact_to_rounding():
    assert contact_error(three_balls, "rk4-located", 0.6)(0.01) < 1e-14
    assert place_error(three_balls, "rk4-located", 1.2)(0.01) < 1e-13


@pytest.mark.parametrize("scheme", ["thesis", "rk4"])
def test_late_contacts_dominate_whatever_integrates_the_motion(scheme):
    """A rolling cue ball and an oblique hit: Runge-Kutta is no better than the thesis's step."""
    error = place_error(three_balls, scheme, 1.4)(1 / 180)
    best = place_error(three_balls, "rk4-located", 1.4)(1 / 180)
    assert error > 1e-3 > 1e6 * best


def test_a_driven_contact_ends():
    """Follow presses the ball into the cushion again and again, until it has been used up."""
    for scheme in RESTING:
        world = tables.thesis()
        world.cushion_law = laws.RigidCushion(0.0, 0.0, 1.2)
        world.engine = TimeStepping(1 / 180, scheme)
        world.add(Ball("white", at=(1.1, 0.0)))
        world.strike("white", Shot(1.0, follow=4.0))
        world.run()
        assert sum(event.kind == "cushion" for event in world.log) > 3


def test_what_fixed_steps_let_overlap_can_be_put_back_in_mid_flight():
    world = scenes.carom()
    world.engine = TimeStepping(1 / 60)
    world.strike("white", Shot(12.0, 37.0))
    for _ in range(120):
        world.step(1 / 60)
        for ball in world.balls:
            ball.position, ball.velocity, ball.spin = ball.position, ball.velocity, ball.spin
    world.stop()
    white, red = world.ball("white"), world.ball("red")
    white.position = red.position
    with pytest.raises(ValueError, match="overlap"):
        world.step(1 / 60)
