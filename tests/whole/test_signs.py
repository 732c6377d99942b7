"""Which way every sign goes, found by playing it: x is right, y away from the player, z up."""

from cmath import phase
from math import degrees, hypot

import numpy as np
import pygame
import pytest

from game import options
from game.aim.entry import BOXES
from game.aim.preview import preview
from game.app import App
from game.input.captions import words
from game.render.parts import gauges
from game.render.table import light, rotation
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.table.presets import table_world
from game.ui.panels import aim_panel
from physics import (
    Ball,
    CueStroke,
    Shot,
    TimeStepping,
    World,
    laws,
    ranges,
    scenes,
    simulate,
    tables,
)
from physics.__main__ import main
from physics.shot import direction

R = tables.MATCH_CAROM.radius
AWAY = 90.0  # degrees: towards the far cushion


def table(**balls: tuple[float, float]) -> World:
    world = tables.match_carom()
    for name, at in balls.items():
        world.add(Ball(name, at=at, radius=R, mass=0.21))
    return world


def played(shot: Shot, until: float | None = None, **balls: tuple[float, float]) -> World:
    after = table(**(balls or {"white": (0.0, 0.0)}))
    after.strike("white", shot)
    after.run(until) if until else after.run()
    return after


def off_the_far_cushion(shot: Shot) -> float:
    """How fast the ball leaves the first cushion to the player's right, m/s."""
    hit = next(event for event in played(shot).log if event.kind == "cushion")
    assert hit.wall == "north"
    return hit.after[0].velocity[0]


# -- side


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_positive_side_is_right_english(sign):
    """Anticlockwise from above, and off the far cushion to the right: what players call right."""
    shot = Shot(2.0, AWAY, follow=2.0, side=sign)
    assert sign * played(shot, 1e-3).ball("white").spin[2] > 0.0
    assert sign * off_the_far_cushion(shot) > 0.1


@pytest.mark.parametrize("engine", [TimeStepping(1e-3), TimeStepping(1e-3, "euler")])
@pytest.mark.parametrize("law", ["rigid", "thesis", "mathavan", laws.CappedCushion()])
def test_every_cushion_and_engine_sends_right_english_to_the_right(law, engine):
    for sign in (1.0, -1.0):
        world = table(white=(0.0, 0.0))
        world.cushion_law, world.engine = law, engine
        world.strike("white", Shot(2.0, AWAY, follow=2.0, side=sign))
        world.run(0.6)
        assert sign * world.ball("white").velocity[0] > 0.1


def test_the_thesis_s_program_knows_right_english_and_no_left():
    for side, right in ((1.0, True), (-1.0, False)):
        world = table(white=(0.0, 0.0))
        world.engine = TimeStepping(1 / 180, "literal")
        world.strike("white", Shot(2.0, AWAY, follow=2.0, side=side))
        world.run(0.6)
        assert (world.ball("white").velocity[0] > 0.1) == right


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_tip_right_of_the_centre_gives_right_english_and_squirts_the_ball_left(sign):
    stroke = CueStroke(2.0, AWAY, side=0.3 * sign)
    shot = stroke.shot(Ball("white", (0.0, 0.0)))
    assert sign * shot.side > 0.0
    assert sign * (shot.angle - AWAY) > 0.0  # anticlockwise: to the left
    assert sign * played(shot, 0.1).ball("white").position[0] < 0.0
    assert sign * off_the_far_cushion(CueStroke(2.0, AWAY, 0.3 * sign, end_ratio=1e12)
                                      .shot(Ball("white", (0.0, 0.0)))) > 0.0  # fmt: skip


def test_positive_spin_about_the_vertical_turns_a_ball_anticlockwise():
    """Its front goes to its left, and drags a ball that it hits full to the left."""
    still = played(Shot(2.0, side=0.0), white=(0.0, 0.0), red=(0.5, 0.0))
    spun = played(Shot(2.0, side=2.0), white=(0.0, 0.0), red=(0.5, 0.0))
    heading = [
        next(event for event in world.log if event.kind == "ball").after[1].velocity[1]
        for world in (still, spun)
    ]
    assert heading[0] == pytest.approx(0.0, abs=1e-12)
    assert heading[1] > 0.0


# -- follow, draw, massé, climb


