"""A ball at a cushion: the checks K of tests/data/validation.json."""

from cmath import phase
from math import atan2, cos, degrees, radians, sin, sqrt
from random import Random
from statistics import median

import pytest

from physics import Ball, Shot, laws, simulate, tables
from tests.support.published import CHECKS, given_and_expected

CAROM_CUSHIONS = [tables.MATCH_CAROM.cushion_law, laws.MathavanCushion(nose=0.037 / 0.03075)]
ALL_CUSHIONS = [*CAROM_CUSHIONS, tables.MATCH_CAROM_2.cushion_law]


def test_k2_mathavans_cushion_gives_the_papers_figures_through_its_public_name():
    given, expected = given_and_expected("K2")
    law = laws.MathavanCushion(given["e_e"], given["mu_w"], given["mu_s"], 1.0 + given["sin_theta"])
    cases = (given["alpha_from_cushion"], given["kT"], given["kS"])
    for k, (alpha, rolls, side) in enumerate(zip(*cases, strict=True)):
        v = complex(-sin(radians(alpha)), cos(radians(alpha)))  # out of the wall, along it
        out, _, _ = law(v, rolls * v, float(side))
        assert abs(out) == pytest.approx(expected["speed"][k], abs=1e-4)
        assert degrees(atan2(out.real, out.imag)) == pytest.approx(expected["angle"][k], abs=0.01)


def test_k3_the_rigid_cushion_gives_back_what_its_formula_says():
    for case in CHECKS["K3"]["input"]["cases"]:
        law = laws.RigidCushion(case["e"], case["mu"], 1.0 + case["s"])
        v, roll, side = law(-1 + 0j, -1 + 0j, 0.0)
        expected = CHECKS["K3"]["expected"]
        assert (v.real, roll.real) == pytest.approx((expected["un"], expected["wn"]), abs=1e-5)
        assert (v.imag, roll.imag, side) == (0.0, 0.0, 0.0)


def arrivals(count, seed):
    """Balls that come to the wall x = 0 from the right, half of them rolling."""
    chance = Random(seed)
    for k in range(count):
        phi, size = chance.uniform(-1.55, 1.55), chance.uniform(0.0, 3.0)
        v = chance.uniform(0.05, 5.0) * complex(-cos(phi), sin(phi))
        roll = v if k % 2 else complex(chance.gauss(0, size), chance.gauss(0, size))
        yield chance, v, roll, chance.gauss(0, size)


def energy(v, roll, side):
    return 0.5 * abs(v) ** 2 + 0.2 * (abs(roll) ** 2 + side**2)


@pytest.mark.parametrize("kind", [laws.RigidCushion, laws.MathavanCushion, laws.CappedCushion])
def test_k4_a_cushion_makes_no_energy(kind):
    """The thesis's push, capped, makes some for a ball that does not roll, and says so."""
    for chance, v, roll, side in arrivals(10_000 if kind is laws.RigidCushion else 2_000, 4):
        e = chance.choice((1.0, chance.random()))
        mu, nose = chance.uniform(0.0, 0.4), chance.uniform(1.0, 1.45)
        if kind is laws.CappedCushion:
            law, roll = kind(e, mu), v
            assert law.creates_energy
        else:
            law = kind(e, mu, nose=nose)
        assert energy(*law(v, roll, side)) <= energy(v, roll, side) * (1.0 + 1e-9)


def test_k4_friction_of_a_rigid_cushion_does_not_turn_the_slip_round():
    """The slip with the vertical velocity that the law then takes away (docs/physics.md)."""
    for chance, v, roll, side in arrivals(10_000, 5):
        law = laws.RigidCushion(chance.random(), chance.uniform(0.0, 0.5), chance.uniform(0.8, 1.4))
        s = law.nose - 1.0
        c = sqrt(1.0 - s * s)
        out, spun, turned = law(v, roll, side)
        before = complex(v.imag + s * roll.imag - c * side, s * v.real + roll.real)
        along = out.imag + s * spun.imag - c * turned
        # the push has no part in the contact's plane: what changed there is the rub, 7/2 of it
        upward = before.imag + 3.5 * (spun.real - roll.real) / 2.5
        assert along * before.real + upward * before.imag >= -1e-9


