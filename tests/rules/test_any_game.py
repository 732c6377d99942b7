"""Whatever is played in whichever game: there is a next player, an answer, and nothing is lost."""

from random import Random

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from danggu.rules import GAMES
from danggu.rules.carom import Carom
from danggu.rules.match import Match, Player
from danggu.rules.state import Call
from danggu.rules.stroke import Act, Rest, Stroke, Zone
from danggu.rules.verdict import Verdict
from tests.rules.grammar import read

POCKETS = ("NW", "N", "NE", "SW", "S", "SE")
WORDS = ("touched", "push", "jumps", "out_of_turn")
STROKES = 40


def begun(name: str, players: int, target: int | None = None) -> Match:
    return Match.of(GAMES[name](), *(Player(str(n), target) for n in range(players)))


def lying(match: Match) -> list[str]:
    """The balls on the table."""
    return sorted({*match.rules.cues, *(match.state.left or match.rules.balls)})


def declared(match: Match, chance: Random) -> Match:
    """The match with some call, or none."""
    balls = [ball for ball in lying(match) if ball not in match.rules.cues]
    if not balls or chance.random() < 0.3:
        return match
    ball, pocket = chance.choice(balls), chance.choice(("", *POCKETS))
    pick = chance.random()
    call = (
        Call(ball, pocket) if pick < 0.8 else Call(safety=True) if pick < 0.9 else Call(push=True)
    )
    return match.called(call)


def struck(match: Match, chance: Random) -> Stroke:
    """Some stroke: contacts, cushions, balls that drop or leave, each once."""
    cue, here, events = match.cue, lying(match), []
    others = [ball for ball in here if ball != cue]
    for _ in range(chance.randrange(7)):
        ball, pick = chance.choice(here), chance.random()
        if pick < 0.5 and others:
            hit = chance.sample(others, min(len(others), 2 if pick < 0.05 else 1))
            events.append(f"{cue}>{'+'.join(hit)}")
        elif pick < 0.7:
            events.append(f"{ball}|{chance.choice('NESW')}")
        elif match.rules.cues == ("cue",) and pick < 0.96:
            events.append(f"{ball}^{chance.choice(POCKETS)}")
            here = [other for other in here if other != ball] or [cue]
        else:
            events.append(f"{ball}@off")
            here = [other for other in here if other != ball] or [cue]
    done = read(events).stroke(cue)
    return with_rest(done, match, chance)


def with_rest(done: Stroke, match: Match, chance: Random) -> Stroke:
    acts = (Act(done.cue, chance.choice(WORDS)),) if chance.random() < 0.05 else ()
    ends = chance.choice(("in", "out", "astride"))
    zones = [Zone(ends, chance.random() < 0.5) for _ in range(2)]
    pairs = ((done.cue, chance.choice(match.rules.balls)),) if chance.random() < 0.2 else ()
    rest = Rest(pairs, chance.random() < 0.3, chance.choice(("", "brown")), *zones)
    return Stroke(done.touches, done.off, done.cue, done.rails, done.pocketed, "", acts, rest)


def answered(match: Match, chance: Random) -> Match:
    """Every answer is one; the match after one of them, or unanswered where that is allowed."""
    asked = match.asked
    assert asked is not None
    assert asked.options
    keys = [option.key for option in asked.options]
    assert len({*keys}) == len(keys)
    for key in keys:
        after = match.answered(key)
        assert after.asked is None
        assert 0 <= after.at < len(after.players)
    if asked.optional:
        assert asked.options[0].state == match.state
        if chance.random() < 0.5:
            return match
    else:
        with pytest.raises(ValueError, match="answered first"):
            match.after(match.ruled(Stroke((), cue=match.cue)))
    return match.answered(chance.choice(keys))


@pytest.mark.parametrize("name", GAMES)
@settings(max_examples=60, deadline=None)
@given(seed=st.integers(0, 2**32), players=st.integers(1, 3))
def test_random_strokes_keep_a_next_player_an_answer_the_scores_and_all_balls(
    name: str, seed: int, players: int
) -> None:
    chance = Random(seed)
    match = begun(name, players, chance.choice((None, 3, 30)))
    for _ in range(STROKES):
        match = declared(match, chance)
        verdict, before = match.ruled(struck(match, chance)), match
        assert verdict.reason
        match = match.after(verdict)
        check_scores(before, match, verdict)
        check_balls(before, match, verdict)
        if match.finished:
            with pytest.raises(ValueError, match="over"):
                match.after(verdict)
            return
        assert 0 <= match.at < players
        assert match.rules.targets(match.turn)
        if match.asked is not None:
            match = answered(match, chance)


