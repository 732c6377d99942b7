"""Numbers as keyboards and clipboards give them: read as meant, or kept in sight and marked."""

import json
from pathlib import Path

import pytest

from game.aim.entry import LONGEST, Aim, fault
from game.input.captions import words
from game.text.numerals import hopeless, typed, value
from game.ui.panels.parts import hint
from game.window import clipboard
from tests.support.players import FRAME, an_app, enter, places, press, write

TYPED = json.loads((Path(__file__).parents[1] / "data" / "typed_numbers.json").read_text("utf-8"))
GOOD = [case for case in TYPED if case["number"] is not None]
BAD = [case for case in TYPED if case["number"] is None]


def what(case):
    return case["what"]


def states(app):
    """How the five boxes look."""
    return [app.view.parts[i].key(app.view.sight)[1] for i in range(5)]


@pytest.mark.parametrize("case", TYPED, ids=what)
def test_all_that_can_be_seen_stays_in_the_box(case):
    assert typed(case["typed"]) == case["kept"]
    assert typed(case["kept"]) == case["kept"]
    app = an_app()
    press(app, "left", "tab")
    write(app, case["typed"])
    assert app.session.aim.texts[1] == case["kept"]


@pytest.mark.parametrize("case", GOOD, ids=what)
def test_what_users_keyboards_give_is_the_number_they_mean(case):
    assert value(case["typed"]) == value(case["kept"]) == case["number"]
    assert fault(1, case["typed"]) is None
    app = an_app()
    enter(app, "3", case["typed"], "0", "0", "0")
    assert app.session.aim.shot.follow == case["number"]


@pytest.mark.parametrize("case", BAD, ids=what)
def test_what_is_no_number_is_marked_and_never_shot(case):
    app = an_app()
    before = places(app.session)
    enter(app, "3", case["typed"], "0", "0", "0")
    press(app, "return", "ctrl+return")
    assert places(app.session) == before
    assert app.session.aim.texts[1] == case["kept"]
    assert states(app)[1] == "invalid"
    assert hint(app.session, words("en")) == ("wrong input · Wx·R: not a number", True)


@pytest.mark.parametrize("case", TYPED, ids=what)
def test_what_is_pasted_is_what_is_typed(case, monkeypatch):
    app = an_app()
    press(app, "left", "tab")
    monkeypatch.setattr(clipboard, "get", lambda: case["typed"].strip())
    press(app, "ctrl+v")
    assert app.session.aim.texts[1].strip() == case["kept"].strip()
    assert (fault(1, app.session.aim.texts[1]) is None) == (case["number"] is not None)


@pytest.mark.parametrize("text", ["1x", "1.2.3", "2 5", "가"])
def test_what_no_more_characters_can_mend_is_marked_while_it_is_typed(text):
    app = an_app()
    press(app, "right")
    write(app, text)
    assert states(app)[0] == "invalid"
    assert hint(app.session, words("en")) == ("V: not a number", True)
    press(app, *["backspace"] * (len(text) - 1))
    assert states(app)[0] == ("focused" if text[0].isdecimal() else "invalid")


@pytest.mark.parametrize("whole", ["-12.5e-3", "+.5", "2.", "1e+3", "30"])
def test_every_beginning_of_a_number_may_still_become_one(whole):
    assert [part for n in range(len(whole) + 1) if hopeless(part := whole[:n])] == []


@pytest.mark.parametrize("text", ["e1", "1e1.5", "..", "+-", "x", "1e5x", "nan"])
def test_what_begins_no_number_is_known_for_it(text):
    assert hopeless(text)


def test_a_paste_that_does_not_fit_is_no_other_number():
    """Cut off, a millionth of a metre a second would be one."""
    aim, long = Aim(), "1.00000000000000000e-6"
    aim.edit(0)
    assert not aim.type(long)
    assert len(aim.texts[0]) == LONGEST
    assert aim.texts[0].startswith("1.0000")
    assert aim.faults[0].reason == "number"


def test_a_character_too_many_is_said_to_be():
    app = an_app()
    press(app, "right")
    write(app, "1" * LONGEST)
    assert app.session.notice is None
    write(app, "2")
    assert app.session.aim.texts[0] == "1" * LONGEST
    assert hint(app.session, words("en")) == ("A box takes no more characters", True)


@pytest.mark.parametrize("key", ["x", "comma", "i", "slash", "minus", "7"])
def test_only_digits_and_signs_begin_an_entry_from_play(key):
    app = an_app()
    char = {"comma": ",", "slash": "/", "minus": "-"}.get(key, key)
    press(app, char)
    assert (app.session.aim.box is not None) == (char in "-7")


def test_a_number_with_a_comma_in_a_box_is_used_by_the_keys_that_change_it():
    app = an_app()
    app.session.aim.texts[0] = "2,5"
    press(app, "pageup")
    assert app.session.aim.texts[0] == "3"
    app.frame(FRAME)
