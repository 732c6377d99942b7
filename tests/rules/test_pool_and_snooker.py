"""The games with pockets, played through a match: questions, fouls in a row, ends."""

from dataclasses import replace

import pytest

from danggu.rules.eight_ball import EightBall
from danggu.rules.lag import Lag, lagged, winner
from danggu.rules.match import Match, Player
from danggu.rules.nine_ball import NineBall
from danggu.rules.pyramid import COMBINED, DYNAMIC, FREE, GIFT, TAKE, Pyramid
from danggu.rules.race import LOSER, WINNER, Race
from danggu.rules.snooker import Snooker, remaining
from danggu.rules.state import ANYWHERE, BREAK, HOUSE, KITCHEN, Call, D
from danggu.rules.straight_pool import StraightPool
from danggu.rules.stroke import Rest
from danggu.rules.ten_ball import TenBall
from danggu.rules.verdict import Rules
from tests.rules.grammar import read


def two(rules: Rules, target: int | None = None) -> Match:
    return Match.of(rules, Player("a", target), Player("b", target))


def play(match: Match, events: str, call: Call | None = None, rest: Rest | None = None) -> Match:
    """The match after a stroke, which has the verdict that is asked for."""
    match = match if call is None else match.called(call)
    done = read(events.split()).stroke(match.cue)
    done = done if rest is None else replace(done, rest=rest)
    return match.after(match.ruled(done))


def keys(match: Match) -> list[str]:
    assert match.asked is not None
    return [option.key for option in match.asked.options]


# -- 8-ball ----------------------------------------------------------------------------------------


def test_after_an_illegal_break_the_opponent_may_have_the_offender_break_again():
    match = play(two(EightBall()), "cue>1 1| 4|")
    assert (match.at, keys(match)) == (1, ["accept", "rerack", "rerack_offender"])
    again = match.answered("rerack_offender")
    assert (again.at, again.state.phase, again.state.region) == (0, BREAK, KITCHEN)
    assert match.answered("rerack").at == 1
    accepted = match.answered("accept")
    assert (accepted.at, accepted.state.phase, accepted.state.region) == (1, "", "")


def test_the_breaker_who_pockets_the_8_chooses_and_goes_on_with_it_spotted():
    match = play(two(EightBall()), "cue>1 8^NE 3^SW")
    assert match.at == 0
    spotted = match.answered("spot_and_accept")
    assert (spotted.at, "8" in spotted.state.left, "3" in spotted.state.left) == (0, True, False)
    assert match.answered("rebreak").state.phase == BREAK


def test_after_a_scratch_on_the_break_the_cue_ball_is_behind_the_head_string():
    match = play(two(EightBall()), "cue>1 3^SW cue^NE")
    assert (match.at, match.state.region) == (1, KITCHEN)
    assert match.answered("accept").state.region == KITCHEN
    # the first option holds without an answer
    assert play(match, "cue>12 12|").at == 0


def test_groups_are_those_of_the_two_players():
    match = play(play(two(EightBall()), "cue>1 3^SW"), "cue>2 2^NE", Call("2", "NE"))
    assert match.state.groups == ("solids", "stripes")
    assert "8" not in match.rules.targets(match.turn)
    assert {*match.passed().rules.targets(match.passed().turn)} == {*map(str, range(9, 16))}


def test_the_obvious_ball_need_not_be_called():
    match = play(play(two(EightBall()), "cue>1 3^SW"), "cue>2 2^NE")
    assert (match.at, match.state.group(0)) == (0, "solids")


def test_on_a_table_where_only_the_8_is_left_it_is_played():
    match = two(EightBall())
    match = replace(match, state=replace(match.state, phase="", left=("8",)))
    assert match.rules.targets(match.turn) == ("8",)
    assert play(match, "cue>8 8^NE", Call("8", "NE")).winner == 0


# -- 9-ball and 10-ball ----------------------------------------------------------------------------


def broken(rules: Rules) -> Match:
    return play(two(rules), "cue>1 5^NE")


def test_a_push_out_is_the_stroke_after_the_break_and_no_other():
    match = broken(NineBall())
    pushed = play(match, "cue>7", Call(push=True))
    assert (pushed.at, keys(pushed)) == (1, ["shoot", "offender_again"])
    assert pushed.answered("shoot").at == 1
    assert pushed.answered("offender_again").at == 0
    later = play(match, "cue>1 1^NE")
    assert play(later, "cue>7 7|", Call(push=True)).state.region == ANYWHERE