def check_scores(before: Match, after: Match, verdict: Verdict) -> None:
    """Points go to the striker, what is given goes to the next player, no other score moves."""
    wanted = [sheet.score for sheet in before.sheets]
    wanted[before.at] += verdict.points
    if len(wanted) > 1:
        wanted[before.next] += verdict.gift
    assert [sheet.score for sheet in after.sheets] == wanted


def check_balls(before: Match, after: Match, verdict: Verdict) -> None:
    """No ball is there twice; what is spotted lies on the table, and what is down does not."""
    left, rules = after.state.left, before.rules
    assert len({*left}) == len(left)
    assert {*left} <= {*rules.balls}
    assert not {*verdict.spot} & {*verdict.down}
    if verdict.rack or after.finished or not left:
        return
    assert {*verdict.spot} - {*rules.cues} <= {*left}
    assert not {*verdict.down} & {*left}


@pytest.mark.parametrize("name", GAMES)
def test_a_game_begins_with_a_player_a_target_and_its_own_name(name):
    match = begun(name, 2)
    assert match.at == 0
    assert not match.finished
    assert match.rules.targets(match.turn)
    assert {*match.rules.targets(match.turn)} <= {*match.rules.balls}


def test_every_game_has_a_key_of_its_own():
    keys = [GAMES[name]().key for name in GAMES]
    assert len({*keys}) == len(keys)


# -- calls -----------------------------------------------------------------------------------------


def test_a_ball_that_is_down_cannot_be_called():
    match = begun("8-ball", 2)
    match = match.after(match.ruled(read(["cue>1", "3^NE"]).stroke("cue")))
    with pytest.raises(ValueError, match="'3' is not on the table"):
        match.called(Call("3", "NE"))
    assert match.called(Call("4", "NE")).call.ball == "4"


def test_a_call_is_for_one_stroke():
    match = begun("9-ball", 2)
    match = match.after(match.ruled(read(["cue>1", "3^NE"]).stroke("cue"))).called(Call(push=True))
    match = match.after(match.ruled(read(["cue|"]).stroke("cue")))
    assert match.call == Call()
    assert match.asked is not None


def test_an_answer_that_was_not_offered_is_refused_by_the_keys_there_are():
    match = begun("8-ball", 2)
    match = match.after(match.ruled(read(["cue>1"]).stroke("cue")))
    with pytest.raises(ValueError, match="accept, rerack, rerack_offender, not 'maybe'"):
        match.answered("maybe")
    with pytest.raises(ValueError, match="no question to answer"):
        match.answered("accept").answered("accept")


# -- equal innings (후구) --------------------------------------------------------------------------

CANNON = ["white>red", "white>yellow"]


def straight(target: int) -> Match:
    rules = Carom(0, red_first=False)
    return Match.of(rules, Player("a", target), Player("b", target), equal_innings=True)


def played(match: Match, *events: str) -> Match:
    cue = match.cue
    other = "yellow" if cue == "white" else "white"
    named = [e.replace("white", "CUE").replace("yellow", other).replace("CUE", cue) for e in events]
    return match.after(match.ruled(read(named).stroke(cue)))


def test_who_comes_after_the_winner_plays_a_last_inning_from_the_opening_position():
    match = played(straight(1), *CANNON)
    assert (match.reached, match.at, match.finished, match.opening) == ((0,), 1, False, True)
    assert played(match, "white>red").winner == 0


def test_who_reaches_the_target_in_the_last_inning_draws():
    match = played(played(straight(1), *CANNON), *CANNON)
    assert match.finished
    assert match.winner is None


def test_the_second_player_who_is_first_there_has_won_at_once():
    match = played(played(straight(1), "white>red"), *CANNON)
    assert match.winner == 1


def test_without_equal_innings_the_first_there_has_won():
    rules = Carom(0, red_first=False)
    match = played(Match.of(rules, Player("a", 1), Player("b", 1)), *CANNON)
    assert match.winner == 0
