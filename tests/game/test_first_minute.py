"""What a newcomer needs in the first minute: names in the log, pages by one key, a full screen."""

from math import pi

import pygame
import pytest

from game.input.captions import words
from game.session.action import Action
from game.session.terms import Contestant, Terms
from game.ui.halls import goal, handicap
from game.ui.panels import launch_card
from game.ui.panels.shot_panels import log_rows
from physics import CueStroke
from tests.support.players import FRAME, an_app, assert_same_as_anew, press

LANGUAGES = pytest.mark.parametrize("language", ["en", "ko"])


@LANGUAGES
def test_every_row_of_the_log_names_its_ball(language):
    app = an_app()
    app.perform(Action("shoot"))
    app.perform(Action("skip"))
    w = words(language)
    rows = log_rows(app.session, w)
    names = [w["ball." + ball.name] for ball in app.session.world.balls]
    assert len(rows) > 4
    assert all(any(name in row.first for name in names) for row in rows)
    second = log_rows(app.session, w, hit="event.hit")
    assert not any(row.first.startswith(tuple(names)) for row in second[1:] if "→" in row.first)


@pytest.mark.parametrize("key", ["f3", "f4", "f5", "f6", "f9", "f10"])
def test_a_page_is_opened_from_the_page_of_keys_by_its_own_key(key):
    app = an_app()
    press(app, key)
    page = app.session.page
    press(app, key, "f1")
    assert (app.session.page, app.session.help) == ("", True)
    press(app, key)
    assert (app.session.page, app.session.help) == (page, False)
    assert_same_as_anew(app)


def test_the_key_of_the_page_below_the_page_of_keys_uncovers_it():
    app = an_app()
    press(app, "f4", "f1", "f4")
    assert (app.session.page, app.session.help) == ("shelf", False)


def test_the_whole_screen_is_filled_and_left_again_for_a_window_as_large_as_before():
    app = an_app((1000, 600))
    desktop = pygame.display.get_desktop_sizes()[0]
    press(app, "f11")
    assert app.screen.get_flags() & pygame.FULLSCREEN
    assert app.screen.get_size() == app.view.sight.layout.size == desktop
    assert app.preferences.settings.size != desktop
    assert_same_as_anew(app)
    press(app, "f4", "f11")
    assert app.session.page == "shelf"
    assert app.screen.get_size() == app.view.sight.layout.size == (1000, 600)
    assert not app.screen.get_flags() & pygame.FULLSCREEN
    app.frame(FRAME)
    assert_same_as_anew(app)


@LANGUAGES
def test_a_handicap_of_four_ball_is_said_as_halls_say_it(language):
    w, seats = words(language), (Contestant(target=15), Contestant())
    assert "150" in goal(Terms("four-ball", seats), 0, w)
    assert handicap(Terms("four-ball", seats), 0, w) != []
    assert goal(Terms("three-cushion", seats, "match"), 0, w) == "15"
    assert handicap(Terms("three-cushion", seats, "match"), 0, w) == []


def read_out(app):
    """What the card of the read-outs says."""
    said = []
    draw = launch_card.cards.readouts
    launch_card.cards.readouts = lambda surface, rect, type_, items: said.append(items) or rect
    try:
        launch_card.draw(app.screen, app.view.sight.layout.readouts, app.view.sight)
    finally:
        launch_card.cards.readouts = draw
    return [(value, unit) for _, value, unit in said[0]]


def test_the_read_outs_say_before_the_stroke_how_the_ball_will_leave():
    app = an_app()
    app.perform(Action("set", "speed 3 follow 0 masse 0 side 1.5 angle 30"))
    assert launch_card.wanted(app.view.sight)
    (speed, _), (spin, _), (squirt, side) = read_out(app)
    ball = app.session.world.ball("white")
    assert speed == "3.00"
    assert float(spin) == pytest.approx(1.5 / (2 * pi * ball.radius), abs=0.05)
    assert squirt == "0.0°"  # as long as squirt is off
    app.perform(Action("squirt", "on"))
    squirt, side = read_out(app)[2]
    # a tip at 0.2 R, right of the centre, drives the ball to the left of the cue's line
    wanted = CueStroke(3.0, side=0.2).squirt
    assert (squirt, side) == (f"{wanted:.1f}°", "left")
    assert wanted > 0.5
    app.perform(Action("shoot"))
    assert not launch_card.wanted(app.view.sight)


def test_the_read_outs_say_how_steeply_a_ball_hops_that_is_driven_into_the_cloth():
    app = an_app()
    for action in (Action("centre"), Action("elevate", "40")):
        app.perform(action)
    assert read_out(app)[2][0].endswith("°")
    assert float(read_out(app)[2][0][:-1]) > 5.0


def test_spins_that_no_cue_gives_have_no_squirt():
    app = an_app()
    app.perform(Action("set", "speed 3 follow 0 masse 4 side 0 angle 30"))
    assert read_out(app)[2][0] == "–"
