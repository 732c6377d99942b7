"""The thesis's printed program, replayed: its digits, and its defects one by one."""

import json
from math import hypot, inf, sqrt
from pathlib import Path

import pytest

from physics import Ball, TimeStepping, World, tables
from physics.engines.literal import per_second

R = tables.THESIS.radius
DT = 1 / 180
SLIDE, ROLL, GRAVITY = 0.2, 0.01, 9.8  # the program's own
DATA = json.loads((Path(__file__).parents[1] / "data" / "reference_cases.json").read_text())
STARTS = {
    "scene1": ((-1.0, 0.5), (2.0, 0.0), (152.67, -305.34, 0.0)),
    "scene2": ((0.0, 0.0), (1.0, 0.0), (0.0, 30.53, 91.60)),
}


def plane(dt: float = DT) -> World:
    return World(engine=TimeStepping(dt, "literal"))


def table(dt: float = DT) -> World:
    world = tables.thesis()
    world.engine = TimeStepping(dt, "literal")
    return world


def rolling(name: str, at: tuple[float, float], speed: float, wz: float = 0.0) -> Ball:
    return Ball(name, at, (speed, 0.0), (0.0, speed / R, wz))


def energy(state) -> float:
    """Per mass."""
    v, w = hypot(*state.velocity), R * hypot(*state.spin)
    return 0.5 * v * v + 0.2 * w * w


@pytest.mark.parametrize(
    "case", DATA["thesis_program_golden"], ids=lambda c: f"{c['scene']} at {c['pps']}"
)
def test_the_program_is_matched_to_its_printed_digits(case):
    """Position and velocity bit for bit; ω, which a ball shows through R ω, to half a digit more.

    The chatter of a rolling ball multiplies a rounding error by six in a substep: nothing but the
    same operations in the same order comes near after a second.
    """
    rate = case["pps"]
    world = table(1 / rate)
    ball = world.add(Ball("white", *STARTS[case["scene"]]))
    for time, printed in case["samples"].items():
        world.run(round(float(time) * rate) * (1 / rate))
        numbers = [float(number) for number in printed]
        assert [*ball.position, *ball.velocity] == numbers[:4]
        assert ball.spin == pytest.approx(numbers[4:], rel=3e-16, abs=0.0)


def test_a_rolling_ball_hardly_slows_down():
    """2.000 to 1.99 m/s in 7 s, where rolling friction would take 0.69 m/s."""
    world = plane()
    ball = world.add(rolling("white", (0.0, 0.0), 2.0))
    world.run(7.0)
    assert 1.98 < ball.velocity[0] < 2.0


def test_a_slow_ball_collapses_to_a_creep_that_never_ends():
    world = plane()
    ball = world.add(rolling("white", (0.0, 0.0), 0.3))
    for time in (0.5, 60.0):
        world.run(time)
        assert ball.velocity[0] == pytest.approx(SLIDE * GRAVITY * DT, rel=1e-9)


def test_a_run_to_rest_is_refused_for_it_would_never_end():
    world = plane()
    world.add(rolling("white", (0.0, 0.0), 0.3))
    with pytest.raises(ValueError, match="never rests"):
        world.run(inf)
    assert world.time == 0.0
    world.stop()
    world.run()
    assert world.at_rest


def test_spin_to_the_right_is_erased_in_one_substep():
    world = plane()
    left = world.add(rolling("left", (0.0, 0.0), 1.0, wz=90.0))
    right = world.add(rolling("right", (0.0, 1.0), 1.0, wz=-90.0))
    world.run(DT)
    assert left.spin[2] == pytest.approx(90.0 - 10.0 * DT)
    assert abs(right.spin[2]) < 1e-13


def test_a_small_slip_is_thrown_to_minus_six_times_itself():
    """Friction that should halve it forgets the mass, 1/4 kg; rolling friction adds to the slip."""
    world, slip = plane(), 0.01
    ball = world.add(Ball("white", (0.0, 0.0), (1.0, 0.0), (0.0, (1.0 - slip) / R, 0.0)))
    world.run(DT)
    rolling_friction = 3.5 * ROLL * GRAVITY * 7.0 * DT
    assert ball.velocity[0] - R * ball.spin[1] == pytest.approx(-6.0 * slip - rolling_friction)


def test_a_stun_shot_leaves_the_cushion_with_more_than_twice_its_energy():
    """0.9² of translation and 2/5 × 1.9² of rotation: × 2.25."""
    world = table()
    world.add(Ball("white", (1.224 - R, 0.0), (2.0, 0.0)))
    world.run(2 * DT)
    (event,) = world.log
    v, w = event.before[0].velocity[0], R * event.before[0].spin[1]
    gained = 0.5 * (0.9 * v) ** 2 + 0.2 * (w - 1.9 * v) ** 2
    assert energy(event.after[0]) == pytest.approx(gained)
    assert energy(event.after[0]) > 2.2 * energy(event.before[0])


