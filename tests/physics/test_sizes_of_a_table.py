"""A ball without a size is one of its table's."""

import copy
import json
import pickle
from dataclasses import replace

import pytest

from physics import (
    Ball,
    EventBudgetError,
    EventDriven,
    Shot,
    World,
    simulate,
    store,
    tables,
)
from physics.tables.pocket_tables import PYRAMID_12FT, SNOOKER_12FT, pool

TABLES = [tables.THESIS, tables.MEDIUM_CAROM, tables.MATCH_CAROM]
ALL = [*TABLES, pool(9), SNOOKER_12FT, PYRAMID_12FT]


def named(table):
    return table.name


def standing(table, laws=tables.THESIS):
    """A world on the table, with no cushions."""
    return World(table.cloth, laws.ball_law, laws.cushion_law, table=table)


@pytest.mark.parametrize("table", TABLES, ids=named)
def test_a_ball_without_a_size_is_one_of_the_table_s(table):
    world = table.world()
    ball = world.add(Ball("white", at=(0.0, 0.0)))
    assert world.table is table
    assert (ball.radius, ball.mass) == (table.radius, table.mass)


@pytest.mark.parametrize("table", ALL, ids=named)
def test_what_is_given_of_a_size_stays(table):
    world = standing(table)
    heavy = world.add(Ball("heavy", at=(0.0, 0.0), mass=0.5))
    big = world.add(Ball("big", at=(0.5, 0.0), radius=0.04))
    assert (heavy.radius, heavy.mass) == (table.radius, 0.5)
    assert (big.radius, big.mass) == (0.04, table.mass)


def test_without_a_table_a_ball_is_what_it_was():
    ball = Ball("white", at=(0.0, 0.0))
    assert (ball.radius, ball.mass) == (0.03275, 0.25)
    World().add(ball)
    assert (ball.radius, ball.mass) == (0.03275, 0.25)


@pytest.mark.parametrize("later", [False, True])
def test_a_shot_on_the_match_table_needs_no_size_and_has_every_bit(later):
    """Also of a ball that had its spin before it had its radius."""
    ends = []
    for size in ({}, {"radius": 0.03075, "mass": 0.21}):
        world = tables.match_carom()
        spin = (11.0, -37.0, 53.0)
        white = Ball("white", (-0.9, 0.1), (1.0, 0.5), (0.0, 0.0, 0.0) if later else spin, **size)
        if later:
            white.spin = spin
        world.add(white)
        world.add(Ball("red", (0.5, 0.3), **size))
        assert white.spin == pytest.approx(spin, rel=1e-15)
        world.run()
        ends.append((list(world.log), [ball.placed for ball in world.balls]))
    assert ends[0] == ends[1]


def test_a_ball_that_was_made_to_roll_rolls_whatever_its_size_becomes():
    ball = Ball("white", at=(0.0, 0.0), velocity=(1.0, 0.5), spin=(0.0, 0.0, 7.0))
    ball.phase = "rolling"
    tables.match_carom().add(ball)
    assert ball.phase == "rolling"
    assert ball.spin[2] == pytest.approx(7.0, rel=1e-15)


def test_copies_forks_shots_files_and_other_processes_keep_the_table():
    world = replace(tables.MATCH_CAROM, length=2.7, mass=0.215).world()
    world.add(Ball("white", at=(0.0, 0.0)))
    for other in (
        world.copy(), world.fork(world.log), simulate(world, "white", Shot(1.0)),
        store.loads(store.dumps(world)), pickle.loads(pickle.dumps(world)),
    ):  # fmt: skip
        assert other.table == world.table
        red = other.add(Ball("red", at=(0.5, 0.3)))
        assert (red.radius, red.mass) == (0.03075, 0.215)


@pytest.mark.parametrize("table", ALL, ids=named)
def test_a_file_keeps_all_of_a_table_and_its_laws_when_the_world_has_others(table):
    world = World(table.cloth, "smooth", "mathavan", table=table, walls=table.world().walls)
    assert world.table == table  # what is assigned later would be its table's too
    loaded = store.loads(store.dumps(world))
    assert loaded.table == table
    assert loaded.table.obstacles == table.obstacles
    assert (loaded.ball_law, loaded.cushion_law) == (world.ball_law, world.cushion_law)


