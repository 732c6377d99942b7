"""Numbers at the diamonds are computed by the engine for the table at hand."""

from cmath import phase
from math import degrees

import pytest

from game.aim import diamonds
from game.aim.diamonds import FIVE, DiamondStroke
from game.input.captions import words
from game.render import layout
from game.render.table.rails import diamond_places
from game.session.action import Action
from game.table.presets import table_world
from physics import Shot, simulate
from tests.support.players import FRAME, an_app, assert_same_as_anew, press

RAILS = ("north", "south", "west", "east")
PLAIN = DiamondStroke(3.5, 0.5, 0.0, 0.0)


@pytest.mark.parametrize("rail", RAILS)
@pytest.mark.parametrize("table", ["medium", "match"])
def test_a_diamonds_number_is_where_the_engine_has_the_third_cushion(table, rail):
    world = table_world(table)
    for name in [ball.name for ball in world.balls][1:]:
        world.ball(name).position = (world.ball(name).position[0], 0.55)
    alone = table_world(table)
    lies = alone.ball("white").position
    for k, name in enumerate([ball.name for ball in alone.balls][1:]):
        alone.ball(name).position = (1.0 + 0.1 * k, -0.6)
    found = diamonds.fan(world, "white", rail, PLAIN).sights
    assert sum(bool(sight.rail) for sight in found) >= len(found) - 2
    assert len(found) == (9 if rail in ("north", "south") else 5)
    for sight in found:
        way = complex(*sight.at) - complex(*lies)
        shot = Shot(3.5, degrees(phase(way)), follow=0.5)
        met = simulate(alone, "white", shot).log
        ours = [e for e in met if e.kind in ("ball", "cushion") and "white" in e.balls]
        if sight.rail and [e.kind for e in ours[:3]] == ["cushion"] * 3:
            assert (ours[2].wall, ours[2].after[0].position) == (sight.rail, sight.third)


def test_the_diamonds_are_those_that_are_drawn():
    where = layout.Layout((1280, 720), 2.54, 1.27)
    drawn = {(round(x, 6), round(y, 6)) for x, y, _ in diamond_places(where)}
    world = table_world("medium")
    length, width = world.table.length, world.table.width
    where = layout.Layout((1280, 720), length, width)
    drawn = {(round(x, 6), round(y, 6)) for x, y, _ in diamond_places(where)}
    sights = [s for rail in RAILS for s in diamonds.sights(world, rail)]
    inner = [s for s in sights if abs(s.at[0]) < length / 2 - 1e-9 or abs(s.at[1]) < width / 2]
    inner = [s for s in inner if s.number not in (0, 8 if abs(s.at[1]) > width / 2 else 4)]
    assert {(round(s.at[0], 6), round(s.at[1], 6)) for s in inner} == drawn


@pytest.mark.parametrize("table", ["medium", "match"])
def test_from_the_corner_the_system_has_about_fifty_as_players_know_it(table):
    """The engine's own numbers: a corner-5 player counts 50 from the corner."""
    world = table_world(table)
    world.ball("white").position = (0.1 - world.table.length / 2, 0.1 - world.table.width / 2)
    start, off = diamonds.fan(world, "white", "north", FIVE).start(right=True)
    assert start == pytest.approx(50.0, abs=4.0)
    assert off < 10.0


def test_a_table_reflected_has_the_same_numbers():
    world, other = table_world("match"), table_world("match")
    world.ball("white").position, other.ball("white").position = (-0.5, -0.4), (0.5, 0.4)
    north = diamonds.fan(world, "white", "north", FIVE).sights
    south = diamonds.fan(other, "white", "south", FIVE).sights
    for one, two in zip(north, reversed(south), strict=True):
        assert (one.first, one.right) == (two.first, two.right)
        assert one.last == (two.last if two.last is None else pytest.approx(two.last, abs=1e-6))


def test_pockets_take_the_place_of_diamonds():
    assert [s.number for s in diamonds.sights(table_world("pool-9"), "north")] == [
        1, 2, 3, 5, 6, 7
    ]  # fmt: skip


@pytest.mark.parametrize("angle", [0.0, 45.0, 90.0, 135.0, 200.0, -60.0])
def test_the_rail_that_is_aimed_at_is_the_first_that_is_met(angle):
    world = table_world("medium")
    for name in ("yellow", "red1", "red2"):
        world.ball(name).position = (-1.2, {"yellow": 0.5, "red1": 0.4, "red2": 0.3}[name])
    log = simulate(world, "white", Shot(3.0, angle)).log
    first = next(e for e in log if e.kind in ("ball", "cushion"))
    if first.kind == "cushion":
        assert diamonds.aimed_at(world, "white", angle) == first.wall


@pytest.mark.parametrize("language", ["en", "ko"])
@pytest.mark.parametrize("size", [(640, 360), (1280, 720)])
def test_a_key_shows_the_stroke_in_the_boxes_then_the_corner_system_then_none(size, language):
    app = an_app(size, lang=language)
    w, said = words(language), []
    for _ in range(3):
        press(app, "d")
        app.frame(FRAME)
        assert_same_as_anew(app)
        said.append(app.view.stage.diamonds.words(app.session, w))
    assert said[0] == w["diamonds.own"]
    assert "±" in said[1] or said[1] == w["diamonds.five.none"]
    assert said[2] == ""


def test_the_numbers_are_computed_again_only_when_they_may_have_changed(monkeypatch):
    app, made = an_app(), []
    fan = diamonds.fan
    monkeypatch.setattr(diamonds, "fan", lambda *how: made.append(how) or fan(*how))
    press(app, "d")
    assert len(made) == 1
    press(app, "q", "w", "a")
    assert len(made) == 1
    app.perform(Action("power", "2"))
    app.frame(FRAME)
    assert len(made) == 2


def test_what_the_numbers_are_waits_until_a_toast_on_the_same_rail_has_gone():
    app = an_app()
    app.view.toast.say("toast.retry")
    press(app, "d")
    app.frame(0)
    assert [card.key[0] for card in app.view.stage.over.cards] == ["toast"]
    app.view.toast.left = 0.0
    app.frame(FRAME)
    assert [card.key[0] for card in app.view.stage.over.cards] == ["diamonds"]
