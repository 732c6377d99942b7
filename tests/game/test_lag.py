"""The lag: who stops nearer to the near cushion begins."""

import pytest

from game.session.action import Action
from game.session.commands import perform
from tests.support.players import an_app
from tests.support.racked_games import playing, stroke


@pytest.mark.parametrize("game", ["9-ball", "three-cushion", "snooker", "four-ball"])
def test_the_better_lag_opens_the_match_with_all_balls_laid(game):
    session = playing(game, lag=True)
    contest = session.contest
    assert sum(not ball.gone for ball in session.world.balls) == 1
    assert contest.in_hand == ""
    stroke(session, "0.6 0 0 0 0")  # it does not come back
    assert contest.verdict.reason in ("lag", "lag_bad")
    assert contest.match.at == 1
    stroke(session, "2.6 0 0 0 0")
    assert contest.lag is None
    assert contest.match.at == 1
    assert contest.race.breaker == 1
    assert not any(ball.gone for ball in session.world.balls)
    assert contest.match.opening
    assert session.cue == contest.match.cue
    perform(session, Action("undo"))
    assert len(contest.lag) == 1
    perform(session, Action("undo"))
    assert contest.lag == ()
    assert contest.match.at == 0


def test_two_lags_that_do_not_count_are_played_again():
    session = playing("9-ball", lag=True)
    for _ in range(2):
        stroke(session, "0.5 0 0 0 0")
    assert session.contest.lag == ()
    assert session.contest.verdict.reason == "lag_again"


def test_the_computer_lags_and_then_breaks_or_waits():
    app = an_app(game="9-ball", table="pool-9")
    terms = app.session.contest.terms
    line = (
        terms.line()
        .replace('"lag":false', '"lag":true')
        .replace('"level":"human"', '"level":"expert"')
    )
    app.perform(Action("match", line), sure=True)
    for _ in range(60):
        app.frame(1 << 15)
        if app.session.contest.lag is None:
            break
    assert app.session.contest.lag is None
    assert min(app.session.contest.race.won) == 0
