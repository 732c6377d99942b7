"""Tasks of a researcher, as short as they should be: known rules of play, found by playing."""

import numpy as np
import pytest

from physics import Ball, Cloth, CueStroke, World, aim, laws, simulate

R = 0.028575


def pair(law, cloth=None):
    balls = [Ball("white", (-2.1 * R, 0.0), radius=R), Ball("red", (0.0, 0.0), radius=R)]
    return World(cloth or Cloth(), ball_law=law, balls=balls)


@pytest.mark.parametrize("cut", [5.0, 30.0, -60.0])
def test_a_stunned_ball_leaves_at_a_right_angle(cut):
    world = pair(laws.SmoothBall(1.0), Cloth(0.0, 0.0, 0.0))
    after = simulate(world, "white", aim.at(world, "white", "red", cut=cut).shot(2.0)).log
    hit = after.first("ball").after
    assert abs(hit["red"].heading - hit["white"].heading) == pytest.approx(90.0, abs=1e-9)


@pytest.mark.parametrize("eighths", [2.0, 4.0, -6.0])
def test_a_rolling_ball_turns_by_about_thirty_degrees_from_quarter_to_three_quarters(eighths):
    world = pair(laws.SmoothBall(1.0))
    found = aim.at(world, "white", "red", eighths=eighths)
    after = simulate(world, "white", found.shot(2.0, follow=2.0)).log
    rolls = after.all("roll", "white")[-1].after["white"].heading
    c = np.radians(found.cut)
    theory = np.degrees(np.arctan2(np.sin(c) * np.cos(c), np.sin(c) ** 2 + 0.4))
    assert found.angle - rolls == pytest.approx(theory, abs=0.15)  # it has lost speed on the way
    assert 26.0 < abs(theory) < 34.0


def throw(cut, speed, follow=0.0, side=0.0):
    """Degrees by which the red leaves the line of centres."""
    world = pair(laws.RoughBall(1.0), Cloth(0.0, 0.0, 0.0))
    found = aim.at(world, "white", "red", cut=cut)
    hit = simulate(world, "white", found.shot(speed, follow=follow, side=side)).log.first("ball")
    return found.line - hit.after["red"].heading


def published(cut, speed, follow=0.0, side=0.0):
    """The same by Alciatore's TP A.14."""
    c = np.radians(cut)
    across = speed * np.sin(c) - side
    slip = np.hypot(across, follow * np.cos(c))
    mu = 9.951e-3 + 0.108 * np.exp(-1.088 * slip)
    k = min(mu * speed * np.cos(c) / slip if slip > 0.0 else 9.0, 1.0 / 7.0)
    return np.degrees(np.arctan(k * across / (speed * np.cos(c))))


@pytest.mark.parametrize("cut", [5.0, 20.0, 40.0, 60.0, 80.0])
@pytest.mark.parametrize("speed", [0.447, 1.3, 3.1])
def test_throw_is_that_of_the_published_analysis(cut, speed):
    for follow in (0.0, speed, -0.5 * speed):
        for side in (0.0, 0.3 * speed, -0.3 * speed):
            expected = published(cut, speed, follow, side)
            assert throw(cut, speed, follow, side) == pytest.approx(expected, abs=1e-9)


@pytest.mark.parametrize("elevation", [30.0, 50.0, 70.0, 85.0])
@pytest.mark.parametrize(("right", "up"), [(0.3, 0.0), (0.4, -0.2), (-0.35, 0.02)])
def test_a_masse_ends_along_the_line_that_coriolis_drew(elevation, right, up):
    """Towards where the cue's line meets the cloth, seen from where the ball touches it."""
    ball = Ball("white", (0.0, 0.0))
    stroke = CueStroke.along(3.0, 0.0, right, up, elevation, end_ratio=1e12)
    log = simulate(World(balls=[ball]), ball, stroke.shot(ball)).log
    tilt, back = np.radians(elevation), np.sqrt(1.0 - right**2 - up**2)
    ahead = up * np.sin(tilt) - back * np.cos(tilt) + (stroke.height + 1.0) / np.tan(tilt)
    expected = np.degrees(np.arctan2(-right, ahead))
    assert log.first("roll").after["white"].heading == pytest.approx(expected, abs=1e-6)
