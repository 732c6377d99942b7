"""The caret and what it does, the same in every text field of the window."""

import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.input.captions import words
from game.input.repeat import FIRST, NEXT
from game.render.parts import fields
from game.session.ticks import TICKS
from game.text import LANGUAGES
from game.text.text_field import TextField
from game.ui.pages import menu_view
from game.window import clipboard
from tests.game.test_composing import to_box, to_name, to_row, to_shelf
from tests.support.players import FRAME, an_app, assert_same_as_anew, click, press, write


def box(app):
    aim = to_box(app)
    return lambda: aim.texts[0]


def name(app):
    menu = to_name(app)
    return lambda: menu.terms.seats[0].name


def handicap(app):
    menu = to_row(app, "target")
    press(app, "backspace")
    return lambda: menu.field.text


def shelf(app):
    page = to_shelf(app)
    return lambda: page.text


FIELDS = {"box": box, "name": name, "handicap": handicap, "shelf": shelf}
every_field = pytest.mark.parametrize("kind", FIELDS)


@pytest.fixture
def app():
    return an_app(size=(1280, 720), game="four-ball")


def clipped(monkeypatch):
    """A clipboard of the test's own."""
    held = [""]
    monkeypatch.setattr(clipboard, "get", lambda: held[0])
    monkeypatch.setattr(clipboard, "put", lambda text: held.__setitem__(0, text) or True)
    return held


# -- the same in each ----------------------------------------------------------------------------


@every_field
@pytest.mark.parametrize(
    ("keys", "wanted"),
    [
        (("left", "0"), "102"),
        (("left", "left", "right", "0"), "102"),
        (("home", "0"), "012"),
        (("home", "end", "left", "0"), "102"),
        (("left", "left", "left", "0"), "012"),
        (("right", "0"), "120"),
        (("backspace",), "1"),
        (("left", "backspace"), "2"),
        (("home", "delete"), "2"),
        (("home", "backspace"), "12"),
        (("delete",), "12"),
        (("ctrl+a", "0"), "0"),
        (("ctrl+a", "delete", "0"), "0"),
        (("ctrl+a", "left", "0"), "012"),
        (("shift+home", "0"), "0"),
        (("shift+left", "0"), "10"),
        (("shift+left", "backspace"), "1"),
    ],
    ids=" ".join,
)
def test_the_caret_goes_and_deletes_as_anywhere(app, kind, keys, wanted):
    text = FIELDS[kind](app)
    for key in ("1", "2", *keys):
        if key.isdecimal() and kind != "handicap":
            write(app, key)
        else:
            press(app, key)
    assert text() == wanted
    assert_same_as_anew(app)


@every_field
@pytest.mark.parametrize(("key", "left"), [("backspace", ""), ("delete", "11")])
def test_a_held_key_goes_on_deleting_in_every_field(app, kind, key, left, monkeypatch):
    text = FIELDS[kind](app)
    for _ in range(2):
        (press if kind == "handicap" else write)(app, "1")
    code = getattr(pygame, f"K_{key.upper()}")
    monkeypatch.setattr(pygame.key, "get_pressed", lambda: {code: True})
    press(app, key, frames=False)
    app.frame(0)
    app.frame(FIRST + 5 * NEXT)
    assert text() == left


@every_field
def test_all_is_copied_cut_and_pasted(app, kind, monkeypatch):
    held, text = clipped(monkeypatch), FIELDS[kind](app)
    for key in "12":
        (press if kind == "handicap" else write)(app, key)
    press(app, "ctrl+a", "ctrl+c")
    assert (held[0], text()) == ("12", "12")
    press(app, "ctrl+x")
    assert (held[0], text()) == ("12", "")
    held[0] = " 3\n"
    press(app, "ctrl+v")
    assert text() == "3"


@every_field
def test_digits_of_the_number_pad_are_digits(app, kind):
    text = FIELDS[kind](app)
    for n in (2, 5):
        code = getattr(pygame, f"K_KP_{n}")
        # a text field gets the character as well, wherever SDL makes one of the key
        app.handle(pygame.event.Event(pygame.KEYDOWN, key=code, mod=0, unicode=""))
        if kind in ("name", "shelf"):
            app.handle(pygame.event.Event(pygame.TEXTINPUT, text=str(n)))
    if kind != "box":  # there SDL's text input is on: the character is the event's to bring
        assert text() == "25"


@pytest.mark.parametrize("before", [(), ("right",)], ids=["play", "box"])
def test_digits_of_the_number_pad_fill_a_box_before_text_input_is_on(app, before):
    aim = app.session.aim
    press(app, *before, frames=False)
    for n in (2, 5):
        key = getattr(pygame, f"K_KP_{n}")
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key, mod=0, unicode=""))
    app.frame(FRAME)
    assert aim.texts[0] == "25"


# -- what is each one's own ----------------------------------------------------------------------


def test_a_click_chooses_a_box_and_the_next_one_a_place_in_it(app):
    press(app, "right")
    write(app, "1234")
    rect = app.view.sight.layout.fields[0]
    sight = app.view.sight
    for place in (0, 2, 4):
        x = next(
            x for x in range(rect.x, rect.right)
            if fields.caret_at(rect, sight.type, "1234", x, "m/s") == place
        )  # fmt: skip
        click(app, (x, rect.centery))
        assert app.session.aim.edited.caret == place
    press(app, "tab")
    click(app, rect.center)
    assert app.session.aim.edited.selected == "1234"
    write(app, "5")
    assert app.session.aim.texts[0] == "5"


