"""The computer as a player: it shows what it means to play, and the window goes on answering."""

import random

import pygame
import pytest

from danggu.players import opponent
from game.computer import thinker
from game.session.action import Action
from game.session.commands import perform
from game.ui.panels import score_plates
from tests.support.players import (
    FRAME,
    an_app,
    assert_same_as_anew,
    click,
    enter,
    places,
    press,
    run_to_rest,
    write,
)


@pytest.fixture
def quick(monkeypatch):
    """A computer that does not think for long."""
    monkeypatch.setattr(thinker, "EFFORT", 30)
    monkeypatch.setattr(opponent, "ROUNDS", ((2, 4), (4, 1)))
    monkeypatch.setattr(opponent, "FRESH", 4)


def a_duel(**more):
    app = an_app(game="four-ball", level="club", seed=3, **more)
    press(app, "ctrl+return", "end")
    while app.session.contest.level is None:
        press(app, "return")
        enter(app, "0.3", "0", "0", "0", "180")
        press(app, "return", "end")
    return app


def until(app, happened, frames=2000):
    for _ in range(frames):
        if happened():
            return
        app.frame(FRAME)
    raise AssertionError("it never happened")


def test_the_computer_shows_what_it_intends_and_plays_it(quick):
    app = a_duel()
    session, shots = app.session, app.session.shots
    assert session.shown_shot  # the last stroke can still be looked at
    until(app, lambda: not session.shown_shot)
    until(app, lambda: session.contest.share is not None and not session.contest.thinking)
    intended = list(session.aim.texts)
    assert "as intended" in score_plates._line(app.view.sight, session.contest, 1)[0]
    assert_same_as_anew(app)
    until(app, lambda: session.shots > shots)
    assert session.shooter == "yellow"
    assert session.aim.texts != intended  # it errs
    assert session.moving


@pytest.mark.parametrize("key", ["return", "end", "space"])
def test_the_computers_thinking_can_be_cut_short(key):
    app = a_duel()
    shots = app.session.shots
    app.frame(FRAME)
    press(app, key)
    app.frame(FRAME)
    assert app.session.shots == shots + 1


def test_the_button_cuts_the_computers_thinking_short():
    app = a_duel()
    shots = app.session.shots
    app.frame(FRAME)
    click(app, app.view.sight.layout.shoot.center)
    app.frame(FRAME)
    assert app.session.shots == shots + 1


def test_while_the_computer_thinks_the_window_answers(quick):
    app = a_duel()
    app.frame(FRAME)
    shots = app.session.shots
    press(app, "left", "4", "right")
    assert app.session.aim.box is None
    press(app, "f2")
    assert app.session.language == "ko"
    for key, held in (("f1", "help"), ("f10", "page"), ("f3", "page")):
        press(app, key)
        assert getattr(app.session, held)
        for _ in range(100):
            app.frame(FRAME)
        assert app.session.shots == shots
        press(app, "escape")
    for _ in range(2):  # the first time it is asked about: a match is being played
        assert not app.session.over
        pygame.event.post(pygame.event.Event(pygame.QUIT))
        app.frame(FRAME)
    assert app.session.over


def test_a_frame_of_thinking_is_at_most_one_simulation_longer_than_its_budget(monkeypatch):
    now = [0.0]
    whole = opponent.simulate
    longest = 0.0

    def slow(*args):
        now[0] += 0.0031
        return whole(*args)

    monkeypatch.setattr(opponent, "simulate", slow)
    monkeypatch.setattr(thinker, "perf_counter", lambda: now[0])
    app = a_duel()
    app.thinker.virtual = False
    for _ in range(60):
        begun = now[0]
        app.frame(FRAME)
        longest = max(longest, now[0] - begun)
    assert thinker.BUDGET <= longest < thinker.BUDGET + 0.0031


def test_two_computers_play_each_other_to_the_end(quick):
    app = an_app(game="four-ball", level="expert,novice", handicap="1", finish="none", seed=5)
    session = app.session
    for _ in range(3000):
        if session.contest.match.finished:
            break
        app.frame(10 * FRAME)
    match = session.contest.match
    assert match.finished
    assert match.sheets[match.winner].score == 1


def test_a_match_with_the_computer_replays_from_its_actions_alone(quick):
    app = a_duel()
    session = app.session
    until(app, lambda: session.contest.level is None or session.shots > 2)
    run_to_rest(app)
    again = an_app(game="four-ball", level="club", seed=3).session
    for tick, action in app.actions:
        again.advance(tick - again.tick)
        perform(again, action)
    again.advance(session.tick - again.tick)
    assert places(again) == places(session)
    assert again.contest.match == session.contest.match


def test_undo_goes_back_to_a_persons_turn(quick):
    app = a_duel()
    session = app.session
    strokes = session.contest.match.sheets[0].strokes
    until(app, lambda: session.shots > strokes)
    press(app, "end")
    press(app, "z")
    assert session.contest.level is None
    assert session.contest.match.sheets[1].strokes == 0
    assert session.contest.match.sheets[0].strokes == strokes - 1


def test_random_events_in_a_match_neither_crash_nor_spoil_the_picture(quick):
    rng, app = random.Random(25), an_app(size=(640, 360), game="four-ball", level="novice")
    keys = ["f10", "f4", "f5", "f3", "escape", "return", "tab", "up", "down", "left", "right", "b",
            "end", "space", "r", "z", "y", "n", "pageup", "delete", "backspace", "5", "ctrl+return",
            "ctrl+c", "f2", "f1", "p"]  # fmt: skip
    for k in range(500):
        if k % 25 == 0:
            assert_same_as_anew(app)
        match rng.randrange(4):
            case 0:
                write(app, rng.choice("0123가a.-"))
            case 1:
                click(app, (rng.randrange(960), rng.randrange(540)))
            case _:
                press(app, rng.choice(keys))
        if app.session.over:
            app.session.over = False
    # what the shelf lays is a drill, or a line where it has no goal
    assert {"sheet", "fire", "edit", "drill"} <= {action.name for _, action in app.actions}


def test_the_action_of_terms_that_are_none_is_an_error():
    with pytest.raises(ValueError, match="JSON"):
        perform(an_app().session, Action("match", "{"))
