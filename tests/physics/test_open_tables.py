"""Tables that do not close: a ball that rolls or flies out through a gap is off the table."""

import numpy as np
import pytest

from physics import (
    Ball,
    Pocket,
    Post,
    Shot,
    TimeStepping,
    Wall,
    World,
    sensitivity,
    simulate,
    simulate_many,
    store,
    tables,
)
from physics.kernel.elementary import direction
from tests.support import fifty
from tests.support.any_shape import pool
from tests.support.batches import same

SOUTH, WEST = ((-1.0, -0.5), (1.0, -0.5)), ((-1.0, 0.5), (-1.0, -0.5))
NORTH, EAST = ((1.0, 0.5), (-1.0, 0.5)), ((1.0, -0.5), (1.0, 0.5))
LOWER, UPPER = ((1.0, -0.5), (1.0, -0.1)), ((1.0, 0.1), (1.0, 0.5))


def walled(*ends, more=()):
    """A world of these segments, and of more."""
    walls = [Wall.segment(p, q, f"wall {k}") for k, (p, q) in enumerate(ends)]
    return World(walls=[*walls, *more])


def door() -> World:
    """A table with a gap in its east wall, and a ball."""
    world = walled(SOUTH, LOWER, UPPER, NORTH, WEST)
    world.add(Ball("a", (0.0, 0.0)))
    return world


HALF = Wall.arc((0.0, 0.0), 0.5, 90.0, 270.0)
OPEN = {  # world, angle of a shot from the middle, how far the edge is in that direction
    "a gap in a wall": (door, 0.0, 1.0 + 0j),
    "three walls": (lambda: walled(SOUTH, NORTH, WEST), 0.0, 1.0 + 0j),
    "a lane": (lambda: walled(SOUTH, NORTH), 180.0, -1.0 + 0j),
    "walls the other way round": (
        lambda: walled(*((q, p) for p, q in (SOUTH, LOWER, UPPER, NORTH, WEST))), 0.0, 1.0 + 0j
    ),
    "a gap in a circle": (lambda: World(walls=[Wall.arc((0, 0), 0.5, 120.0, 60.0 + 360.0)]), 90.0,
                          0.25j * np.sqrt(3.0)),
    "half a circle": (lambda: World(walls=[HALF]), 0.0, 0j),
    "a gap between a wall and a half circle": (
        lambda: walled(((0.0, -0.5), (0.5, -0.5)), ((0.5, 0.5), (0.0, 0.5)), more=[HALF]), 0.0,
        0.5 + 0j,
    ),
    "with posts, pockets and a wall inside": (
        lambda: walled(SOUTH, LOWER, UPPER, NORTH, WEST, ((0.2, 0.2), (0.4, 0.3)),
                       more=[Post((0.0, 0.3), 0.05), Pocket((-0.5, -0.3), 0.06, "hole")]),
        0.0, 1.0 + 0j,
    ),
}  # fmt: skip

CLOSED = {
    "no walls": World,
    "a post": lambda: World(walls=[Post((0.0, 0.0), 0.1)]),
    "two posts": lambda: World(walls=[Post((0.0, 0.0), 0.1), Post((1.0, 0.0), 0.1)]),
    "one wall": lambda: walled(SOUTH),
    "one wall in two pieces": lambda: walled(((0, 0), (1, 0)), ((2, 0), (3, 0))),
    "a corner": lambda: walled(SOUTH, WEST),
    "a quarter of a circle": lambda: World(walls=[Wall.arc((0, 0), 0.5, 0.0, 90.0)]),
    "four walls": lambda: walled(SOUTH, EAST, NORTH, WEST),
    "a side in two pieces": lambda: walled(SOUTH, ((1.0, -0.5), (1.0, 0.1)), UPPER, NORTH, WEST),
    "a circle": lambda: World(walls=[Wall.arc((0.3, 0.1), 0.5, 10.0, 370.0)]),
    "a stadium": lambda: walled(
        ((0.0, -0.5), (0.7, -0.5)), ((0.7, 0.5), (0.0, 0.5)),
        more=[HALF, Wall.arc((0.7, 0.0), 0.5, -90.0, 90.0)],
    ),
    "four walls and pockets in them": pool,
    "lines, with walls in the middle": lambda: World(
        walls=[*(wall for wall in tables.match_carom().walls), Wall.segment((0, 0), (0.2, 0)),
               Wall.segment((0, 0.2), (0.2, 0.2))]),
    "a pool table": tables.pool_9ft,
    "a snooker table": tables.snooker_12ft,
}  # fmt: skip


@pytest.mark.parametrize("case", OPEN)
def test_a_ball_that_rolls_out_through_a_gap_is_off(case):
    make, angle, edge = OPEN[case]
    world = make()
    if not world.balls:
        world.add(Ball("a", (-0.1, 0.0)))
    before = world.energy
    world.strike("a", Shot(3.0, angle))
    world.run()
    event = world.log[-1]
    assert (event.kind, event.wall, world.ball("a").phase) == ("off", None, "off")
    ahead = direction(angle).conjugate() * (complex(*event.point) - edge)
    assert ahead.real == pytest.approx(0.0, abs=1e-12)
    assert before == world.energy == 0.0


