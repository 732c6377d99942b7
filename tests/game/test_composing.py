"""Syllables while they are composed, in the orders in which input methods send what they do."""

import json
from pathlib import Path

import pygame
import pytest

from game.ui.pages import menu_view, shelf_view
from tests.support.players import FRAME, an_app, assert_same_as_anew, click, pixels, press

CASES = json.loads((Path(__file__).parents[1] / "data" / "composing.json").read_text("utf-8"))
KINDS = {"edit": pygame.TEXTEDITING, "text": pygame.TEXTINPUT}


def what(case):
    return case["what"]


def send(app, kind, said):
    """One event as SDL sends it, without a frame."""
    if kind == "key":
        key = ord(said) if len(said) == 1 else getattr(pygame, f"K_{said.upper()}")
        app.handle(pygame.event.Event(pygame.KEYDOWN, key=key, mod=0, unicode=""))
    else:
        app.handle(pygame.event.Event(KINDS[kind], text=said, start=0, length=len(said)))


def to_row(app, name):
    """Open the menu at a row."""
    press(app, "f10")
    while app.view.page.row.name != name:
        press(app, "down")
    return app.view.page


def to_name(app):
    return to_row(app, "name")


def to_shelf(app):
    press(app, "f4", "tab")
    return app.view.page


def to_box(app):
    press(app, "right")
    return app.session.aim


FIELDS = {"name": to_name, "shelf": to_shelf, "box": to_box}


@pytest.mark.parametrize("frames", [False, True], ids=["in one frame", "a frame each"])
@pytest.mark.parametrize("case", CASES, ids=what)
def test_a_name_is_what_was_composed_whatever_came_first(case, frames):
    app = an_app(game="four-ball", lang="ko")
    menu = to_name(app)
    for kind, said in case["events"]:
        send(app, kind, said)
        if frames:
            app.frame(FRAME)
    assert menu.terms.seats[0].name == case["name"]
    assert app.session.page == "menu"
    assert (menu.row.name != "name") == case["left"]


@pytest.mark.parametrize("case", [case for case in CASES if not case["left"]], ids=what)
def test_a_set_up_has_the_name_that_was_composed(case):
    app = an_app(lang="ko")
    shelf = to_shelf(app)
    for kind, said in case["events"]:
        send(app, kind, said)
    assert shelf.text == case["name"]


def test_return_saves_the_set_up_with_its_last_syllable():
    app = an_app(lang="ko")
    shelf = to_shelf(app)
    for kind, said in (("edit", "나"), ("text", "나"), ("edit", "의"), ("key", "return")):
        send(app, kind, said)
    assert shelf.said == ("shelf.saved", "나의")
    send(app, "text", "의")
    assert list(shelf.library.items) == ["나의"]
    assert shelf.text == ""


@pytest.mark.parametrize("field", FIELDS)
@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1280, 720)])
def test_what_is_composed_is_shown_at_the_caret_of_every_field(field, size):
    app = an_app(size=size, lang="ko", game="four-ball")
    FIELDS[field](app)
    for kind, said in (("text", "12"), ("key", "left")):
        send(app, kind, said)
    app.frame(FRAME)
    before = pixels(app)
    send(app, "edit", "김")
    app.frame(FRAME)
    assert pixels(app) != before
    assert_same_as_anew(app)
    send(app, "edit", "")
    app.frame(FRAME)
    assert pixels(app) == before


def test_what_is_composed_in_a_box_is_kept_and_marked():
    app = an_app(lang="ko")
    to_box(app)
    for kind, said in (("text", "2"), ("edit", "ㅁ"), ("key", "5"), ("text", "5"), ("text", "ㅁ")):
        send(app, kind, said)
    assert app.session.aim.texts[0] == "2ㅁ5"
    assert [fault.box for fault in app.session.aim.shown_faults] == [0]


def test_a_click_elsewhere_keeps_the_syllable_where_it_was_composed(monkeypatch):
    app = an_app(size=(1280, 720), lang="ko", game="four-ball")
    menu, calls = to_name(app), []
    monkeypatch.setattr(pygame.key, "start_text_input", lambda: calls.append("start"))
    monkeypatch.setattr(pygame.key, "stop_text_input", lambda: calls.append("stop"))
    send(app, "edit", "김")
    names = [place for place, row in enumerate(menu.rows) if row.name == "name"]
    click(app, menu_view.row_rect(menu.rows, names[1], app.view.sight.layout).center)
    assert calls == ["stop", "start"]  # the input method has to be told to begin again
    send(app, "text", "김")
    send(app, "edit", "이")
    send(app, "text", "이")
    assert [seat.name for seat in menu.terms.seats] == ["김", "이"]


def test_where_nothing_is_typed_nothing_is_composed():
    app = an_app(lang="ko")
    before = pixels(app)
    send(app, "edit", "김")
    app.frame(FRAME)
    assert pixels(app) == before
    assert app.view.composition.text == ""


def test_what_is_composed_does_not_outlive_its_field():
    app = an_app(lang="ko", game="four-ball")
    to_name(app)
    send(app, "edit", "김")
    click(app, (2, 2))
    assert app.session.page == ""
    to_box(app)
    app.frame(FRAME)
    assert app.view.composition.text == ""


def test_a_name_of_sixteen_syllables_in_pieces_is_a_name_of_sixteen():
    app = an_app(game="four-ball")
    menu = to_name(app)
    for _ in range(16):
        send(app, "text", "\u1112\u1161\u11ab")
    assert menu.terms.seats[0].name == "한" * 16
    assert menu.refused == ""


def test_the_box_of_the_shelf_shows_its_place_when_it_is_clicked():
    app = an_app(size=(1280, 720))
    shelf = to_shelf(app)
    send(app, "text", "12345")
    window = shelf_view.text_window(app.view.sight)
    click(app, (window.x + app.view.sight.type.width("12", 13), window.centery))
    send(app, "text", "x")
    assert shelf.text == "12x345"
