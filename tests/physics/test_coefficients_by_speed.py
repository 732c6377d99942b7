"""Laws whose restitution and friction depend on speed: what they do, in all arithmetics."""

from math import inf

import numpy as np
import pytest

from physics import (
    Ball,
    EventDriven,
    Shot,
    Wall,
    World,
    laws,
    ledger,
    scenes,
    simulate,
    simulate_many,
    store,
    tables,
)
from tests.support import fifty

NOSE = 0.037 / 0.03075
MEASURED = laws.RigidCushion(0.871, 0.269, NOSE, e_slope=-0.051)
BOTH = laws.MathavanCushion(0.9, 0.22, None, NOSE, e_slope=-0.05, mu_slope=-0.02)
BALL = laws.RoughBall(0.95, 0.05, e_slope=-0.01, mu_slope=-0.02)
SHOT = Shot(4.0, 33.0, 0.5, 0.3, 1.5)


def carom(cushion=MEASURED, ball=BALL):
    world = scenes.carom()
    world.cushion_law, world.ball_law = cushion, ball
    return world


@pytest.mark.parametrize("speed", [0.2, 1.0, 2.5, 4.0])
@pytest.mark.parametrize("kind", [laws.RigidCushion, laws.MathavanCushion])
def test_a_cushion_is_at_each_speed_the_one_with_the_coefficients_of_that_speed(kind, speed):
    law = kind(0.871, 0.269, nose=NOSE, e_slope=-0.051, mu_slope=-0.03)
    there = kind(0.871 - 0.051 * (speed - 1), 0.269 - 0.03 * (speed - 1), nose=NOSE)
    hit = complex(-speed, 0.7), complex(-0.4 * speed, 0.5), 0.8
    assert np.allclose(law(*hit), there(*hit), rtol=0, atol=1e-14)
    if speed == 1.0:
        assert law(*hit) != kind(0.9, 0.269, nose=NOSE)(*hit)


@pytest.mark.parametrize("speed", [0.2, 1.0, 3.0])
def test_balls_part_with_the_restitution_of_their_closing_speed(speed):
    push, _ = laws.SmoothBall(0.95, -0.02)(complex(speed, 1.0), 0j, 0.0, 0.1)
    assert push == pytest.approx(0.1 * speed * (1.95 - 0.02 * (speed - 1)), rel=1e-14)


@pytest.mark.parametrize("slip", [0.8, 1.0, 3.0])
def test_balls_rub_with_the_friction_of_their_slip(slip):
    push, rub = laws.RoughBall(0.95, 0.05, 0.0, -0.01)(complex(2.0, slip), 0j, 0.0, 0.1)
    assert abs(rub) == pytest.approx((0.05 - 0.01 * (slip - 1)) * push, rel=1e-14)


@pytest.mark.parametrize("law", [MEASURED, BOTH])
def test_no_speed_takes_restitution_below_none_and_the_ball_always_leaves(law):
    world = World(tables.MEASURED, cushion_law=law)
    world.add(Wall.through((0.0, 0.0), (1.0, 0.0)))
    world.add(Ball("white", (0.0, 0.2)))
    hit = next(
        event
        for event in simulate(world, "white", Shot(40.0, 270.0)).log
        if event.kind == "cushion"
    )
    assert hit.closing > 30.0
    assert 0.0 < hit.after[0].velocity[1] < 3.0  # what is left comes from the spin
    for speed in (20.0, 100.0, 1e4):
        assert law(complex(-speed, 0.0), 0j, 0.0)[0].real <= 0.1 * speed
        assert world.scene.cushion_rule.parting > 0.0


@pytest.mark.parametrize("kind", [laws.RigidCushion, laws.MathavanCushion])
def test_no_speed_takes_restitution_above_one(kind):
    law = kind(0.98, 0.2, nose=NOSE, e_slope=-0.3)
    for speed in (1e-3, 0.1, 0.9, 1.1, 5.0):
        v, roll, side = law(complex(-speed, 0.3), complex(0.1, -0.2), 0.5)
        before = 0.5 * (speed**2 + 0.09) + 0.2 * (0.05 + 0.25)
        assert 0.5 * abs(v) ** 2 + 0.2 * (abs(roll) ** 2 + side**2) <= before * (1 + 1e-9)


@pytest.mark.parametrize("world", [carom(), carom(BOTH)], ids=["rigid", "mathavan"])
def test_the_compiled_kernel_has_the_same_bits(world):
    pytest.importorskip("numba")
    shots = [Shot(5.0, 360.0 * k / 60, follow=0.5, side=1.5) for k in range(60)]
    plain, fast = (simulate_many(world, "white", shots, compiled=c) for c in (False, True))
    assert np.array_equal(plain.positions, fast.positions)
    assert np.array_equal(plain.times, fast.times)