@pytest.mark.parametrize(
    "law",
    [laws.RigidCushion(1.0, 0.0, 1.0), laws.MathavanCushion(1.0, 0.0, 0.0, 1.203)],
    ids=["rigid", "mathavan"],
)
def test_k4_without_friction_and_loss_a_cushion_is_a_mirror(law):
    for _, v, roll, side in arrivals(1_000, 6):
        out, spun, turned = law(v, roll, side)
        assert (out, spun, turned) == pytest.approx((-v.conjugate(), roll, side), abs=1e-12)


@pytest.mark.parametrize("law", CAROM_CUSHIONS, ids=lambda law: type(law).__name__)
def test_k5_a_rolling_ball_comes_off_a_carom_cushion_as_measured(law):
    for k in range(-5, 6):
        for speed in (0.8, 1.5, 2.3):
            v = speed * complex(-1.0, 0.1 * k)
            out, roll, _ = (x / speed for x in law(v, v, 0.0))
            assert 0.85 <= out.real <= 0.93
            assert -0.47 <= roll.real <= -0.11
            assert 0.53 <= (5 * out.real + 2 * roll.real) / 7 <= 0.60


def test_k5_the_second_edition_settles_as_measured_in_the_median_and_leaves_a_little_slowly():
    """Fitted to whole paths, it has right what a path shows: how fast the ball rolls afterwards."""
    law, rolls = tables.MATCH_CAROM_2.cushion_law, []
    for k in range(-5, 6):
        for speed in (0.8, 1.15, 1.5, 1.9, 2.3):
            v = speed * complex(-1.0, 0.1 * k)
            out, roll, _ = (x / speed for x in law(v, v, 0.0))
            assert 0.79 <= out.real <= 0.93  # measured from 0.85 on
            assert -0.47 <= roll.real <= -0.11
            rolls.append((5 * out.real + 2 * roll.real) / 7)
            assert 0.53 <= rolls[-1] <= 0.60
    assert 0.54 <= median(rolls) <= 0.57


@pytest.mark.parametrize("law", ALL_CUSHIONS, ids=lambda law: type(law).__name__)
def test_k6_it_does_not_leave_the_cushion_rolling(law):
    for k in range(-5, 6):
        v = complex(-1.0, 0.1 * k)
        out, roll, _ = law(v, v, 0.0)
        assert (out - roll).real >= 0.8


def third_diamond(law, start, first, speed):
    """Where a ball, from diamond `start` by diamond `first` of the long rails, comes to the third.

    Diamonds are 9 cm behind the noses and count from the far short rail; running side half of v.
    """
    world, (half, wide, diamond) = tables.match_carom(), (1.42, 0.71, 0.355)
    world.cushion_law = law
    p = complex(start * diamond - half, -wide - 0.09)
    q = complex(first * diamond - half, wide + 0.09)
    course = (q - p) / abs(q - p)
    p += course * (0.29 / course.imag)
    p += course * max(0.0, (half - 0.031 - p.real) / course.real)  # not in the corner
    white = world.add(Ball("white", (p.real, p.imag), radius=0.03075, mass=0.21))
    shot = Shot(speed, degrees(phase(course)), follow=speed, side=-0.5 * speed)
    hits = [event for event in simulate(world, white, shot).log if event.kind == "cushion"][:3]
    assert [hit.wall for hit in hits] == ["north", "west", "south"]
    (x, y), (vx, vy) = hits[2].before[0].position, hits[2].before[0].velocity
    return (x + vx / vy * (-wide - 0.09 - y) + half) / diamond


@pytest.mark.parametrize("law", ALL_CUSHIONS, ids=lambda law: type(law).__name__)
@pytest.mark.parametrize("speed", [2.0, 3.0, 4.0])
def test_k8_the_corner_five_system_holds(law, speed):  # soft
    third = {(d, f): third_diamond(law, d, f, speed) for d in (6, 7, 8) for f in (1, 2, 3)}
    errors = [t - (d / 2 + 1 - f) for (d, f), t in third.items()]
    assert abs(sum(errors) / len(errors)) <= 0.75
    for (d, f), t in third.items():
        if d < 8:
            assert 0.25 <= third[d + 1, f] - t <= 0.9
        if f < 3:
            assert -1.7 <= third[d, f + 1] - t <= -0.6
