"""What the mouse holds: for as long as its button is down, and only where nothing lies over it."""

import pygame
import pytest

from game.render.parts import cue_card, gauges
from game.session.action import Action
from game.ui.pages import settings_view
from game.ui.pages.settings_rows import ROWS
from game.ui.table.drag_aim import pull
from tests.support.players import FRAME, an_app, in_window, places, press


def send(app, kind, at=(0, 0), held=True, **more):
    """A mouse event at a point of the picture, as SDL sends it."""
    more = {"pos": in_window(app, at), "button": 1, "rel": (1, 1), **more}
    app.handle(pygame.event.Event(kind, buttons=(int(held), 0, 0), **more))


def hold(app, at, to):
    """Press the button and drag, without letting go."""
    send(app, pygame.MOUSEMOTION, at, held=False)
    send(app, pygame.MOUSEBUTTONDOWN, at)
    send(app, pygame.MOUSEMOTION, to)
    app.frame(FRAME)


def wander(app, *, held=False):
    """Move the mouse over the whole window."""
    w, h = app.canvas.surface.get_size()
    for n in range(12):
        send(app, pygame.MOUSEMOTION, (w * (n + 1) / 13, h * ((5 * n) % 12 + 1) / 14), held)
    app.frame(FRAME)


def state(app):
    session = app.session
    return (
        places(session),
        list(session.aim.texts),
        session.timeline.at,
        app.preferences.settings.volume,
    )


def table(app):
    x, y = app.view.sight.layout.to_screen(0.2, 0.2)
    return (x, y), (x + 9, y + 30)


def cue(app):
    app.perform(Action("set", "speed 1 angle 0"))
    layout, ball = app.view.sight.layout, app.session.world.ball("white")
    x, y = layout.to_screen(*ball.position)
    x -= (ball.radius + pull(1.0) + 0.05) * layout.scale
    return (x, y), (x - 30, y)


def power(app):
    return app.view.sight.layout.power.center, app.view.sight.layout.power.midright


def tip(app):
    layout = app.view.sight.layout
    (x, y), radius = gauges.tip_circle(layout.tip, layout.s)
    return (x, y), (x + 0.3 * radius, y)


def elevation(app):
    layout = app.view.sight.layout
    x, y = cue_card.side_ball(layout.tip, layout.s)
    return (x + 45 * layout.s, y), (x + 30 * layout.s, y - 25 * layout.s)


def timeline(app):
    press(app, "return", "end")
    rect = app.view.sight.layout.timeline
    return rect.center, (rect.centerx + 40, rect.centery)


def placing(app):
    press(app, "b")
    x, y = app.view.sight.layout.to_screen(*app.session.world.ball("red1").position)
    return (x, y), (x + 40, y + 40)


HELD = {f.__name__: f for f in (table, cue, power, tip, elevation, timeline, placing)}
PAGES = ("f1", "f3", "f4", "f5", "f10")


@pytest.mark.parametrize("part", HELD)
@pytest.mark.parametrize("key", PAGES)
def test_a_page_opened_in_mid_drag_ends_the_drag(part, key):
    app = an_app(size=(1280, 720))
    before = state(app)
    hold(app, *HELD[part](app))
    held = state(app)
    assert held != before
    press(app, key)
    send(app, pygame.MOUSEBUTTONUP, (300, 300), held=False)
    press(app, "escape")
    wander(app)
    assert state(app) == held
    wander(app, held=True)  # the button may be down again elsewhere, or for another window
    assert state(app) == held


@pytest.mark.parametrize("part", HELD)
def test_a_page_opened_and_closed_with_the_button_still_down_ends_the_drag_too(part):
    app = an_app(size=(1280, 720))
    hold(app, *HELD[part](app))
    press(app, "f1", "f1")
    held = state(app)
    wander(app, held=True)
    assert state(app) == held


@pytest.mark.parametrize("part", HELD)
def test_a_button_let_go_where_nobody_said_so_holds_nothing(part):
    app = an_app(size=(1280, 720))
    hold(app, *HELD[part](app))
    held = state(app)
    app.handle(pygame.event.Event(pygame.WINDOWLEAVE))
    wander(app)
    wander(app, held=True)
    assert state(app) == held


