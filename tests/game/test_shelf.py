"""Set-ups in the window: taken from the shelf, saved, pasted, and placed by hand."""

import random
from itertools import product

import pygame
import pytest

from game.table import lineup
from game.ui.pages import shelf_view
from game.ui.pages.shelf import laid
from game.window import clipboard
from tests.support.players import an_app, assert_same_as_anew, click, places, press, write

R = 0.03275


def test_a_set_up_is_taken_from_the_shelf_by_keys_and_by_mouse():
    app = an_app()
    press(app, "f4", "right", "right", "return")
    assert laid(app.session, shot=False).balls == list(lineup.shelf())[2].lineup.balls
    press(app, "f4")
    layout = app.view.sight.layout
    click(app, shelf_view.tab_rects(layout)[1].center)
    click(app, shelf_view.card_rect(1, layout).center)
    assert app.session.table == "match"
    assert app.session.page == ""
    press(app, "f4", *["pagedown"] * (shelf_view.GROUPS.index("scenes") - 1), "return")
    assert app.session.table == "thesis_1"
    assert app.session.moving


def test_a_set_up_is_saved_by_name_and_loaded_again(tmp_path):
    app = an_app()
    app.view.pages["shelf"].library.path = tmp_path / "set-ups.json"
    press(app, "down", "f4")
    wanted = places(app.session)
    box = shelf_view.box_rect(app.view.sight.layout)
    click(app, box.center)
    write(app, "나의 공")
    press(app, "return")
    assert app.view.page.said == ("shelf.saved", "나의 공")
    press(app, "escape", "down")
    assert places(app.session) != wanted
    press(app, "f4", "return")
    assert places(app.session) == wanted


def test_a_line_is_copied_and_pasted_even_without_a_clipboard(monkeypatch):
    app = an_app()
    press(app, "f4", "ctrl+c")
    line = app.view.page.text
    assert line.startswith("danggu1 medium white=")
    wanted = places(app.session)
    press(app, "escape", "down", "f4")
    monkeypatch.setattr("game.window.clipboard.get", lambda: "")
    press(app, "ctrl+v")
    assert app.session.page == ""
    assert places(app.session) == wanted


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
    before = places(app.session)
    press(app, "f4", "tab")
    write(app, "danggu1 medium white=5,0")
    press(app, "return")
    assert app.view.page.said == ("line.outside", "white")
    assert app.session.page == "shelf"
    assert places(app.session) == before


def test_balls_are_placed_by_keys_alone_and_by_mouse_alone():
    app = an_app()
    white = app.session.world.ball("white").position
    press(app, "b", "right", "shift+up")
    found = app.session.world.ball("white").position
    assert found == pytest.approx((white[0] + 0.02, white[1] + 0.001))
    press(app, "tab")
    assert app.session.held_ball == "yellow"
    press(app, "return")
    assert not app.session.arranging
    press(app, "b")
    layout = app.view.sight.layout
    red = app.session.world.ball("red1").position
    to = (0.8, -0.3)
    click(app, layout.to_screen(*red), layout.to_screen(*to))
    assert app.session.world.ball("red1").position == pytest.approx(to, abs=1.5 / layout.scale)
    click(app, layout.shoot.center)
    assert not app.session.arranging
    assert_same_as_anew(app)


def test_a_ball_dragged_around_the_table_never_overlaps_anything():
    rng, app = random.Random(6), an_app(size=(640, 360))
    layout, balls = app.view.sight.layout, app.session.world.balls
    press(app, "b")
    for _ in range(40):
        start = layout.to_screen(*rng.choice(balls).position)
        click(app, start, (rng.randrange(960), rng.randrange(540)))
        for a, b in product(balls, balls):
            gap = abs(complex(*a.position) - complex(*b.position))
            assert a is b or gap >= 2 * R
        walls = app.session.world.walls
        assert min(w.distance(b.position) for w in walls for b in balls) >= R
