"""How much a stroke may err: Alciatore's TP 3.4, and holes that are grazed.

TP 3.4 (billiards.colostate.edu, "Margin of error based on distance and cut angle") has for smooth
balls, a cue ball whose centre travels d to where it hits, and a cut by φ: an aim that errs by Δφ
turns the object ball by Δθ = φ - Δφ + asin(d/2R sin Δφ - sin(φ - Δφ)), the other way. For small
errors the ratio is d / (2R cos φ); so a straight shot is as hard as the product of its distances.
"""

from math import asin, cos, degrees, radians, sin, sqrt

import pytest

from physics import Ball, Pocket, Shot, World, heading, laws
from tests.support import fifty
from tests.support.any_shape import ICE, MIRROR, R

CUTS = (0.0, 15.0, 30.0, 45.0, 60.0, 75.0)


def layout(d: float, cut: float) -> World:
    """The cue ball at 0, to be shot along x: so it cuts the object ball to the left."""
    world = World(ICE, laws.SmoothBall(1.0), MIRROR)
    world.add(Ball("cue", (0.0, 0.0), radius=R))
    at = d + 2.0 * R * cos(radians(cut)), 2.0 * R * sin(radians(cut))
    world.add(Ball("object", at, radius=R))
    return world


def turned(d: float, cut: float, off: float) -> float:
    """By how much the object ball is turned to the left, degrees, by an aim that is off so much."""
    world = layout(d, cut)
    world.strike("cue", Shot(1.0, off, follow=1.0))
    world.run(2.0 * d)
    v = complex(*world.ball("object").velocity)
    return heading(v) - cut


def published(d: float, cut: float, off: float) -> float:
    phi, error = radians(cut), radians(off)
    return -degrees(phi - error + asin(d / (2.0 * R) * sin(error) - sin(phi - error)))


@pytest.mark.parametrize("cut", CUTS)
@pytest.mark.parametrize("d", [0.2, 0.7, 1.8])
def test_an_error_of_aim_turns_the_object_ball_as_in_tp_3_4(d, cut):
    for off in (-0.2, -0.05, 0.05, 0.2):
        if abs(d / (2.0 * R) * sin(radians(off)) - sin(radians(cut - off))) < 0.99:
            assert turned(d, cut, off) == pytest.approx(published(d, cut, off), abs=1e-11)


@pytest.mark.parametrize("cut", CUTS)
def test_errors_grow_by_the_distance_over_the_cosine_of_the_cut(cut):
    """Against a straight shot: 1.15 times at 30 degrees, 1.41 at 45, twice at 60."""
    d, small = 0.7, 1e-4
    ratio = (turned(d, cut, small) - turned(d, cut, -small)) / (2.0 * small)
    assert -ratio == pytest.approx(d / (2.0 * R * cos(radians(cut))), rel=1e-6)


def window(d: float, far: float) -> float:
    """Degrees by which a straight shot may err, into a hole whose middle is `far` from the ball."""
    low, high = 0.0, 1.0
    for _ in range(25):
        off = 0.5 * (low + high)
        world = layout(d, 0.0)
        world.add(Pocket((d + 2.0 * R + far, 0.0), 0.05, "hole"))
        world.strike("cue", Shot(1.0, off, follow=1.0))
        world.run(4.0)
        low, high = (off, high) if world.ball("object").phase == "pocketed" else (low, off)
    return low


def test_a_straight_shot_is_as_hard_as_the_product_of_its_distances():
    """And so for a length hardest with the ball halfway."""
    hardness = {d: 1.0 / window(d, 1.6 - d) for d in (0.4, 0.8, 1.2)}
    assert hardness[0.8] > max(hardness[0.4], hardness[1.2])
    for d in (0.4, 1.2):
        assert hardness[0.8] / hardness[d] == pytest.approx(0.8 * 0.8 / (d * (1.6 - d)), rel=0.05)


def test_a_ball_that_grazes_a_hole_falls_if_its_centre_comes_over_the_rim():
    """From rolling past it by 1e-3 to within rounding: as 50 digits have it."""
    for k in range(3, 16):
        for side in (1.0, -1.0):
            world = World()
            world.add(Pocket((0.5, 0.06 + side * 10.0**-k), 0.06, "hole"))
            world.add(Ball("a", (0.0, 0.0), radius=R))
            world.strike("a", Shot(1.5, 0.0, follow=1.5))
            _, events = fifty.rest(world)
            world.run()
            assert (world.ball("a").phase == "pocketed") == (side < 0.0)
            assert len(world.log) == events
            if side < 0.0:
                reach = 0.5 - sqrt(0.06**2 - (0.06 - 10.0**-k) ** 2)
                assert world.log[-1].point[0] == pytest.approx(reach, abs=1e-8)
