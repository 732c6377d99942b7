"""What ends or changes a running match is asked for first: "no" leaves everything as it was."""

import pygame
import pytest

from game.input.captions import words
from game.session.action import Action
from game.text import LANGUAGES
from game.ui.pages import question, settings_view, shelf_view
from game.ui.pages.settings_rows import ROWS
from tests.support.matches import menu_button, opening_numbers
from tests.support.players import (
    FRAME,
    an_app,
    assert_same_as_anew,
    click,
    enter,
    pixels,
    places,
    press,
    write,
)

TABLE = next(i for i, row in enumerate(ROWS) if row.name == "table")


def to_another_table(app):
    press(app, "f3", *["down"] * (TABLE - app.view.pages["settings"].focus), "right")


def answer(app, name):
    rect = question.answers(app.view.sight.layout)[question.ANSWERS.index(name)]
    click(app, rect.center)


@pytest.fixture
def app():
    """A match in which a point has been made."""
    app = an_app(game="four-ball", handicap="5")
    enter(app, *opening_numbers())
    press(app, "return", "end", "return")
    assert app.session.contest.match.sheets[0].score == 1
    return app


def everything(app):
    session = app.session
    return (
        session.contest.match,
        places(session),
        session.aim.texts[:],
        session.table,
        len(session.history.past),
    )


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
    assert app.session.page == "settings"
    assert everything(app) == before
    assert app.preferences.settings.table == settings
    press(app, "escape", "ctrl+return")
    assert app.session.moving
    assert "table" not in {action.name for _, action in app.actions}


@pytest.mark.parametrize("how", YES)
def test_a_match_ends_when_the_player_wants_another_table(app, how):
    to_another_table(app)
    YES[how](app)
    assert app.view.question is None
    assert app.session.contest is None
    assert app.session.table == app.preferences.settings.table == "match"


def test_by_mouse_alone(app):
    press(app, "f3")
    spots = settings_view.cells(TABLE, app.view.sight)
    click(app, next(cell.rect for cell in spots if cell.key == "thesis").center)
    assert app.session.contest is not None
    answer(app, "end")
    assert app.session.table == "thesis"


def test_a_set_up_from_the_shelf_asks_too(app):
    before = everything(app)
    press(app, "f4", "return", "escape")
    assert everything(app) == before
    click(app, shelf_view.card_rect(1, app.view.sight.layout).center)
    assert everything(app) == before
    answer(app, "end")
    assert app.session.contest is None


def test_a_new_game_from_the_menu_asks_too(app):
    before = everything(app)
    press(app, "f10")
    start = menu_button(app, "start")
    click(app, start)
    assert app.view.question is not None
    press(app, "escape")
    assert app.session.page == "menu"
    assert everything(app) == before
    click(app, start)
    answer(app, "end")
    assert app.session.page == ""
    assert app.session.contest.match.opening
    press(app, "f10")
    click(app, start)  # nothing has been played yet
    assert app.view.question is None
    press(app, "ctrl+return", "f10")
    click(app, start)
    assert app.view.question is not None


# -- what changes it, and leaving the game, also without a page


def to_the_engine_card(app, down):
    card = app.view.sight.layout.engine
    click(app, (card.x + 40, card.centery + (12 if down else -12)))


def to_a_row(app, name):
    place = next(i for i, row in enumerate(ROWS) if row.name == name)
    press(app, "f3", *["down"] * ((place - app.view.pages["settings"].focus) % len(ROWS)), "right")


CHANGES = {
    "the key of the engine": ("engine", lambda app: press(app, "e")),
    "the key of the laws": ("law", lambda app: press(app, "l")),
    "the engine on its card": ("engine", lambda app: to_the_engine_card(app, down=False)),
    "the laws on the card": ("law", lambda app: to_the_engine_card(app, down=True)),
    "the engine among the settings": ("engine", lambda app: to_a_row(app, "engine")),
    "the laws among the settings": ("law", lambda app: to_a_row(app, "law")),
    "the cloth among the settings": ("cloth", lambda app: to_a_row(app, "cloth")),
}


