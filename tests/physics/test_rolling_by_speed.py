"""A cloth law of one's own: rolling resistance that depends on the speed, in exact bands."""

from dataclasses import replace
from math import exp, inf, log

import numpy as np
import pytest

from physics import (
    Ball,
    Cloth,
    Shot,
    TimeStepping,
    World,
    ledger,
    scenes,
    sensitivity,
    simulate,
    simulate_many,
    store,
    tables,
)
from tests.physics import test_sensitivity_by as by_inputs
from tests.support import fifty

A, B = 0.0402, 0.0125  # m/s² and 1/s: as measured (docs/accuracy.md)


def measured(speed):
    return A + B * speed


def distance(first, last):
    """How far a ball rolls by that law between two speeds: the integral of v / (A + B v)."""
    return (first - last) / B - A / B**2 * log((A + B * first) / (A + B * last))


CLOTH = tables.MEASURED.rolling(measured)
SHOT = Shot(4.0, 33.0, 0.5, 0.3, 1.5)


def rolled(cloth, speed, until=inf):
    world = World(cloth)
    world.add(Ball("white", (0.0, 0.0)))
    world.strike("white", Shot(speed, 0.0, follow=speed))
    world.run(until)
    return world


def carom(cloth=CLOTH):
    world = scenes.carom()
    world.cloth = cloth
    return world


@pytest.mark.parametrize("speed", [0.1, 0.5, 1.3, 4.0])
def test_a_ball_that_starts_at_a_band_s_edge_runs_exactly_as_far_as_by_the_law(speed):
    (x, _) = rolled(CLOTH, speed).balls[0].position
    assert x == pytest.approx(distance(speed, 0.0), rel=1e-9)


@pytest.mark.parametrize("step", [0.1, 0.05])
def test_the_error_is_of_second_order_in_the_width_of_bands(step):
    """Of places over two seconds, from any speed: the bound of docs/accuracy.md."""
    cloth, worst = tables.MEASURED.rolling(measured, step), 0.0
    for speed in np.linspace(0.5, 3.0, 26) + 0.033:
        decay = exp(-2.0 * B)
        x = (speed + A / B) * (1.0 - decay) / B - A / B * 2.0
        worst = max(worst, abs(rolled(cloth, speed, 2.0).balls[0].position[0] - x))
    assert worst < 0.5 * (0.5 * step * B) * 2.0**2  # half a band's width off, for two seconds
    assert worst > 0.0


def test_one_band_is_the_same_to_the_bit_as_none():
    world, plain = carom(replace(tables.MEASURED, bands=((0.0, 1.0),))), carom(tables.MEASURED)
    ends = [simulate(each, "white", SHOT) for each in (world, plain)]
    assert [ball.position for ball in ends[0].balls] == [ball.position for ball in ends[1].balls]
    assert len(ends[0].log) == len(ends[1].log)


def test_a_ball_s_deceleration_is_that_of_its_band_and_slow_events_part_them():
    cloth = Cloth(bands=((0.0, 1.0), (0.5, 2.0), (1.0, 4.0)))
    world = rolled(cloth, 1.4)
    assert [event.kind for event in world.log] == ["slow", "slow", "rest"]
    g = cloth.roll * cloth.gravity
    times = [0.4 / (4 * g), 0.5 / (2 * g), 0.5 / g]
    assert [event.time for event in world.log] == pytest.approx(np.cumsum(times))
    for event, speed in zip(world.log[:2], (1.0, 0.5), strict=True):
        assert event.after[0].velocity[0] == pytest.approx(speed, rel=1e-14)


def test_steps_of_time_and_being_put_back_change_no_bit():
    one, other = carom(), carom()
    for world in (one, other):
        world.strike("white", SHOT)
    one.run()
    while not other.at_rest:
        other.step(1 / 60)
    assert one.layout() == other.layout()


