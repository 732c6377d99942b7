"""What ends a running match is asked for first, and "no" leaves everything as it was."""

import pygame
import pytest
from matches import menu_button, opening_numbers
from players import FRAME, an_app, assert_same_as_anew, click, enter, pixels, places, press, write

from game.text import LANGUAGES, words
from game.ui import question, sheetview, shelfview
from game.ui.choices import ROWS

TABLE = next(i for i, row in enumerate(ROWS) if row.name == "table")


def to_another_table(app):
    press(app, "f3", *["down"] * (TABLE - app.view.sheets["settings"].focus), "right")


def answer(app, name):
    rect = question.answers(app.view.sight.layout)[question.ANSWERS.index(name)]
    click(app, rect.center)


@pytest.fixture
def app():
    """A match in which a point has been made."""
    app = an_app(game="four-ball", handicap="5")
    enter(app, *opening_numbers())
    press(app, "return", "end", "return")
    assert app.game.contest.match.sheets[0].score == 1
    return app


def everything(app):
    game = app.game
    return game.contest.match, places(game), game.aim.texts[:], game.table, len(game.history.past)


NO = {
    "escape": lambda app: press(app, "escape"),
    "return": lambda app: press(app, "return"),
    "there and back": lambda app: press(app, "right", "left", "space"),
    "the button": lambda app: answer(app, "keep"),
    "beside it": lambda app: click(app, question.box(app.view.sight.layout).move(-9, 0).midleft),
}
YES = {
    "right and return": lambda app: press(app, "right", "return"),
    "tab and space": lambda app: press(app, "tab", "space"),
    "the button": lambda app: answer(app, "end"),
}


@pytest.mark.parametrize("how", NO)
def test_a_match_goes_on_when_the_player_does_not_want_another_table(app, how):
    before, settings = everything(app), app.preferences.settings.table
    to_another_table(app)
    assert everything(app) == before
    NO[how](app)
    assert app.view.question is None
    assert app.game.sheet == "settings"
    assert everything(app) == before
    assert app.preferences.settings.table == settings
    press(app, "escape", "ctrl+return")
    assert app.game.moving
    assert "table" not in {action.name for _, action in app.actions}


@pytest.mark.parametrize("how", YES)
def test_a_match_ends_when_the_player_wants_another_table(app, how):
    to_another_table(app)
    YES[how](app)
    assert app.view.question is None
    assert app.game.contest is None
    assert app.game.table == app.preferences.settings.table == "match"


def test_by_mouse_alone(app):
    press(app, "f3")
    spots = sheetview.cells(TABLE, app.view.sight)
    click(app, next(cell.rect for cell in spots if cell.key == "thesis").center)
    assert app.game.contest is not None
    answer(app, "end")
    assert app.game.table == "thesis"


def test_a_set_up_from_the_shelf_asks_too(app):
    before = everything(app)
    press(app, "f4", "return", "escape")
    assert everything(app) == before
    click(app, shelfview.card_rect(1, app.view.sight.layout).center)
    assert everything(app) == before
    answer(app, "end")
    assert app.game.contest is None


def test_a_new_game_from_the_menu_asks_too(app):
    before = everything(app)
    press(app, "f10")
    start = menu_button(app, "start")
    click(app, start)
    assert app.view.question is not None
    press(app, "escape")
    assert app.game.sheet == "menu"
    assert everything(app) == before
    click(app, start)
    answer(app, "end")
    assert app.game.sheet == ""
    assert app.game.contest.match.opening
    press(app, "f10")
    click(app, start)  # nothing has been played yet
    assert app.view.question is None
    press(app, "ctrl+return", "f10")
    click(app, start)
    assert app.view.question is not None


def test_nothing_is_asked_on_the_free_table_or_when_the_match_is_over():
    app = an_app()
    to_another_table(app)
    assert app.game.table == "match"
    app = an_app(game="four-ball", handicap="1", finish="none")
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert app.game.contest.match.finished
    to_another_table(app)
    assert app.game.contest is None


def test_a_question_takes_every_key_and_is_forgotten_with_its_page(app):
    to_another_table(app)
    for key in ("f3", "f10", "5", "down", "up", "f1"):
        press(app, key)
        assert app.view.question is not None
        assert app.game.sheet == "settings"
    write(app, "3")
    press(app, "f2")
    assert app.game.language == "ko"
    pygame.event.post(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=-2))
    app.frame(FRAME)
    assert app.view.question is not None
    press(app, "escape", "escape", "f3")
    assert app.view.question is None


@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1280, 720)])
@pytest.mark.parametrize("page", ["f3", "f4"])
def test_a_question_is_the_same_drawn_in_part_and_anew(size, page):
    app = an_app(size=size, game="four-ball")
    if page == "f3":
        to_another_table(app)
    else:
        press(app, page, "return")
    plain = pixels(app)
    press(app, "right")
    assert pixels(app) != plain
    assert_same_as_anew(app)
    click(app, question.answers(app.view.sight.layout)[0].midtop)
    assert_same_as_anew(app)


@pytest.mark.parametrize("lang", LANGUAGES)
@pytest.mark.parametrize("size", [(960, 540), (1280, 720)])
def test_what_is_asked_and_answered_fits(lang, size):
    sight, w = an_app(size=size, lang=lang).view.sight, words(lang)
    s, type_ = sight.layout.s, sight.type
    room = question.box(sight.layout).w - 24 * s
    assert max(type_.width(w["ask.match"], 15), type_.width(w["ask.hint"], 13)) <= room
    for name, rect in zip(question.ANSWERS, question.answers(sight.layout), strict=True):
        assert type_.width(w[f"ask.{name}"], 15) <= rect.w - 8 * s
