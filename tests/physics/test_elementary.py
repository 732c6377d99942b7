"""Sine, cosine and exponential of our own: their errors, symmetries and exact values."""

import random
from fractions import Fraction
from math import copysign, fmod, inf, isnan, log, nan, sqrt, ulp

import mpmath
import numpy as np
import pytest

from physics.kernel import elementary
from physics.kernel.elementary import cos, direction, exp, sin
from physics.shot import heading
from physics.studies import dual
from tests.support import fifty

fifty.kernel()  # sets the digits of mpmath
CHANCE = random.Random(2007)
MULTIPLES = [15.0 * k for k in range(-120, 121)]
ANGLES = [
    *MULTIPLES,
    *(x + CHANCE.gauss(0.0, 1.0) * 10.0 ** CHANCE.uniform(-16, -1) for x in MULTIPLES * 3),
    *(CHANCE.uniform(-720.0, 720.0) for _ in range(2_000)),
    *(CHANCE.gauss(0.0, 1.0) * 10.0 ** CHANCE.uniform(-323, 300) for _ in range(500)),
    5e-324, 1e-309, 1e-9, 1e22, 1.7976931348623157e308,
]  # fmt: skip
POWERS = [
    *(CHANCE.uniform(-12.0, 0.0) for _ in range(2_000)),
    *(CHANCE.uniform(-746.0, 709.7) for _ in range(4_000)),
    *((k + 0.5) * log(2.0) * (1.0 + CHANCE.gauss(0.0, 1e-15)) for k in range(-1074, 1023)),
    *(CHANCE.gauss(0.0, 1.0) * 10.0 ** CHANCE.uniform(-320, 0) for _ in range(2_000)),
    0.0, -0.0, -745.13, -745.14, 709.782712893384,
]  # fmt: skip


def units(found, exact):
    """How far off, in units in the last place of what was found."""
    return float(abs(mpmath.mpf(found) - exact) / ulp(found))


def turned(degrees):
    """The exact direction, folded into a turn first, which rounds nothing."""
    return mpmath.expjpi(mpmath.mpf(fmod(degrees, 360.0)) / 180)


def test_sine_and_cosine_are_within_a_unit_in_the_last_place():
    worst_sine = worst_cosine = 0.0
    for degrees in ANGLES:
        exact = turned(degrees)
        worst_sine = max(worst_sine, units(sin(degrees), exact.imag))
        worst_cosine = max(worst_cosine, units(cos(degrees), exact.real))
    assert worst_sine < 0.87  # 0.854 among 3e7 angles
    assert worst_cosine < 0.87  # in the octants beside 90° it is the other's polynomial


def test_the_exponential_is_within_a_unit_in_the_last_place():
    assert max(units(exp(x), mpmath.exp(mpmath.mpf(x))) for x in POWERS) < 0.95  # 0.922 in 1e8


def test_whole_sixths_and_eighths_of_a_turn_have_their_exact_values():
    half, root, long = 0.5, sqrt(0.5), sqrt(0.75)
    sines = {0: 0.0, 30: half, 45: root, 60: long, 90: 1.0}
    sines |= {180 - d: sines[d] for d in (30, 45, 60)} | {180: 0.0}
    sines |= {180 + d: -sines[d] for d in list(sines)}
    for degrees, wanted in sines.items():
        for turns in (0, 1, -1, 7, -1000, 10**12):
            assert sin(degrees + 360.0 * turns) == wanted
            assert cos(degrees + 360.0 * turns - 90.0) == wanted


def test_the_zeros_are_those_that_ieee_754_asks_of_sine_and_cosine_in_half_turns():
    for k in range(5):
        assert copysign(1.0, sin(180.0 * k)) == 1.0
        assert copysign(1.0, sin(-180.0 * k)) == -1.0
        assert copysign(1.0, cos(90.0 + 180.0 * k)) == 1.0
    assert copysign(1.0, sin(-0.0)) == -1.0


