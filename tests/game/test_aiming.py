"""Aiming by mouse and keys: what is drawn, what is in the boxes and what is shot are one thing."""

from itertools import pairwise
from math import atan2, cos, degrees, hypot, radians, sin

import pygame
import pytest
from hypothesis import given
from hypothesis import strategies as st

from game.aim.edit import share, speed_at
from game.aim.preview import preview
from game.aim.tip import LIMIT, Tip, tip_of
from game.render.parts import cue_card, gauges
from game.session.action import Action
from game.session.terms import Terms
from game.ui.table.drag_aim import TRAVEL, pull
from physics import Ball, CueStroke, Shot, tables
from tests.support.players import FRAME, an_app, assert_same_as_anew, click, enter, press, write


@pytest.fixture
def app():
    return an_app(size=(1280, 720))


def number(app, box):
    return float(app.session.aim.texts[box])


def shift(monkeypatch, mods=pygame.KMOD_SHIFT):
    monkeypatch.setattr(pygame.key, "get_mods", lambda: mods)


def roll(app, over, notches):
    """Turn the wheel over a point."""
    pygame.event.post(pygame.event.Event(pygame.MOUSEMOTION, pos=over, rel=(0, 0), buttons=()))
    pygame.event.post(pygame.event.Event(pygame.MOUSEWHEEL, x=0, y=notches, flipped=False))
    app.frame(FRAME)


# -- the tip point and the boxes -----------------------------------------------------------------


@given(st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.floats(0.0, 50.0), st.floats(0.05, 10.0))
def test_a_tip_point_gives_the_spins_that_the_cue_of_the_physics_gives(right, up, steep, speed):
    tip = Tip(right, up, steep).within()
    away = (1.0 - tip.right**2 - tip.up**2) ** 0.5
    height = tip.up * cos(radians(steep)) + away * sin(radians(steep))
    heavy_end = CueStroke(1.0, 0.0, tip.right, height, steep, end_ratio=1e12, friction=0.61)

    class Struck:
        mass = 0.2

    shot = heavy_end.shot(Struck())
    spins = tip.spins(speed)
    for name in ("follow", "masse", "side"):
        assert spins[name] / speed == pytest.approx(getattr(shot, name) / shot.speed, abs=1e-9)


@given(st.floats(-0.5, 0.5), st.floats(-0.5, 0.5), st.floats(1.0, 80.0), st.floats(0.05, 10.0))
def test_a_tip_point_is_found_again_from_its_spins(right, up, steep, speed):
    right = right + 0.01 if right >= 0 else right - 0.01
    found = tip_of(Shot(speed, **Tip(right, up, steep).spins(speed)))
    assert (found.right, found.up) == pytest.approx((right, up), abs=1e-9)
    assert found.elevation == pytest.approx(steep, abs=1e-6)


@pytest.mark.parametrize(("side", "masse"), [(0.0, 1.0), (1.0, -1.0), (-1.0, 1.0)])
def test_spins_that_no_cue_gives_have_no_elevation(side, masse):
    assert tip_of(Shot(2.0, side=side, masse=masse)).elevation is None


def test_what_the_picker_shows_stays_what_was_set_although_boxes_are_rounded(app):
    for value in ("0.013 0.207", "-0.31 -0.2"):
        app.perform(Action("tip", value))
        app.perform(Action("elevate", "33"))
        right, up = map(float, value.split())
        assert app.session.aim.tip == Tip(right, up, 33.0)
        for speed in ("0.37", "5.11", "0.05", "2"):
            app.perform(Action("power", speed))
            assert app.session.aim.tip == Tip(right, up, 33.0)


def test_typing_into_a_box_moves_the_tip_point_at_once(app):
    app.perform(Action("tip", "0.2 0.1"))
    press(app, "tab", "tab", "tab", "tab")
    write(app, "3.5")
    assert app.session.aim.tip.right == pytest.approx(3.5 / (2.5 * 3.5))