def test_a_click_into_a_name_chooses_a_place_in_it(app):
    menu = to_name(app)
    write(app, "abcd")
    place = menu.focus
    rect = menu_view.row_rect(menu.rows, place, app.view.sight.layout)
    click(app, menu_view.text_window(rect, app.view.sight).center)
    write(app, "x")
    assert menu.terms.seats[0].name == "abxcd"


def test_arrows_count_a_handicap_until_something_is_typed(app):
    menu = to_row(app, "target")
    press(app, "right", "right", "left")
    assert menu.terms.seats[0].target == 11
    press(app, "pageup")
    assert menu.terms.seats[0].target == 21
    press(app, "lshift", "right", "left", "3", "5", "left", "left", "1")
    assert menu.terms.seats[0].target == 135
    press(app, "down", "up", "right")
    assert menu.terms.seats[0].target == 136


@pytest.mark.parametrize("text", ["x", "2.5", "-3", "1 2"])
def test_what_is_no_handicap_is_refused_in_words(app, text, monkeypatch):
    held, menu = clipped(monkeypatch), to_row(app, "target")
    held[0] = text
    press(app, "ctrl+v")
    assert menu.terms.seats[0].target == 10
    assert menu.refused
    assert_same_as_anew(app)
    press(app, "7")
    assert (menu.terms.seats[0].target, menu.refused) == (7, "")


@pytest.mark.parametrize("text", ["２５", "٢٥", " 25 "])
def test_digits_of_any_script_are_a_handicap(app, text, monkeypatch):
    held, menu = clipped(monkeypatch), to_row(app, "target")
    held[0] = text
    press(app, "ctrl+v")
    assert menu.terms.seats[0].target == 25


def test_a_handicap_that_begins_with_nought_is_typed_on(app):
    menu = to_row(app, "target")
    press(app, "0", "5")
    assert menu.terms.seats[0].target == 5


def test_a_name_too_long_says_so(app):
    menu = to_name(app)
    write(app, "x" * 16)
    assert menu.refused == ""
    write(app, "y")
    assert menu.terms.seats[0].name == "x" * 16
    assert menu.refused == "full"


def test_a_line_is_still_pasted_as_a_set_up_and_copied_where_nothing_is_selected(monkeypatch):
    held, app = clipped(monkeypatch), an_app()
    page = to_shelf(app)
    press(app, "ctrl+c")
    assert held[0] == page.text
    assert held[0].startswith("danggu1 ")
    press(app, "ctrl+v")
    assert app.session.page == ""


def test_held_keys_of_a_page_without_a_field_do_nothing_again(monkeypatch):
    app = an_app()
    press(app, "f3", "down")
    monkeypatch.setattr(pygame.key, "get_pressed", lambda: {pygame.K_RIGHT: True})
    press(app, "right", frames=False)
    app.frame(0)
    table = app.session.table
    app.frame(TICKS)
    assert app.session.table == table


def test_a_held_key_does_nothing_behind_a_page(monkeypatch):
    app = an_app()
    monkeypatch.setattr(pygame.key, "get_pressed", lambda: {pygame.K_q: True})
    press(app, "q", frames=False)
    app.frame(0)
    click(app, app.view.sight.layout.engine.move(-48, -8).midright)
    assert app.session.page == "menu"
    angle = app.session.aim.texts[4]
    app.frame(TICKS)
    assert app.session.aim.texts[4] == angle


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_refusal_has_its_words(language):
    w = words(language)
    for key in ("menu.refused.name", "menu.refused.target"):
        assert "{" not in w[key].format(most=200, length=16)


# -- the field itself ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("start", "to", "caret"),
    [(5, "back", 4), (11, "back", 8), (4, "back", 0), (0, "back", 0), (0, "ahead", 4),
     (5, "ahead", 8), (9, "ahead", 11), (3, 7, 7), (3, 99, 11), (3, "left", 2)],
)  # fmt: skip
def test_words_are_gone_over_and_places_gone_to(start, to, caret):
    field = TextField("one two red", caret=start, anchor=start)
    field.go(to)
    assert (field.caret, field.selected) == (caret, "")


KEYS = st.sampled_from(
    ["erase", "delete", *(f"{keep}{step}" for keep in ("", "+")
                          for step in ("left", "right", "home", "end", "back", "ahead"))]
)  # fmt: skip


@given(st.text(max_size=12), st.lists(KEYS | st.tuples(st.text(max_size=4)), max_size=20))
def test_whatever_is_done_a_field_stays_within_its_bounds(text, keys):
    field = TextField(text, longest=12)
    for key in keys:
        before = len(field.text) - len(field.selected)
        if isinstance(key, tuple):
            assert field.type(key[0]) or len(field.text) == 12 or before >= 12
        elif key in ("erase", "delete"):
            getattr(field, key)()
        else:
            field.go(key)
        assert len(field.text) <= max(12, len(text))
        assert min(field.selection) >= 0
        assert max(field.selection) <= len(field.text)
