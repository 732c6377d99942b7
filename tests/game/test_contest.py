"""A match at the table: strokes are judged from the log, turns change, and all can be undone."""

import json
from dataclasses import replace

import pytest

from danggu.players.positions import opening
from danggu.rules import carom, free, sagu
from danggu.rules import verdict as verdicts
from danggu.rules.verdict import Verdict
from game import options
from game.__main__ import new_game
from game.session import terms
from game.session.action import Action
from game.session.running_match import Contest
from game.session.session import Game, Notice
from game.session.terms import FOUR_BALL, Fixture, Seat
from game.table import presets
from game.text import LANGUAGES, words
from game.ui.panels.score_plates import reason

TWO = (Seat("Ann"), Seat("Bo"))
ONE_POINT = (Seat("Ann", target=1), Seat("Bo", target=3))


def a_match(game=FOUR_BALL, seats=TWO, **rules):
    table = "match" if game == "three-cushion" else "medium"
    found = Game(presets.table_world("medium"))
    found.perform(Action("match", Fixture(game, seats, table, **rules).line()))
    return found


def stroke(game, *, speed=0.0, follow=0.0, side=0.0, angle=0.0):
    """Play a stroke to its end."""
    game.perform(Action("next"))
    numbers = f"speed {speed} follow {follow} masse 0 side {side} angle {angle}"
    game.perform(Action("set", numbers))
    game.perform(Action("shoot"))
    assert game.moving
    game.perform(Action("skip"))
    return game.contest.verdict


def answer(game):
    """Play the opening stroke that the shelf knows."""
    kind = "sagu" if "red1" in game.contest.match.rules.balls else "three_cushion"
    angle, speed, right, up = opening(kind).answer
    turn = 2.5 * speed
    return stroke(game, speed=speed, follow=turn * up, side=turn * right, angle=angle)


def lay(game, **places):
    """Lay balls down in the middle of a match, as only a test may."""
    world = game.world
    game.lay([places.get(ball.name, ball.position) for ball in world.balls])


def test_both_reds_count_a_point_and_the_same_player_goes_on():
    game = a_match()
    verdict = answer(game)
    assert (verdict.reason, verdict.points) == ("both_reds", 1)
    match = game.contest.match
    assert (match.at, match.run, match.sheets[0].score) == (0, 1, 1)
    assert game.cue == "white"


def test_a_miss_gives_the_turn_and_the_other_cue_ball():
    game = a_match()
    verdict = stroke(game, speed=0.5, angle=90.0)
    assert (verdict.reason, verdict.points) == ("one_red", 0)
    assert game.contest.match.at == 1
    assert game.cue == "yellow"
    assert game.shooter == "white"
    assert "yellow" in {lane.name for lane in game.preview.story.lanes if lane.legs}


def test_the_next_player_finds_the_aim_on_a_ball_that_may_be_hit_first():
    game = a_match()
    stroke(game, speed=0.5, angle=90.0)
    game.perform(Action("next"))
    assert game.preview.contact.ball in ("red1", "red2")
    assert abs(game.preview.contact.overlap) > 0.97
    game = a_match("three-cushion")
    assert game.preview.contact.ball == "red"


def test_hitting_nothing_and_hitting_the_opponents_ball_are_fouls():
    game = a_match()
    assert stroke(game, speed=0.3, angle=180.0).reason == "no_red"
    assert game.contest.match.sheets[0].fouls == 1
    assert game.contest.match.sheets[0].score == 0
    lay(game, yellow=(0.3, 0.3), white=(0.6, 0.3))
    assert stroke(game, speed=1.0, angle=0.0).reason == "opponent_ball"
    assert game.contest.match.at == 0


def test_a_foul_costs_points_down_to_zero_or_below_it():
    game = a_match(floor=False, penalty=2)
    stroke(game, speed=0.3, angle=180.0)
    assert game.contest.match.sheets[0].score == -2


def test_at_the_target_the_match_is_won_and_nobody_may_strike():
    game = a_match(seats=ONE_POINT, finish="none")
    assert answer(game).won
    assert game.contest.match.winner == 0
    before = [ball.position for ball in game.world.balls]
    game.perform(Action("next"))
    game.perform(Action("fire"))
    assert game.notice == Notice("refused.over", error=True)
    assert [ball.position for ball in game.world.balls] == before


def test_the_last_point_needs_three_cushions_where_that_is_the_rule():
    game = a_match(seats=ONE_POINT, finish="last_point_3c")
    assert game.contest.closing == 3
    verdict = answer(game)
    assert verdict.facts.cushions < 3
    assert verdict.reason == "few_cushions"
    assert game.contest.match.winner is None