def test_a_rack_and_contacts_that_last_have_the_same_bits_compiled():
    pytest.importorskip("numba")
    world = scenes.rack15()
    world.stop()
    world.cushion_law, world.ball_law = MEASURED, BALL
    shots = [Shot(7.0, angle, follow=2.0) for angle in (0.0, 0.01, 1.0, 10.0)]
    plain, fast = (simulate_many(world, "cue", shots, compiled=c) for c in (False, True))
    assert np.array_equal(plain.positions, fast.positions)


@pytest.mark.parametrize(
    ("cushion", "bound"),
    [(MEASURED, 1e-10), (BOTH, 1e-5)],  # where rounding changes a step of Mathavan's, it shows
)
def test_the_digits_are_those_of_the_same_source_in_fifty(cushion, bound):
    world = carom(cushion)
    world.strike("white", SHOT)
    exact, events = fifty.rest(world)
    world.run()
    assert len(world.log) == events
    for ball, rest in zip(world.balls, exact, strict=True):
        assert abs(complex(*ball.position) - complex(rest)) < bound


@pytest.mark.parametrize("cushion", [MEASURED, BOTH])
def test_every_joule_is_in_the_ledger(cushion):
    after = simulate(carom(cushion), "white", SHOT)
    entries = list(ledger(after.log))
    start = entries[0].energy + entries[0].energy_lost + entries[0].cloth_lost
    lost = sum(entry.energy_lost + entry.cloth_lost for entry in entries)
    assert start - lost == pytest.approx(entries[-1].energy, abs=1e-12 * start)
    assert all(entry.energy_lost >= -1e-7 for entry in entries)


def test_the_log_shows_the_restitution_of_a_ball_without_spin():
    world = World(tables.MEASURED, cushion_law=laws.RigidCushion(0.871, 0.0, 1.0, e_slope=-0.051))
    world.add(Wall.through((0.0, 0.0), (1.0, 0.0)))
    world.add(Ball("white", (0.0, 0.04)))
    for speed in (0.5, 2.0):
        hit = simulate(world, "white", Shot(speed, 270.0)).log[0]
        share = hit.after[0].velocity[1] / hit.closing
        assert share == pytest.approx(0.871 - 0.051 * (hit.closing - 1), rel=1e-12)


def test_a_nose_met_in_the_air_has_the_restitution_of_its_speed():
    hits = []
    for law in (laws.RigidCushion(0.9, 0.0, 1.2), laws.RigidCushion(0.9, 0.0, 1.2, -0.1)):
        world = tables.medium_carom()
        world.cushion_law = law
        ball = world.add(Ball("white", (1.2, 0.0), velocity=(3.0, 0.0)))
        ball.height = 2e-3
        world.run(0.1)
        hits.append(next(event for event in world.log if event.kind == "cushion"))
    constant, sloping = (-hit.after[0].velocity[0] / hit.closing for hit in hits)
    assert hits[0].before[0].height > 0.0
    assert constant - sloping == pytest.approx(0.1 * (3.0 - 1.0), rel=0.1)


def test_springs_between_touching_balls_take_the_restitution_of_the_fastest():
    world = scenes.cradle(3)
    ends = []
    for law in (laws.SmoothBall(0.9), laws.SmoothBall(0.95, -0.05), laws.SmoothBall(0.95)):
        world.ball_law, world.cluster_law = law, laws.HertzCluster()
        ends.append(simulate(world, "0", Shot(2.0, follow=2.0)).log[-1].after[-1].velocity)
    assert ends[0] == pytest.approx(ends[1], rel=1e-12)
    assert ends[0][0] < ends[2][0] - 0.01


def test_a_law_without_slopes_is_written_as_before():
    world = scenes.carom()
    assert "slope" not in store.dumps(world)
    world.cushion_law = MEASURED
    assert '"e_slope": -0.051' in store.dumps(world)
    assert store.loads(store.dumps(world)).cushion_law == MEASURED


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: laws.RigidCushion(e_slope=inf), "RigidCushion.e_slope must be finite"),
        (lambda: laws.RigidCushion(mu=1.2, mu_slope=0.1), "RigidCushion.mu must be from 0 to 1"),
        (lambda: laws.RoughBall(mu_slope=-0.1), "mu_slope is -0.1, but Alciatore's fit"),
        (lambda: laws.SmoothBall(e_slope="x"), "SmoothBall.e_slope must be a number"),
        (lambda: laws.MathavanCushion(mu=0.4, slide=1.0, nose=1.45, mu_slope=0.1), "jam"),
        (lambda: laws.MathavanCushion(mu=0.1, slide=1.0, nose=1.45, mu_slope=-0.9), "jam"),
    ],
)
def test_slopes_that_cannot_be_are_refused_by_name(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_an_engine_without_floor_still_has_the_ball_leave():
    world = carom(laws.RigidCushion(0.5, 0.2, NOSE, e_slope=-1.0))
    world.engine = EventDriven(vmin=1e-4)
    after = simulate(world, "white", Shot(3.0, 90.0))
    assert after.at_rest
    assert all(
        event.after[0].velocity[1] < 0.0
        for event in after.log
        if event.kind == "cushion" and event.wall == "north" and event.closing > 0.01
    )
