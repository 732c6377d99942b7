"""Tables of any shape: no ball is lost, and all that plays shots knows them."""

from collections import Counter
from itertools import product
from math import cos, hypot, pi, sin
from random import Random

import numpy as np
import pytest

from benchmarks import pool_shots as pool_table
from benchmarks.skips import go, planned, run
from benchmarks.switches import POCKETS, count, fresh
from danggu.rules.stroke import stroke
from physics import (
    Ball,
    Cloth,
    Pocket,
    Post,
    Shot,
    TimeStepping,
    Wall,
    World,
    laws,
    sensitivity,
    simulate,
    simulate_many,
    store,
    tables,
)
from tests.support import fifty
from tests.support.any_shape import CORNERS, ICE, MIRROR, R, box, polygon, pool
from tests.support.batches import same

# -- tables that are not convex

ELL = (0j, 2 + 0j, 2 + 1j, 1 + 1j, 1 + 2j, 2j)


def concave(dice: Random) -> World:
    """A star-shaped table with reentrant corners, with posts and a pocket in it."""
    n = dice.randrange(5, 9)
    corners = [
        dice.uniform(0.6, 1.3) * complex(cos(2 * pi * k / n), sin(2 * pi * k / n)) for k in range(n)
    ]
    law = dice.choice(("rigid", laws.RigidCushion(0.95, 0.1, 1.0), MIRROR))
    world = polygon(World(Cloth(), "rough", law), corners)
    world.add(Post((0.1, 0.05), 0.03, "post"))
    if dice.random() < 0.5:
        world.add(Pocket((-0.15, -0.1), 0.05, "hole"))
    return world


def within(corners, p: complex) -> bool:
    """Is the point in the polygon?"""
    inside, n = False, len(corners)
    for k in range(n):
        a, b = corners[k], corners[(k + 1) % n]
        if (a.imag > p.imag) != (b.imag > p.imag):
            x = a.real + (p.imag - a.imag) / (b.imag - a.imag) * (b.real - a.real)
            inside ^= p.real < x
    return inside


def check_kept(world: World, corners) -> None:
    """At every event, every ball is on the table and in nothing."""
    for event in world.log:
        for name, state in world.log.at(event.time).items():
            p = complex(*state.position)
            assert within(corners, p), (name, event)
            for wall in world.walls:
                if wall.pushes:
                    assert wall.distance(state.position) > world.ball(name).radius - 1e-9


@pytest.mark.parametrize("seed", range(40))
def test_no_ball_escapes_from_a_concave_table(seed):
    dice = Random(seed)
    world = concave(dice)
    corners = [complex(*wall.p) for wall in world.walls if wall.kind == "segment"]
    world.add(Ball("a", (0.25, 0.1), radius=R))
    world.add(Ball("b", (-0.1, 0.2), radius=R))
    world.add(Ball("c", (0.0, -0.25), radius=R))
    after = simulate(world, "a", Shot(dice.uniform(0.5, 6.0), dice.uniform(0, 360), side=1.0))
    check_kept(after, corners)
    assert after.at_rest


def ell() -> World:
    """Six balls on a table with a corner that points inward, one on its way."""
    world = polygon(World(Cloth(roll=0.002), "rough", laws.RigidCushion(0.95, 0.1, 1.0)), ELL)
    for k in range(6):
        world.add(Ball(f"{k}", (0.2 + 0.3 * k, 0.3), radius=R))
    world.strike("0", Shot(9.0, 45.0))
    return world


def stadium() -> World:
    """Two straight walls and two half circles; cloth, so that the ball stops."""
    world = World(Cloth(), "rough", MIRROR)
    world.add(Wall.segment((-0.5, -0.5), (0.5, -0.5), "south"))
    world.add(Wall.arc((0.5, 0.0), 0.5, -90.0, 90.0, "east"))
    world.add(Wall.segment((0.5, 0.5), (-0.5, 0.5), "north"))
    world.add(Wall.arc((-0.5, 0.0), 0.5, 90.0, 270.0, "west"))
    world.add(Ball("a", (0.1, 0.05), (4.0, 2.7), radius=R))
    return world


def test_an_ell_keeps_its_balls():
    world = ell()
    world.run()
    check_kept(world, ELL)
    assert {e.wall for e in world.log if e.kind == "cushion"} >= {"c", "d"}


