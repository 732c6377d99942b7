"""What is written beside games with pockets: who gets what, and which balls are down."""

from math import atan2, degrees

import pygame
import pytest

from danggu.rules.verdict import Facts, Verdict
from game.input.captions import words
from game.render import theme
from game.session.action import Action
from game.ui.panels import rack_words, score_plates, shot_panels, tray, warning
from tests.support.players import FRAME, an_app, assert_same_as_anew, press
from tests.support.racked_games import leave, playing


@pytest.mark.parametrize(("lang", "said"), [("en", "4 to Player 2"), ("ko", "선수 2 4점")])
def test_a_foul_names_the_player_to_whom_it_gives_points(lang, said):
    contest = playing("snooker").contest
    assert rack_words.gift(contest, Verdict("miss", foul=True, gift=4), words(lang)) == said


def test_a_foul_says_that_the_ball_is_in_hand():
    session = playing("9-ball")
    leave(session, cue=(-0.5, 0.0), b1=(0.5, 0.0), b9=(0.5, 0.3))
    contest = session.contest
    foul = Verdict("scratch", foul=True, passes=True, state=contest.match.rules.start(2))
    contest._rule(foul, contest.match)
    assert rack_words.facts(contest, foul, words("en"))[-1] == "ball in hand"


def slot(app, name):
    """The picture of a slot of the tray, and its text's colour apart."""
    surface = pygame.Surface((60, 60))
    surface.fill(theme.PANEL)
    tray._slot(surface, app.view.sight, name, (30.0, 30.0), 20.0)
    return surface


def test_the_reds_that_are_down_fill_their_slot_and_none_leave_it_empty():
    app = an_app(size=(1280, 720), game="snooker", table="snooker")
    press(app, "return")
    assert slot(app, "red").get_at((30, 30))[:3] == theme.PANEL
    leave(app.session, cue=(-1.0, 0.0), black=(1.0, 0.0), red1=(0.0, 0.0))
    assert slot(app, "red").get_at((30, 16))[:3] != theme.PANEL


def test_a_set_up_without_reds_has_slots_for_the_balls_that_there_are():
    app = an_app(size=(1280, 720), table="snooker")
    app.perform(Action("line", "danggu1 snooker cue=0.0,0.0 black=1.0,0.3 pink=1.0,-0.3"))
    assert tray.slots(app.session) == ["pink", "black"]
    assert_same_as_anew(app)


def test_the_ring_of_the_black_can_be_seen_on_the_panel():
    app = an_app(size=(1280, 720), game="snooker", table="snooker")
    ring = slot(app, "black").get_at((30, 11))[:3]
    assert max(ring) - max(theme.PANEL) >= 40


def test_a_stroke_that_runs_says_which_balls_are_down_so_far():
    app = an_app(size=(1280, 720), game="snooker", table="snooker")
    press(app, "return")
    session, w = app.session, app.view.sight.words
    leave(session, cue=(0.0, 0.0), red1=(1.4, 0.7), red2=(1.0, 0.0), black=(1.4, -0.2))
    app.perform(Action("play", f"3 0 0 0 {degrees(atan2(0.7, 1.4))}"))
    app.frame(FRAME)
    assert rack_words.so_far(session, w) == ("0", "No ball down")
    assert session.settled is None
    for _ in range(400):
        app.frame(FRAME)
        if not session.world.ball("red1").gone:
            continue
        assert session.moving
        assert rack_words.so_far(session, w) == ("1", "Down: red 1")
        assert shot_panels._result_look(app.view.sight)[:2] == ("1", "Down: red 1")
        return
    raise AssertionError("the red was to drop")


def test_a_foul_that_is_foreseen_is_said_before_the_stroke():
    app = an_app(size=(1280, 720), game="9-ball", table="pool-9")
    press(app, "return")
    leave(app.session, cue=(-0.6, 0.0), b1=(0.3, 0.0), b9=(0.5, 0.3))
    app.perform(Action("set", "speed 0.7 follow 0 masse 0 side 0 angle 0"))
    assert warning.of(app.view.sight) == "Foul: no cushion after"
    app.perform(Action("set", "speed 3"))
    assert warning.of(app.view.sight) == ""


@pytest.mark.parametrize(("off", "said"), [
    (("cue",), "Foul: ball off the table"), ((), "Foul: cue ball down"),
])  # fmt: skip
def test_a_cue_ball_that_left_the_table_is_not_said_to_be_down(off, said):
    foul = Verdict("scratch", foul=True, facts=Facts(off=off))
    assert score_plates.reason(foul, words("en")) == said


def test_a_cue_ball_that_would_leave_the_table_is_said_before_the_stroke():
    app = an_app(size=(1280, 720), game="9-ball", table="pool-9")
    press(app, "return")
    leave(app.session, cue=(0.0, 0.0), b1=(-0.5, 0.3), b9=(-0.5, -0.3))
    app.perform(Action("set", "speed 8 follow 0 masse 0 side 0 angle 20"))
    app.perform(Action("elevate", "55"))
    assert warning.of(app.view.sight) == "The cue ball leaves the table"