def test_a_third_foul_in_a_row_loses_the_rack_and_the_second_brings_the_warning():
    match = broken(NineBall())
    for fouls in (1, 2):
        match = play(match, "cue>7 7|")
        assert (match.state.fouls[0], match.state.warned[0]) == (fouls, fouls == 2)
        match = play(match, "cue>1 1|")
    assert play(match, "cue|").winner == 1


def test_nobody_loses_for_a_third_foul_without_a_warning():
    match = broken(NineBall(warns=False))
    for _ in range(4):
        match = play(play(match, "cue>7 7|"), "cue>1 1|")
    assert (match.finished, match.state.fouls[0]) == (False, 2)


def test_a_stroke_without_a_foul_ends_the_row_of_fouls():
    match = play(play(broken(NineBall()), "cue>7 7|"), "cue>1 1|")
    assert play(match, "cue>1 1|").state.fouls == (0, 0)


def test_the_edition_says_which_ball_is_racked_on_the_foot_spot():
    assert NineBall(2016).on_foot_spot == "1"
    assert NineBall(2025).on_foot_spot == "9"
    with pytest.raises(ValueError, match="edition must be one of"):
        NineBall(1999)


def test_a_10_that_drops_early_as_called_is_spotted_or_wins():
    call = Call("10", "NE")
    match = play(broken(TenBall()), "cue>1 1>10 10^NE", call)
    assert (match.at, match.finished, "10" in match.state.left) == (0, False, True)
    assert play(broken(TenBall(early=True)), "cue>1 1>10 10^NE", call).winner == 0


def test_a_split_hit_of_a_legal_ball_and_another_is_good():
    match = broken(NineBall())
    assert match.ruled(read(["cue>1+2", "2|"]).stroke("cue")).foul is False


# -- 14.1 ------------------------------------------------------------------------------------------


def straight(target: int | None = None) -> Match:
    return play(two(StraightPool(), target), "cue>1 cue| 5| 9|")


def test_fourteen_balls_down_are_racked_again_and_the_run_goes_on():
    match = straight()
    for ball in range(1, 14):
        match = play(match, f"cue>{ball} {ball}^NE")
    verdict = match.ruled(read(["cue>14", "14^NE"]).stroke("cue"))
    assert verdict.rack == 14
    match = match.after(verdict)
    assert (match.sheet.score, match.run, len(match.state.left)) == (14, 14, 15)


def test_the_last_two_balls_at_once_bring_a_full_rack():
    match = straight()
    match = replace(match, state=replace(match.state, left=("7", "9")))
    assert match.ruled(read(["cue>7", "7^NE", "9^SW"]).stroke("cue")).rack == 15


def test_three_fouls_cost_sixteen_more_than_two_and_the_offender_breaks():
    match = straight()
    for _ in range(2):
        match = play(play(match, "cue|"), "cue>5 5|")
    match = play(match, "cue|")
    assert (match.at, match.sheet.score) == (1, -18)
    assert (match.state.phase, match.state.fouls[1], match.state.region) == (BREAK, 0, KITCHEN)


def test_the_points_that_reach_the_target_win():
    match = straight(2)
    assert play(match, "cue>5 5^NE 7^SW").winner == 1


# -- snooker ---------------------------------------------------------------------------------------


def test_a_miss_may_be_played_again_from_where_all_balls_lay():
    match = play(two(Snooker()), "cue>blue")
    assert (match.at, match.sheets[1].score) == (1, 5)
    assert keys(match) == ["play_on", "put_in_again", "replay"]
    assert match.asked is not None
    assert match.asked.option("replay").restore
    assert match.answered("replay").state == two(Snooker()).state
    assert match.answered("put_in_again").at == 0
    assert keys(play(two(Snooker(miss=False)), "cue>blue")) == ["play_on", "put_in_again"]


def test_a_foul_on_the_ball_on_is_no_miss():
    assert keys(play(two(Snooker()), "cue>red1 cue^NE")) == ["play_on", "put_in_again"]


def test_a_player_who_needs_snookers_makes_no_miss():
    match = two(Snooker())
    match = replace(match, state=replace(match.state, left=("pink", "black"), on="pink"))
    sheets = (replace(match.sheet, score=0), replace(match.sheet, score=60))
    assert keys(play(replace(match, sheets=sheets), "cue>black")) == ["play_on", "put_in_again"]


