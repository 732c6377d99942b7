"""Two balls that meet: the checks B of tests/data/validation.json."""

from math import atan2, cos, degrees, hypot, radians, sin
from random import Random
from statistics import median

import pytest

from physics import Ball, Cloth, EventDriven, World, laws, tables
from tests.support.published import CHECKS, given_and_expected

R = 0.03275
ALCIATORE = laws.RoughBall(1.0, "alciatore")


def heading(velocity):
    return degrees(atan2(velocity[1], velocity[0]))


def collide(law, v, w=(0.0, 0.0, 0.0), cut=0.0, other=((0.0, 0.0), (0.0, 0.0, 0.0)), sizes=None):
    """The balls just after ball 1, (vx, vy) m/s and R ω m/s, has met another one; the line of their
    centres is `cut` degrees to the left of x.  sizes: (radius, mass) of each."""
    (r, m), (s, n) = sizes or ((R, 0.25), (R, 0.25))
    world = World(Cloth(), law, engine=EventDriven(vmin=0.0))
    line = cos(radians(cut)), sin(radians(cut))
    spins = [tuple(x / size for x in spin) for spin, size in ((w, r), (other[1], s))]
    one = world.add(Ball("1", (0.0, 0.0), v, spins[0], r, m))
    two = world.add(Ball("2", (1.0, 1.0), other[0], spins[1], s, n))
    apart = one.touching_distance(two)
    two.position = (apart * line[0], apart * line[1])
    world.run(until=1e-13)
    assert [event.kind for event in world.log][:1] == ["ball"]
    return one, two


def settled(ball):
    """The velocity once it rolls."""
    (vx, vy), (wx, wy, _) = ball.velocity, ball.spin
    return (5 * vx + 2 * ball.radius * wy) / 7, (5 * vy - 2 * ball.radius * wx) / 7


def test_b1_a_head_on_hit_shares_the_speed_as_restitution_says():
    given, expected = given_and_expected("B1")
    one, two = collide(laws.SmoothBall(given["e"]), (given["v1"], 0.0))
    assert one.velocity == pytest.approx((expected["v1"], 0.0), abs=1e-12)
    assert two.velocity == pytest.approx((expected["v2"], 0.0), abs=1e-12)


def test_b2_momentum_stays_and_energy_does_not_grow():
    chance = Random(2)
    hits = 0
    while hits < 10_000:
        e, mu = chance.choice((1.0, chance.random())), chance.choice((0.06, chance.random()))
        law = chance.choice((laws.SmoothBall(e), ALCIATORE, laws.RoughBall(e, mu)))
        sizes = [(chance.uniform(0.02, 0.04), chance.uniform(0.1, 0.4)) for _ in range(2)]
        (v1, w1), (v2, w2) = balls = [
            (
                tuple(chance.uniform(-3.5, 3.5) for _ in range(2)),
                tuple(chance.uniform(-8, 8) for _ in range(3)),
            )
            for _ in range(2)
        ]
        cut = chance.uniform(-180, 180)
        if (v1[0] - v2[0]) * cos(radians(cut)) + (v1[1] - v2[1]) * sin(radians(cut)) < 0.05:
            continue
        hits += 1
        after = collide(law, v1, w1, cut, (v2, w2), sizes)
        for axis in (0, 1):
            gain = sum(
                m * (ball.velocity[axis] - v[axis])
                for ball, (v, _), (_, m) in zip(after, balls, sizes, strict=True)
            )
            assert abs(gain) < 1e-12
        gain = 0.0
        for ball, (v, w), (r, m) in zip(after, balls, sizes, strict=True):
            gain += 0.5 * m * (hypot(*ball.velocity) ** 2 - hypot(*v) ** 2)
            gain += 0.2 * m * (hypot(*(r * x for x in ball.spin)) ** 2 - hypot(*w) ** 2)
        assert gain < 1e-12


def test_b3_balls_part_at_a_right_angle_but_for_their_restitution():
    given, expected = given_and_expected("B3")
    for e, angle in zip(given["e"], expected["sep_deg"], strict=True):
        one, two = collide(laws.SmoothBall(e), (1.0, 0.0), cut=given["cut"])
        assert heading(two.velocity) - heading(one.velocity) == pytest.approx(angle, abs=1e-3)


def turned(e, cut):
    """Degrees by which a rolling ball's course has turned once it rolls again; and its speed."""
    one, _ = collide(laws.SmoothBall(e), (1.0, 0.0), (0.0, 1.0, 0.0), cut)
    return -heading(settled(one)), hypot(*settled(one))


def test_b4_the_thirty_degree_rule_of_a_rolling_ball():
    given, expected = given_and_expected("B4")
    for cut, theta in zip(given["cut"], expected["theta"], strict=True):
        assert turned(1.0, cut)[0] == pytest.approx(theta, abs=1e-3)
    most, at = max((turned(1.0, 27.0 + 0.001 * k)[0], 27.0 + 0.001 * k) for k in range(2000))
    assert most == pytest.approx(33.749, abs=1e-3)
    assert at == pytest.approx(28.126, abs=0.01)