@pytest.mark.parametrize("case", CLOSED)
def test_a_table_that_closes_has_no_openings_nor_has_what_is_no_table(case):
    world = CLOSED[case]()
    world.add(Ball("a", (0.05, 0.1) if "post" not in case else (0.5, 0.5)))
    world.plan()
    assert world.scene.openings == ()


def test_a_ball_from_outside_rolls_in_and_out_on_the_other_side():
    world = walled(SOUTH, NORTH)
    ball = world.add(Ball("a", (2.0, 0.0)))
    world.strike(ball, Shot(4.0, 180.0))
    world.run()
    assert world.log[-1].kind == "off"
    assert ball.position[0] == pytest.approx(-1.0)


def test_a_ball_outside_rolls_on_over_the_cloth():
    world = door()
    world.ball("a").position = (1.5, 0.0)
    world.strike("a", Shot(2.0, 20.0))
    world.run()
    assert world.ball("a").phase == "resting"
    assert world.ball("a").position[0] > 2.0


def test_a_ball_that_flies_out_is_off_and_one_that_lands_before_rolls_on():
    ends = []
    for x, climb in ((0.9, 2.0), (-0.9, 0.5)):
        world = door()
        world.ball("a").position = (x, 0.0)
        world.strike("a", Shot(2.0 if x > 0 else 0.5, 0.0, climb=climb))
        world.run()
        ends.append((world.ball("a").phase, "land" in {event.kind for event in world.log}))
    assert ends == [("off", False), ("resting", True)]


def test_an_off_ball_can_be_put_back_and_a_wall_in_the_gap_closes_the_table():
    world = door()
    world.strike("a", Shot(3.0))
    world.run()
    world.ball("a").position = (0.0, 0.0)
    world.add(Wall.segment((1.0, -0.1), (1.0, 0.1), "plug"))
    world.strike("a", Shot(3.0))
    world.run()
    assert world.ball("a").phase == "resting"
    assert world.log.first("cushion", "plug")
    assert world.scene.openings == ()


def test_batches_know_openings_and_both_kernels_agree():
    pytest.importorskip("numba")
    world = door()
    world.add(Ball("b", (0.5, 0.05)))
    shots = np.array([[3.0, 3.0 * angle, 1.0, 0.2, 1.0, 0.4 * (angle % 4)] for angle in range(120)])
    plain, fast = (simulate_many(world, "a", shots, compiled=c, contacts=40) for c in (False, True))
    assert same(plain, fast)
    gone = np.isnan(plain.positions[:, :, 0])
    assert 5 < gone.sum() < gone.size
    for shot in range(0, 120, 7):
        after = simulate(world, "a", Shot(*shots[shot]))
        log = [contact[:4] for contact in plain.log(shot)]
        assert log == [contact[:4] for contact in after.log.contacts()]
        assert [ball.phase == "off" for ball in after.balls] == gone[shot].tolist()


def test_cells_and_files_change_no_bit(monkeypatch):
    def story(world: World):
        return [(e.time, e.kind, e.balls, e.wall, e.point) for e in world.log]

    shot = Shot(3.0, 1.0)
    whole = simulate(door(), "a", shot)
    half = door()
    half.strike("a", shot)
    half.run(0.2)
    again = store.loads(store.dumps(half))
    again.run()
    assert again.ball("a").phase == "off"
    assert again.ball("a").position == whole.ball("a").position
    monkeypatch.setattr("physics.world.FEW", 0)
    assert story(simulate(door(), "a", shot)) == story(whole)


@pytest.mark.parametrize("scheme", ["thesis", "euler", "rk4", "rk4-located", "literal"])
def test_fixed_steps_know_openings(scheme):
    world = door()
    world.cloth = tables.THESIS.cloth
    world.engine = TimeStepping(1 / 1000, scheme)
    world.strike("a", Shot(3.0))
    world.run(2.0)
    assert (world.log[-1].kind, world.log[-1].wall) == ("off", None)
    assert world.ball("a").position[0] == pytest.approx(1.0, abs=0.01)


def test_fifty_digits_agree_where_it_leaves():
    world = door()
    world.strike("a", Shot(3.0, 2.0))
    rest, events = fifty.rest(world)
    world.run()
    assert events == len(world.log)
    assert complex(*world.ball("a").position) == pytest.approx(complex(rest[0]), abs=1e-13)


def test_when_it_leaves_depends_on_the_speed_as_differences_say():
    def leaves(speed: float) -> float:
        return simulate(door(), "a", Shot(speed, 2.0)).log[-1].time

    step = 1e-5
    [slope] = [
        event for event in sensitivity(door(), "a", Shot(3.0, 2.0)).events
        if event.event.kind == "off"
    ]  # fmt: skip
    wanted = (leaves(3.0 + step) - leaves(3.0 - step)) / (2.0 * step)
    assert slope.time[0] == pytest.approx(wanted, rel=1e-7)
