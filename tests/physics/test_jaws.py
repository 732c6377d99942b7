"""In the jaws of pockets: rattles, balls frozen on noses, balls that fly in; mirror images agree to
the bit."""

from itertools import product
from math import sqrt

import numpy as np
import pytest

from physics import Ball, Cloth, Post, Shot, Wall, World, laws, simulate, simulate_many, tables
from tests.support.any_shape import ICE, MIRROR, R
from tests.support.batches import same

X, Y = 1.27, 0.635
SIGNS = ((1, 1), (-1, 1), (1, -1), (-1, -1))
SIDE = 0.5 * 5.0625 * 0.0254  # m: half the mouth at the side


def outcome(sx: int, sy: int, at, velocity, spin=(0.0, 0.0, 0.0), cushion=None, name="pool_9ft"):
    """What happens to a ball on a table, told in the quarter where it is; mirrored by the signs."""
    world = getattr(tables, name)()
    if cushion is not None:
        world.cushion_law = cushion
    world.add(
        Ball("a", (sx * at[0], sy * at[1]), (sx * velocity[0], sy * velocity[1]),
             (sy * spin[0], sx * spin[1], sx * sy * spin[2]))
    )  # fmt: skip
    world.run()
    events = [(e.time, e.kind, sx * e.point[0], sy * e.point[1], e.closing) for e in world.log]
    x, y = world.ball("a").position
    return events, (sx * x, sy * y), world.ball("a").phase


def alike(*stroke, **kind):
    """The same in all four quarters, to the last bit; the one outcome."""
    first, *others = (outcome(*signs, *stroke, **kind) for signs in SIGNS)
    assert all(other == first for other in others)
    return first


# -- rattles


@pytest.mark.parametrize("name", ["pool_9ft", "snooker_12ft", "pyramid_12ft"])
def test_rattles_in_a_corner_are_mirror_images_in_all_four(name):
    hits, fates = 0, set()
    x, y = (0.5 * size for size in (getattr(tables, name)().table.length,
                                    getattr(tables, name)().table.width))  # fmt: skip
    for off, speed in product(np.linspace(-0.09, 0.09, 9).tolist(), (0.4, 3.0)):
        at = x - 0.35 + off, y - 0.35 - off
        events, _, phase = alike(at, (speed, speed), (-20.0, 10.0, 5.0), name=name)
        hits = max(hits, sum(kind == "cushion" for _, kind, *_ in events[:6]))
        fates.add(phase)
    assert hits > 1
    assert fates == {"pocketed", "resting"}


def test_a_ball_along_the_axis_of_a_pocket_goes_in_and_touches_nothing():
    events, _, phase = alike((0.9, 0.635 - 0.37), (2.0, 2.0))
    assert [kind for _, kind, *_ in events if kind not in ("roll",)] == ["pocket"]
    assert phase == "pocketed"


def corridor(gap: float) -> World:
    """Two facings, parallel and long, with nothing lost: a ball goes back and forth between."""
    world = World(ICE, "rough", MIRROR)
    world.add(Wall.segment((0.0, 0.0), (3.0, 0.0), "below"))
    world.add(Wall.segment((3.0, gap), (0.0, gap), "above"))
    return world


def test_between_parallel_facings_a_ball_rattles_at_the_times_of_a_reflected_line():
    gap, up, along = 5.0 * R, 0.7, 0.3
    world = corridor(gap)
    world.add(Ball("a", (0.2, R), (along, up), radius=R))
    world.run(8.0)
    hits = [event for event in world.log if event.kind == "cushion"]
    assert len(hits) == int(8.0 * up / (gap - 2.0 * R))
    for k, hit in enumerate(hits, start=1):
        assert hit.time == pytest.approx(k * (gap - 2.0 * R) / up, rel=1e-13)
        assert hit.point[0] == pytest.approx(0.2 + along * hit.time, rel=1e-13)
        assert hit.wall == ("above", "below")[(k - 1) % 2]


@pytest.mark.parametrize("room", [0.0, 1e-15, 1e-12, 1e-4, 1e-3])
def test_a_ball_that_just_fits_between_facings_ends_and_stays_between_them(room):
    for up in (0.0, 1e-9, 1e-3, 1.0):
        world = corridor(2.0 * R + room)
        world.cloth, world.cushion_law = Cloth(), "rigid"
        world.add(Ball("a", (0.2, R), (1.0, up), radius=R))
        world.run()
        assert world.at_rest
        assert len(world.log) < 2000
        x, y = world.ball("a").position
        assert R - 1e-12 <= y <= R + room + 1e-12 or x > 3.0


