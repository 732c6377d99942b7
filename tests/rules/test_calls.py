"""What is said before a stroke: which ball is played, which is nominated, and for how long."""

import pytest

from danggu.rules import GAMES
from danggu.rules.match import Match, Player
from danggu.rules.pyramid import DYNAMIC, FREE, Pyramid
from danggu.rules.race import Race
from danggu.rules.snooker import Snooker
from danggu.rules.state import Call
from tests.rules.grammar import read

ANY_BALL = ("free-pyramid",)


def two(name: str) -> Match:
    return Match.of(GAMES[name](), Player("a"), Player("b"))


@pytest.mark.parametrize("name", [name for name in GAMES if name not in ANY_BALL])
def test_only_the_own_cue_ball_can_be_played_where_there_is_one(name):
    match = two(name)
    own = match.cue
    assert match.called(Call(cue=own)).cue == own
    for ball in {*match.rules.balls} - {own}:
        with pytest.raises(ValueError, match=f"'{ball}' cannot be played: the cue ball is '{own}'"):
            match.called(Call(cue=ball))


def test_any_ball_that_is_on_the_table_can_be_played_in_free_pyramid():
    match = two("free-pyramid")
    assert match.called(Call(cue="5")).cue == "5"
    match = match.after(match.ruled(read(["cue>1", "cue^NE"]).stroke("cue")))
    assert match.called(Call(cue="5")).cue == "5"
    with pytest.raises(ValueError, match="'cue' is not on the table"):
        match.called(Call(cue="cue"))


def test_in_dynamic_pyramid_the_cue_ball_is_there_again_after_it_was_pocketed():
    match = Match.of(Pyramid(DYNAMIC), Player("a"), Player("b"))
    match = match.after(match.ruled(read(["cue>1", "cue^NE"]).stroke("cue"))).answered("7")
    assert match.called(Call(cue="cue")).cue == "cue"
    assert Pyramid(FREE).start(2).left != Pyramid(DYNAMIC).start(2).left


@pytest.mark.parametrize(
    ("events", "gift"), [(["cue>red3", "red3^NE"], 7), (["cue>blue", "blue^NE"], 0)]
)
def test_a_red_cannot_be_nominated_as_the_colour(events, gift):
    """It scored one point, and another colour was on. Now it is as if nothing had been said."""
    match = Match.of(Snooker(), Player("a"), Player("b"))
    match = match.after(match.ruled(read(["cue>red1", "red1^NE"]).stroke("cue")))
    verdict = match.called(Call("red3")).ruled(read(events).stroke("cue"))
    assert verdict == match.ruled(read(events).stroke("cue"))
    assert (verdict.gift, verdict.points) == (gift, 0 if gift else 5)


@pytest.mark.parametrize("bad", [0, -1, 1.5, "3", True])
def test_a_target_is_a_whole_number(bad):
    with pytest.raises(ValueError, match=f"target of 'a' must be a whole .* not {bad!r}"):
        Player("a", bad)
    with pytest.raises(ValueError, match=f"a race is to a whole number, 1 or more, not {bad!r}"):
        Race(bad)


@pytest.mark.parametrize("player", [-1, 2, None])
def test_a_rack_is_won_by_one_of_the_players(player):
    with pytest.raises(ValueError, match=f"there is no player {player}: there are 2"):
        Race(3).after(player)


@pytest.mark.parametrize("name", ["8-ball", "9-ball", "10-ball", "14.1", "snooker"])
def test_the_balls_of_a_rack_are_called_as_the_rules_of_its_game_call_them(name):
    from physics.tables.pocket_tables import SNOOKER_12FT, pool

    table = SNOOKER_12FT if name == "snooker" else pool(9)
    racked = {ball.name for ball in table.rack(name)}
    assert racked == {*GAMES[name]().balls} - {"cue"}