def test_a_stadium_keeps_its_ball():
    world = stadium()
    world.cloth = ICE
    world.run(100.0)
    for event in world.log:
        x, y = event.after[0].position
        assert hypot(max(0.0, abs(x) - 0.5), y) < 0.5 - R + 1e-12
    assert len(world.log) > 300


def test_a_mirrored_table_has_mirrored_outcomes_to_the_last_bit():
    for seed in range(12):
        dice = Random(seed)
        shapes = [(dice.uniform(-0.8, 0.8), dice.uniform(-0.4, 0.4)) for _ in range(4)]
        angle = 7.5 + 15.0 * seed
        ends = []
        for sign in (1.0, -1.0):
            world = box()
            if sign < 0:
                world = polygon(World(), [p.conjugate() for p in CORNERS[::-1]],
                                ("south", "east", "north", "west"))  # fmt: skip
            for k, (x, y) in enumerate(shapes):
                if hypot(x, y) > 0.3:
                    world.add(Post((x, sign * y), 0.02 * (k + 1)))
            world.add(Ball("a", (0.0, 0.0), radius=R))
            after = simulate(world, "a", Shot(4.0, sign * angle, follow=1.0, side=sign * 2.0))
            ends.append([(e.time, e.kind, e.point[0], sign * e.point[1]) for e in after.log])
        assert ends[0] == ends[1]


# -- every other engine and use


def test_batches_know_pockets_and_both_kernels_agree():
    pytest.importorskip("numba")
    world = pool()
    shots = np.array([[5.0, angle, 1.0, 0.2, 1.0] for angle in range(0, 360, 3)], float)
    plain, fast = (simulate_many(world, "0", shots, compiled=c) for c in (False, True))
    assert same(plain, fast)
    lost = np.isnan(plain.positions[:, :, 0])
    assert 20 < lost.sum() < lost.size
    for k in (3, 50):
        after = simulate(world, "0", Shot(*shots[k]))
        for i, ball in enumerate(after.balls):
            assert lost[k, i] == (ball.phase == "pocketed")
            assert lost[k, i] or tuple(plain.positions[k, i]) == ball.position


def test_cells_change_no_bit_of_a_table_with_pockets(monkeypatch):
    shot = Shot(6.0, 45.0)
    plain = simulate(pool(), "0", shot)
    monkeypatch.setattr("physics.world.FEW", 1)
    celled = simulate(pool(), "0", shot)
    assert [tuple(e) for e in plain.log] == [tuple(e) for e in celled.log]
    assert any(e.kind == "pocket" for e in plain.log)


def test_fifty_digits_agree_on_a_table_of_all_shapes():
    world = box()
    world.add(Post((0.3, 0.1), 0.05))
    world.add(Wall.arc((0.0, 0.0), 0.45, 200.0, 250.0))
    world.add(Pocket((0.9, 0.4), 0.06))
    world.add(Ball("a", (-0.5, 0.2), radius=R))
    world.strike("a", Shot(2.5, 17.0))
    rest, events = fifty.rest(world)
    world.run()
    assert events == len(world.log)
    assert complex(*world.ball("a").position) == pytest.approx(complex(rest[0]), abs=1e-11)


@pytest.mark.parametrize("scheme", ["thesis", "euler", "rk4", "rk4-located", "literal"])
def test_fixed_steps_know_posts_segments_and_pockets(scheme):
    world = box(cloth=tables.THESIS.cloth)
    world.engine = TimeStepping(1 / 2000, scheme)
    world.add(Pocket((0.9, 0.0), 0.08, "hole"))
    world.add(Post((-0.6, 0.0), 0.05, "post"))
    world.add(Ball("a", (0.0, 0.0)))
    world.strike("a", Shot(1.5, 180.0))
    world.run(4.0)
    met = [e.wall for e in world.log if e.wall]
    assert met[0] == "post"
    if scheme != "literal":
        assert world.ball("a").phase in ("pocketed", "resting")
    world.ball("a").position = (0.5, 0.0)
    world.strike("a", Shot(1.5))
    world.run(world.time + 2.0)
    assert world.ball("a").phase == "pocketed"
    assert world.log[-1].kind == "pocket"


