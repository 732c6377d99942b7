"""What a player finds aimed at, and what is said before a stroke that is a foul for certain."""

import pytest

from game.session.action import Action
from game.session.commands import perform
from game.ui.panels.parts import _hint_look
from tests.support.players import an_app, press
from tests.support.racked_games import RACKED, leave, playing


@pytest.mark.parametrize("game", RACKED)
def test_enter_enter_does_not_begin_a_game_with_a_foul_on_the_wrong_ball(game):
    session = playing(game)
    perform(session, Action("arrange"))
    contact = session.preview.contact
    contest = session.contest
    assert contact.ball in contest.match.rules.targets(contest.match.turn)


@pytest.mark.parametrize(
    ("places", "met"),
    [
        ({"b9": (0.3, 0.3)}, "1"),
        ({"b9": (0.3, 0.04)}, "1"),  # past the 9, which hides the far side
        ({"b9": (0.3, -0.04)}, "1"),
        ({"b9": (0.0, 0.0)}, "9"),  # snookered: no straight way leads to the 1
    ],
)
def test_the_ball_on_is_aimed_at_where_it_can_be_seen(places, met):
    session = playing("9-ball")
    leave(session, cue=(-0.5, 0.0), b1=(0.5, 0.0), **places)
    session.contest.given = False
    session.arranging = False
    perform(session, Action("next"))
    assert session.preview.contact.ball == met


def test_of_several_balls_on_the_nearest_that_is_free_is_aimed_at_in_full():
    session = playing("8-ball")
    leave(session, cue=(-0.5, 0.0), b8=(-0.2, 0.0), b1=(0.1, 0.0), b2=(0.5, 0.4))
    session.contest.given = session.arranging = False
    perform(session, Action("next"))
    contact = session.preview.contact
    assert (contact.ball, abs(contact.overlap)) == ("2", pytest.approx(1.0, abs=1e-3))


def the_hint(app):
    return _hint_look(app.view.sight)


def shown(**places):
    """An app of 9-ball at its second stroke, aimed along the table."""
    app = an_app(size=(1280, 720), game="9-ball", table="pool-9")
    press(app, "return")
    leave(app.session, **places)
    app.session.arranging = False
    app.perform(Action("next"))
    return app


def test_a_ball_that_is_not_on_is_named_before_the_shot():
    app = shown(cue=(-0.5, 0.0), b1=(0.5, 0.3), b9=(0.5, 0.0))
    app.perform(Action("set", "speed 2 angle 0"))
    assert the_hint(app) == ("Not on: ball 9 would be hit first", False, True)
    app.perform(Action("set", "speed 0.3 angle 180"))
    assert the_hint(app)[0] == "No ball is hit"
    app.perform(Action("set", "angle 16.7"))
    app.perform(Action("set", "speed 2"))
    assert not the_hint(app)[2]


def test_a_cue_ball_that_goes_down_is_said_before_the_shot():
    app = shown(cue=(1.0, 0.365), b1=(1.15, 0.515), b9=(-0.5, 0.0))
    app.perform(Action("set", "speed 3 follow 3 masse 0 side 0 angle 45"))
    assert the_hint(app) == ("The cue ball goes down, far right", False, True)
    app.perform(Action("aids", "off"))
    assert not the_hint(app)[2]
