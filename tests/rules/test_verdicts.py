"""Verdicts over arrays are those of the rules, shot by shot."""

from dataclasses import replace

import numpy as np
import pytest

from danggu.rules import GAMES, Balkline, Carom, Sagu, TenBall
from danggu.rules.match import Match, Player
from danggu.rules.state import Call
from danggu.rules.verdict import Turn
from tests.support.scattered import LIMIT, played

FEW, MANY = 300, 100_000
OWN = {
    "umb": ("three-cushion", Carom(umb=True, penalty=2)),
    "pba": ("three-cushion", Carom(bank=2, red_first=False, penalty=1, floor_zero=False)),
    "last point": ("four-ball", Sagu("last_point_3c", penalty=3)),
    "barred": ("straight-rail", Balkline(limit=1, bank=2)),
    "early": ("10-ball", TenBall(early=True, warns=False)),
}
GIVEN = {**{game: (game, make()) for game, make in GAMES.items()}, **OWN}


def turns(rules):
    """Turns that the rules take differently."""
    match = Match.of(rules, Player("a"), Player("b"))
    start = replace(match.turn, opening=False)
    later = replace(start, state=replace(start.state, phase="", fouls=(2, 0), warned=(True, False)))
    last = replace(later, state=replace(later.state, left=rules.balls[-1:], fouls=(1, 1)))
    eight = replace(last, state=replace(last.state, left=("8",), groups=("solids", "stripes")))
    second = replace(start, state=replace(start.state, phase="second"))
    groups = replace(later, state=replace(later.state, groups=("stripes", "solids")))
    return [
        last, replace(last, call=Call(rules.balls[-1])), eight, replace(eight, call=Call("8", "S")),
        second, replace(second, call=Call(push=True)), groups, replace(groups, call=Call("12")),
        start, replace(start, opening=True), later, replace(later, call=Call("3", "NE")),
        replace(later, score=9, target=10, against=4), replace(later, score=10, target=10),
        replace(later, call=Call(safety=True)),
    ]  # fmt: skip


def check(rules, outcomes, turn):
    """Every shot as `rules.verdict` has it; returns the reasons."""
    found = rules.verdicts(outcomes, turn)
    for k in range(len(outcomes.times)):
        one = rules.verdict(outcomes.log(k), turn)
        given = found.points[k], found.made[k], found.foul[k], found.reason[k]
        assert given == (one.points, one.made, one.foul, one.reason), (turn, k)
    assert np.array_equal(found.certain, outcomes.dropped == 0) or outcomes.dropped.any()
    return {*found.reason}


@pytest.mark.parametrize("name", GIVEN)
def test_a_batch_is_judged_as_its_logs_are(name):
    game, rules = GIVEN[name]
    outcomes, seen = played(game, FEW, np.random.default_rng(1)), set()
    for turn in turns(rules):
        seen |= check(rules, outcomes, turn)
    assert len(seen) > 3 or name == "free"
    assert seen <= {""} or "" not in seen


@pytest.mark.stress
@pytest.mark.parametrize("name", GIVEN)
def test_a_hundred_thousand_shots_are_judged_as_their_logs_are(name):
    game, rules = GIVEN[name]
    rng, turn = np.random.default_rng(2), turns(rules)
    for _ in range(MANY // LIMIT):
        outcomes = played(game, LIMIT, rng)
        for one in rng.permutation(len(turn))[:3]:
            check(rules, outcomes, turn[one])


@pytest.mark.parametrize("name", ["three-cushion", "umb", "four-ball", "barred"])
@pytest.mark.parametrize("kept", [1, 3, 6])
def test_a_verdict_that_is_certain_is_that_on_all_contacts(name, kept):
    game, rules = GIVEN[name]
    for turn in turns(rules)[8:10]:
        whole = rules.verdicts(played(game, FEW, np.random.default_rng(3)), turn)
        part = rules.verdicts(played(game, FEW, np.random.default_rng(3), kept), turn)
        sure = part.certain
        for a, b in zip(whole[:4], part[:4], strict=True):
            assert np.array_equal(a[sure], b[sure])
        assert whole.certain.all()
        assert not sure.all()
        assert sure.any() or kept == 1


def test_no_shots_have_no_verdicts():
    outcomes = played("three-cushion", 1, np.random.default_rng(4))
    columns = ("positions", "times", "events", "contacts", "dropped")
    none = outcomes._replace(**{name: getattr(outcomes, name)[:0] for name in columns})
    for game in ("three-cushion", "four-ball", "free", "9-ball"):
        rules = GAMES[game]()
        turn = Turn("white", state=rules.start(2))
        assert [len(column) for column in rules.verdicts(none, turn)] == [0] * 5


@pytest.mark.parametrize("game", ["three-cushion", "four-ball", "9-ball"])
def test_a_cue_ball_that_is_not_there_is_named(game):
    outcomes = played("three-cushion", 1, np.random.default_rng(5))
    with pytest.raises(ValueError, match="no ball 'blue' among white, yellow, red"):
        GAMES[game]().verdicts(outcomes, Turn("blue"))