def test_after_the_target_one_more_stroke_off_three_cushions_is_needed():
    game = a_match(seats=ONE_POINT)
    assert game.contest.closing == 0
    answer(game)
    assert game.contest.match.sheets[0].score == 1
    assert game.contest.match.winner is None
    assert game.contest.closing == 3


def test_the_opening_of_three_cushion_scores_off_the_red():
    game = a_match("three-cushion")
    assert game.table == "match"
    assert len(game.world.balls) == 3
    verdict = answer(game)
    assert (verdict.reason, verdict.points) == ("cannon", 1)
    assert verdict.facts.cushions >= 3


def test_the_opening_of_three_cushion_must_hit_the_red_first():
    game = a_match("three-cushion")
    white, yellow = (game.world.ball(n).position for n in ("white", "yellow"))
    assert yellow[0] == pytest.approx(white[0])
    assert stroke(game, speed=1.0, angle=90.0).reason == "opening_not_red"
    game = a_match("three-cushion", red_first=False)
    assert stroke(game, speed=1.0, angle=90.0).reason == "one_ball"


def test_rules_read_nothing_but_the_events_of_the_stroke():
    game = a_match()
    answer(game)
    contacts = list(game.world.log.contacts())
    assert game.contest.fixture.match().judged(contacts) == game.contest.verdict


def test_a_stroke_counts_alike_under_fixed_steps():
    game = a_match()
    game.perform(Action("engine", "thesis"))
    assert stroke(game, speed=0.5, angle=90.0).reason == "one_red"
    assert game.contest.match.at == 1


def test_a_stroke_while_balls_move_is_refused_in_a_match():
    game = a_match()
    game.perform(Action("fire"))
    game.advance(6000)
    game.perform(Action("fire"))
    assert game.shots == 1
    assert game.notice == Notice("refused.moving", error=True)


def test_stopping_the_balls_of_a_match_lets_the_stroke_go_on_to_its_end():
    game, again = a_match(), a_match()
    for one, action in ((game, "stop"), (again, "skip")):
        one.perform(Action("fire"))
        one.advance(3000)
        one.perform(Action(action))
    assert not game.moving
    ends = [[ball.position for ball in one.world.balls] for one in (game, again)]
    assert ends[0] == ends[1]
    assert game.contest.verdict == again.contest.verdict is not None


def test_balls_of_a_match_are_neither_placed_by_hand_nor_at_random():
    game = a_match()
    before = [ball.position for ball in game.world.balls]
    for name in ("place", "arrange"):
        game.perform(Action(name))
        assert game.notice == Notice("refused.match", error=True)
    assert [ball.position for ball in game.world.balls] == before
    assert not game.arranging


def test_undo_gives_back_score_turn_and_cue_ball_and_redo_takes_them_again():
    game = a_match()
    begun = game.contest.snapshot()
    answer(game)
    one = game.contest.snapshot()
    stroke(game, speed=0.3, angle=180.0)
    two = game.contest.snapshot()
    assert two.match.at == 1
    game.perform(Action("undo"))
    assert game.contest.snapshot() == one
    assert game.cue == "white"
    game.perform(Action("undo"))
    assert game.contest.snapshot() == begun
    game.perform(Action("redo"))
    assert game.contest.match == one.match
    game.perform(Action("redo"))
    assert game.contest.match == two.match
    assert game.cue == "yellow"


def test_retry_takes_the_stroke_back_with_its_numbers():
    game = a_match()
    begun = game.contest.snapshot()
    verdict = answer(game)
    game.perform(Action("retry"))
    assert game.contest.snapshot() == begun
    game.perform(Action("shoot"))
    game.perform(Action("skip"))
    again = game.contest.verdict
    assert (again.reason, again.facts.path) == (verdict.reason, verdict.facts.path)


def test_a_retry_while_balls_move_is_no_stroke():
    game = a_match()
    begun = game.contest.snapshot()
    game.perform(Action("fire"))
    game.advance(3000)
    game.perform(Action("retry"))
    assert game.contest.snapshot() == begun
    assert not game.contest.pending


def test_each_player_finds_the_own_speed_and_spins_again():
    game = a_match()
    stroke(game, speed=0.5, follow=0.25, angle=90.0)
    stroke(game, speed=0.7, side=0.5, angle=0.0)
    assert game.contest.match.at == 0
    game.perform(Action("next"))
    assert game.aim.texts[:4] == ["0.5", "0.25", "0", "0"]


def test_another_table_or_a_set_up_ends_the_match():
    game = a_match()
    game.perform(Action("table", "thesis"))
    assert game.contest is None
    game = a_match()
    game.perform(Action("scene", "single"))
    assert game.contest is None


