"""Segments, arcs, posts and pockets: when and where a ball meets them, and what is refused."""

from itertools import pairwise
from math import cos, hypot, inf, nan, sin, sqrt
from random import Random

import mpmath
import numpy as np
import pytest

from physics import (
    Ball,
    Cloth,
    Pocket,
    Post,
    Shot,
    Wall,
    World,
    laws,
    scenes,
    simulate,
)
from physics.kernel import contact, obstacle
from physics.kernel.obstacle import Shape
from tests.support import fifty
from tests.support.any_shape import ICE, MIRROR, R, box, pool, xy


def alone(thing, at, velocity, cloth=ICE, law=MIRROR) -> World:
    """One ball that moves towards a thing; with the events of the next seconds."""
    world = World(cloth, "rough", law)
    world.add(thing)
    world.add(Ball("a", at, velocity, radius=R))
    world.run(3.0)
    return world


def first(world: World):
    return next(iter(world.log))


# -- where and when


def test_a_ball_meets_a_segment_as_it_would_the_line():
    shot = Shot(3.0, 37.0, follow=1.0, side=2.0)
    line, segment = (simulate(with_ball(make()), "a", shot) for make in (tables_box, box))
    assert [e.time for e in line.log] == [e.time for e in segment.log]
    assert [e.wall for e in line.log] == [e.wall for e in segment.log]
    assert line.ball("a").position == segment.ball("a").position


def tables_box() -> World:
    world = World()
    for a, b, d, name in ((0, 1, 0.5, "south"), (-1, 0, 1.0, "east"), (0, -1, 0.5, "north"),
                          (1, 0, 1.0, "west")):  # fmt: skip
        world.add(Wall.line(a, b, d, name))
    return world


def with_ball(world: World) -> World:
    world.add(Ball("a", (0.1, 0.05), radius=R))
    return world


@pytest.mark.parametrize("beyond", [-0.5 * R, 0.0, 0.3 * R, 0.9 * R])
def test_an_end_of_a_segment_is_a_point(beyond):
    world = alone(Wall.segment((-1.0, 0.0), (0.0, 0.0), "s"), (beyond, 0.5), (0.0, -1.0))
    hit = first(world)
    height = sqrt(R * R - max(0.0, beyond) ** 2)
    assert hit.time == pytest.approx(0.5 - height, rel=1e-14)
    assert hit.point == pytest.approx((min(0.0, beyond), 0.0), abs=1e-15)


def test_a_ball_beyond_the_end_of_a_segment_passes():
    assert not len(alone(Wall.segment((-1.0, 0.0), (0.0, 0.0)), (1.001 * R, 0.5), (0.0, -1.0)).log)


def test_a_segment_has_two_sides():
    for y in (0.5, -0.5):
        hit = first(alone(Wall.segment((-1.0, 0.0), (1.0, 0.0)), (0.1, y), (0.0, -2.0 * y)))
        assert hit.time == pytest.approx((0.5 - R) / 1.0, rel=1e-14)
        assert hit.after[0].velocity == (0.0, pytest.approx(2.0 * y))


def test_a_ball_behind_the_line_of_a_segment_is_not_in_it():
    """In the mouth of a pocket it is behind the line of the rail."""
    world = alone(Wall.segment((-1.0, 0.0), (0.0, 0.0)), (0.5, -0.3), (0.0, -1.0))
    assert not len(world.log)
    curved = World(Cloth(0.2, 0.01, 0.0), "rough", MIRROR)
    curved.add(Wall.segment((-1.0, 0.0), (0.0, 0.0), "s"))
    curved.add(Ball("a", (0.2, -0.1), (-0.2, 0.9), spin=(120.0, 0.0, 0.0), radius=R))
    curved.run(0.5)
    assert [event.wall for event in curved.log if event.wall] == []


