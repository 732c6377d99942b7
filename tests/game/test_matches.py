"""An inning in the window: by keyboard alone, by mouse alone, and what plates and card tell."""

from math import cos, radians, sin

import pygame

from danggu.players.positions import opening
from game.input.captions import words
from game.render.parts.gauges import tip_circle
from game.session.action import Action
from game.ui.panels import prompts, score_plates, shot_panels
from game.ui.panels.parts import hint
from tests.support.matches import choose, menu_button, opening_numbers, scores, told
from tests.support.players import (
    FRAME,
    an_app,
    assert_same_as_anew,
    click,
    enter,
    press,
    run_to_rest,
)


def test_an_inning_of_4_ball_by_keyboard_alone():
    app = an_app()
    press(app, "f10", "right", *["tab"] * len(app.view.pages["menu"].rows))
    while app.view.page.row is not None:
        press(app, "down")
    press(app, "return")
    assert app.session.contest is not None
    enter(app, *opening_numbers())
    press(app, "return")
    assert prompts.hint(app.session) == "hint.rolling"
    run_to_rest(app)
    assert scores(app) == [1, 0]
    assert told(app) == ("+1", "Both reds, 2 cushions", "count 1 of 10 · run 1")
    assert_same_as_anew(app)
    press(app, "return")
    assert not app.session.shown_shot
    enter(app, "0.4", "0", "0", "0", "180")
    press(app, "return")
    run_to_rest(app)
    assert told(app) == ("−1", "Foul: no red", "turn passes")
    match = app.session.contest.match
    assert (match.at, match.cue, app.session.cue) == (1, "yellow", "yellow")
    assert match.sheets[0].innings == 1
    assert match.sheets[0].best == 1
    press(app, "return", "return")
    assert app.session.moving
    assert app.session.shooter == "yellow"


def test_an_inning_of_4_ball_by_mouse_alone():
    app = an_app(size=(1280, 720))
    layout = app.view.sight.layout
    click(app, layout.engine.move(-64, -11).midright)
    choose(app, "game")
    click(app, menu_button(app, "start"))
    layout, session = app.view.sight.layout, app.session
    (x, y), radius = tip_circle(layout.tip, layout.s)
    click(app, (x, y - 0.34 * radius))
    white = session.world.ball("white").position
    for off in range(12):  # as a person does: turn the aim until the preview shows the point
        angle = radians(5.0 + 0.12 * off)
        far = layout.to_screen(white[0] + 1.6 * cos(angle), white[1] + 1.6 * sin(angle))
        click(app, far)
        story = session.preview.story
        met = [b for e in story.events if e.kind == "ball" and "white" in e.balls for b in e.balls]
        if {"red1", "red2"} <= {*met} and "yellow" not in met:
            break
    click(app, layout.shoot.center)
    assert session.moving
    click(app, layout.shoot.center)  # to the end
    assert not session.moving
    assert session.contest.match.sheets[0].score == 1
    assert told(app)[0] == "+1"
    click(app, layout.shoot.center)  # the next turn
    assert not session.shown_shot
    at = layout.to_screen(*session.world.ball("white").position)
    click(app, (at[0] - 60, at[1]))
    click(app, layout.power.midleft)
    click(app, layout.shoot.center)
    click(app, layout.shoot.center)
    assert session.contest.match.at == 1
    assert session.cue == "yellow"


def shown(app):
    """Badge and first line of the result card."""
    return shot_panels._result_look(app.view.sight)[:2]


def when(app, happened):
    """Let time pass frame by frame until something has happened; the balls still roll then."""
    while not happened():
        assert app.session.moving
        app.frame(FRAME)
    assert app.session.moving


def test_a_cannon_shows_on_the_card_as_soon_as_the_second_ball_is_hit():
    app = an_app(game="three-cushion", table="match")
    angle, speed, right, up = opening("three_cushion").answer
    turn = 2.5 * speed
    numbers = f"speed {speed} follow {turn * up} masse 0 side {turn * right} angle {angle}"
    app.perform(Action("set", numbers))
    app.perform(Action("shoot"))
    when(app, lambda: app.session.counts[0] == 1)
    assert shown(app) == ("1", "One ball met")
    when(app, lambda: app.session.counts[0] == 2)
    early = shown(app)
    assert early[0] == "+1"
    assert scores(app) == [0, 0]
    assert_same_as_anew(app)
    run_to_rest(app)
    assert told(app)[:2] == early
    assert scores(app) == [1, 0]


def test_a_foul_of_4_ball_shows_at_once_and_a_point_when_it_cannot_be_lost_any_more():
    app = an_app(game="four-ball")
    enter(app, *opening_numbers())
    press(app, "return")
    when(app, lambda: app.session.counts[0] == 2)
    assert shown(app) == ("2", "2 balls met")  # the yellow one may still be hit
    run_to_rest(app)
    assert shown(app)[0] == "+1"
    app.session.lay([(0.6, 0.3), (0.9, 0.3), (-0.6, 0.3), (-0.6, -0.3)])
    press(app, "return")
    enter(app, "1", "0", "0", "0", "0")
    press(app, "return")
    when(app, lambda: app.session.counts[0] == 1)
    assert shown(app) == ("−1", "Foul: opponent's ball")
    run_to_rest(app)
    assert told(app)[:2] == ("−1", "Foul: opponent's ball")


def test_the_plates_show_turn_score_and_the_last_point():
    app = an_app(game="four-ball", handicap="1", finish="last_point_3c")
    contest, sight = app.session.contest, app.view.sight
    assert score_plates._line(sight, contest, 0)[0] == "Last point: three cushions"
    before = app.screen.subsurface(sight.layout.score[0]).copy()
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert told(app)[1] == "Only 2 of 3 cushions"
    assert contest.match.at == 1
    after = app.screen.subsurface(sight.layout.score[0])
    assert pygame.image.tobytes(before, "RGB") != pygame.image.tobytes(after, "RGB")


def test_a_handicap_reached_wins_and_the_window_says_so():
    app = an_app(game="four-ball", players="Ann,Bo", handicap="1", finish="none")
    enter(app, *opening_numbers())
    press(app, "return", "end")
    assert told(app) == ("+1", "Ann wins", "1 inning · avg 1.00 · Both reds, 2 cushions")
    assert score_plates._line(app.view.sight, app.session.contest, 0)[0] == "wins after 1 inning"
    press(app, "ctrl+return")
    assert hint(app.session, words("en")) == ("the match is over · F10 rematch", True)
    click(app, app.view.sight.layout.shoot.center)
    assert app.session.page == "menu"


def test_somebody_may_play_alone():
    app = an_app(game="three-cushion", players="1")
    press(app, "ctrl+return", "end")
    match = app.session.contest.match
    assert match.at == 0
    assert match.sheets[0].innings == 1 or match.run
    assert_same_as_anew(app)


def test_events_are_told_in_both_languages_when_asked_for():
    app = an_app(game="four-ball")
    press(app, "return", "end")
    one = app.screen.subsurface(app.view.sight.layout.log).copy()
    press(app, "n")
    two = app.screen.subsurface(app.view.sight.layout.log)
    assert pygame.image.tobytes(one, "RGB") != pygame.image.tobytes(two, "RGB")
    assert_same_as_anew(app)