REASONS = [
    *(value for name, value in vars(verdicts).items() if name.isupper() and isinstance(value, str)),
    *(sagu.BOTH_REDS, sagu.BOTH_REDS_3C, sagu.ONE_RED, sagu.NO_RED, sagu.OPPONENT_BALL),
    *(carom.CANNON, carom.BANK, carom.OPENING_NOT_RED, free.FREE),
]


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.parametrize("why", REASONS)
def test_every_reason_is_said_in_both_languages_with_its_number(why, language):
    said = reason(Verdict(why, facts=verdicts.Facts(cushions=2)), words(language))
    assert said
    assert "{" not in said


# -- fixtures ------------------------------------------------------------------------------------


def test_a_fixture_is_read_back_as_it_was_written():
    seats = (Seat("김 사구", "expert", 25), Seat("", "human", 3))
    one = Fixture("three-cushion", seats, "match", "worn", "thesis", bank=2, red_first=False)
    assert terms.read(one.line()) == one
    assert "\n" not in one.line()


WRONG = [
    ("{", "JSON"),
    ("[]", "object"),
    ('{"game":"chess"}', "chess"),
    ('{"seats":[]}', "1 or 2"),
    ('{"seats":7}', "seats"),
    ('{"seats":[{"target":0}]}', "handicap"),
    ('{"seats":[{"target":true}]}', "handicap"),
    ('{"seats":[{"level":"god"}]}', "god"),
    ('{"seats":[{"shoes":1}]}', "shoes"),
    ('{"seats":[{"name":"' + "x" * 17 + '"}]}', "name"),
    ('{"cloth":"silk"}', "silk"),
    ('{"time":3}', "time"),
    ('{"penalty":9}', "penalty"),
]


@pytest.mark.parametrize(("line", "blamed"), WRONG)
def test_a_fixture_that_cannot_be_played_says_why(line, blamed):
    with pytest.raises(ValueError, match=blamed):
        terms.read(line)


def test_every_fixture_of_the_menu_begins():
    for name in terms.GAMES:
        for table in presets.TABLES:
            for cloth in presets.CLOTHS:
                game = Game(presets.table_world("medium"))
                game.perform(Action("match", Fixture(name, table=table, cloth=cloth).line()))
                assert game.table == table
                assert game.cloth == cloth
                assert (game.contest is None) == (name == "free")


# -- the command line ----------------------------------------------------------------------------


def begun(*arguments):
    return new_game(options.read(list(arguments)))


def test_the_command_line_begins_a_match():
    game = begun("--game", "three-cushion", "--players", "Ann,Bo", "--handicap", "7,5")
    assert [p.name for p in game.contest.match.players] == ["Ann", "Bo"]
    assert [p.target for p in game.contest.match.players] == [7, 5]
    assert game.table == "match"
    game = begun("--game", "four-ball", "--players", "1", "--finish", "none", "--table", "thesis")
    assert len(game.contest.match.players) == 1
    assert (game.table, game.contest.fixture.finish) == ("thesis", "none")
    game = begun("--game", "four-ball", "--level", "master")
    assert [seat.level for seat in game.contest.fixture.seats] == ["human", "master"]


REFUSED = [
    (["--level", "god"], "god"),
    (["--handicap", "x"], "handicap"),
    (["--handicap", "0"], "handicap is 1 to"),
    (["--players", "3"], "1 or 2, not 3"),
    (["--players", "a,b,c"], "players"),
    (["--players", "1", "--level", "club,club"], "players"),
]


@pytest.mark.parametrize(("arguments", "blamed"), REFUSED)
def test_the_command_line_refuses_players_that_there_are_not(arguments, blamed):
    with pytest.raises(ValueError, match=blamed):
        begun("--game", "four-ball", *arguments)


@pytest.mark.parametrize(
    ("arguments", "blamed"),
    [
        ("--level club", "--level club: needs --game four-ball or three-cushion"),
        ("--game free --players Ann", "--players Ann: needs --game"),
        ("--handicap 5 --level club", "--handicap 5 and --level club: needs --game"),
        ("--game three-cushion --finish none", "--finish none: needs --game four-ball"),
    ],
)
def test_what_only_a_match_can_use_is_refused_without_one(capsys, arguments, blamed):
    with pytest.raises(SystemExit) as stop:
        options.read(arguments.split())
    assert stop.value.code == 2
    assert blamed in capsys.readouterr().err


def test_a_set_up_on_the_command_line_lies_on_the_table():
    game = begun("--setup", "danggu1 thesis white=0.25,-0.5")
    assert game.world.ball("white").position == (0.25, -0.5)
    assert game.table == "thesis"
    with pytest.raises(ValueError, match="table"):
        begun("--setup", "danggu1 moon white=0,0")


def test_the_free_table_has_no_contest():
    assert Contest.of(Fixture()) is None
    with pytest.raises(ValueError, match="no rules"):
        _ = Fixture().rules
    assert json.loads(replace(Fixture(), penalty=0).line())["penalty"] == 0
