"""With squirt the cue stays where it points while the tip moves, and the ball leaves its line."""

from math import radians

import pytest

from game.aim.tip import LIMIT, squirt
from game.render.parts import cue_card
from game.replay.game_record import read
from game.replay.recorder import Recorder
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.settings.settings import Settings
from game.start import greet
from game.table import presets
from game.ui.table import cue_pose
from physics import CueStroke
from tests.support.players import an_app, assert_same_as_anew, click, press


def session_with(*steps):
    session = Session(presets.table_world("match"), table="match")
    for step in ("centre", "set speed 3 angle 30", *steps):
        name, _, value = step.partition(" ")
        perform(session, Action(name, value or None))
    return session


def angle(session):
    return session.aim.angle


def test_it_is_off_until_it_is_chosen_and_then_a_tip_at_the_right_sends_the_ball_to_the_left():
    assert angle(session_with("tip 0.3 0")) == 30.0
    session = session_with("squirt on", "tip 0.3 0")
    assert angle(session) == pytest.approx(30.0 + CueStroke(1.0, side=0.3).squirt, abs=1e-4)
    assert angle(session) > 30.0
    assert session.aim.cue_angle == pytest.approx(30.0, abs=1e-4)
    assert angle(session_with("squirt on", "tip -0.3 0")) < 30.0


def test_the_cue_is_drawn_along_its_own_line():
    session = session_with("squirt on", "tip 0.3 0")
    assert cue_pose.pose(session, False).angle == pytest.approx(radians(30.0), abs=1e-5)


@pytest.mark.parametrize("way", ["centre", "tip 0 0.2", "nudge -0.3 0"])
def test_the_tip_in_the_middle_again_gives_the_cue_s_direction_back(way):
    assert angle(session_with("squirt on", "tip 0.3 0", way)) == pytest.approx(30.0, abs=2e-4)


def test_power_and_elevation_leave_the_direction_alone():
    session = session_with("squirt on", "tip 0.3 0")
    before = angle(session)
    for step in ("power 5", "elevate 30", "elevate 0"):
        name, value = step.split()
        perform(session, Action(name, value))
        assert angle(session) == before


def test_a_tip_beyond_the_ring_squirts_as_at_the_ring():
    assert squirt(0.9) == squirt(LIMIT) > 0.0


def test_it_is_switched_by_a_key_and_on_the_card_and_stays_on_another_table():
    app = an_app(size=(1280, 720))
    press(app, "j")
    assert app.session.aim.squirts
    assert_same_as_anew(app)
    click(app, cue_card.corner(app.view.sight.layout.tip, app.view.sight.layout.s).center)
    assert not app.session.aim.squirts
    press(app, "j")
    app.perform(Action("table", "pool-9"))
    assert app.session.aim.squirts
    assert app.preferences.settings.squirt == "on"


def test_a_record_of_a_game_with_squirt_comes_out_the_same(tmp_path):
    path = tmp_path / "record"
    app = an_app(size=(1280, 720))
    app.preferences.settings = Settings(squirt="on")
    app.journal = Recorder(str(path), app.options, app.session)
    greet(app)
    app.perform(Action("tip", "0.3 0"))
    app.perform(Action("fire"))
    texts = list(app.session.aim.texts)
    app.journal.close()
    names = [action.name for _, action in read(str(path), app.options).actions]
    assert names == ["squirt", "tip", "fire"]
    session = Session(presets.table_world("medium"), table="medium")
    for _, action in read(str(path), app.options).actions:
        perform(session, action)
    assert session.aim.texts == texts