def test_two_balls_lose_momentum_and_swap_their_spin():
    world = plane()
    world.add(rolling("white", (0.0, 0.0), 1.0))
    world.add(Ball("red", (0.1, 0.0)))
    world.run(0.1)
    (event,) = world.log
    (white, _), (stopped, sent) = event.before, event.after
    assert stopped.velocity == (0.0, 0.0)
    assert sent.velocity[0] == pytest.approx(0.98 * white.velocity[0])
    assert sent.spin[1] == pytest.approx(0.98 * white.spin[1])
    assert stopped.spin[1] == pytest.approx(0.0, abs=1e-12)  # no follow


def test_balls_that_part_are_thrown_at_each_other_and_stick_for_seconds():
    """Touching balls that roll apart have their velocities swapped, again and again."""
    world = plane()
    world.add(rolling("left", (0.0, 0.0), -0.3))
    world.add(rolling("right", (2 * R, 0.0), 0.3))
    world.run(3.0)
    assert world.log[0].closing == -0.6
    assert len(world.log) == 541  # at every grid time of three seconds
    exact = World()
    exact.add(rolling("left", (0.0, 0.0), -0.3))
    exact.add(rolling("right", (2 * R, 0.0), 0.3))
    exact.run(3.0)
    assert [event for event in exact.log if event.kind == "ball"] == []


@pytest.mark.parametrize(("speed", "escapes"), [(11.7, False), (12.5, True)])
def test_balls_tunnel_through_walls_from_a_diameter_a_substep(speed, escapes):
    """2 R a substep is 11.79 m/s at 180 a second."""
    tunnelled = 0
    for k in range(66):  # start positions over one substep's way, a millimetre apart
        world = table()
        ball = world.add(rolling("white", (1.1 - 0.001 * k, 0.0), speed))
        world.run(0.1)
        tunnelled += ball.position[0] > 1.224
        assert (len(world.log) == 0) == (ball.position[0] > 1.224)
    assert (tunnelled > 0) == escapes


def test_its_constants_and_laws_are_its_own():
    def end(law: str) -> tuple[float, float]:
        world = table()
        world.cushion_law = law
        ball = world.add(rolling("white", (1.0, 0.0), 1.0, wz=30.0))
        world.run(0.5)
        return ball.position

    assert end("rigid") == end("thesis")


def test_friction_at_a_wall_is_capped_by_comparing_an_impulse_with_a_speed():
    """Where the slip is slow it takes half of it as momentum: 1/2m of it, twice too much."""
    world, slip = table(), 0.05
    world.add(Ball("white", (1.224 - R, 0.0), (3.0, slip)))
    world.run(2 * DT)
    (event,) = world.log
    vx, vy = event.before[0].velocity
    rub = 0.25 * 1.9 * vx * 0.1
    assert rub > vy
    assert event.after[0].velocity[1] == pytest.approx(vy - 0.5 * vy / 0.25)
    spin = -2.5 * sqrt(21 / 25) * 0.5 * vy / 0.25 / R
    assert event.after[0].spin[2] == pytest.approx(spin)


def test_a_contact_pushes_balls_on_by_a_part_of_a_substep():
    world = table()
    world.add(rolling("white", (0.9, 0.0), 2.0))
    world.add(Ball("red", (1.0, 0.01)))
    world.run(0.2)
    shares = {"ball": 0.25, "cushion": 0.5}
    assert {event.kind for event in world.log} == {"ball", "cushion"}
    for event in world.log:
        for before, after in zip(event.before, event.after, strict=True):
            for was, moved, speed in zip(
                before.position, after.position, after.velocity, strict=True
            ):
                assert moved - was == pytest.approx(shares[event.kind] * speed * DT, abs=1e-15)


def test_balls_in_one_place_keep_their_velocities():
    """The program divides by the smallest float instead of by no distance."""
    world, alone = plane(), plane()
    for name, x in (("white", 0.0), ("red", 1.0)):
        world.add(Ball(name, (x, 0.0), (1.0, 0.0)))
    single = alone.add(Ball("white", (0.0, 0.0), (1.0, 0.0)))
    world.run(0.0)
    white, red = world.scene.balls
    red.position = white.position
    world.run(DT)
    alone.run(DT)
    assert [ball.velocity for ball in world.balls] == 2 * [single.velocity]
    assert len(world.log) == 0


def test_a_step_that_is_a_reciprocal_has_that_number_a_second():
    """1 / (1 / 49) is not 49 in floats, and the program multiplies by 49."""
    assert 1 / (1 / 49) != 49.0
    assert per_second(1 / 49) == 49.0
    assert per_second(0.0059) == 1 / 0.0059
