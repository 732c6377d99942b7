"""The inverse problem: the strike found again from the path."""

import math
from dataclasses import astuple

import numpy as np
import pytest

from physics import Ball, Cloth, Shot, World, recover, simulate, tables, trace

R = 0.03275
CLOTH = tables.MEASURED
TIMES = np.arange(0.02, 1.2, 1 / 50.2)  # C9: a camera's
CASES = [((2.0, 0.0), (3.5, 0.0)), ((2.0, 0.0), (3.0, 4.0)), ((2.0, 0.0), (2.0, 0.0))]
SEEN = 5e-4  # m: the noise of tracked paths


def path(velocity, slip, times=TIMES, cloth=CLOTH, at=(0.1, 0.2)):
    """Where the engine has a ball that sets out at time 0, (n, 2)."""
    wx, wy = velocity[0] - slip[0], velocity[1] - slip[1]
    world = World(cloth)
    ball = world.add(Ball("white", at, velocity, (-wy / R, wx / R, 7.0), radius=R))
    places = []
    for time in times:
        world.run(time)
        places.append(ball.position)
    return np.array(places)


def spin_of(velocity, slip):
    return np.array((slip[1] - velocity[1], velocity[0] - slip[0])) / R


@pytest.mark.parametrize(("velocity", "slip"), CASES)
def test_c9_without_noise_the_strike_is_found_exactly(velocity, slip):
    found = recover(TIMES, path(velocity, slip), CLOTH, R, start=0.0)
    assert found.phase == "both"
    assert found.velocity == pytest.approx(velocity, abs=1e-12)  # C9 asks for 1e-6
    assert found.slip == pytest.approx(slip, abs=1e-12)
    assert found.spin == pytest.approx(spin_of(velocity, slip), abs=1e-10)
    assert found.position == pytest.approx((0.1, 0.2), abs=1e-12)
    assert found.misfit < 1e-14


def trials(velocity, slip, count):
    exact, chance = path(velocity, slip), np.random.default_rng(9)
    return [
        recover(TIMES, exact + chance.normal(0.0, SEEN, exact.shape), CLOTH, R, start=0.0)
        for _ in range(count)
    ]


@pytest.mark.parametrize(("velocity", "slip"), CASES)
def test_c9_noise_of_half_a_millimetre_costs_what_it_must(velocity, slip):
    found = trials(velocity, slip, 60)
    v = np.array([one.velocity - velocity for one in found])
    u = np.array([one.slip - slip for one in found])
    assert np.sqrt((v**2).mean(axis=0)).max() < 0.005
    assert np.sqrt((u**2).mean(axis=0)).max() < 0.018
    # and as much as the covariance says: Mahalanobis distances have mean square 6
    truth = (0.1, 0.2, *velocity, *spin_of(velocity, slip))
    x = np.array([(*o.position, *o.velocity, *o.spin) for o in found]) - truth
    distance = [e @ np.linalg.solve(o.covariance, e) for e, o in zip(x, found, strict=True)]
    assert 6 - 4 * math.sqrt(12 / 60) < np.mean(distance) < 6 + 4 * math.sqrt(12 / 60)
    assert np.mean([one.misfit for one in found]) == pytest.approx(SEEN, rel=0.1)


def test_a_ball_that_rolls_all_along_is_found_to_roll():
    found = recover(TIMES, path((1.0, -0.5), (0.0, 0.0)), CLOTH, R, start=0.0)
    assert found.phase == "rolling"
    assert found.velocity == pytest.approx((1.0, -0.5), abs=1e-12)
    assert found.spin == pytest.approx((0.5 / R, 1.0 / R), abs=1e-10)


def test_a_ball_that_comes_to_rest_in_sight_is_found_all_the_same():
    times = np.linspace(0.0, 4.0, 50)
    cloth = Cloth(roll=0.03)
    places = path((0.5, 0.2), (0.4, -0.3), times, cloth)
    assert (places[-1] == places[-8]).all()
    found = recover(times, places, cloth, R)
    assert found.velocity == pytest.approx((0.5, 0.2), abs=1e-10)
    assert found.slip == pytest.approx((0.4, -0.3), abs=1e-10)