def test_a_free_ball_is_only_for_the_player_who_takes_the_stroke():
    match = play(two(Snooker()), "cue>blue", rest=Rest(snookered=True))
    assert match.state.free
    assert not match.answered("put_in_again").state.free
    scored = play(match, "cue>brown brown^NE", Call("brown"))
    assert (scored.sheet.score, scored.state.on, scored.state.free) == (6, "colour", False)
    assert "brown" in scored.state.left


def test_a_snooker_behind_the_free_ball_is_a_foul_but_for_the_last_two_balls():
    match = two(Snooker())
    match = replace(match, state=replace(match.state, free=True))
    assert play(match, "cue>brown", Call("brown"), Rest(hidden="brown")).sheets[1].score == 4
    assert play(match, "cue>brown", Call("brown"), Rest(hidden="red1")).sheets[1].score == 0
    state = replace(match.state, left=("pink", "black"), on="pink")
    last = replace(match, state=state)
    assert play(last, "cue>black", Call("black"), Rest(hidden="black")).sheets[1].score == 0


def test_who_plays_away_from_a_touching_ball_on_has_hit_it():
    touching = Rest(touching=(("cue", "red1"),))
    match = play(two(Snooker()), "cue>red1", rest=touching)
    assert match.state.touching
    assert play(match, "cue|").sheets[0].score == 0
    assert play(match, "cue>blue").sheets[0].score == 0
    assert play(match, "cue>red1").sheets[0].score == 4


def test_a_colour_touching_as_reds_are_on_is_no_hit():
    match = play(two(Snooker()), "cue>red1", rest=Rest(touching=(("cue", "blue"),)))
    assert play(match, "cue|").sheets[0].score == 4


@pytest.mark.parametrize(
    ("on", "events", "points"),
    [
        ("red", "cue>black", 7),
        ("red", "cue>red1+pink", 6),
        ("red", "cue>red1 yellow^NE", 4),
        ("red", "cue>red1 black@off", 7),
        ("blue", "cue|", 5),
        ("black", "cue>black cue^NE", 7),
        ("pink", "cue>pink cue:double_hit", 6),
        ("red", "cue>red1 black:touched", 7),
        ("red", "cue>red1 cue:jumps(black)", 4),
        ("red", "yellow:struck_as_cue", 7),
    ],
)
def test_a_foul_costs_the_value_of_the_ball_on_or_concerned_and_4_at_least(on, events, points):
    match = two(Snooker())
    match = replace(match, state=replace(match.state, on=on))
    written = read(events.split())
    assert match.ruled(written.stroke("cue")).gift == points


@pytest.mark.parametrize(
    ("events", "touching", "reason"),
    [
        ("cue>red1 cue^NE blue@off", (), "scratch"),
        ("cue>red1 blue@off", (), "off_table"),
        ("cue>red1 cue:jumps(black)", (), "jumps"),
        ("cue>red1 yellow^NE", (), "ball_not_on"),
        ("cue>red1", (("cue", "red1"),), "touching_moved"),
    ],
)
def test_the_reason_of_a_foul_says_what_was_wrong(events, touching, reason):
    match = two(Snooker())
    match = replace(match, state=replace(match.state, touching=touching))
    assert match.ruled(read(events.split()).stroke("cue")).reason == reason


def test_a_wrong_ball_without_the_option_of_a_miss_is_named_and_so_is_a_snooker_by_the_free_ball():
    match = two(Snooker(miss=False))
    assert match.ruled(read(["cue>blue"]).stroke("cue")).reason == "wrong_ball"
    assert match.ruled(read(["cue|"]).stroke("cue")).reason == "no_ball"
    match = replace(match, state=replace(match.state, free=True), call=Call("brown"))
    done = replace(read(["cue>brown"]).stroke("cue"), rest=Rest(snookered=True, hidden="brown"))
    assert match.ruled(done).reason == "behind_free"


def test_the_last_red_brings_a_colour_and_then_all_in_their_order():
    match = two(Snooker())
    colours = ("yellow", "green", "brown", "blue", "pink", "black")
    match = replace(match, state=replace(match.state, left=("red4", *colours)))
    match = play(match, "cue>red4 red4^NE")
    assert match.state.on == "colour"
    match = play(match, "cue>pink pink^NE", Call("pink"))
    assert (match.state.on, len(match.state.left)) == ("yellow", 6)
    for colour in colours:
        assert match.state.on == colour
        match = play(match, f"cue>{colour} {colour}^NE")
    assert (match.winner, match.sheets[0].score) == (0, 34)