def test_positive_follow_goes_on_after_a_full_hit_and_negative_comes_back():
    for follow in (1.5, -1.5):
        after = played(Shot(1.5, follow=follow), 1.2, white=(0.0, 0.0), red=(0.2, 0.0))
        hit = next(event for event in after.log if event.kind == "ball")
        assert follow * (after.ball("white").position[0] - hit.before[0].position[0]) > 0.01


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_positive_masse_curves_to_the_right(sign):
    after = played(Shot(1.0, AWAY, follow=1.0, masse=2.0 * sign), 0.3)
    assert sign * after.ball("white").position[0] > 0.01


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_raised_cue_curves_the_ball_to_the_side_of_the_tip(sign):
    ball = Ball("white", (0.0, 0.0))
    shot = CueStroke(2.0, AWAY, 0.3 * sign, height=0.4, elevation=45.0, end_ratio=1e12).shot(ball)
    assert sign * shot.masse > 0.0
    assert sign * played(shot, 0.3).ball("white").position[0] > 0.01


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_the_tip_above_the_centre_follows_and_below_it_draws(sign):
    assert sign * CueStroke(2.0, height=0.3 * sign).shot(Ball("white", (0.0, 0.0))).follow > 0.0


def test_a_raised_cue_draws_for_its_line_passes_below_the_centre():
    assert CueStroke(2.0, elevation=30.0).shot(Ball("white", (0.0, 0.0))).follow < 0.0


def test_positive_climb_lifts_the_ball():
    assert played(Shot(1.0, climb=1.0), 0.05).ball("white").height > 0.01


# -- angles


@pytest.mark.parametrize(("angle", "way"), [(0.0, (1, 0)), (90.0, (0, 1)), (180.0, (-1, 0))])
def test_angles_are_anticlockwise_from_the_right(angle, way):
    x, y = played(Shot(1.0, angle), 0.1).ball("white").position
    assert (x, y) == pytest.approx(tuple(0.0975 * part for part in way), abs=0.01)
    assert direction(angle) == complex(*way)


def test_the_thesis_s_three_spins_are_about_the_left_the_course_and_the_vertical():
    """Wx, Wy, Wz of a ball that runs to +x are its spin about +y, +x and +z, right-handed."""
    world = table(white=(0.0, 0.0))
    world.strike("white", Shot(1.0, follow=0.1, masse=0.2, side=0.3))
    wx, wy, wz = (w * R for w in world.ball("white").spin)
    assert (wy, wx, wz) == pytest.approx((0.1, 0.2, 0.3), rel=1e-12)


def test_a_scene_s_motion_is_read_back_as_the_five_numbers_that_make_it():
    world = table(white=(0.0, 0.0))
    world.strike("white", Shot(1.0, 30.0, follow=0.1, masse=0.2, side=0.3))
    texts = Session(world, table="match").aim.texts
    assert [float(text) for text in texts] == pytest.approx([1.0, 0.1, 0.2, 0.3, 30.0], abs=1e-3)


# -- thickness


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_thickness_is_positive_where_the_cue_ball_passes_on_the_right(sign):
    """Of a ball a little to the left of the line of aim; it is then sent to the left."""
    world = table(white=(0.0, 0.0), red=(-0.02 * sign, 0.4))
    seen = preview(world, "white", Shot(2.0, AWAY))
    assert sign * seen.contact.overlap > 0.0
    assert sign * seen.contact.leaves[1][0] < 0.0
    session = Session(world, table="match")
    perform(session, Action("set", "speed 2 follow 0 masse 0 side 0 angle 90"))
    before = session.aim.angle
    perform(session, Action("thick", round(7 * sign)))
    assert sign * (session.aim.angle - before) < 0.0  # farther to its right is clockwise


# -- the window


@pytest.fixture(scope="module")
def app():
    return App(Session(table_world("medium")), options.read(["--frames", "1"]))


@pytest.mark.parametrize("sign", [1, -1])
def test_right_of_the_tip_picker_is_right_english_and_above_is_follow(app, sign):
    sight, session = app.view.sight, app.session
    (x, y), radius = gauges.tip_circle(sight.layout.tip, sight.layout.s)
    app.perform(Action("centre"))
    sight.pointer.pressing, sight.pointer.grip = True, ""
    for at, box in (((x + 0.3 * sign * radius, y), 3), ((x, y - 0.3 * sign * radius), 1)):
        app.perform(aim_panel.tip_touch(at, sight.layout.tip, sight))
        assert sign * float(session.aim.texts[box]) > 0.1
        assert [float(text) for i, text in enumerate(session.aim.texts[1:4], 1) if i != box] == [
            0,
            0,
        ]
    sight.pointer.pressing = False


