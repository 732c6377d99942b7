"""The drills of tables with pockets: on the table, apart, and their answers pot what they say."""

from itertools import combinations
from math import dist

import pytest

from danggu.players.drills import DRILLS, POOL, PYRAMID, SNOOKER
from danggu.players.levels import Attempt
from danggu.players.positions import Position
from physics import Ball, World, simulate, tables

TABLES = {POOL: tables.pool(9), SNOOKER: tables.SNOOKER_12FT, PYRAMID: tables.PYRAMID_12FT}
IDS = [f"{drill.game}-{drill.key}" for drill in DRILLS]


def laid(drill: Position) -> World:
    table = TABLES[drill.game]
    world = table.world()
    for name, at in drill.on(table.length, table.width).items():
        world.add(Ball(name, at))
    return world


def after(drill: Position) -> World:
    return simulate(laid(drill), drill.cue, Attempt(*drill.answer).shot())


def test_each_family_has_a_dozen_or_more_of_its_own():
    games = [drill.game for drill in DRILLS]
    assert all(games.count(game) >= 12 for game in TABLES)
    assert len({(drill.game, drill.key) for drill in DRILLS}) == len(DRILLS)


@pytest.mark.parametrize("drill", DRILLS, ids=IDS)
def test_balls_of_a_drill_lie_on_the_table_and_apart(drill):
    world = laid(drill)
    bed = world.table.regions["anywhere"]
    for one, other in combinations(world.balls, 2):
        assert dist(one.position, other.position) > 2 * one.radius
    assert all(bed.contains(ball.position) for ball in world.balls)


@pytest.mark.parametrize("drill", DRILLS, ids=IDS)
def test_the_answer_hits_what_it_says_first_and_pots_that_ball_in_that_pocket_alone(drill):
    first, ball, pocket = drill.way
    log = list(after(drill).log.contacts())
    met = next(event for event in log if event.kind == "ball" and drill.cue in event.balls)
    assert first in met.balls
    assert [(e.balls, e.wall) for e in log if e.kind == "pocket"] == [((ball,), pocket)]


def ends(key: str) -> tuple[float, float]:
    """How far the cue ball ends ahead of where the ball lay, and aside, m."""
    drill = next(one for one in DRILLS if (one.game, one.key) == (POOL, key))
    before = laid(drill)
    start, ball = (complex(*before.ball(name).position) for name in ("cue", "1"))
    along = (ball - start) / abs(ball - start)
    end = (complex(*after(drill).ball("cue").position) - ball) / along
    return end.real, end.imag


def test_stop_draw_and_follow_leave_the_cue_ball_where_their_names_say():
    assert abs(ends("stop")[0]) < 0.08
    assert ends("draw")[0] < -0.3
    assert ends("follow")[0] > 0.3
