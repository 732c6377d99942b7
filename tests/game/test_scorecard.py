"""The sheet of a match: what counts as a try, and who won the rack."""

from dataclasses import replace

import pytest

from danggu.rules.state import Call
from danggu.rules.verdict import Verdict
from game.input.captions import words
from game.session import scorecard
from game.settings.statistics import Figures
from game.ui.pages import score_page
from game.ui.panels import rack_words
from tests.support.racked_games import leave, playing

MISSED, POTTED = Verdict("missed"), Verdict("potted", made=True, passes=False)


def match_of(game):
    """A match in the middle of a rack."""
    session = playing(game)
    leave(session, cue=(-0.5, 0.0), b1=(0.5, 0.0), b9=(0.3, 0.3), red1=(0.5, 0.0))
    return session.contest.match


@pytest.mark.parametrize("game", ["9-ball", "8-ball", "snooker", "14.1"])
def test_a_dry_break_is_no_missed_pot(game):
    match = playing(game).contest.match
    card = scorecard.after((), match, MISSED, 1)
    assert scorecard.totals(card, 0).spared == 1
    broke = scorecard.totals(scorecard.after((), match, POTTED, 1), 0)
    assert (broke.made, broke.strokes - broke.spared) == (1, 0)  # nor one that pots a meant one


def test_a_break_that_pots_is_no_part_of_the_pot_rate():
    card = scorecard.after((), playing("9-ball").contest.match, POTTED, 1)
    later = replace(match_of("9-ball"), visit=1)
    for verdict, share in ((MISSED, 0.0), (POTTED, 0.5)):
        card = scorecard.after(card, later, verdict, 1)
        totals = scorecard.totals(card, 0)
        figures = Figures().plus(totals, won=False)
        assert totals.share == figures.share == share


@pytest.mark.parametrize("call", [Call(safety=True), Call(push=True)])
def test_push_outs_and_safeties_are_no_missed_pots(call):
    match = match_of("9-ball")
    card = scorecard.after((), match, POTTED, 1)
    card = scorecard.after(card, replace(match, visit=1, call=call), MISSED, 1)
    assert scorecard.totals(card, 0).share == 1.0
    card = scorecard.after(card, replace(match, visit=2), MISSED, 1)
    assert scorecard.totals(card, 0).share == 0.5


def test_the_plate_says_the_same_share():
    session = playing("9-ball")
    contest = session.contest
    contest.card = scorecard.after((), contest.match, MISSED, 1)
    assert not any("pots" in part for part in rack_words.line(contest, 0, words("en")))
    contest.card = scorecard.after(contest.card, match_of("9-ball"), POTTED, 1)
    assert "pots 100 %" in rack_words.line(contest, 0, words("en"))


@pytest.mark.parametrize(("game", "won", "lost"), [
    ("9-ball", "wins the rack", "loses the rack"), ("snooker", "wins the frame", "loses the frame"),
])  # fmt: skip
def test_the_sheet_says_who_won_the_rack(game, won, lost):
    contest = playing(game).contest
    match = match_of(game)
    for verdict, said in ((Verdict("rack_won", made=True, won=True), won),
                          (Verdict("rack_lost", foul=True, lost=True), lost)):  # fmt: skip
        visit = scorecard.after((), match, verdict, 1)[-1]
        assert score_page._end(visit, contest, words("en")) == said


def test_a_visit_keeps_the_balls_that_scored_in_their_order():
    match, card = match_of("snooker"), ()
    for visit, (down, spot) in enumerate([(("red3", "red1"), ()), ((), ("black",))]):
        potted = replace(POTTED, points=1, down=down, spot=spot)
        card = scorecard.after(card, replace(match, visit=visit), potted, 1)
    assert scorecard.running(card, replace(match, visit=2)) == ("red3", "red1", "black")
    assert scorecard.running(card, match.passed()) == scorecard.running((), match) == ()
    foul = Verdict("ball_not_on", foul=True, down=("red4",), spot=("blue",))
    assert scorecard.after(card, replace(match, visit=2), foul, 1)[-1].balls == card[-1].balls
