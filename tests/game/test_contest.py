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
from game.input.captions import words
from game.session import terms
from game.session.action import Action
from game.session.commands import perform
from game.session.running_match import Contest
from game.session.session import Notice, Session
from game.session.terms import FOUR_BALL, Contestant, Terms
from game.table import presets
from game.text import LANGUAGES
from game.ui.panels.score_plates import reason

TWO = (Contestant("Ann"), Contestant("Bo"))
ONE_POINT = (Contestant("Ann", target=1), Contestant("Bo", target=3))


def a_match(game=FOUR_BALL, seats=TWO, **rules):
    table = "match" if game == "three-cushion" else "medium"
    found = Session(presets.table_world("medium"))
    perform(found, Action("match", Terms(game, seats, table, **rules).line()))
    return found


def stroke(session, *, speed=0.0, follow=0.0, side=0.0, angle=0.0):
    """Play a stroke to its end."""
    perform(session, Action("next"))
    numbers = f"speed {speed} follow {follow} masse 0 side {side} angle {angle}"
    perform(session, Action("set", numbers))
    perform(session, Action("shoot"))
    assert session.moving
    perform(session, Action("skip"))
    return session.contest.verdict


def answer(session):
    """Play the opening stroke that the shelf knows."""
    kind = "sagu" if "red1" in session.contest.match.rules.balls else "three_cushion"
    angle, speed, right, up = opening(kind).answer
    turn = 2.5 * speed
    return stroke(session, speed=speed, follow=turn * up, side=turn * right, angle=angle)


def lay(session, **places):
    """Lay balls down in the middle of a match, as only a test may."""
    world = session.world
    session.lay([places.get(ball.name, ball.position) for ball in world.balls])


def test_both_reds_count_a_point_and_the_same_player_goes_on():
    session = a_match()
    verdict = answer(session)
    assert (verdict.reason, verdict.points) == ("both_reds", 1)
    match = session.contest.match
    assert (match.at, match.run, match.sheets[0].score) == (0, 1, 1)
    assert session.cue == "white"


def test_a_miss_gives_the_turn_and_the_other_cue_ball():
    session = a_match()
    verdict = stroke(session, speed=0.5, angle=90.0)
    assert (verdict.reason, verdict.points) == ("one_red", 0)
    assert session.contest.match.at == 1
    assert session.cue == "yellow"
    assert session.shooter == "white"
    assert "yellow" in {lane.name for lane in session.preview.story.lanes if lane.legs}


def test_the_next_player_finds_the_aim_on_a_ball_that_may_be_hit_first():
    session = a_match()
    stroke(session, speed=0.5, angle=90.0)
    perform(session, Action("next"))
    assert session.preview.contact.ball in ("red1", "red2")
    assert abs(session.preview.contact.overlap) > 0.97
    session = a_match("three-cushion")
    assert session.preview.contact.ball == "red"


def test_hitting_nothing_and_hitting_the_opponents_ball_are_fouls():
    session = a_match()
    assert stroke(session, speed=0.3, angle=180.0).reason == "no_red"
    assert session.contest.match.sheets[0].fouls == 1
    assert session.contest.match.sheets[0].score == 0
    lay(session, yellow=(0.3, 0.3), white=(0.6, 0.3))
    assert stroke(session, speed=1.0, angle=0.0).reason == "opponent_ball"
    assert session.contest.match.at == 0


def test_a_foul_costs_points_down_to_zero_or_below_it():
    session = a_match(floor=False, penalty=2)
    stroke(session, speed=0.3, angle=180.0)
    assert session.contest.match.sheets[0].score == -2


def test_at_the_target_the_match_is_won_and_nobody_may_strike():
    session = a_match(seats=ONE_POINT, finish="none")
    assert answer(session).won
    assert session.contest.match.winner == 0
    before = [ball.position for ball in session.world.balls]
    perform(session, Action("next"))
    perform(session, Action("fire"))
    assert session.notice == Notice("refused.over", error=True)
    assert [ball.position for ball in session.world.balls] == before


def test_the_last_point_needs_three_cushions_where_that_is_the_rule():
    session = a_match(seats=ONE_POINT, finish="last_point_3c")
    assert session.contest.closing == 3
    verdict = answer(session)
    assert verdict.facts.cushions < 3
    assert verdict.reason == "few_cushions"
    assert session.contest.match.winner is None


def test_after_the_target_one_more_stroke_off_three_cushions_is_needed():
    session = a_match(seats=ONE_POINT)
    assert session.contest.closing == 0
    answer(session)
    assert session.contest.match.sheets[0].score == 1
    assert session.contest.match.winner is None
    assert session.contest.closing == 3


def test_the_opening_of_three_cushion_scores_off_the_red():
    session = a_match("three-cushion")
    assert session.table == "match"
    assert len(session.world.balls) == 3
    verdict = answer(session)
    assert (verdict.reason, verdict.points) == ("cannon", 1)
    assert verdict.facts.cushions >= 3


def test_the_opening_of_three_cushion_must_hit_the_red_first():
    session = a_match("three-cushion")
    white, yellow = (session.world.ball(n).position for n in ("white", "yellow"))
    assert yellow[0] == pytest.approx(white[0])
    assert stroke(session, speed=1.0, angle=90.0).reason == "opening_not_red"
    session = a_match("three-cushion", red_first=False)
    assert stroke(session, speed=1.0, angle=90.0).reason == "one_ball"


def test_rules_read_nothing_but_the_events_of_the_stroke():
    session = a_match()
    answer(session)
    contacts = list(session.world.log.contacts())
    assert session.contest.terms.match().judged(contacts) == session.contest.verdict