@pytest.mark.parametrize("part", HELD)
def test_a_window_that_loses_the_keyboard_lets_go(part):
    app = an_app(size=(1280, 720))
    hold(app, *HELD[part](app))
    held = state(app)
    app.handle(pygame.event.Event(pygame.WINDOWFOCUSLOST))
    wander(app, held=True)
    assert state(app) == held


def test_a_drag_goes_on_outside_the_window():
    app = an_app(size=(1280, 720))
    hold(app, *power(app))
    app.handle(pygame.event.Event(pygame.WINDOWLEAVE))
    assert app.view.pointer.over == ""
    send(app, pygame.MOUSEMOTION, (5000, 300))
    assert app.session.aim.texts[0] == "8"


def test_the_volume_is_let_go_with_its_page():
    app = an_app(size=(1280, 720))
    press(app, "f3")
    index = next(i for i, row in enumerate(ROWS) if row.name == "volume")
    track = settings_view.track(index, app.view.sight)
    hold(app, track.center, (track.centerx + 20, track.centery))
    held = state(app)
    press(app, "escape")
    send(app, pygame.MOUSEBUTTONUP, (300, 300), held=False)
    press(app, "f3")
    wander(app)
    wander(app, held=True)
    assert state(app) == held


def test_a_page_opened_by_the_mouse_leaves_no_button_pressed():
    app = an_app(size=(1280, 720), game="four-ball", handicap="1", finish="none")
    app.perform(Action("set", "speed 1"))
    send(app, pygame.MOUSEBUTTONDOWN, app.view.sight.layout.shoot.center)
    assert app.view.pointer.held == "shoot"
    press(app, "f10")
    send(app, pygame.MOUSEBUTTONUP, (5, 5), held=False)
    assert app.view.pointer.held == ""


# -- a click that is none ------------------------------------------------------------------------


@pytest.mark.parametrize("size", [(640, 360), (960, 540), (1920, 1080)])
@pytest.mark.parametrize("where", [(0, 0), (0.9, 0), (-0.6, 0.6), (0, -0.9)])
def test_a_click_on_the_cue_ball_leaves_a_fine_aim_alone(size, where):
    app = an_app(size=size)
    app.perform(Action("set", "angle 33.57"))
    before, layout = state(app), app.view.sight.layout
    ball = app.session.world.ball("white")
    x, y = (p + ball.radius * w for p, w in zip(ball.position, where, strict=True))
    at = layout.to_screen(x, y)
    near = at[0] - where[0], at[1] + where[1]
    hold(app, at, near)
    send(app, pygame.MOUSEBUTTONUP, near, held=False)
    assert state(app) == before


def test_a_drag_out_of_the_cue_ball_aims():
    app = an_app(size=(1280, 720))
    x, y = app.view.sight.layout.to_screen(*app.session.world.ball("white").position)
    hold(app, (x, y), (x, y - 200))
    assert float(app.session.aim.texts[4]) == pytest.approx(90, abs=0.5)


def test_a_fine_drag_over_the_ball_does_not_throw_the_aim_about(monkeypatch):
    app = an_app(size=(1280, 720))
    app.perform(Action("set", "angle 33.57"))
    monkeypatch.setattr(pygame.key, "get_mods", lambda: pygame.KMOD_SHIFT)
    x, y = app.view.sight.layout.to_screen(*app.session.world.ball("white").position)
    hold(app, (x + 1, y), (x - 1, y))
    for dx, dy in ((0, 1), (1, 0), (0, -1)):
        send(app, pygame.MOUSEMOTION, (x + dx, y + dy))
    assert app.session.aim.texts[4] == "33.57"


@pytest.mark.parametrize("part", ["cue", "placing"])
def test_a_click_with_a_shaking_hand_moves_nothing_that_it_takes(part):
    app = an_app(size=(1280, 720))
    (x, y), _ = HELD[part](app)
    before = state(app)
    hold(app, (x, y), (x + 2, y + 1))
    assert state(app) == before
    send(app, pygame.MOUSEMOTION, (x - 60, y))
    assert state(app) != before