def test_b5_the_thirty_degree_rule_with_restitution():
    given, expected = given_and_expected("B5")
    rows = zip(given["cut"], expected["theta"], expected["speed"], strict=True)
    for cut, theta, speed in rows:
        assert turned(given["e"], cut) == pytest.approx((theta, speed), abs=1e-3)


def throw(law, v, w=(0.0, 0.0, 0.0), cut=0.0):
    """Degrees by which friction turns the second ball, towards where the first one goes."""
    _, two = collide(law, (v, 0.0), w, cut)
    return cut - heading(two.velocity)


def test_b6_friction_throws_a_ball_that_is_cut():
    given, expected = given_and_expected("B6")
    for v, row in zip(given["speeds"], expected["deg"], strict=True):
        for cut, angle in zip(given["cuts"], row, strict=True):
            assert throw(ALCIATORE, v, cut=cut) == pytest.approx(angle, abs=1e-3)
    for v, at, most in ((0.5, 32.4, 5.18), (1, 27.75, 4.29), (2, 22.0, 3.3), (3, 18.6, 2.75)):
        cuts = [at + 0.05 * k for k in range(-40, 41)]
        found = max((throw(ALCIATORE, v, cut=cut), cut) for cut in cuts)
        assert found == pytest.approx((most, at), abs=0.06)
        assert found[0] == pytest.approx(most, abs=0.005)


def test_b7_a_rolling_ball_throws_less():
    given, expected = given_and_expected("B7")
    for v, row in zip(given["speeds"], expected["deg"], strict=True):
        for cut, angle in zip(given["cuts"], row, strict=True):
            assert throw(ALCIATORE, v, (0.0, v, 0.0), cut) == pytest.approx(angle, abs=1e-3)


def test_b8_outside_side_that_gears_throws_nothing():
    for cut in CHECKS["B8"]["input"]["cut"]:
        _, two = collide(ALCIATORE, (1.0, 0.0), (0.0, 0.0, sin(radians(cut))), cut)
        assert heading(two.velocity) == pytest.approx(cut, abs=1e-10)
        assert [R * x for x in two.spin] == pytest.approx([0.0, 0.0, 0.0], abs=1e-10)
        assert throw(ALCIATORE, 1.0, (0.0, 0.0, -sin(radians(cut))), cut) > 1.0  # inside side


def test_b9_side_throws_a_ball_that_is_hit_straight():
    given, expected = given_and_expected("B9")
    for side, angle in zip(given["R_wz"], expected["deg"], strict=True):
        assert -throw(ALCIATORE, 1.0, (0.0, 0.0, -side)) == pytest.approx(angle, abs=1e-3)
        assert throw(ALCIATORE, 1.0, (0.0, 0.0, side)) == pytest.approx(angle, abs=1e-3)


def test_b11_enough_friction_stops_the_slip_and_turns_both_balls_alike():
    given, expected = given_and_expected("B11")
    one, two = collide(laws.RoughBall(given["e"], given["mu"]), (given["v"], 0.0), cut=given["cut"])
    assert given["cut"] - heading(two.velocity) == pytest.approx(expected["throw_deg"], abs=1e-3)
    assert one.spin == pytest.approx(two.spin, abs=1e-10)
    nx, ny = cos(radians(given["cut"])), sin(radians(given["cut"]))
    wx, wy, wz = (R * (a + b) for a, b in zip(one.spin, two.spin, strict=True))
    vx, vy = (a - b for a, b in zip(one.velocity, two.velocity, strict=True))
    along = -vx * ny + vy * nx + wz
    upward = wx * ny - wy * nx
    assert (along, upward) == pytest.approx((0.0, 0.0), abs=1e-10)


@pytest.mark.parametrize("edition", tables.MATCH_EDITIONS)
def test_b12_the_carom_presets_hit_as_real_balls_do(edition):  # soft
    given, expected = given_and_expected("B12")
    law = tables.MATCH_EDITIONS[edition].ball_law
    assert law.e == expected["e"]
    low, high = (float(x) for x in given["cut"].split("-"))
    cuts = [low + (high - low) * k / 10 for k in range(11)]
    for rolls in (0.0, 1.0):
        throws, angles = [], []
        for v in (0.7, 1.0, 1.3, 1.6, 2.0):
            for cut in cuts:
                one, two = collide(law, (v, 0.0), (0.0, rolls * v, 0.0), cut)
                throws.append(cut - heading(two.velocity))
                angles.append(heading(two.velocity) - heading(one.velocity))
        small, large = expected["throw_deg"]
        assert small - 1.0 <= median(throws) <= large + 1.0
        small, large = expected["separation_deg"]
        assert small - 1.0 <= median(angles) <= large + 1.0
        assert max(throws) < expected["throw_ceiling_deg"]