def test_compiled_and_interpreted_agree_in_every_bit():
    world, chance = carom(), np.random.default_rng(3)
    shots = np.column_stack((chance.uniform(0.2, 6.0, 200), chance.uniform(0.0, 360.0, 200),
                             chance.uniform(-3.0, 3.0, (200, 3))))  # fmt: skip
    fast, plain = (simulate_many(world, "white", shots, compiled=way) for way in (True, False))
    assert np.array_equal(fast.positions, plain.positions)
    assert np.array_equal(fast.times, plain.times)
    assert np.array_equal(fast.events, plain.events)


def test_fifty_digits_have_the_same_events_and_places():
    world = carom()
    world.strike("white", Shot(2.0, 33.0, 0.5, 0.3, 1.5))
    places, events = fifty.rest(world.copy())
    world.run()
    assert len(world.log) == events
    assert any(event.kind == "slow" for event in world.log)
    for ball, exact in zip(world.balls, places, strict=True):
        assert abs(complex(*ball.position) - complex(exact)) < 1e-11


def test_every_input_has_eleven_digits_of_its_derivative():
    """Against central differences in 50 digits, through the ends of bands as well."""
    world = by_inputs.carom(*by_inputs.SLOPING)
    world.cloth = CLOTH
    found = sensitivity(world, "white", by_inputs.SHOT, by_inputs.ALL)
    assert sum(slope.event.kind == "slow" for slope in found.events) > 5
    exact = by_inputs.central_differences(world, by_inputs.SHOT, found.by)
    size = np.abs(exact).max(axis=(0, 1))
    assert (np.abs(found.rest - exact).max(axis=(0, 1)) < 1e-11 * np.maximum(size, 1e-3)).all()


def test_every_joule_is_in_the_ledger():
    after = simulate(carom(), "white", SHOT)
    *_, last = ledger(after.log)
    lost = sum(e.energy_lost + e.cloth_lost for e in ledger(after.log))
    white = after.log.legs("white")[0]
    assert last.energy == 0.0
    assert lost == pytest.approx(white.energy(after.log.masses[0]), rel=1e-12)


def test_a_file_keeps_the_bands_and_a_cloth_without_has_none_in_it(tmp_path):
    world = carom()
    world.strike("white", SHOT)
    world.run(1.0)
    again = store.loads(store.dumps(world))
    assert again.cloth == CLOTH
    for each in (world, again):
        each.run()
    assert world.layout() == again.layout()
    assert "bands" not in store.dumps(carom(tables.MEASURED))


@pytest.mark.parametrize(
    ("bands", "message"),
    [
        (((0.5, 1.0),), "speeds must begin at 0 and grow"),
        (((0.0, 1.0), (0.0, 2.0)), "speeds must begin at 0 and grow"),
        (((0.0, -1.0),), "share must not be negative"),
        (((0.0, float("nan")),), "must be finite"),
        ((0.0, 1.0), "must be 2 numbers"),
        (7, "must be pairs"),
    ],
)
def test_bands_that_cannot_be_are_refused(bands, message):
    with pytest.raises(ValueError, match=message):
        Cloth(bands=bands)


@pytest.mark.parametrize(
    ("law", "options", "message"),
    [
        (lambda v: 0.05 - 0.02 * v, {}, r"rolling: law\(.*\) must be above zero"),
        (lambda v: 0.0, {}, r"rolling: law\(1.0\) must be above zero"),
        (measured, {"step": 0.0}, "step must be above zero"),
        (measured, {"step": 1e-5}, "fastest / step must be a whole number from 1 to 10000"),
    ],
)
def test_laws_that_cannot_be_are_refused(law, options, message):
    with pytest.raises(ValueError, match=message):
        Cloth().rolling(law, **options)


def test_fixed_steps_refuse_it():
    world = carom()
    world.engine = TimeStepping(1 / 180)
    world.strike("white", SHOT)
    with pytest.raises(ValueError, match="fixed steps know one rolling resistance"):
        world.run(1.0)