def test_a_world_without_a_table_and_a_file_from_before_tables_have_none():
    assert World().table is None
    assert store.loads(store.dumps(World())).table is None
    data = json.loads(store.dumps(tables.match_carom()))
    del data["table"]
    world = store.loads(json.dumps(data))
    assert world.table is None
    assert len(world.walls) == 4


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        ({"radius": -1.0}, r"table: Table\.radius must be above zero"),
        ({"kind": "bowls"}, r"table: Table\.kind must be one of carom, .* not 'bowls'"),
        ({"mass": "heavy"}, r"table\.mass must be a number"),
        ({"name": 3}, r"table\.name must be text"),
        ({"pockets": 3}, r"table\.pockets must be an object"),
        ({"pockets": {"corner": {"width": 1}}}, r"table\.pockets\.corner\.facing is missing"),
        ({"ball_law": {"name": "Law"}}, r"table\.ball_law\.name is 'Law'"),
    ],
)
def test_a_file_whose_table_is_none_says_where(spoil, message):
    data = json.loads(store.dumps(tables.match_carom()))
    data["table"].update(spoil)
    with pytest.raises(ValueError, match=message):
        store.loads(json.dumps(data))


def test_a_table_with_a_law_of_one_s_own_cannot_be_saved():
    world = World(
        table=replace(tables.MATCH_CAROM, ball_law=lambda v, roll, side, mass: (mass, 0j))
    )  # with laws of its own: what is assigned to a world is its table's too
    with pytest.raises(ValueError, match="the table's ball law"):
        store.dumps(world)


@pytest.mark.parametrize("thing", [5, "match", tables.Table, tables.match_carom, object()])
def test_what_is_no_table_is_refused(thing):
    with pytest.raises(ValueError, match="a world's table is a Table"):
        World(table=thing)
    with pytest.raises(AttributeError):
        tables.match_carom().table = thing


@pytest.mark.parametrize("again", [copy.deepcopy, lambda ball: pickle.loads(pickle.dumps(ball))])
def test_a_copy_of_a_ball_that_is_in_no_world_can_be_added_to_one(again):
    """A process that is sent a ball gets such a copy."""
    ball = again(Ball("white", at=(0.1, 0.2), spin=(1.0, 2.0, 3.0)))
    tables.match_carom().add(ball)
    assert (ball.radius, ball.mass) == (0.03075, 0.21)
    assert ball.spin == pytest.approx((1.0, 2.0, 3.0), rel=1e-15)
    with pytest.raises(ValueError, match="'white' is in a world already"):
        World().add(ball)
    with pytest.raises(ValueError, match="'white' is in a world already"):
        World().add(again(ball))


def test_a_table_takes_the_names_of_laws_and_no_cloth_as_a_world_does_and_can_be_saved():
    plain = replace(tables.MATCH_CAROM, cloth=None, ball_law="rough", cushion_law="rigid")
    world = World()
    assert (plain.cloth, plain.ball_law, plain.cushion_law) == (
        world.cloth, world.ball_law, world.cushion_law
    )  # fmt: skip
    assert store.loads(store.dumps(plain.world())).table == plain
    with pytest.raises(ValueError, match="unknown ball law 'soft'"):
        replace(plain, ball_law="soft")
    with pytest.raises(ValueError, match="a world's cloth is a Cloth, not 3"):
        replace(plain, cloth=3)


class Sizes:
    """What knows the size of balls, and is no Table."""

    radius, mass = 0.02, 0.1


def test_a_world_on_a_custom_table_cannot_be_saved_and_says_so():
    world = World(table=Sizes())
    world.add(Ball("white", at=(0.0, 0.0)))
    with pytest.raises(ValueError, match=r"the table .*Sizes.* is a custom one"):
        store.dumps(world)


def test_a_world_on_a_custom_table_that_makes_too_many_events_says_how_it_stood():
    world = World(table=Sizes(), engine=EventDriven(budget=1))
    white = world.add(Ball("white", at=(0.0, 0.0)))
    with pytest.raises(EventBudgetError) as error:
        simulate(world, white, Shot(speed=3.0, angle=0.0))
    assert "Sizes" in error.value.scene["table"]["name"]