def test_a_pocketed_ball_can_be_put_back():
    world = World()
    world.add(Pocket((0.0, 0.0), 0.06, "hole"))
    ball = world.add(Ball("a", (0.0, 0.5), (0.0, -1.0), radius=R))
    world.run()
    with pytest.raises(ValueError, match="has left the table"):
        ball.velocity = (1.0, 0.0)
    ball.position = (0.4, 0.4)
    world.run()
    assert ball.phase == "resting"
    world.strike("a", Shot(2.0, 225.0))
    world.run()
    assert ball.phase == "pocketed"


def test_undo_brings_a_pocketed_ball_back():
    world = pool()
    layout = world.layout()
    world.strike("0", Shot(6.0, 45.0))
    world.run()
    down, then = [b.name for b in world.balls if b.phase == "pocketed"], world.layout()
    assert down
    world.recall(layout)
    world.run()
    assert all(ball.phase == "resting" for ball in world.balls)
    world.recall(then)
    world.run()
    assert [b.name for b in world.balls if b.phase == "pocketed"] == down


def test_a_saved_table_goes_on_as_it_was():
    world = pool()
    world.add(Wall.arc((0.0, 0.0), 0.4, 80.0, 100.0, "arc"))
    world.add(Post((0.0, -0.4), 0.01, "post"))
    world.strike("0", Shot(6.0, 225.0))
    for until in (0.3, 0.9, 2.0):
        world.run(until)
        again = store.loads(store.dumps(world))
        assert again.walls == world.walls
        assert [b.phase for b in again.balls] == [b.phase for b in world.balls]
        ahead = world.copy()
        ahead.run()
        again.run()
        assert again.layout() == ahead.layout()


def test_the_derivative_at_the_rim_is_that_of_two_shots():
    def outcome(angle: float):
        world = World(Cloth())
        world.add(Post((0.5, 0.12), 0.05, "post"))
        world.add(Pocket((0.2, -0.6), 0.1, "hole"))
        world.add(Ball("a", (0.0, 0.1), radius=R))
        return world, Shot(3.0, angle)

    world, shot = outcome(-3.2)
    found = sensitivity(world, "a", shot)
    kinds = [e.event.kind for e in found.events]
    assert kinds[-1] == "pocket"
    assert "cushion" in kinds
    step, ends = 1e-5, []
    for sign in (1, -1):
        world, shot = outcome(-3.2 + sign * step)
        ends.append(simulate(world, "a", shot).log[-1])
    rate = (ends[0].time - ends[1].time) / (2 * step)
    assert found.events[-1].time[1] == pytest.approx(rate, rel=1e-6)
    x = (ends[0].point[0] - ends[1].point[0]) / (2 * step)
    assert found.events[-1].before[0, 0, 1] == pytest.approx(x, rel=1e-6)


def test_balls_held_between_a_post_and_a_wall_come_to_rest():
    world = box()
    world.add(Post((0.0, -0.5 + 2.2 * R), 0.5 * R))
    world.add(Ball("a", (-3.0 * R, -0.5 + R), radius=R))
    world.add(Ball("b", (-0.5, -0.5 + R), radius=R))
    after = simulate(world, "b", Shot(5.0, 0.0))
    assert after.at_rest
    assert len(after.log) < 300


# -- what a leg asks for


@pytest.mark.parametrize("make", [pool_table.pool_shot, pool_table.pool_break, stadium, ell])
def test_the_frame_and_the_boxes_change_no_bit(make):
    """And with them few legs ask for what is not a long wall."""
    outcomes, asked = [], []
    for switch in (None, *POCKETS):
        package, work = fresh(), Counter()
        if switch:
            switch.off(package)
        count(package, work)
        outcomes.append(repr(run(package, make)))
        asked.append(work["obstacles met"])
    assert len(set(outcomes)) == 1
    assert asked[0] <= asked[1] <= 40 * work["legs planned"]
    assert asked[0] <= asked[2]


def test_a_leg_on_a_pool_table_asks_for_hardly_more_than_on_a_table_of_four_lines():
    work = Counter()
    package = fresh()
    count(package, work)
    for seed in range(20):
        world = pool_table.midgame(4, seed)
        world.strike("cue", Shot(3.0, 18.0 * seed, follow=1.0))
        go(package, planned(lambda world=world: world, package))
    assert work["obstacles met"] < 0.5 * work["legs planned"]


