"""Set-ups in the window: taken from the shelf, saved, pasted, and placed by hand."""

import random
from itertools import product

import pygame
import pytest

from game.table import lineup
from game.ui.pages import shelf_view
from game.window import clipboard
from tests.support.players import an_app, assert_same_as_anew, click, places, press, write

R = 0.03275


def test_a_set_up_is_taken_from_the_shelf_by_keys_and_by_mouse():
    app = an_app()
    press(app, "f4", "right", "right", "return")
    assert lineup.of(app.game).balls == list(lineup.shelf())[2].lineup.balls
    press(app, "f4")
    layout = app.view.sight.layout
    click(app, shelf_view.tab_rects(layout)[1].center)
    click(app, shelf_view.card_rect(1, layout).center)
    assert app.game.table == "match"
    assert app.game.sheet == ""
    press(app, "f4", "pagedown", "return")
    assert app.game.table == "thesis_1"
    assert app.game.moving


def test_a_set_up_is_saved_by_name_and_loaded_again(tmp_path):
    app = an_app()
    app.view.sheets["shelf"].library.path = tmp_path / "set-ups.json"
    press(app, "down", "f4")
    wanted = places(app.game)
    box = shelf_view.box_rect(app.view.sight.layout)
    click(app, box.center)
    write(app, "나의 공")
    press(app, "return")
    assert app.view.sheet.said == ("shelf.saved", "나의 공")
    press(app, "escape", "down")
    assert places(app.game) != wanted
    press(app, "f4", "return")
    assert places(app.game) == wanted


def test_a_line_is_copied_and_pasted_even_without_a_clipboard(monkeypatch):
    app = an_app()
    press(app, "f4", "ctrl+c")
    line = app.view.sheet.text
    assert line.startswith("danggu1 medium white=")
    wanted = places(app.game)
    press(app, "escape", "down", "f4")
    monkeypatch.setattr("game.window.clipboard.get", lambda: "")
    press(app, "ctrl+v")
    assert app.game.sheet == ""
    assert places(app.game) == wanted


def test_what_is_copied_can_be_pasted():
    an_app()
    assert clipboard.put("danggu1 사구")
    assert clipboard.get() == "danggu1 사구"


def test_without_any_clipboard_nothing_is_copied_and_nothing_breaks(monkeypatch):
    def none():
        raise pygame.error("no clipboard")

    for name in ("_scrap", "_sdl", "_ready"):
        monkeypatch.setattr(clipboard, name, none)
    assert not clipboard.put("x")
    assert clipboard.get() == ""


def test_a_broken_line_in_the_box_says_what_is_wrong_and_changes_nothing():
    app = an_app()
    before = places(app.game)
    press(app, "f4", "tab")
    write(app, "danggu1 medium white=5,0")
    press(app, "return")
    assert app.view.sheet.said == ("line.outside", "white")
    assert app.game.sheet == "shelf"
    assert places(app.game) == before


def test_balls_are_placed_by_keys_alone_and_by_mouse_alone():
    app = an_app()
    white = app.game.world.ball("white").position
    press(app, "b", "right", "shift+up")
    found = app.game.world.ball("white").position
    assert found == pytest.approx((white[0] + 0.02, white[1] + 0.001))
    press(app, "tab")
    assert app.game.held_ball == "yellow"
    press(app, "return")
    assert not app.game.arranging
    press(app, "b")
    layout = app.view.sight.layout
    red = app.game.world.ball("red1").position
    to = (0.8, -0.3)
    click(app, layout.to_screen(*red), layout.to_screen(*to))
    assert app.game.world.ball("red1").position == pytest.approx(to, abs=1.5 / layout.scale)
    click(app, layout.shoot.center)
    assert not app.game.arranging
    assert_same_as_anew(app)


def test_a_ball_dragged_around_the_table_never_overlaps_anything():
    rng, app = random.Random(6), an_app(size=(640, 360))
    layout, balls = app.view.sight.layout, app.game.world.balls
    press(app, "b")
    for _ in range(40):
        start = layout.to_screen(*rng.choice(balls).position)
        click(app, start, (rng.randrange(960), rng.randrange(540)))
        for a, b in product(balls, balls):
            gap = abs(complex(*a.position) - complex(*b.position))
            assert a is b or gap >= 2 * R
        walls = app.game.world.walls
        assert min(w.distance(b.position) for w in walls for b in balls) >= R