def test_a_post_is_a_disc():
    hit = first(alone(Post((0.0, 0.0), 0.1, "post"), (0.05, 0.5), (0.0, -1.0)))
    assert hit.time == pytest.approx(0.5 - sqrt((0.1 + R) ** 2 - 0.05**2), rel=1e-14)
    assert (hit.kind, hit.wall) == ("cushion", "post")
    assert hypot(*hit.point) == pytest.approx(0.1, rel=1e-14)


def test_an_arc_is_met_from_inside_and_from_outside():
    ring = Wall.arc((0.0, 0.0), 0.4, 0.0, 360.0, "ring")
    hit = first(alone(ring, (0.0, 0.1), (1.0, 0.0)))
    assert hit.time == pytest.approx(sqrt((0.4 - R) ** 2 - 0.01), rel=1e-14)
    hit = first(alone(ring, (-1.0, 0.1), (1.0, 0.0)))
    assert hit.time == pytest.approx(1.0 - sqrt((0.4 + R) ** 2 - 0.01), rel=1e-14)


def test_a_ball_goes_in_by_the_gap_of_an_arc_and_meets_it_inside():
    bay = Wall.arc((0.0, 0.0), 0.4, -90.0, 90.0, "bay")
    hit = first(alone(bay, (-1.0, 0.1), (1.0, 0.0)))
    assert hit.time == pytest.approx(1.0 + sqrt((0.4 - R) ** 2 - 0.01), rel=1e-14)


def test_the_ends_of_an_arc_are_points():
    bay = Wall.arc((0.0, 0.0), 0.4, -90.0, 90.0, "bay")
    hit = first(alone(bay, (-1.0, 0.4 - 0.5 * R), (1.0, 0.0)))
    assert hit.time == pytest.approx(1.0 - sqrt(R * R - 0.25 * R * R), rel=1e-13)
    assert hit.point == pytest.approx((0.0, 0.4), abs=1e-14)


def test_a_ball_falls_when_its_centre_comes_to_the_rim():
    world = alone(Pocket((0.0, 0.0), 0.06, "hole"), (0.03, 0.5), (0.0, -1.0))
    fall, ball = first(world), world.ball("a")
    assert (fall.kind, fall.wall, fall.balls) == ("pocket", "hole", ("a",))
    assert fall.time == pytest.approx(0.5 - sqrt(0.06**2 - 0.03**2), rel=1e-14)
    assert hypot(*fall.point) == pytest.approx(0.06, rel=1e-14)
    assert (ball.phase, ball.gone, ball.lies, ball.velocity) == ("pocketed", True, True, (0, 0))
    assert fall.energy_lost == pytest.approx(0.5 * ball.mass, rel=1e-12)
    assert world.at_rest


def fates(thing: Shape, rolls):
    """For random rolls, when it is met in double precision and in 50 digits."""
    fine, exact = fifty.kernel(), fifty.record(thing)
    for p, v, a, horizon in rolls:
        at = [fifty.exact(z) for z in (p, v, a, R, horizon)]
        yield obstacle.touch(thing, p, v, a, R, horizon), fine.obstacle.touch(exact, *at)


SHAPES = {
    "segment": Wall.segment((-0.3, 0.1), (0.2, -0.05)),
    "arc": Wall.arc((0.0, 0.0), 0.3, 20.0, 290.0),
    "bay": Wall.arc((0.1, 0.0), 0.2, -80.0, 80.0),
    "ring": Wall.arc((0.0, 0.0), 0.9, 0.0, 360.0),
    "post": Post((0.05, 0.0), 0.05),
    "point": Post((0.05, 0.0), 0.0),
    "pocket": Pocket((0.05, 0.0), 0.06),
}