def test_power_keeps_the_tip_point_and_so_takes_the_spins_along(app):
    enter(app, "2", "1", "0", "0.5", "0")
    app.perform(Action("power", "4"))
    assert app.session.aim.texts == ["4", "2", "0", "1", "0"]


def test_a_level_cue_gives_no_masse_and_a_steep_one_does(app):
    app.perform(Action("tip", "0.3 -0.2"))
    assert number(app, 2) == 0
    app.perform(Action("elevate", "45"))
    assert number(app, 2) == pytest.approx(number(app, 3), abs=0.01)


def test_beyond_the_miscue_ring_the_tip_is_held_and_the_player_told(app):
    app.perform(Action("tip", "0.6 0.6"))
    assert app.session.aim.tip.away == pytest.approx(LIMIT)
    assert app.session.notice.key == "miscue"
    assert_same_as_anew(app)
    press(app, "c")
    assert app.session.notice is None
    for _ in range(60):
        app.perform(Action("nudge", "0.05 0"))
    assert app.session.aim.tip.away == pytest.approx(LIMIT)


def test_dragging_the_point_of_the_picker_writes_what_is_under_the_mouse(app):
    layout = app.view.sight.layout
    (x, y), radius = gauges.tip_circle(layout.tip, layout.s)
    click(app, (x, y), (x + 0.25 * radius, y - 0.125 * radius))
    assert app.session.aim.tip.right == pytest.approx(0.25, abs=1 / radius)
    assert app.session.aim.tip.up == pytest.approx(0.125, abs=1 / radius)


def test_the_cue_in_the_side_view_is_raised_by_dragging_its_end(app):
    layout = app.view.sight.layout
    x, y = cue_card.side_ball(layout.tip, layout.s)
    reach = 45 * layout.s
    click(app, (x + reach, y), (x + reach * cos(radians(40)), y - reach * sin(radians(40))))
    assert app.session.aim.tip.elevation == pytest.approx(40, abs=2)


def test_alt_and_the_arrows_move_the_tip_and_raise_the_cue(app, monkeypatch):
    press(app, "c")
    for key, mods in (("RIGHT", pygame.KMOD_ALT), ("UP", pygame.KMOD_ALT | pygame.KMOD_SHIFT)):
        code = getattr(pygame, f"K_{key}")
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=code, mod=mods, unicode=""))
    steep = pygame.event.Event(pygame.KEYDOWN, key=pygame.K_PAGEUP, mod=pygame.KMOD_ALT, unicode="")
    pygame.event.post(steep)
    app.frame(FRAME)
    assert app.session.aim.tip == Tip(0.05, 0.01, 5.0)


# -- the angle -----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("key", "step"),
    [("q", 1), ("w", -1), ("shift+q", 0.1), ("shift+right", -0.1), ("ctrl+w", -0.01),
     ("ctrl+left", 0.01)],
)  # fmt: skip
def test_keys_turn_the_aim_by_their_step(app, key, step):
    before = number(app, 4)
    press(app, key)
    assert number(app, 4) == pytest.approx(before + step, abs=1e-9)
    assert app.session.aim.complete


@pytest.mark.parametrize(
    ("mods", "step"), [(0, 1), (pygame.KMOD_SHIFT, 0.1), (pygame.KMOD_CTRL, 0.01)]
)
def test_the_wheel_turns_the_aim_by_the_same_steps(app, monkeypatch, mods, step):
    shift(monkeypatch, mods)
    before = number(app, 4)
    roll(app, app.view.sight.layout.bed.center, 3)
    assert number(app, 4) == pytest.approx(before + 3 * step, abs=1e-9)


def test_a_drag_aims_at_the_mouse_and_with_shift_turns_a_tenth_as_much(app, monkeypatch):
    layout, ball = app.view.sight.layout, app.session.world.ball("white")
    x, y = layout.to_screen(*ball.position)
    click(app, (x + 100, y), (x + 200, y - 100))
    assert number(app, 4) == pytest.approx(degrees(atan2(100, 200)), abs=0.5)
    before = number(app, 4)
    shift(monkeypatch)
    click(app, (x + 200, y), (x + 200, y - 200))
    assert number(app, 4) == pytest.approx(before + 4.5, abs=0.1)


