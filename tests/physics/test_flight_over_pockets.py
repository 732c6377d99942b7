"""Balls in the air over the pockets and noses of a table: down, off, or back on the cloth."""

from random import Random

import numpy as np
import pytest

from physics import Ball, EventDriven, Shot, World, simulate_many, tables

TABLES = [tables.pool_9ft, tables.snooker_12ft, tables.pyramid_12ft]

ABOVE = {
    "the end of a rail": (
        tables.pool_9ft, (0.41575863579526917, 0.18102660800137865),
        (-4.29162833896763, 5.52182404880388), 0.7537237749902489,
    ),
    "the back of a snooker pocket": (
        tables.snooker_12ft, (-0.9262058126222282, 0.12140574988339618),
        (2.452678012541736, 2.2095578634022), 1.9726085481703666,
    ),
    "its other side": (
        tables.snooker_12ft, (1.352737430650098, 0.008876448951358713),
        (-2.9306997412152587, -2.089971650550837), 2.3487246579044814,
    ),
    "the back of a pyramid's pocket": (
        tables.pyramid_12ft, (1.054041698173706, 0.31607887868444223),
        (-2.252969695518752, -2.692296754206655), 2.3782183656286695,
    ),
}  # fmt: skip


def jump(world: World, dice: Random) -> Ball:
    """A ball on its way to a pocket, to come down somewhat before, in or beyond it."""
    table = world.table
    spot = complex(dice.uniform(-0.4, 0.4) * table.length, dice.uniform(-0.4, 0.4) * table.width)
    hole = dice.choice([thing.points[0] for thing in table.obstacles if thing.part == "hole"])
    way, speed = hole - spot, dice.uniform(2.0, 8.0)
    v, lasts = speed * way / abs(way), dice.uniform(0.9, 1.6) * abs(way) / speed
    ball = world.add(Ball("a", (spot.real, spot.imag), (v.real, v.imag)))
    ball.climb = 0.5 * world.cloth.gravity * lasts
    return ball


@pytest.mark.parametrize("make", TABLES, ids=lambda make: make.__name__)
def test_no_ball_comes_down_behind_a_cushion_or_beyond_a_hole(make):
    ends = set()
    for seed in range(80):
        world = make()
        world.engine = EventDriven(budget=2000)
        ball = jump(world, Random(seed))
        world.run()
        x, y = abs(ball.position[0]), abs(ball.position[1])
        ends.add(ball.phase)
        inside = x < 0.5 * world.table.length and y < 0.5 * world.table.width
        assert inside or ball.phase in ("off", "pocketed")
        if ball.phase == "off":
            last = world.log[-1]
            assert (last.kind, last.wall in {wall.name for wall in world.walls}) == ("off", True)
    assert ends == {"off", "pocketed", "resting"}


@pytest.mark.parametrize("case", ABOVE)
def test_a_ball_that_came_over_the_top_does_not_meet_the_side_of_what_it_is_above(case):
    """It was met at once, again and again, because it overlapped it."""
    make, at, velocity, climb = ABOVE[case]
    world = make()
    world.engine = EventDriven(budget=200)
    ball = world.add(Ball("a", at))
    ball.velocity, ball.climb = velocity, climb
    world.run()
    assert ball.phase in ("off", "resting", "pocketed")


def test_compiled_flights_agree_in_every_bit():
    pytest.importorskip("numba")
    world = tables.pool_9ft()
    world.add(Ball("a", (0.3, 0.1)))
    shots = [Shot(4.0, 8.0 * k, follow=1.0, side=0.5, climb=1.0 + 0.05 * k) for k in range(45)]
    here, there = (simulate_many(world, "a", shots, compiled=c) for c in (True, False))
    assert np.array_equal(here.positions, there.positions, equal_nan=True)
    assert np.array_equal(here.events, there.events)


CAME_DOWN_ON = [  # over a snooker table's noses: position, velocity, seconds until it lands
    ((1.8601464248541033, 1.0614812314591213), (-0.31453107256054225, -0.3960050342494982), 0.279),
    ((0.07433812507194712, -0.8516889875013784), (0.046915868714, -0.046676006259), 0.336539),
    ((1.9901766053386087, -1.0579820018073485), (-0.7405452056691701, 0.9255072227430058), 0.24848),
    ((-2.079963574532125, -0.7976740212646902), (0.603783456633482, -0.2446837151497105), 0.34124),
]


@pytest.mark.parametrize(("at", "velocity", "lasts"), CAME_DOWN_ON)
def test_a_ball_that_comes_down_on_a_nose_is_off(at, velocity, lasts):
    """It lay in it, and was pushed from one wall into another until the budget."""
    world = tables.snooker_12ft()
    world.engine = EventDriven(budget=300)
    ball = world.add(Ball("a", at, velocity))
    ball.climb = 0.5 * 9.81 * lasts
    world.run()
    assert ball.phase == "off"
    assert world.log[-1].wall in {wall.name for wall in world.walls}
