"""The cue model: published checks S1, S3 and S4, and what must hold for every stroke."""

from math import cos, radians, sin, sqrt

import pytest

from physics import Ball, CueStroke, tables
from tests.support.published import CHECKS

WHITE = Ball("white", at=(0.0, 0.0), mass=0.21, radius=0.03075)


@pytest.mark.parametrize("where", ["side", "height"])
def test_s1_a_level_stroke_gives_the_ball_its_speed(where):
    check = CHECKS["S1"]["input"]
    for offset, expected in zip(
        check["offset_over_R"], CHECKS["S1"]["expected"]["v_over_V"], strict=True
    ):
        stroke = CueStroke(2.0, cue_mass=check["M"], restitution=check["e_tip"], **{where: offset})
        shot = stroke.shot(Ball("white", at=(0.0, 0.0), mass=check["m"]))
        assert shot.speed / 2.0 == pytest.approx(expected, abs=1e-4)
        spin = shot.follow if where == "height" else shot.side
        assert spin == pytest.approx(2.5 * offset * shot.speed, abs=1e-12)


def test_s1_a_ball_struck_two_fifths_above_the_centre_rolls_at_once():
    shot = CueStroke(2.0, 30.0, height=0.4).shot(WHITE)
    assert abs(shot.velocity() - shot.roll()) < 1e-12


def test_s3_the_ball_squirts_away_from_the_side_of_the_tip():
    check = CHECKS["S3"]
    for ratio, row in zip(check["input"]["m_over_endmass"], check["expected"]["deg"], strict=True):
        for offset, expected in zip(check["input"]["offset_over_R"], row, strict=True):
            for sign in (1.0, -1.0):
                stroke = CueStroke(1.0, 40.0, side=sign * offset, end_ratio=ratio)
                shot = stroke.shot(WHITE)
                assert shot.angle - 40.0 == pytest.approx(sign * expected, abs=1e-3)
                # the tip that turns the ball anticlockwise is on its right: it leaves to the left
                assert shot.side * (shot.angle - 40.0) > 0.0


def test_squirt_turns_the_course_and_not_the_axis_of_the_spin():
    straight = CueStroke(2.0, 10.0, side=0.3, height=0.3, end_ratio=1e12).shot(WHITE)
    squirted = CueStroke(2.0, 10.0, side=0.3, height=0.3).shot(WHITE)
    assert squirted.angle - straight.angle > 1.0
    assert abs(squirted.roll() - straight.roll()) < 1e-11
    assert squirted.speed == straight.speed


def test_s4_a_tip_slips_beyond_its_friction():
    check = CHECKS["S4"]
    for mu, expected in zip(
        check["input"]["mu_tip"], check["expected"]["max_offset_over_R"], strict=True
    ):
        limit = CueStroke(1.0, friction=mu).limit
        assert limit == pytest.approx(expected, abs=1e-3)
        assert CueStroke(1.0, side=limit - 1e-9, friction=mu).shot(WHITE).side > 0.0
        with pytest.raises(ValueError, match="miscue"):
            CueStroke(1.0, side=limit + 1e-9, friction=mu)
        with pytest.raises(ValueError, match="miscue"):
            CueStroke(1.0, side=-0.8 * limit, height=0.8 * limit, friction=mu)


def test_an_elevated_cue_with_side_makes_a_masse_that_curves_to_the_side_of_the_tip():
    a, b, theta = 0.3, 0.4, radians(45.0)
    stroke = CueStroke(3.0, side=a, height=b, elevation=45.0, end_ratio=1e12)
    shot = stroke.shot(WHITE)
    # pooltool's instantaneous point
    c, sine, cosine = sqrt(1.0 - a * a - b * b), sin(theta), cos(theta)
    square = a**2 + (b * cosine) ** 2 + (c * sine) ** 2 - 2.0 * b * c * cosine * sine
    kick = 1.73 * 3.0 / (1.0 + 0.21 / 0.5 + 2.5 * square)
    assert stroke.offset == pytest.approx(sqrt(square), abs=1e-15)
    assert shot.speed == pytest.approx(kick * cosine, rel=1e-14)
    assert shot.follow == pytest.approx(2.5 * kick * (b * cosine - c * sine), rel=1e-9)
    assert shot.masse == pytest.approx(2.5 * kick * a * sine, rel=1e-9)
    assert shot.side == pytest.approx(2.5 * kick * a * cosine, rel=1e-14)
    world = tables.match_carom()
    white = world.add(Ball("white", at=(-1.0, 0.0), radius=0.03075, mass=0.21))
    world.strike(white, shot)
    # the tip was on the right, and so friction pushes there: μ g t²/2 times the sine of the slip
    slip = shot.velocity() - shot.roll()
    drift = 0.212 * 9.81 * 0.2**2 / 2.0 * slip.imag / abs(slip)
    world.run(until=0.2)
    assert white.position[1] == pytest.approx(-drift, rel=1e-12)
    assert white.position[1] < -0.01


def test_a_stroke_on_the_cues_own_level_is_the_limit_of_small_elevations():
    level, raised = (
        CueStroke(2.0, side=0.2, height=0.1, elevation=e).shot(WHITE) for e in (0.0, 1e-9)
    )
    for name in ("speed", "angle", "follow", "masse", "side"):
        assert getattr(level, name) == pytest.approx(getattr(raised, name), abs=1e-9)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("speed", 0.0), ("speed", float("nan")), ("angle", float("inf")), ("side", "left"),
        ("elevation", 90.0), ("elevation", -1.0), ("cue_mass", 0.0), ("restitution", 1.5),
        ("end_ratio", -1.0), ("friction", -0.1), ("height", 1.0),
    ],
)  # fmt: skip
def test_a_bad_stroke_is_refused_by_name(name, value):
    with pytest.raises(ValueError, match=f"CueStroke.*{name}"):
        CueStroke(**{"speed": 1.0, name: value})


@pytest.mark.parametrize("side", [0.0, -0.0])
def test_no_zero_of_a_stroke_shows_a_sign(side):
    shot = CueStroke(2.0, side=side, height=0.2).shot(WHITE)
    assert "-0.0" not in repr(shot)