@pytest.mark.parametrize("name", SHAPES)
def test_contacts_agree_with_fifty_digits(name):
    dice, thing = Random(7), SHAPES[name].shape
    rolls = []
    while len(rolls) < 150:
        p, miss, a = (complex(dice.gauss(0, 1), dice.gauss(0, 1)) for _ in range(3))
        p, v = 0.4 * p, 0.2 * miss - p
        if obstacle.clearance(thing, p, R) > 1e-3:
            rolls.append((p, v, a, dice.uniform(0.1, 1.0)))
    found = 0
    for time, exact in fates(thing, rolls):
        assert (time == inf) == (exact == mpmath.inf)
        if time < inf:
            found += 1
            assert abs(time - exact) < 1e-12
    assert found > 10


def test_what_rises_out_of_a_circle_does_so_when_a_fine_march_says():
    dice = Random(3)
    for _ in range(100):
        q = 0.3 * complex(dice.uniform(-1, 1), dice.uniform(-1, 1))
        v, a = (complex(dice.gauss(0, 1), dice.gauss(0, 1)) for _ in range(2))
        time = contact.rise_time(q, v, a, 0.5, 2.0)
        march = np.linspace(0.0, 2.0, 20001)
        out = np.flatnonzero(abs(q + march * (v + 0.5 * march * a)) > 0.5)
        if len(out) and time < inf:
            assert time == pytest.approx(march[out[0]], abs=1.01e-4)
        else:
            assert (len(out) == 0) == (time == inf)


# -- tips, to the last digit


@pytest.mark.parametrize("reach", [1e-17, 1e-15, 1e-12, 1e-9])
def test_a_ball_rolled_at_a_tip_is_never_lost(reach):
    """The wall ends there, or bends: the ball comes to its end within rounding of the corner."""
    corner = (-1.0 + 0j, 0.0 + 0j, 0.3 - 0.4j)
    for sign in (-1.0, 1.0):
        for turn in range(24):
            along = complex(cos(turn), sin(turn))
            world = World(ICE, "rough", MIRROR)
            for p, q in pairwise(corner):
                world.add(Wall.segment(xy(p * along), xy(q * along)))
            at, v = (sign * reach + 0.5j) * along, -1j * along
            world.add(Ball("a", xy(at), xy(v), radius=R))
            world.run(2.0)
            assert 1 <= len(world.log) <= 2
            assert first(world).time == pytest.approx(0.5 - R, abs=1e-12)


def test_balls_pressed_along_a_wall_past_its_end_are_not_lost():
    for gap in (0.0, 1e-17, 1e-15, 1e-12):
        world = World(ICE, "rough", MIRROR)
        world.add(Wall.segment((-1.0, 0.0), (0.0, 0.0)))
        world.add(Ball("a", (-0.5, R + gap), (1.0, 0.0), radius=R))
        world.run(2.0)
        assert world.ball("a").position[0] == pytest.approx(1.5, abs=0.01)
        assert len(world.log) < 4


# -- in the air


def flying(thing, at, velocity, height, climb=0.0) -> World:
    world = World(Cloth(bounce=0.0), "rough", laws.RigidCushion(0.9, 0.1, 1.3))
    world.add(thing)
    ball = world.add(Ball("a", at, velocity, radius=R))
    ball.height, ball.climb = height, climb
    world.run()
    return world


def test_a_ball_that_comes_down_over_a_pocket_falls_in():
    fall = sqrt(2 * 0.1 / 9.80665)
    world = flying(Pocket((fall, 0.0), 0.06, "hole"), (0.0, 0.0), (1.0, 0.0), 0.1)
    assert [e.kind for e in world.log] == ["pocket"]
    assert world.ball("a").phase == "pocketed"


def test_a_ball_that_flies_over_a_pocket_goes_on():
    world = flying(Pocket((0.2, 0.0), 0.06, "hole"), (0.0, 0.0), (4.0, 0.0), 0.1)
    assert first(world).kind == "land"


