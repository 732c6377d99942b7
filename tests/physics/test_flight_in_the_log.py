"""Balls in the air in the log: ledger, heights for plots, and the balls a custom law was given."""

import math

import numpy as np
import pytest

from physics import Ball, Cloth, Shot, World, heights, laws, ledger, simulate, tables, trace

RADIUS, MASS = 0.03075, 0.21


def pair(height=0.0):
    """A ball at rest, and one 0.4 m beside it."""
    world = tables.match_carom()
    for name, x in (("a", 0.0), ("b", 0.4)):
        world.add(Ball(name, (x, 0.0), radius=RADIUS, mass=MASS)).height = height
    return world


# -- the ledger


def test_a_landing_shows_how_fast_the_ball_came_down_and_went_up():
    world = World(Cloth(bounce=0.5))
    world.add(Ball("stone", (0.0, 0.0), velocity=(0.3, 0.0), mass=MASS)).height = 0.2
    world.run()
    first, second = list(ledger(world.log))[:2]
    down = math.sqrt(2 * world.cloth.gravity * 0.2)
    level = 5 / 7 * 0.3  # enough friction that it rolls
    assert first.kind == second.kind == "land"
    assert first.speed_before == pytest.approx(math.hypot(0.3, down), rel=1e-14)
    assert first.speed_after == pytest.approx(math.hypot(level, 0.5 * down), rel=1e-14)
    assert second.speed_before == pytest.approx(first.speed_after, rel=1e-14)
    assert first.height == pytest.approx(0.0, abs=1e-16)


def test_energy_in_the_ledger_counts_what_gravity_has_stored():
    world = World(Cloth())
    stone = world.add(Ball("stone", (0.0, 0.0), mass=MASS))
    world.run(1.0)
    stone.height = 0.2
    world.run()
    lifted = next(entry for entry in ledger(world.log) if entry.kind == "hand")
    assert lifted.energy == pytest.approx(MASS * world.cloth.gravity * 0.2, rel=1e-14)
    assert (lifted.height, lifted.speed_after) == (0.2, 0.0)


def test_a_hit_aloft_shows_its_height_and_its_speeds_in_space():
    world = pair(height=0.1)
    world.ball_law = laws.SmoothBall(1.0)
    world.ball("a").velocity = 4.0, 0.0
    world.run()
    hit = next(entry for entry in ledger(world.log) if entry.kind == "ball")
    when = (0.4 - 2 * RADIUS) / 4.0
    falling = world.cloth.gravity * when
    assert hit.height == pytest.approx(0.1 - 0.5 * falling * when, rel=1e-13)
    speeds = hit.speed_before, hit.other_before, hit.speed_after, hit.other_after
    fast = math.hypot(4.0, falling)
    assert speeds == pytest.approx((fast, falling, falling, fast), rel=1e-13)
    assert ledger(world.log).table()["height"].max() == hit.height


# -- heights for plots


def test_heights_are_those_of_the_balls_at_the_times_of_the_trace():
    world = pair()
    world.strike("a", Shot(1.5, climb=1.2))
    live = world.copy()
    world.run()
    times, paths = trace(world, 100.0)
    high = heights(world, 100.0)
    assert high.shape == paths.shape[:2] == (len(times), 2)
    for k in range(60):
        live.run(until=float(times[k]))
        assert high[k].tolist() == pytest.approx([b.height for b in live.balls], abs=1e-14)
    top = 1.2**2 / (2 * world.cloth.gravity)  # between two samples
    assert top * 0.99 < high[:60, 0].max() <= top
    assert high[-1].tolist() == [0.0, 0.0]


def test_a_ball_that_is_off_the_table_has_no_height():
    after = simulate(pair(), "a", Shot(3.0, angle=90.0, climb=1.5))
    assert after.ball("a").phase == "off"
    high = heights(after)
    assert high[:, 0].max() > 0.05
    assert high[-1, 0] == 0.0
    assert (high >= 0.0).all()


@pytest.mark.parametrize("rate", [0.0, -1.0, math.nan])
def test_heights_at_no_rate_are_refused(rate):
    with pytest.raises(ValueError, match="rate"):
        heights(pair(), rate)


# -- custom laws


@pytest.mark.parametrize("spin", [(0.0, 0.0, 0.0), (5.0, 40.0, -60.0)], ids=["plain", "spinning"])
@pytest.mark.parametrize("climb", [0.0, 0.4])
def test_an_error_of_a_ball_law_names_the_balls_that_met_in_the_air(spin, climb):
    world = pair(height=0.1)
    world.add(Ball("c", (0.8, 0.3), radius=RADIUS, mass=MASS))
    world.ball_law = lambda v, roll, side, mass: None
    a = world.ball("a")
    a.velocity, a.spin, a.climb = (4.0, 0.1), spin, climb
    with pytest.raises(ValueError, match="at balls 'a' and 'b', returned None"):
        world.run()


def test_a_ball_below_is_not_taken_for_the_one_that_was_hit():
    world = pair()
    world.add(Ball("high", (0.4, 0.0), radius=RADIUS, mass=MASS))
    world.ball_law = lambda v, roll, side, mass: None
    world.ball("a").velocity = 4.0, 0.0
    for name in ("a", "high"):
        world.ball(name).height = 0.1
    with pytest.raises(ValueError, match="at balls 'a' and 'high', returned None"):
        world.run()


def test_a_ball_that_lands_on_another_is_named_with_it():
    world = pair()
    b = world.ball("b")
    b.position, b.height = (0.02, 0.0), 0.3
    world.ball_law = lambda v, roll, side, mass: None
    with pytest.raises(ValueError, match="at balls 'a' and 'b', returned None"):
        world.run()
    assert np.isclose(world.ball("b").height, 0.3)  # as before the run
