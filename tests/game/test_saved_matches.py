"""A match that is saved goes on as it stood, to the last bit; a broken one says what is wrong."""

import json

import pytest

from game.session import saved, terms
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.table import presets
from tests.support.racked_games import played, playing
from tests.support.sampling import mostly

VISIT = {"player": 0, "rack": 1, "points": 0, "strokes": 1, "made": 1, "foul": False}
GAMES = [name for name in terms.GAMES if name != "free"]


def text_of(session):
    return saved.written(session.contest, session.world, session.shots)


@pytest.mark.parametrize("game", mostly(GAMES, quick=("14.1", "snooker", "three-cushion")))
def test_a_resumed_match_stands_as_it_was_and_goes_on_as_the_other_one_does(game):
    session = playing(game, seed=3)
    list(played(session, 5, 6 if session.contest.terms.discipline.position == "" else 3))
    other = Session(presets.table_world("medium"))
    perform(other, Action("resume", text_of(session)))
    assert other.world.layout() == session.world.layout()
    assert other.contest.match == session.contest.match
    assert other.contest.race == session.contest.race
    assert other.contest.card == session.contest.card
    assert text_of(other) == text_of(session)
    for one in (session, other):
        list(played(one, 6, 3))
    assert other.world.layout() == session.world.layout()
    assert other.contest.match == session.contest.match


def changed(text, *path, to):
    data = json.loads(text)
    at = data
    for step in path[:-1]:
        at = at[step]
    at[path[-1]] = to
    return json.dumps(data)


@pytest.mark.parametrize(
    ("path", "to", "why"),
    [
        (("terms", "game"), "chess", "game must be"),
        (("terms", "game"), "free", "no match"),
        (("kept", "at"), 5, "no player"),
        (("kept", "at"), "0", "int expected"),
        (("kept", "balls"), ["cue"], "balls"),
        (("kept", "layout"), [], "place for each"),
        (("kept", "layout", 0, "velocity"), ["0x1p0", "0x0p0"], "lie still"),
        (("kept", "layout", 0, "position"), ["nan", "0x0p0"], "lie still"),
        (("kept", "state", "left"), ["17"], "has not"),
        (("kept", "state", "color"), 1, "no 'color'"),
        (("kept", "race", "to"), 0, "race"),
        (("kept", "sheets"), [], "sheets"),
        (("kept", "card"), [VISIT | {"balls": ["17"]}], "has not"),
    ],
)
def test_a_broken_save_is_refused_and_says_why(path, to, why):
    text = text_of(playing("9-ball"))
    with pytest.raises(ValueError, match=why):
        saved.read(changed(text, *path, to=to))


@pytest.mark.parametrize("text", ["", "[]", "{}", "null", '{"terms":{},"kept":{}}', "[" * 9999])
def test_what_is_no_saved_match_at_all_is_refused(text):
    with pytest.raises(ValueError, match=r"saved match|terms|missing"):
        saved.read(text)


def test_the_card_has_a_row_for_each_visit_and_undo_takes_it_back():
    session = playing("8-ball")
    list(played(session, 5, 10))
    card = session.contest.card
    assert sum(visit.strokes for visit in card) == session.shots
    perform(session, Action("undo"))
    assert sum(visit.strokes for visit in session.contest.card) <= session.shots


def test_a_match_that_was_saved_without_the_balls_of_its_visits_is_read():
    text = changed(text_of(playing("9-ball")), "kept", "card", to=[VISIT])
    assert saved.read(text).kept.card[0].balls == ()
