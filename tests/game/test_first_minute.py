"""What a newcomer needs in the first minute: names in the log, pages by one key, a full screen."""

import pygame
import pytest

from game.input.captions import words
from game.session.action import Action
from game.session.terms import Contestant, Terms
from game.ui.halls import goal, handicap
from game.ui.panels.shot_panels import log_rows
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