def test_a_ball_passes_over_a_segment_from_the_table_and_is_off():
    world = flying(Wall.segment((0.3, -1.0), (0.3, 1.0), "rail"), (0.0, 0.0), (4.0, 0.0), 0.1)
    assert [(e.kind, e.wall) for e in world.log] == [("off", "rail")]
    low = flying(Wall.segment((0.3, -1.0), (0.3, 1.0), "rail"), (0.0, 0.0), (4.0, 0.0), 0.03)
    assert first(low).kind == "cushion"
    beside = flying(Wall.segment((0.3, 0.5), (0.3, 1.0), "rail"), (0.0, 0.0), (4.0, 0.0), 0.1)
    assert first(beside).kind == "land"


def test_a_low_ball_hits_a_post_and_a_high_one_passes_over():
    post = Post((0.3, 0.0), 0.02, "post")
    assert first(flying(post, (0.0, 0.0), (4.0, 0.0), 0.03)).wall == "post"
    assert first(flying(post, (0.0, 0.0), (4.0, 0.0), 0.15)).kind == "land"


# -- what is refused

REFUSED = {
    "segment of no length": (lambda: Wall.segment((1.0, 2.0), (1.0, 2.0)), "two points"),
    "segment nan": (lambda: Wall.segment((1.0, nan), (1.0, 2.0)), "Wall.segment p"),
    "segment text": (lambda: Wall.segment((1.0, 0.0), "ab"), "Wall.segment q"),
    "arc radius": (lambda: Wall.arc((0, 0), 0.0, 0, 90), "Arc.radius"),
    "arc of nothing": (lambda: Wall.arc((0, 0), 1.0, 90, 90), "after its start"),
    "arc too long": (lambda: Wall.arc((0, 0), 1.0, 0, 361), "after its start"),
    "arc nan": (lambda: Wall.arc((0, 0), 1.0, 0, nan), "Arc.end"),
    "post radius": (lambda: Post((0, 0), -1.0), "Post.radius"),
    "post inf": (lambda: Post((0, inf), 1.0), "Post.at"),
    "pocket radius": (lambda: Pocket((0, 0), 0.0), "Pocket.radius"),
    "pocket nan": (lambda: Pocket((nan, 0), 1.0), "Pocket.at"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_bad_obstacles_are_refused_by_name(name):
    make, message = REFUSED[name]
    with pytest.raises(ValueError, match=message):
        make()


def refused(world: World, thing, message: str) -> None:
    walls, layout = world.walls, world.layout()
    with pytest.raises(ValueError, match=message):
        world.add(thing)
    assert (world.walls, world.layout()) == (walls, layout)


def test_pockets_that_overlap_are_refused():
    world = pool()
    refused(world, Pocket((-0.9, -0.5), 0.08, "more"), "'more' and 'hole 0' overlap")


def test_lines_that_leave_no_room_or_not_the_room_that_was_meant_are_refused():
    world = scenes.carom()
    refused(world, Wall.line(1.0, 0.0, -9.0, "far"), "no place is inside")
    world = World()
    for a, b, d in ((0, 1, 0), (1, 0, 0), (-1, 0, 2), (0, -1, 2), (-1, 0, 1)):
        world.add(Wall.line(a, b, d, f"{a} {b} {d}"))
    refused(world, Wall.line(-1.0, -1.0, 0.5, "cut"), r"use Wall\.segment")


@pytest.mark.parametrize(
    ("thing", "message"),
    [
        (Post((0.1, 0.0), 0.1, "post"), "in the post 'post'"),
        (Pocket((0.1, 0.0), 0.11, "hole"), "in the pocket 'hole'"),
        (Wall.segment((0.0, 0.02), (1.0, 0.02), "rail"), "in the wall 'rail'"),
        (Wall.arc((0.0, 0.5), 0.5, 180.0, 360.0, "arc"), "in the wall 'arc'"),
    ],
)
def test_a_ball_in_an_obstacle_is_refused(thing, message):
    world = World()
    world.add(Ball("a", (0.0, 0.0), radius=R))
    world.add(thing)
    with pytest.raises(ValueError, match=message):
        world.plan()
