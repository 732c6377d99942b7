"""Zones and anchors lie on the cloth of the games that count in them, and nowhere else."""

import pytest

from game.session.action import Action
from game.ui.table import balklines
from tests.support.players import an_app, assert_same_as_anew
from tests.support.racked_games import playing


def edges(game):
    return balklines.edges(playing(game))


@pytest.mark.parametrize(
    ("game", "count"),
    [("straight-rail", 4), ("balkline-47/1", 12 + 24), ("balkline-47/2", 12 + 24),
     ("balkline-71/2", 7 + 18), ("three-cushion", 0), ("8-ball", 0)],
)  # fmt: skip
def test_each_edge_is_drawn_once_and_none_along_a_cushion(game, count):
    assert len(edges(game)) == count


def test_the_lines_of_47_2_are_a_third_of_the_width_from_the_cushions():
    table = playing("balkline-47/2").world.table
    apart = 0.47 / 1.42 * table.width
    across = {round(p[0], 6) for p, q in edges("balkline-47/2") if p[0] == q[0]}
    assert round(table.length / 2 - apart, 6) in across
    assert round(apart - table.length / 2, 6) in across


def test_they_are_on_the_table_of_the_match_and_gone_on_the_next_one():
    app = an_app(size=(1280, 720), table="match")
    plain = app.view.stage.base.copy()
    app.perform(Action("match", '{"game":"balkline-47/2","table":"match"}'))
    app.frame(0)
    lined = app.view.stage.base
    assert lined.get_view("2").raw != plain.get_view("2").raw
    assert_same_as_anew(app)
    app.perform(Action("match", '{"game":"three-cushion","table":"match"}'))
    app.frame(0)
    assert app.view.stage.base.get_view("2").raw == plain.get_view("2").raw