def test_a_stroke_counts_alike_under_fixed_steps():
    session = a_match()
    perform(session, Action("engine", "thesis"))
    assert stroke(session, speed=0.5, angle=90.0).reason == "one_red"
    assert session.contest.match.at == 1


def test_a_stroke_while_balls_move_is_refused_in_a_match():
    session = a_match()
    perform(session, Action("fire"))
    session.advance(6000)
    perform(session, Action("fire"))
    assert session.shots == 1
    assert session.notice == Notice("refused.moving", error=True)


def test_stopping_the_balls_of_a_match_lets_the_stroke_go_on_to_its_end():
    session, again = a_match(), a_match()
    for one, action in ((session, "stop"), (again, "skip")):
        perform(one, Action("fire"))
        one.advance(3000)
        perform(one, Action(action))
    assert not session.moving
    ends = [[ball.position for ball in one.world.balls] for one in (session, again)]
    assert ends[0] == ends[1]
    assert session.contest.verdict == again.contest.verdict is not None


def test_balls_of_a_match_are_neither_placed_by_hand_nor_at_random():
    session = a_match()
    before = [ball.position for ball in session.world.balls]
    for name in ("place", "arrange"):
        perform(session, Action(name))
        assert session.notice == Notice("refused.match", error=True)
    assert [ball.position for ball in session.world.balls] == before
    assert not session.arranging


def test_undo_gives_back_score_turn_and_cue_ball_and_redo_takes_them_again():
    session = a_match()
    begun = session.contest.snapshot()
    answer(session)
    one = session.contest.snapshot()
    stroke(session, speed=0.3, angle=180.0)
    two = session.contest.snapshot()
    assert two.match.at == 1
    perform(session, Action("undo"))
    assert session.contest.snapshot() == one
    assert session.cue == "white"
    perform(session, Action("undo"))
    assert session.contest.snapshot() == begun
    perform(session, Action("redo"))
    assert session.contest.match == one.match
    perform(session, Action("redo"))
    assert session.contest.match == two.match
    assert session.cue == "yellow"


def test_retry_takes_the_stroke_back_with_its_numbers():
    session = a_match()
    begun = session.contest.snapshot()
    verdict = answer(session)
    perform(session, Action("retry"))
    assert session.contest.snapshot() == begun
    perform(session, Action("shoot"))
    perform(session, Action("skip"))
    again = session.contest.verdict
    assert (again.reason, again.facts.path) == (verdict.reason, verdict.facts.path)


def test_a_retry_while_balls_move_is_no_stroke():
    session = a_match()
    begun = session.contest.snapshot()
    perform(session, Action("fire"))
    session.advance(3000)
    perform(session, Action("retry"))
    assert session.contest.snapshot() == begun
    assert not session.contest.pending


def test_each_player_finds_the_own_speed_and_spins_again():
    session = a_match()
    stroke(session, speed=0.5, follow=0.25, angle=90.0)
    stroke(session, speed=0.7, side=0.5, angle=0.0)
    assert session.contest.match.at == 0
    perform(session, Action("next"))
    assert session.aim.texts[:4] == ["0.5", "0.25", "0", "0"]


def test_another_table_or_a_set_up_ends_the_match():
    session = a_match()
    perform(session, Action("table", "thesis"))
    assert session.contest is None
    session = a_match()
    perform(session, Action("scene", "single"))
    assert session.contest is None


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


# -- terms ---------------------------------------------------------------------------------------


def test_terms_are_read_back_as_they_were_written():
    seats = (Contestant("김 사구", "expert", 25), Contestant("", "human", 3))
    one = Terms("three-cushion", seats, "match", "worn", "thesis", bank=2, red_first=False)
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
def test_terms_that_cannot_be_played_say_why(line, blamed):
    with pytest.raises(ValueError, match=blamed):
        terms.read(line)


def test_all_terms_of_the_menu_begin():
    for name in terms.GAMES:
        for table in terms.DISCIPLINES[name].tables or presets.TABLES:
            for cloth in presets.CLOTHS if table in presets.CAROM else ("table", "new"):
                session = Session(presets.table_world("medium"))
                perform(session, Action("match", Terms(name, table=table, cloth=cloth).line()))
                assert session.table == table
                assert session.cloth == cloth
                assert (session.contest is None) == (name == "free")


# -- the command line ----------------------------------------------------------------------------


def begun(*arguments):
    return new_game(options.read(list(arguments)))


def test_the_command_line_begins_a_match():
    session = begun("--game", "three-cushion", "--players", "Ann,Bo", "--handicap", "7,5")
    assert [p.name for p in session.contest.match.players] == ["Ann", "Bo"]
    assert [p.target for p in session.contest.match.players] == [7, 5]
    assert session.table == "match"
    session = begun(
        "--game", "four-ball", "--players", "1", "--finish", "none", "--table", "thesis"
    )
    assert len(session.contest.match.players) == 1
    assert (session.table, session.contest.terms.finish) == ("thesis", "none")
    session = begun("--game", "four-ball", "--level", "master")
    assert [seat.level for seat in session.contest.terms.seats] == ["human", "master"]


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
    session = begun("--setup", "danggu1 thesis white=0.25,-0.5")
    assert session.world.ball("white").position == (0.25, -0.5)
    assert session.table == "thesis"
    with pytest.raises(ValueError, match="table"):
        begun("--setup", "danggu1 moon white=0,0")


def test_the_free_table_has_no_contest():
    assert Contest.of(Terms()) is None
    with pytest.raises(ValueError, match="no rules"):
        _ = Terms().rules
    assert json.loads(replace(Terms(), penalty=0).line())["penalty"] == 0