def test_the_frame_of_a_pool_table_is_its_four_sides():
    world = pool_table.midgame()
    world.plan()
    frame, walls, sides = list(world.scene.frame), world.walls, []
    while frame:
        sides.append(sorted(walls[k].name for k in frame[1 : frame[0] + 1]))
        del frame[: frame[0] + 1]
    assert sorted(map(len, sides)) == [1, 1, 2, 2]
    assert all(hypot(*walls[k].p) > 0.5 for side in sides for k in range(len(side)))


@pytest.mark.parametrize("gap", [0.0, 1e-17, 1e-15, 1e-12, 1e-9, 1e-5])
def test_balls_along_a_rail_past_a_mouth_change_no_bit_with_the_frame(gap):
    """Frozen to the rail, and at the points within rounding."""
    side, corner = 0.5 * pool_table.SIDE, pool_table.X - pool_table.CORNER * 0.5**0.5
    for x, back, angle in product((-side, corner), (0.2, 1e-3, 1e-6, 0.0), (0.0, 1e-9, -1e-9, -1)):
        outcomes = []
        for frame in (None, ()):
            world = pool_table.table()
            pool_table.put(world, "cue", x - back, -pool_table.Y + pool_table.RADIUS + gap)
            world.plan()
            if frame is not None:
                world.scene = world.scene._replace(frame=frame)
            after = simulate(world, "cue", Shot(1.5, angle, follow=1.0))
            outcomes.append([tuple(event) for event in after.log])
        assert outcomes[0] == outcomes[1]


def test_a_ball_that_leans_on_the_corner_of_two_walls_has_one_contact_there():
    """Pressed into a rail by spin, it crawls around the rail's end, which is the facing's too."""
    stopped = 0
    for along in (-3.0, -2.0, -1.0, -0.3):
        for speed in (0.02, 0.06, 0.1, 0.2, 0.3, 0.5):
            world = pool_table.table()
            x, y = 0.5 * pool_table.SIDE - along * R, -pool_table.Y + R + 1e-6
            world.add(Ball("a", (x, y), (-speed, -0.01), spin=(150.0, 0.0, 3.0), radius=R))
            world.run()
            stopped += world.ball("a").phase == "resting"
    assert stopped > 5


def test_the_rules_read_which_pocket_a_ball_fell_into():
    world = pool_table.table()
    pool_table.put(world, "cue", 0.0, 0.0)
    pool_table.put(world, "1", 0.0, 0.3)
    read = stroke(simulate(world, "cue", Shot(2.0, 90.0)).log.contacts(), "cue")
    assert read.pocketed[0].ball == "1"
    holes = {wall.name for wall in world.walls if not wall.pushes}
    assert {drop.pocket for drop in read.pocketed} <= holes


CUSHIONS = (None, laws.RigidCushion(0.95, 0.05, 1.2), laws.RigidCushion(0.6, 0.4, 1.29), MIRROR,
            laws.ThesisCushion())  # fmt: skip


def shots(count: int, seed: int):
    """Of all strengths, with follow, draw and side."""
    dice = np.random.default_rng(seed)
    low, high = (0.2, 0.0, -6.0, -2.0, -3.0), (9.0, 360.0, 6.0, 2.0, 3.0)
    return dice.uniform(low, high, (count, 5))


def check_none_is_lost(tables: int, count: int) -> None:
    """Every ball ends on the table, in the jaws or in a pocket, and no shot is refused."""
    for seed in range(tables):
        world = pool_table.midgame(1 + seed % 15, seed, CUSHIONS[seed % len(CUSHIONS)])
        rests = simulate_many(world, "cue", shots(count, seed), compiled=True).positions
        lies = ~np.isnan(rests[:, :, 0])
        assert (abs(rests[lies]) < (pool_table.X + 0.1, pool_table.Y + 0.1)).all()


def test_no_ball_leaves_a_pool_table():
    pytest.importorskip("numba")
    check_none_is_lost(15, 1000)


@pytest.mark.stress
def test_no_ball_leaves_a_pool_table_in_a_million_shots():
    pytest.importorskip("numba")
    check_none_is_lost(50, 20_000)