def test_the_mouse_aims_the_next_shot_straight_after_the_last_one(app):
    press(app, "return", "end")
    assert app.session.shown_shot
    click(app, app.view.sight.layout.bed.center)
    assert not app.session.shown_shot
    assert app.session.aim.complete


# -- power ---------------------------------------------------------------------------------------


@given(st.floats(0.05, 8.0))
def test_the_power_bar_goes_there_and_back(speed):
    assert speed_at(share(speed)) == pytest.approx(speed, rel=1e-9)


def test_more_than_half_of_the_power_bar_is_for_less_than_three_metres_a_second():
    assert share(3.0) > 0.5
    assert share(1.0) > 0.25


def test_pulling_the_cue_back_gives_power_one_to_one(app):
    app.perform(Action("set", "speed 1 angle 0"))
    layout, ball = app.view.sight.layout, app.session.world.ball("white")
    grip = ball.position[0] - ball.radius - pull(1.0) - 0.05, ball.position[1]
    x, y = layout.to_screen(*grip)
    click(app, (x, y), (x - 0.1 * layout.scale, y))
    assert number(app, 4) == 0
    assert pull(number(app, 0)) - pull(1.0) == pytest.approx(0.1, abs=1.5 / layout.scale)
    assert TRAVEL > 0.1


@pytest.mark.parametrize(
    ("key", "step"), [("pageup", 0.5), ("shift+pagedown", -0.1), ("ctrl+pageup", 0.01)]
)
def test_keys_change_the_power_by_their_step(app, key, step):
    press(app, key)
    assert number(app, 0) == pytest.approx(3.5 + step)


def test_the_wheel_over_the_power_bar_changes_the_power(app):
    roll(app, app.view.sight.layout.power.center, 2)
    assert number(app, 0) == 4.5


# -- thickness -----------------------------------------------------------------------------------


def test_every_eighth_can_be_chosen_and_is_met_exactly(app):
    app.perform(Action("set", "angle 33"))
    for place, eighth in enumerate(gauges.EIGHTHS_SHOWN):
        layout = app.view.sight.layout
        click(app, gauges.eighth_boxes(layout.thickness, layout.s)[place].center)
        contact = app.session.preview.contact
        assert abs(contact.overlap) == pytest.approx(1 - abs(eighth) / 8, abs=2e-4)
        if eighth:
            assert (contact.overlap > 0) == (eighth > 0)


def test_a_curved_way_meets_the_eighth_as_well(app):
    enter(app, "2", "-1", "1", "1", "40")
    first = app.session.preview.contact
    assert first is not None
    assert len(app.session.preview.way) > 2
    press(app, "t")
    ball = app.session.preview.contact
    past = 8 * (1 - abs(ball.overlap))
    assert past == pytest.approx(round(past), abs=2e-3)
    assert ball.ball == first.ball


def test_off_a_cushion_the_eighth_is_met_off_that_cushion(app):
    app.perform(Action("set", "speed 4 follow 0 masse 0 side 0 angle 120"))
    for step in range(60):
        app.perform(Action("set", f"angle {100 + step}"))
        contact = app.session.preview.contact
        if contact is not None and len(app.session.preview.way) > 2:
            break
    press(app, "t")
    now = app.session.preview
    assert now.contact.ball == contact.ball
    assert len(now.way) > 2
    assert abs(number(app, 4) - (100 + step)) < 3
    past = 8 * (1 - abs(now.contact.overlap))
    assert past == pytest.approx(round(past), abs=5e-3)


def test_t_goes_through_the_eighths_one_by_one_and_stops_at_the_last(app):
    app.perform(Action("set", "angle 33"))
    press(app, *["shift+t"] * 20)
    seen = []
    for _ in range(20):
        seen.append(round(app.session.preview.contact.overlap * 8))
        press(app, "t")
    assert seen[:15] == [1, 2, 3, 4, 5, 6, 7, seen[7], -7, -6, -5, -4, -3, -2, -1]
    assert abs(seen[7]) == 8
    assert set(seen[15:]) == {-1}