@pytest.mark.parametrize("how", CHANGES)
@pytest.mark.parametrize("rolling", [False, True])
def test_what_a_match_is_played_with_is_not_changed_unasked(app, how, rolling):
    name, change = CHANGES[how]
    if rolling:
        press(app, "ctrl+return")
        for _ in range(20):
            app.frame(FRAME)
    session, match, was = app.session, app.session.contest.match, getattr(app.session, name)
    change(app)
    assert app.view.question is not None
    before = everything(app)
    for _ in range(30):
        app.frame(FRAME)
    assert everything(app) == before  # time stands
    press(app, "escape")
    assert app.view.question is None
    assert (getattr(session, name), session.contest.match, session.moving) == (was, match, rolling)
    press(app, *["escape"] * bool(session.page))
    assert session.page == ""
    change(app)
    press(app, "right", "return", *["escape"] * bool(session.page))
    assert getattr(session, name) != was
    assert session.contest.match == match
    assert session.moving == rolling


LEAVES = {
    "the window's button": lambda app: (
        pygame.event.post(pygame.event.Event(pygame.QUIT)), app.frame(FRAME)
    ),
    "the menu": lambda app: (press(app, "f10"), click(app, menu_button(app, "quit"))),
}  # fmt: skip


@pytest.mark.parametrize("how", LEAVES)
def test_a_match_is_not_left_unasked(app, how):
    before = everything(app)
    LEAVES[how](app)
    assert not app.session.over
    assert app.view.question.words == "ask.quit"
    press(app, "return")
    assert not app.session.over
    press(app, *["escape"] * bool(app.session.page))
    assert everything(app) == before
    LEAVES[how](app)
    press(app, "tab", "return")
    assert app.session.over


@pytest.mark.parametrize("how", LEAVES)
@pytest.mark.parametrize("page", [None, "f1", "f3", "f10"])
def test_closing_the_window_twice_leaves_wherever_it_was_asked(app, how, page):
    press(app, *[page] * (page is not None))
    LEAVES["the window's button"](app)
    assert not app.session.over
    assert_same_as_anew(app)
    LEAVES["the window's button"](app)
    assert app.session.over


def test_closing_the_window_over_another_question_asks_about_that_first(app):
    to_another_table(app)
    LEAVES["the window's button"](app)
    assert not app.session.over
    assert app.view.question.words == "ask.quit"
    LEAVES["the window's button"](app)
    assert app.session.over
    assert app.session.contest is not None


def test_a_signal_leaves_at_once(app):
    app.handle(pygame.event.Event(pygame.QUIT, sure=True))
    assert app.session.over


@pytest.mark.parametrize("begun", [False, True])
def test_the_free_table_and_a_match_not_begun_are_left_at_once(begun):
    app = an_app(game="four-ball") if begun else an_app()
    LEAVES["the window's button"](app)
    assert app.session.over


def test_what_is_chosen_already_is_not_asked_about(app):
    app.perform(Action("law", app.session.law))
    assert app.view.question is None


@pytest.mark.parametrize("size", [(640, 360), (1280, 720)])
@pytest.mark.parametrize("key", ["e", "l"])
def test_a_question_over_the_table_is_the_same_drawn_in_part_and_anew(size, key):
    app = an_app(size=size, game="four-ball")
    press(app, key)
    assert_same_as_anew(app)
    press(app, "right")
    assert_same_as_anew(app)
    press(app, "return")
    assert_same_as_anew(app)


def test_nothing_is_asked_on_the_free_table_or_when_the_match_is_over():
    app = an_app()
    to_another_table(app)
    assert app.session.table == "match"
    app = an_app(game="four-ball", handicap="1", finish="none")
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert app.session.contest.match.finished
    to_another_table(app)
    assert app.session.contest is None


def test_a_question_takes_every_key_and_is_forgotten_with_its_page(app):
    to_another_table(app)
    for key in ("f3", "f10", "5", "down", "up", "f1"):
        press(app, key)
        assert app.view.question is not None
        assert app.session.page == "settings"
    write(app, "3")
    press(app, "f2")
    assert app.session.language == "ko"
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
    for key in ("ask", "ask.terms", "ask.quit"):
        said = type_.width(w[f"{key}.match"], 15), type_.width(w[f"{key}.hint"], 13)
        assert max(said) <= room
        for name, rect in zip(question.ANSWERS, question.answers(sight.layout), strict=True):
            assert type_.width(w[f"{key}.{name}"], 15) <= rect.w - 8 * s