def test_arrows_with_alt_move_the_tip_as_they_point(app):
    for key, box, sign in (("RIGHT", 3, 1), ("LEFT", 3, -1), ("UP", 1, 1), ("DOWN", 1, -1)):
        app.perform(Action("centre"))
        code = getattr(pygame, f"K_{key}")
        event = pygame.event.Event(pygame.KEYDOWN, key=code, mod=pygame.KMOD_LALT, unicode="")
        pygame.event.post(event)
        app.frame(1)
        assert sign * float(app.session.aim.texts[box]) > 0.0


def test_a_raised_cue_with_the_tip_on_the_right_is_a_positive_masse(app):
    for sign in (1, -1):
        app.perform(Action("centre"))
        app.perform(Action("tip", f"{0.2 * sign} 0"))
        app.perform(Action("elevate", "45"))
        assert sign * float(app.session.aim.texts[2]) > 0.1


def test_the_aim_turns_left_on_the_screen_with_the_key_that_says_so(app):
    assert words("en")["key.turn 1"].endswith("left")
    layout, session = app.view.sight.layout, app.session
    app.perform(Action("set", "angle 90"))
    app.perform(Action("turn", "1"))
    ahead = direction(session.aim.angle)
    x, y = (a - b for a, b in zip(layout.to_screen(ahead.real, ahead.imag),
                                  layout.to_screen(0.0, 0.0), strict=True))  # fmt: skip
    assert x < 0 > y  # up the screen, and to the left


def test_a_ball_with_right_english_turns_anticlockwise_on_the_screen():
    turn = rotation.matrix(rotation.rotated((1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 1.0), 0.5))
    x, y = (turn @ np.array((1.0, 0.0, 0.0), np.float32))[:2]
    assert degrees(phase(complex(x, y))) == pytest.approx(degrees(0.5), rel=1e-5)
    normal, _ = light.normals(21, 10.0, 10.5)
    assert normal[0][20, 10] > 0.9  # the table's x is right on the screen, its y is up
    assert normal[1][10, 0] > 0.9


def test_a_rolling_ball_s_top_goes_the_way_it_rolls():
    world = played(Shot(1.0, 30.0, follow=1.0), 1e-3)
    turn = rotation.matrix(rotation.rotated((1.0, 0.0, 0.0, 0.0), world.ball("white").spin, 1e-3))
    x, y, _ = turn @ np.array((0.0, 0.0, 1.0), np.float32)
    assert degrees(phase(complex(x, y))) == pytest.approx(30.0, abs=0.1)
    assert hypot(x, y) == pytest.approx(1e-3 / R, rel=0.01)


# -- what is said


def test_both_languages_say_which_way_side_and_masse_go():
    english, korean = words("en"), words("ko")
    for w, right, left in ((english, "+ right english", "− left"),
                           (korean, "+ 오른쪽 당점", "− 왼쪽 당점")):  # fmt: skip
        assert right in w["help.side"]
        assert left in w["help.side"]
        assert w["sign.side"] == right
    assert "+ curves right" in english["help.masse"]
    assert "+ 오른쪽" in korean["help.masse"]
    assert BOXES[1:4] == tuple(key[5:] for key in english if key.startswith("sign."))


@pytest.mark.parametrize(("language", "said"), [("en", "+ right english"), ("ko", "+ 오른쪽 당점")])
def test_the_box_of_the_side_says_which_way_it_goes(language, said, monkeypatch):
    from game.render.font import Type

    written: list[str] = []
    draw = Type.draw

    def noted(self, surface, string, *how):
        written.append(string)
        return draw(self, surface, string, *how)

    monkeypatch.setattr(Type, "draw", noted)
    app = App(Session(table_world("medium")), options.read(["--frames", "1"]))
    app.perform(Action("language", language))
    app.frame(1)
    assert any(string.endswith(said) for string in written)


def test_help_of_the_command_line_says_which_way_every_number_goes(capsys):
    with pytest.raises(SystemExit):
        options.read(["--help"])
    said = capsys.readouterr().out
    assert "right english" in said
    assert "curves to the right" in said
    with pytest.raises(SystemExit):
        main(["sweep", "--help"])
    swept = " ".join(capsys.readouterr().out.split())
    assert all(meaning in swept for meaning in ranges.MEANING.values())


def test_a_sweep_s_side_is_the_shot_s(capsys):
    assert main(["sweep", "carom", "--speed", "2", "--side", "1", "--csv", "-"]) == 0
    row = capsys.readouterr().out.splitlines()[1]
    world = scenes.carom()
    x, y = simulate(world, "white", Shot(2.0, side=1.0)).ball("white").position
    assert f"{x!r},{y!r}" in row
