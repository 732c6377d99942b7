"""The mouse and the keys of aiming work on whatever boxes are filled, and say what they miss."""

import pytest

from game.aim.entry import Aim
from game.aim.tip import Tip
from game.render.parts import gauges
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Notice
from game.ui.panels import aim_panel
from tests.support.players import an_app, click, enter, press, write


@pytest.fixture
def app():
    """A window in which all five boxes have been cleared."""
    app = an_app(size=(1280, 720))
    press(app, "right", "escape")
    return app


def tip_at(app, right, up):
    layout = app.view.sight.layout
    (x, y), radius = gauges.tip_circle(layout.tip, layout.s)
    click(app, (x + right * radius, y - up * radius))


def test_power_aim_and_tip_point_fill_cleared_boxes_by_mouse_alone(app):
    layout = app.view.sight.layout
    click(app, layout.power.center)
    tip_at(app, 0.2, -0.1)
    click(app, layout.table.center)
    shot = app.session.aim.shot
    assert shot is not None
    assert app.session.aim.complete
    # the nearest pixel of the ball is up to 0.02 R away, and a spin 5/2 of that
    assert shot.side == pytest.approx(0.5 * shot.speed, abs=0.05 * shot.speed)
    assert shot.follow == pytest.approx(-0.25 * shot.speed, abs=0.05 * shot.speed)


@pytest.mark.parametrize(
    "what", ["tip 0.2 0.1", "nudge 0.05 0.0", "elevate 20", "tilt 5", "centre"]
)
def test_a_tip_point_without_a_speed_asks_for_the_power(app, what):
    name, _, value = what.partition(" ")
    perform(app.session, Action(name, value) if value else Action(name))
    assert app.session.notice == Notice("power", error=True)
    assert app.session.aim.texts == [""] * 5


@pytest.mark.parametrize("what", ["nudge 0.05 0.1", "elevate 20", "tilt 5", "centre"])
def test_keys_of_the_tip_point_begin_in_the_middle_where_spins_are_missing(app, what):
    write(app, "2")
    name, _, value = what.partition(" ")
    perform(app.session, Action(name, value) if value else Action(name))
    right, up = map(float, value.split()) if name == "nudge" else (0.0, 0.0)
    steep = float(value) if name in ("elevate", "tilt") else 0.0
    assert app.session.aim.tip == Tip(right, up, steep)
    assert app.session.aim.number("side") == pytest.approx(5.0 * right)


def test_the_power_bar_shows_the_speed_while_other_boxes_are_empty(app):
    empty = aim_panel.power_key(app.view.sight)
    write(app, "4.5")
    assert empty == (None, 8.0)
    assert aim_panel.power_key(app.view.sight) == (4.5, 8.0)


def test_the_tip_point_is_known_while_the_angle_is_missing(app):
    write(app, "2")
    press(app, "return")
    for spin in ("1", "0", "0.5"):
        write(app, spin)
        press(app, "return")
    assert app.session.aim.shot is None
    assert app.session.aim.tip == Tip(0.1, 0.2)


@pytest.mark.parametrize("speed", ["0.004", "3.14159"])
def test_a_tip_point_leaves_a_typed_speed_as_it_is(speed):
    app = an_app()
    enter(app, speed, "0", "0", "0", "30")
    perform(app.session, Action("tip", "0.2 0.1"))
    assert app.session.aim.texts[0] == speed
    assert app.session.aim.shot is not None


def test_power_scales_spins_that_no_cue_gives():
    aim = Aim(texts=["2", "1", "1.5", "0", "30"])
    aim.speed(4.0)
    assert aim.texts == ["4", "2", "3", "0", "30"]
