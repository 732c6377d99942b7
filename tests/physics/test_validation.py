"""The published and derived checks of tests/data/validation.json that no other file has, by id.

Ids are in the names of tests, or in a comment beside them; the first test says that none is left
out, here or elsewhere. Checks of tier "soft" are bands of what real tables do: ours lie inside,
docs/accuracy.md has the figures.
"""

import re
from math import cos, isfinite, pi, sin
from pathlib import Path
from random import Random
from statistics import median

import pytest

from physics import Ball, Cloth, Shot, Wall, World, laws, scenes, simulate, tables
from tests.support.published import CHECKS, given_and_expected

HERE = Path(__file__).parents[1]
R = 0.03275


def test_every_check_has_a_test_with_its_name():
    tests = "".join(path.read_text() for path in HERE.rglob("test_*.py"))
    named = {name.upper() for name in re.findall(r"def test_([a-z]\d+)_", tests)}
    for line in re.findall(r"def test_\w+.*# (.*)", tests):
        named |= set(re.findall(r"\b[A-Z]\d+\b", line))
    assert set(CHECKS) <= named


# -- cloth -------------------------------------------------------------------------------------


def test_c6_a_rolling_ball_has_slowed_down_after_a_second():
    given, expected = given_and_expected("C6")
    world = World(Cloth(roll=given["mu_r"], gravity=given["g"]))
    ball = world.add(Ball("white", (0, 0), given["v"], (0, given["v"][0] / R, 0)))
    world.run(until=given["t"])
    assert ball.velocity == pytest.approx((expected["v"], 0.0), abs=1e-12)


def test_c7_a_ball_that_rolls_slowly_is_not_braked_harder():
    """Read off the path alone: velocities over a hundredth of a second."""
    speeds = CHECKS["C7"]["input"]["speeds"]
    brakes = []
    for speed in speeds:
        world = tables.match_carom()
        ball = world.add(Ball("white", (0, 0), (speed, 0), (0, speed / 0.03075, 0), 0.03075))
        world.run(until=0.01)
        brakes.append((speed - ball.velocity[0]) / 0.01)
    assert brakes[0] <= 1.1 * brakes[-1]
    assert 0.04 <= min(brakes) <= max(brakes) <= 0.15  # the level, a table's own property
    measured = CHECKS["C7"]["expected"]["decel_m_s2"]
    assert measured[0] <= median(brakes) <= measured[-1]


def turn(z, angle, mirror):
    """The point or velocity z, mirrored at the x axis or not, then turned."""
    x, y = z[0], -z[1] if mirror else z[1]
    return x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)


def turned_scene(law, seed, angle, mirror):
    """A ball with any spin, among four walls and with one that it may meet; all of it turned.

    Spin is a pseudovector: a mirror turns it round, but for what lies across the mirror.
    """
    chance = Random(seed)
    world = World(Cloth(), "rough", law)
    corners = [(-1.0, -0.6), (1.0, -0.5), (0.9, 0.7), (-0.8, 0.6)]
    for k in range(4):
        p, q = (turn(corners[(k + i) % 4], angle, mirror) for i in (0, 1))
        world.add(Wall.through(*((q, p) if mirror else (p, q))))
    course, speed = chance.uniform(-pi, pi), chance.uniform(0.5, 4.0)
    spin = [chance.uniform(-100, 100) for _ in range(3)]
    at = chance.uniform(-0.2, 0.2), chance.uniform(-0.2, 0.2)
    wx, wy = turn((-spin[0], -spin[1]) if mirror else spin[:2], angle, mirror)
    world.add(Ball("red", turn((0.5, 0.1), angle, mirror)))
    world.add(Ball(
        "white", turn(at, angle, mirror),
        turn((speed * cos(course), speed * sin(course)), angle, mirror),
        (wx, wy, -spin[2] if mirror else spin[2]),
    ))  # fmt: skip
    return world


# Mathavan's steps are as long as the slips let them be: where rounding changes that choice, which
# it does at one hit in a hundred, the outcome moves by their error
@pytest.mark.parametrize(
    ("law", "close"), [("rigid", 1e-11), ("capped", 1e-11), ("thesis", 1e-11), ("mathavan", 2e-6)]
)
def test_c11_a_turned_or_mirrored_scene_turns_or_mirrors_all_that_follows(law, close):
    chance = Random(11)
    for seed in range(CHECKS["C11"]["input"]["n"]):
        angle, mirror = chance.uniform(-pi, pi), bool(seed % 2)
        plain = turned_scene(law, seed, 0.0, False)
        other = turned_scene(law, seed, angle, mirror)
        for world in (plain, other):
            world.run(until=1.0)
        kinds = [event.kind for event in plain.log]
        assert [event.kind for event in other.log] == kinds
        for mine, its in zip(plain.balls, other.balls, strict=True):
            assert turn(mine.position, angle, mirror) == pytest.approx(its.position, abs=close)


# -- numerics ----------------------------------------------------------------------------------


def test_n2_an_error_of_aim_turns_the_object_ball_fifteen_times_as_far():
    given, expected = given_and_expected("N2")
    r, aim = given["R"], 1e-6
    courses = []
    for angle in (-aim, aim):
        world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0))
        world.add(Ball("1", (0, 0), (cos(angle), sin(angle)), radius=r))
        red = world.add(Ball("2", (given["centre_distance"], 0), radius=r))
        world.run(until=1.0)
        courses.append(red.velocity[1] / red.velocity[0])
    slope = (courses[1] - courses[0]) / (2 * aim)
    assert slope == pytest.approx(expected["dpsi_dtheta"], rel=1e-4)


def test_n3_two_hundred_random_shots_end_and_are_the_same_three_times():
    given, chance = CHECKS["N3"]["input"], Random(3)
    for _ in range(given["n"]):
        shot = Shot(chance.uniform(0.1, 8.0), *(chance.uniform(-k, k) for k in (180, 8, 8, 8)))
        ends = []
        for _ in range(given["repeat"]):
            after = simulate(scenes.carom(), "white", shot)
            ends.append([(ball.position, ball.velocity, ball.phase) for ball in after.balls])
            assert after.time <= CHECKS["N3"]["expected"]["max_time"]
        assert ends[0] == ends[1] == ends[2]
        assert all(end[1:] == ((0.0, 0.0), "resting") for end in ends[0])
        assert all(isfinite(x) for end in ends[0] for x in end[0])
