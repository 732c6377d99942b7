"""The cue model: published checks S1, S3 and S4, and what must hold for every stroke."""

from dataclasses import astuple, replace
from math import cos, radians, sin, sqrt, tan

import pytest

from physics import Ball, CueStroke, Shot, tables
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
    assert "-0.0" not in repr(astuple(shot))


# -- as one sees it along a raised cue, and back from a shot ---------------------------------------


@pytest.mark.parametrize("elevation", [0.0, 20.0, 55.0, 85.0])
@pytest.mark.parametrize(("right", "up"), [(0.0, 0.0), (0.3, 0.05), (-0.2, -0.4), (0.45, 0.0)])
def test_a_tip_seen_along_the_cue_is_where_the_cue_meets_the_ball(elevation, right, up):
    stroke = CueStroke.along(3.0, 10.0, right, up, elevation)
    assert stroke.seen == pytest.approx((right, up), abs=1e-14)
    assert stroke.offset == pytest.approx(sqrt(right**2 + up**2), abs=1e-14)
    # the point on the sphere, ahead, left and upward, by turning the view back to the cloth's level
    tilt, back = radians(elevation), sqrt(1.0 - right**2 - up**2)
    spot = -back * cos(tilt) + up * sin(tilt), -right, back * sin(tilt) + up * cos(tilt)
    level = -sqrt(1.0 - stroke.side**2 - stroke.height**2), -stroke.side, stroke.height
    assert level[1:] == pytest.approx(spot[1:], abs=1e-14)
    assert level[0] == pytest.approx(spot[0], abs=1e-12)


def test_a_tip_beyond_the_top_of_the_ball_is_refused():
    with pytest.raises(ValueError, match=r"up 0\.1: a cue raised by 85\.0° meets the ball beyond"):
        CueStroke.along(3.0, right=0.3, up=0.1, elevation=85.0)


def test_a_tip_beside_the_ball_is_refused_as_seen_along_the_cue():
    with pytest.raises(ValueError, match=r"right and up, 0\.8 and 0\.7, miss the ball"):
        CueStroke.along(3.0, right=0.8, up=0.7)


STROKES = [
    CueStroke(3.0), CueStroke(2.0, 200.0, side=-0.4, height=0.2), CueStroke(5.0, height=-0.5),
    CueStroke.along(3.0, 40.0, 0.3, 0.1, 60.0), CueStroke.along(2.0, 0.0, -0.2, -0.4, 30.0),
    CueStroke.along(2.0, 90.0, 0.2, -0.2, 80.0, cue_mass=0.6, restitution=0.8, end_ratio=50.0),
]  # fmt: skip


@pytest.mark.parametrize("stroke", STROKES, ids=str)
def test_a_stroke_is_found_from_the_shot_that_it_makes(stroke):
    cue = {name: getattr(stroke, name) for name in ("cue_mass", "restitution", "end_ratio")}
    for shot in (stroke.shot(WHITE), stroke.jump(WHITE)):
        found = CueStroke.of(shot, WHITE, **cue)
        assert astuple(found) == pytest.approx(astuple(stroke), abs=1e-6)


def test_a_jump_without_side_is_found_too():
    stroke = CueStroke.along(4.0, 10.0, up=0.1, elevation=40.0)
    assert astuple(CueStroke.of(stroke.jump(WHITE), WHITE)) == pytest.approx(astuple(stroke))


@pytest.mark.parametrize("follow", [1.5, 0.0, -1.0])
def test_a_shot_without_masse_is_played_with_a_level_cue_that_leaves_what_squirt_makes(follow):
    shot = Shot(3.0, 30.0, follow=follow, side=0.75)
    stroke = CueStroke.of(shot, WHITE)
    assert stroke.elevation == pytest.approx(0.0, abs=1e-9)
    made = stroke.shot(WHITE)
    assert made.masse == pytest.approx(follow * tan(radians(stroke.squirt)), abs=1e-12)
    assert astuple(replace(made, masse=0.0)) == pytest.approx(astuple(shot), abs=1e-9)


@pytest.mark.parametrize(
    ("shot", "words"),
    [(Shot(2.0, masse=1.0), "no stroke"), (Shot(2.0, side=1.0, masse=-3.0), "no stroke"),
     (Shot(2.0, climb=1.0), "no stroke"), (Shot(1.0, follow=2.4), "miscue"),
     (Shot(1.0, side=3.0), "miss the ball")],
)  # fmt: skip
def test_a_shot_that_no_stroke_gives_is_refused(shot, words):
    with pytest.raises(ValueError, match=words):
        CueStroke.of(shot, WHITE)
