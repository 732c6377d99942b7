"""Games with pockets at the table: balls that are down, in hand, spotted and racked."""

import re
from dataclasses import replace
from math import dist, sqrt
from pathlib import Path

import pytest

from danggu import rules
from danggu.rules.state import ANYWHERE
from game.session import terms
from game.session.action import Action
from game.session.commands import perform
from game.session.match_commands import pockets
from game.text import LANGUAGES
from physics import heading
from tests.support.racked_games import RACKED, leave, played, playing, stroke
from tests.support.sampling import mostly

STRAIGHT = "1.6 -1 0 0"
UP_RIGHT = complex(1, 1) / sqrt(2)


def gone(session):
    return {ball.name for ball in session.world.balls if ball.gone}


def test_every_game_of_the_rules_has_a_table():
    assert {*terms.GAMES} == {*rules.GAMES}


OFTEN = ("8-ball", "snooker", "free-pyramid", "three-cushion", "four-ball")


@pytest.mark.parametrize(
    "game", mostly([name for name in terms.GAMES if name != "free"], quick=OFTEN)
)
def test_a_game_goes_on_for_ten_strokes_and_the_table_holds_the_balls_it_counts(game):
    session = playing(game)
    for _ in played(session, 1, 10 if game in RACKED else 4):
        match = session.contest.match
        if match.state.left and not match.finished:
            there = {ball.name for ball in session.world.balls if not ball.gone}
            assert there - {"cue"} == {*match.state.left} - {"cue"}
        session.world.plan()  # which refuses balls that overlap


@pytest.mark.stress
@pytest.mark.parametrize("game", ["8-ball", "9-ball", "10-ball", "14.1", "snooker"])
def test_a_whole_game_comes_to_its_end(game):
    session = playing(game)
    list(played(session, 2, 800))
    assert session.contest.over


@pytest.mark.parametrize("game", mostly(RACKED, quick=("9-ball", "snooker")))
def test_undo_and_redo_go_through_strokes_with_balls_down_to_the_digit(game):
    session = playing(game)
    list(played(session, 4, 6))
    end, standing = session.world.layout(), session.contest.match
    count = 0
    while session.history.past:
        perform(session, Action("undo"))
        count += 1
    assert session.contest.match == terms.Terms(game, table=session.table).match()
    assert gone(session) == set()
    for _ in range(count):
        perform(session, Action("redo"))
    assert session.world.layout() == end
    assert session.contest.match == standing


def test_the_cue_ball_in_hand_stays_where_it_is_if_the_place_is_none_and_the_reason_is_said():
    session = playing("8-ball")
    assert session.arranging
    before = session.world.ball("cue").position
    perform(session, Action("move", "0.5 0.1"))
    assert session.world.ball("cue").position == before
    assert session.notice.key == "hand.pool"
    perform(session, Action("move", "-0.9 0.2"))
    assert session.world.ball("cue").position == (-0.9, 0.2)
    assert session.notice is None
    perform(session, Action("arrange"))
    assert not session.arranging


def test_a_ball_in_hand_is_not_placed_on_another_ball():
    session = playing("9-ball")
    leave(session, cue=(-0.9, 0.0), b1=(0.2, 0.1), b9=(0.6, 0.0))
    stroke(session, "1 0 0 0 90")
    assert session.contest.verdict.foul
    assert session.contest.in_hand == ANYWHERE
    perform(session, Action("next"))
    perform(session, Action("move", "0.21 0.1"))
    assert (session.notice.key, session.notice.about) == ("hand.ball", "1")


def test_a_ball_that_is_down_cannot_be_called_and_the_call_stays_as_it_was():
    session = playing("8-ball")
    leave(session, cue=(-0.9, 0.0), b1=(0.2, 0.1), b8=(0.6, 0.0))
    perform(session, Action("call", "ball 1"))
    perform(session, Action("call", "ball 5"))
    assert session.notice.key == "refused.call.down"
    assert session.contest.match.call.ball == "1"
    perform(session, Action("call", "pocket nowhere"))
    assert session.notice.key == "refused.call.none"


def test_a_question_holds_the_stroke_until_it_is_answered():
    session = playing("8-ball")
    stroke(session, "0.3 0 0 0 0")  # an illegal break
    assert session.contest.match.asked.options[0].key == "accept"
    shots = session.shots
    perform(session, Action("fire"))
    assert session.shots == shots
    assert session.notice.key == "refused.asked"
    perform(session, Action("answer", "nothing"))
    assert session.notice.key == "refused.answer"
    perform(session, Action("answer", "rerack"))
    assert session.contest.match.at == 1
    assert session.contest.in_hand not in ("", ANYWHERE)
    assert gone(session) == set()


