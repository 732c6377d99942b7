"""What is written beside games with pockets: who gets what, and which balls are down."""

import pygame
import pytest

from danggu.rules.verdict import Verdict
from game.input.captions import words
from game.render import theme
from game.ui.panels import rack_words, tray
from tests.support.players import an_app, press
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


def test_the_ring_of_the_black_can_be_seen_on_the_panel():
    app = an_app(size=(1280, 720), game="snooker", table="snooker")
    ring = slot(app, "black").get_at((30, 11))[:3]
    assert max(ring) - max(theme.PANEL) >= 40