def test_sine_is_odd_and_cosine_even_and_half_a_turn_turns_both():
    for degrees in ANGLES:
        assert sin(-degrees) == -sin(degrees)
        assert cos(-degrees) == cos(degrees)
        opposite = degrees + 180.0
        if Fraction(opposite) == Fraction(degrees) + 180:  # the sum was not rounded
            assert direction(opposite) == -direction(degrees)
        quarter = degrees + 90.0
        if Fraction(quarter) == Fraction(degrees) + 90:
            assert direction(quarter) == 1j * direction(degrees)


def test_what_is_no_number_stays_none_and_what_is_too_large_is_infinite():
    for strange in (inf, -inf, nan):
        assert isnan(sin(strange))
        assert isnan(cos(strange))
    assert isnan(exp(nan))
    assert (exp(-inf), exp(inf), exp(-800.0), exp(709.8)) == (0.0, inf, 0.0, inf)
    assert (exp(0.0), exp(-0.0)) == (1.0, 1.0)


def test_they_compile_to_the_same_bits():
    pytest.importorskip("numba", reason="compiled batches need the extra `fast`")
    import numba

    from physics.batch import compiled

    package = compiled.kernel().elementary
    own, towards = package.exp, package.direction

    @numba.njit
    def exps(numbers, results):
        for k in range(len(numbers)):
            results[k] = own(numbers[k])

    @numba.njit
    def directions(degrees, vectors):
        for k in range(len(degrees)):
            vectors[k] = towards(degrees[k])

    vectors, results = np.empty(len(ANGLES), complex), np.empty(len(POWERS))
    directions(np.array(ANGLES), vectors)
    exps(np.array(POWERS), results)
    assert vectors.tobytes() == np.array([direction(x) for x in ANGLES]).tobytes()
    assert results.tobytes() == np.array([exp(x) for x in POWERS]).tobytes()


def test_with_fifty_digits_they_are_right_to_fifty_digits():
    package = fifty.kernel().elementary
    third = mpmath.mpf(1) / 3
    for own, exact in (
        (package.exp(-third), mpmath.exp(-third)),
        (package.sin(third), mpmath.sin(mpmath.radians(third))),
        (package.cos(third), mpmath.cos(mpmath.radians(third))),
        (package.direction(60.0), (1 + 1j * mpmath.sqrt(3)) / 2),
    ):
        assert abs(own - exact) < mpmath.mpf(10) ** -49


@pytest.mark.parametrize("x", [-300.0, -1.5, 0.0, 33.3, 170.0])
def test_dual_numbers_take_their_slopes_along(x):
    package, steps = dual.kernel().elementary, np.array([1.0, 0.0, -2.0, 0.0, 0.5])
    for name, rate in (
        ("sin", cos(x) * elementary.RADIANS),
        ("cos", -sin(x) * elementary.RADIANS),
        ("exp", exp(x)),
    ):
        function = getattr(package, name)
        found = function(dual.Dual(x, steps))
        assert found.value == function(x) == getattr(elementary, name)(x)
        assert found.slope == pytest.approx(rate * steps, rel=1e-15)


def test_a_heading_is_the_inverse_of_a_direction():
    vectors = [complex(CHANCE.gauss(0, 1), CHANCE.gauss(0, 1)) for _ in range(1_000)]
    vectors += [complex(z.real, z.imag * 10.0 ** CHANCE.uniform(-150, 0)) for z in vectors]
    for z in vectors:
        assert units(heading(z), mpmath.degrees(mpmath.arg(mpmath.mpc(z)))) < 3.0  # 1.9 in 2e5
    assert [heading(z) for z in (0j, 1 + 0j, 1 + 1j, 1j, -1 + 1j, -1 + 0j, -1 - 1j, -1j)] == [
        0.0, 0.0, 45.0, 90.0, 135.0, 180.0, -135.0, -90.0
    ]  # fmt: skip
    for degrees in range(-180, 181):
        assert heading(direction(float(degrees))) == pytest.approx(degrees, abs=2e-14)