# -- frozen on a nose


def nose(sx: int, turn: float) -> tuple[float, float]:
    """Where a ball touches the point of a side pocket, so many radii of it past the rail's end."""
    return sx * (SIDE - R * turn), Y - R * sqrt(1.0 - turn * turn)


@pytest.mark.parametrize("turn", [0.0, 1e-9, 0.1, 0.5, 0.9])
def test_a_ball_frozen_on_a_nose_leaves_it_alike_in_all_quarters(turn):
    for v, spin in product(((0.0, 1.0), (1.0, 0.0), (-1e-9, 1e-9), (0.0, -1.0), (-3.0, 2.0)),
                           ((0.0, 0.0, 0.0), (-60.0, 30.0, 10.0))):  # fmt: skip
        alike(nose(1, turn), v, spin)


def test_a_ball_frozen_on_a_nose_and_pushed_at_it_bounces_off_along_their_line():
    """By a mirror: the speed turns about the line from the point to its centre."""
    x, y = nose(1, 0.6)
    world = tables.pool_9ft()
    world.cloth, world.cushion_law = ICE, MIRROR
    world.add(Ball("a", (x, y), (0.3, 1.0), radius=R))
    world.run(0.01)
    (hit,) = world.log
    n, v = complex(-0.6, -0.8), complex(0.3, 1.0)
    after = v - 2.0 * (n.conjugate() * v).real * n
    assert hit.time == pytest.approx(0.0, abs=1e-14)
    assert hit.after[0].velocity == pytest.approx((after.real, after.imag), abs=1e-12)
    assert hit.point == pytest.approx((SIDE, Y), abs=1e-14)


def test_a_ball_driven_into_a_mouth_too_narrow_for_it_comes_to_rest_before_it():
    """Two points less than a ball apart; two contacts at one instant are taken in their order, so
    it may turn a little."""
    world = World(None, laws.SmoothBall(), laws.RigidCushion(0.5, 0.2, nose=1.2))
    for x in (-0.8 * R, 0.8 * R):
        world.add(Post((x, 0.0), 0.0))
    world.add(Ball("a", (0.0, 0.6 * R), radius=R))
    for speed in (1e-6, 0.1, 3.0):
        after = simulate(world, "a", Shot(speed, 270.0))
        assert after.at_rest
        assert after.ball("a").position[1] > 0.6 * R - 1e-12
        assert len(after.log) < 500


# -- in the air


def test_a_ball_that_flies_over_a_pocket_is_off_behind_it_and_a_low_one_drops():
    for sx, sy in SIGNS:
        ends = []
        for climb in (0.6, 1.5):
            world = tables.pool_9ft()
            world.add(Ball("a", (sx * 0.9, sy * (Y - 0.37)), (sx * 2.5, sy * 2.5)))
            world.ball("a").climb = climb
            world.run()
            ends.append(world.ball("a").phase)
        assert ends == ["pocketed", "off"]


def test_a_ball_in_the_air_at_the_end_of_a_facing_is_hit_by_its_nose_or_by_its_point_once():
    """High up it is nearer to the nose than it can be on the cloth, and so within the point's
    reach where there is a nose yet."""
    for x in np.linspace(-2.0 * R, 0.5 * R, 11).tolist():
        for climb in (0.0, 0.5, 1.0, 1.5):
            world = tables.pool_9ft()
            world.add(Ball("a", (SIDE + x - 0.05, Y - 0.1), (0.5, 2.0)))
            world.ball("a").height, world.ball("a").climb = 0.012, climb
            world.run()
            assert len(world.log) < 200


# -- both kernels


@pytest.mark.parametrize("name", ["pool_9ft", "pool_7ft", "snooker_12ft", "pyramid_12ft"])
def test_both_kernels_agree_on_shots_into_the_jaws(name):
    pytest.importorskip("numba")
    world = getattr(tables, name)()
    x, y = 0.5 * world.table.length, 0.5 * world.table.width
    world.add(Ball("a", (x - 0.3, y - 0.25)))
    world.add(Ball("b", (x - 0.1, y - 0.1)))
    world.add(Ball("c", (0.05, y - 0.1)))
    dice = np.random.default_rng(3)
    low, high = (0.3, 0.0, -4.0, -1.0, -2.0, 0.0), (8.0, 90.0, 4.0, 1.0, 2.0, 1.0)
    shots = dice.uniform(low, high, (60, 6))
    shots[::2, 5] = 0.0
    plain, fast = (simulate_many(world, "a", shots, compiled=c) for c in (False, True))
    assert same(plain, fast)
