"""Motion on the cloth and at contacts, as formulas have it: checks C, K, M and N by hand."""

import pytest

from physics import Ball, Cloth, Wall, World, laws


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
    two = world.add(Ball("two", (0.0, 0.0), (-0.5, 0.1), (-4.0, 20.0, 9.0), radius=0.04))
    two.position = (one.touching_distance(two), 0.0)
    world.run(until=1e-12)
    assert one.velocity == pytest.approx((0.9 * -0.5, 0.2), abs=1e-10)
    assert two.velocity == pytest.approx((0.9 * 1.0, 0.1), abs=1e-10)
    assert one.spin == pytest.approx((3.0, 0.9 * 20.0, 7.0), abs=1e-8)
    assert two.spin == pytest.approx((-4.0, 0.9 * 50.0, 9.0), abs=1e-8)