def test_level_scores_bring_the_black_back_and_then_the_next_score_or_foul_ends_it():
    match = two(Snooker())
    sheets = (replace(match.sheet, score=50), replace(match.sheet, score=57))
    state = replace(match.state, left=("black",), on="black")
    match = play(replace(match, sheets=sheets, state=state), "cue>black black^NE")
    assert (match.finished, match.state.left, match.state.region) == (False, ("black",), D)
    match = match.answered("shoot")
    assert play(match, "cue|").winner == 0


def test_what_is_on_the_table_counts_a_black_with_each_red():
    assert remaining(two(Snooker()).state) == 147


# -- pyramid ---------------------------------------------------------------------------------------


def test_any_ball_may_be_played_in_free_pyramid_and_may_drop():
    match = two(Pyramid())
    match = play(match, "7>5 7^NE", Call(cue="7"))
    assert (match.at, match.sheet.score) == (0, 1)
    with pytest.raises(ValueError, match="'7' is not on the table"):
        match.called(Call(cue="7"))


@pytest.mark.parametrize(("kind", "region"), [(DYNAMIC, ANYWHERE), (COMBINED, HOUSE)])
def test_for_the_cue_ball_another_one_is_taken_and_it_is_in_hand(kind, region):
    match = play(two(Pyramid(kind)), "cue>5 cue^NE")
    assert (match.at, match.sheet.score, match.state.region) == (0, 1, region)
    taken = match.answered("5")
    assert (taken.at, "5" in taken.state.left) == (0, False)


def test_a_foul_costs_a_point_or_gives_one_or_a_ball_as_is_agreed():
    assert [s.score for s in play(two(Pyramid()), "cue|").sheets] == [-1, 0]
    assert [s.score for s in play(two(Pyramid(FREE, GIFT)), "cue|").sheets] == [0, 1]
    match = play(two(Pyramid(FREE, TAKE)), "cue|")
    assert ([s.score for s in match.sheets], match.at) == ([0, 1], 1)
    assert "3" not in match.answered("3").state.left


def test_the_last_ball_is_taken_without_asking_and_ends_the_game():
    match = two(Pyramid(COMBINED))
    match = replace(match, state=replace(match.state, left=("5",)))
    match = play(match, "cue>5 cue^NE")
    assert (match.asked, match.winner) == (None, 0)


def test_a_ball_that_drops_on_a_foul_is_spotted():
    match = two(Pyramid())
    verdict = match.ruled(read(["cue^NE", "5^SW"]).stroke("cue"))
    assert verdict.foul
    assert {*verdict.spot} >= {"5"}
    assert "5" in match.after(verdict).state.left


def test_rules_that_do_not_exist_are_refused_by_name():
    with pytest.raises(ValueError, match="kind must be one of"):
        Pyramid("siberian")
    with pytest.raises(ValueError, match="penalty must be one of"):
        Pyramid(FREE, "two")


# -- lag and race ----------------------------------------------------------------------------------


def test_the_lag_is_won_by_the_good_ball_that_is_closer():
    assert winner(Lag(0.1), Lag(0.2)) == 0
    assert winner(Lag(0.1, good=False), Lag(0.2)) == 1
    assert winner(Lag(0.1), Lag(0.1)) is None
    assert winner(Lag(0.1, good=False), Lag(0.1, good=False)) is None


@pytest.mark.parametrize(
    ("events", "good"),
    [
        ("cue|E", True),
        ("cue|E cue|W", True),
        ("cue|W", False),
        ("cue|E cue|W cue|E", False),
        ("cue|N cue|E", False),
        ("cue|E cue^NW", False),
        ("cue|E cue>other", False),
    ],
)
def test_a_lag_meets_the_far_cushion_once_and_no_side(events, good):
    done = read(events.split()).stroke("cue")
    assert lagged(done, 0.1, far="E", near="W").good is good


def test_a_race_ends_at_its_number_and_says_who_breaks():
    race = Race(2).after(0)
    assert (race.won, race.breaker, race.winner) == ((1, 0), 1, None)
    assert race.after(0).winner == 0
    with pytest.raises(ValueError, match="the race is over"):
        race.after(0).after(1)
    assert Race(3, breaks=WINNER).after(1).breaker == 1
    assert Race(3, breaks=LOSER).after(1).breaker == 0
