"""Balls that fill the gap between obstacles, but for a little play, gain no energy.

Contacts that face each other cannot both open: asked to, they made any speed along the gap.
"""

from itertools import product
from math import cos, hypot, inf, radians, sin

import pytest

from benchmarks.invariants import faults
from physics import Ball, Post, Shot, Wall, World, laws, simulate_many
from tests.support.batches import same

R = 0.03275
PLAYS = (0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 5e-6, 1e-5, 5e-5, 1e-4)
ANGLES = (0.0, 10.0, 25.0, 45.0, 88.0, 90.0)


def ring(turns: int, play: float, radius: float = 0.1) -> list[Post]:
    """Posts around a ball at the origin."""
    far = R + play + radius
    spots = [radians(5.0 + 360.0 / turns * k) for k in range(turns)]
    return [Post((far * cos(a), far * sin(a)), radius) for a in spots]


def lines(play: float) -> World:
    return World(
        walls=[Wall.line(0, 1, R + play), Wall.line(0, -1, R + play)], balls=[Ball("b", (0, 0))]
    )


def smooth_lines(play: float) -> World:
    world = lines(play)
    world.cushion_law = laws.RigidCushion(0.85, 0.0)
    return world


def channel(play: float) -> World:
    walls = [
        Wall.segment((-1, -R - play), (1, -R - play)),
        Wall.segment((1, R + play), (-1, R + play)),
    ]
    return World(walls=walls, balls=[Ball("b", (-0.5, 0.0))])


def wall_and_post(play: float) -> World:
    post = Post((2.0 * R + 0.1 + play, 0.0), 0.1)
    return World(walls=[Wall.line(1, 0, 0), post], balls=[Ball("b", (R, 0.0))])


def two_posts(play: float) -> World:
    far = R + 0.1 + play
    posts = [Post((0.0, far), 0.1), Post((0.0, -far), 0.1)]
    return World(walls=posts, balls=[Ball("b", (-0.5, 0.0))])


def three_posts(play: float) -> World:
    return World(walls=ring(3, play), balls=[Ball("b", (0.0, 0.0))])


def circle(play: float) -> World:
    return World(walls=[Wall.arc((0, 0), R + play, 0, 360)], balls=[Ball("b", (0.0, 0.0))])


def row(balls: int, play: float) -> World:
    """Balls across two lines, as near to each other as to the lines."""
    half, gap = balls * R + 0.5 * play, play / (balls + 1)
    world = World(walls=[Wall.line(0, 1, half), Wall.line(0, -1, half)])
    for k in range(balls):
        world.add(Ball("b" if k == 0 else f"{k}", (0.0, gap + R - half + k * (2.0 * R + gap))))
    return world


def pair(play: float) -> World:
    return row(2, play)


def triple(play: float) -> World:
    return row(3, play)


SCENES = (lines, smooth_lines, channel, wall_and_post, two_posts, three_posts, circle, pair, triple)


def played(world: World, shot: Shot) -> World:
    """To rest; no energy is made on the way."""
    world.strike("b", shot)
    start = left = world.energy
    world.run(inf)
    for event in world.log:
        left -= event.energy_lost
        assert left <= start * (1.0 + 1e-6)
    assert world.at_rest
    return world


def gaps(world: World) -> list[float]:
    """From balls to obstacles, metres."""
    return [wall.distance(ball.position) - R for wall in world.walls for ball in world.balls]


@pytest.mark.parametrize(("scene", "play"), [*product(SCENES, PLAYS)])
def test_no_energy_comes_of_a_ball_that_fills_a_gap(scene, play):
    for angle, follow in product(ANGLES, (0.0, 2.0)):
        world = played(scene(play), Shot(3.0, angle=angle, follow=follow))
        assert min(gaps(world)) >= -1e-12
        fastest = max(hypot(*s.velocity) for event in world.log for s in event.after)
        assert fastest <= 3.0


@pytest.mark.parametrize("scene", SCENES)
def test_nothing_is_wrong_on_the_way(scene):
    for play, angle in product((1e-12, 1e-7, 1e-5), (10.0, 88.0)):
        assert faults(played(scene(play), Shot(3.0, angle=angle, follow=1.0))) == []


@pytest.mark.parametrize("play", PLAYS)
def test_a_ball_does_not_leave_a_circle_of_its_own_width(play):
    for angle in ANGLES:
        ball = played(circle(play), Shot(3.0, angle=angle)).ball("b")
        assert hypot(*ball.position) <= play + 1e-12


@pytest.mark.parametrize("half", [1e-1, 1e-2, 1e-4, 1e-6, 1e-9])
def test_a_ball_shot_into_a_funnel_stops_there(half):
    x = -R / sin(half) - 0.3
    reach = (-(1.0 - x) * cos(half), (1.0 - x) * sin(half))
    walls = [Wall.through((0, 0), reach), Wall.through((reach[0], -reach[1]), (0, 0))]
    for follow in (0.0, 3.0):
        world = World(walls=walls, balls=[Ball("b", (x, 0.0))])
        played(world, Shot(3.0, follow=follow))


@pytest.mark.parametrize("play", [0.0, 1e-12, 1e-9, 3e-7, 1e-6, 1e-5])
def test_so_it_is_between_two_circles(play):
    for angle in ANGLES:
        walls = [Wall.arc((0, 0), 0.3 + 2.0 * R + play, 0, 360), Post((0, 0), 0.3)]
        world = World(walls=walls, balls=[Ball("b", (0.3 + R + 0.5 * play, 0.0))])
        world.strike("b", Shot(1.0, angle=angle, follow=1.0))
        start = world.energy
        world.run(0.5)
        assert world.energy <= start
        assert world.at_rest or play > 3e-5 * R


@pytest.mark.parametrize("scene", SCENES)
def test_both_kernels_agree_in_a_gap(scene):
    pytest.importorskip("numba")
    shots = [Shot(3.0, angle=angle, follow=1.0) for angle in ANGLES]
    for play in (1e-12, 1e-7, 1e-5):
        plain, fast = (simulate_many(scene(play), "b", shots, compiled=c) for c in (False, True))
        assert same(plain, fast)