def test_half_a_ball_of_another_size_is_half_of_the_distance_at_which_they_touch():
    world = tables.medium_carom()
    white = world.add(Ball("white", (-0.5, 0.0), radius=0.04))
    small = world.add(Ball("small", (0.0, 0.0), radius=0.02))
    for aside in (0.0, 0.5, 0.99):
        small.position = (0.0, aside * white.touching_distance(small))
        contact = preview(world, "white", Shot(3.0)).contact
        assert abs(contact.overlap) == pytest.approx(1.0 - aside, abs=1e-9)


def test_without_a_ball_in_the_way_there_is_no_thickness_to_choose(app):
    app.perform(Action("set", "speed 0.3 follow 0 side 0 angle 180"))
    before = list(app.session.aim.texts)
    press(app, "t")
    assert app.session.notice.key == "thickness.none"
    assert app.session.aim.texts == before


# -- aids and the fan ----------------------------------------------------------------------------


def test_the_selector_on_the_card_chooses_the_aids(app):
    sight = app.view.sight
    names = [sight.words[f"aids.{key}"] for key in ("off", "short", "full")]
    boxes = cue_card.choice_boxes(sight.layout.tip, sight.type, names)
    for key, box in zip(("off", "short", "full"), boxes, strict=True):
        click(app, box.center)
        assert sight.settings.aids == key
        assert_same_as_anew(app)


def test_the_fan_waits_until_the_aim_is_still_and_comes_a_few_samples_a_frame(app):
    press(app, "f")
    counts = []
    for _ in range(40):
        app.frame(FRAME)
        counts.append(len(app.view.spread.samples))
    assert counts[5] == 0
    assert max(b - a for a, b in pairwise(counts)) == 2
    assert counts[-1] == 40
    assert_same_as_anew(app)
    press(app, "q")
    assert app.view.spread.samples == []
    press(app, "f")
    assert_same_as_anew(app)


def test_the_fan_takes_no_part_in_what_happens(app):
    other = an_app(size=(1280, 720))
    press(app, "f")
    for one in (app, other):
        for _ in range(30):
            one.frame(FRAME)
        press(one, "return", "end")
    ends = [[ball.position for ball in one.session.world.balls] for one in (app, other)]
    assert ends[0] == ends[1]


# -- the stroke ----------------------------------------------------------------------------------


def test_the_balls_do_not_wait_for_the_cue(app):
    press(app, "return", frames=False)
    app.frame(0)
    assert hypot(*app.session.world.ball("white").velocity) == pytest.approx(3.5)
    shown = app.view.stage._cue[0]
    assert shown is not None
    for _ in range(25):
        app.frame(FRAME)
        assert_same_as_anew(app)
    assert app.view.stage._cue[0] is None


def test_reduced_motion_shows_no_stroke(app):
    app.perform(Action("still"))
    press(app, "return")
    assert app.view.stage._cue[0] is None


def test_in_a_match_the_share_of_the_fan_that_scores_is_told(app):
    app.perform(Action("match", Terms("four-ball").line()))
    app.perform(Action("set", "speed 3.49 follow 0.78 masse 0 side -1.15 angle 83.72"))
    press(app, "f")
    for _ in range(40):
        app.frame(FRAME)
    share_made = app.view.spread.share
    made = [one.made for one in app.view.spread.samples]
    assert share_made == sum(made) / 40
    assert 0 < share_made < 1
    assert_same_as_anew(app)
    free = an_app()
    press(free, "f")
    for _ in range(40):
        free.frame(FRAME)
    assert free.view.spread.done
    assert free.view.spread.share is None


@pytest.mark.parametrize("engine", ["exact", "thesis"])
def test_a_shot_that_never_ends_has_no_preview_under_either_engine(engine):
    app = an_app(scene="cradle")
    app.perform(Action("engine", engine))
    press(app, "space", "q")
    assert app.session.aim.complete
    assert app.session.preview is None
    assert_same_as_anew(app)