def pot(session, ball, *others):
    """Pot that ball straight into the far right pocket, with others on the table."""
    hole = complex(*pockets(session.world)["north-east pocket"])
    ball_at = hole - 0.35 * UP_RIGHT
    cue = ball_at - 0.4 * UP_RIGHT
    places = {"cue": (cue.real, cue.imag), ball: (ball_at.real, ball_at.imag), **dict(others)}
    leave(session, **places)
    stroke(session, f"{STRAIGHT} {heading(UP_RIGHT)}")


def test_a_colour_is_spotted_while_reds_last():
    session = playing("snooker")
    pot(session, "red1", ("red2", (0.0, -0.5)), ("black", (-0.3, 0.1)))
    contest = session.contest
    assert contest.verdict.reason == "potted"
    assert contest.match.state.on == "colour"
    assert gone(session) >= {"red1"}
    contest.match = replace(contest.match, state=replace(contest.match.state, on="red"))
    pot(session, "black", ("red2", (0.0, -0.5)))
    assert contest.verdict.foul  # red was on
    assert contest.verdict.gift == 7
    assert session.world.ball("black").position == session.world.table.spots["black"]


def test_a_nine_that_drops_on_a_foul_is_spotted_on_the_foot_spot():
    session = playing("9-ball")
    pot(session, "b9", ("b1", (-0.5, -0.3)))
    assert session.contest.verdict.reason == "wrong_ball"
    assert session.world.ball("9").position == session.world.table.spots["foot"]
    assert session.contest.in_hand == ANYWHERE


def test_a_rack_of_fourteen_leaves_the_last_ball_and_the_apex_free():
    session = playing("14.1")
    pot(session, "b2", ("b5", (-0.9, 0.4)))
    assert session.contest.verdict.rack == 14
    assert gone(session) == set()
    assert session.world.ball("5").position == (-0.9, 0.4)
    foot = session.world.table.spots["foot"]
    assert min(dist(ball.position, foot) for ball in session.world.balls) > 0.04


def test_a_race_racks_again_for_the_other_player_and_can_be_undone():
    session = playing("9-ball", race=2)
    contest = session.contest
    pot(session, "b9")
    assert contest.verdict.won
    assert contest.race.won == (1, 0)
    assert contest.between
    perform(session, Action("shoot"))
    assert contest.match.at == 1
    assert gone(session) == set()
    assert session.arranging
    perform(session, Action("undo"))
    assert contest.between


def test_in_free_pyramid_any_ball_is_played():
    session = playing("free-pyramid")
    perform(session, Action("call", "cue 5"))
    assert session.cue == "5"
    perform(session, Action("ball", 1))
    assert session.cue != "5"


# -- words -----------------------------------------------------------------------------------------


def reasons_and_options():
    """Every key that a verdict or a question of the rules can have, read from their source."""
    folder = Path(rules.__file__).parent
    source = "\n".join(p.read_text() for p in folder.glob("*.py"))
    named = dict(re.findall(r'^([A-Z_0-9]+) = "([a-z_0-9]+)"$', source, re.M))
    for heads, values in re.findall(
        r"^([A-Z_0-9, ]+) = \(?\s*((?:\"[a-z_0-9]+\",?\s*)+)\)?", source, re.M
    ):
        named |= dict(zip(heads.split(", "), re.findall(r'"([a-z_0-9]+)"', values), strict=False))
    options = set(re.findall(r'Option\(\s*(?:[a-z]+\.)?("[a-z_]+"|[A-Z_]+)', source))
    return (
        {
            value(named, said)
            for said in re.findall(r'Verdict\(\s*(?:[a-z]+\.)?("[a-z_]+"|[A-Z_]+),', source)
        },
        {value(named, said) for said in options},
    )


def value(named, said):
    return said.strip('"') if said.startswith('"') else named[said]


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_reason_and_every_option_of_the_rules_has_its_words(language):
    words = LANGUAGES[language]
    reasons, options = reasons_and_options()
    assert len(reasons) > 8
    assert len(options) > 10
    missing = [r for r in reasons if f"reason.{r}" not in words and f"reason.{r}.0" not in words]
    missing += [o for o in options if f"option.{o}" not in words]
    missing += [o for o in options if f"option.{o}.hint" not in words]
    assert missing == []


@pytest.mark.parametrize("game", ["8-ball", "9-ball", "10-ball", "14.1", "snooker"])
def test_what_really_happens_has_words(game):
    for said in played(playing(game), 9, 8):
        kind, _, key = said.rpartition(" ")
        name = f"{'option' if kind else 'reason'}.{key}"
        assert all(name in words for words in LANGUAGES.values()), said