def test_of_a_ball_that_slides_all_along_only_the_least_slip_is_known():
    places = path((3.0, 1.0), (8.0, 6.0))
    found = recover(TIMES, places, CLOTH, R, start=0.0)
    assert found.phase == "sliding"
    assert found.velocity == pytest.approx((3.0, 1.0), abs=1e-11)
    least = 3.5 * CLOTH.slide * CLOTH.gravity * TIMES[-1]
    assert found.slip == pytest.approx((0.8 * least, 0.6 * least), abs=1e-10)
    assert least < 10.0
    assert np.isnan(found.spin).all()
    assert np.isinf(found.covariance[4:]).all()
    assert np.isfinite(found.covariance[:4, :4]).all()


def test_a_path_that_has_met_a_cushion_gives_itself_away_by_its_misfit():
    places = path((2.0, 0.0), (2.0, 0.0))
    far = places[:, 0] > 1.0
    places[far, 0] = 2.0 - places[far, 0]
    assert recover(TIMES, places, CLOTH, R, start=0.0).misfit > 20 * SEEN


def test_the_start_is_the_first_sample_unless_given():
    whole = path((2.0, 0.3), (1.0, 2.0))
    found = recover(TIMES + 5.0, whole, CLOTH, R)
    world = World(CLOTH)
    ball = world.add(Ball("white", (0.1, 0.2), (2.0, 0.3), (1.7 / R, 1.0 / R, 0.0), radius=R))
    world.run(TIMES[0])
    assert found.position == pytest.approx(ball.position, abs=1e-12)
    assert found.velocity == pytest.approx(ball.velocity, abs=1e-11)
    assert found.spin == pytest.approx(ball.spin[:2], abs=1e-9)


@pytest.mark.parametrize(
    ("times", "places", "cloth", "options", "message"),
    [
        (TIMES[:4], path((2, 0), (1, 0))[:4], CLOTH, {}, "5 samples or more, not 4"),
        (TIMES, path((2, 0), (1, 0))[1:], CLOTH, {}, "positions"),
        (TIMES[::-1], path((2, 0), (1, 0)), CLOTH, {}, "must grow"),
        (TIMES * math.nan, path((2, 0), (1, 0)), CLOTH, {}, "finite"),
        (TIMES.astype(str), path((2, 0), (1, 0)), CLOTH, {}, "times must be numbers"),
        (TIMES, path((2, 0), (1, 0)).astype(complex), CLOTH, {}, "positions must be numbers"),
        (TIMES, [[{}, {}]] * len(TIMES), CLOTH, {}, "positions must be numbers"),
        (TIMES, path((2, 0), (1, 0)), Cloth(slide=0.0), {}, "slide"),
        (TIMES, path((2, 0), (1, 0)), CLOTH, {"start": 0.1}, "after the first sample"),
        (TIMES, path((2, 0), (1, 0)), CLOTH, {"radius": -1.0}, "radius"),
    ],
)
def test_what_cannot_be_a_path_is_refused(times, places, cloth, options, message):
    with pytest.raises(ValueError, match=message):
        recover(times, places, cloth, **options)


def test_what_is_recovered_is_a_shot_again():
    world = tables.match_carom()
    white = world.add(Ball("white", at=(-1.0, -0.4)))
    shot = Shot(1.2, 20.0, follow=-2.0, masse=1.5, side=0.3)
    times, paths = trace(simulate(world, white, shot), times=[0.02 * k for k in range(40)])
    found = recover(times, paths[:, 0], world.cloth, white.radius).shot(side=0.3)
    assert astuple(found) == pytest.approx(astuple(shot), abs=1e-6)


def test_a_ball_that_slides_to_the_last_sample_gives_no_shot():
    world = tables.match_carom()
    white = world.add(Ball("white", at=(-1.0, -0.4)))
    times, paths = trace(simulate(world, white, Shot(3.0, 20.0, follow=-2.0)), 100.0)
    with pytest.raises(ValueError, match="its spin is not known"):
        recover(times[:20], paths[:20, 0], world.cloth, white.radius).shot()
