"""Every key of the game, by posted events."""

from math import hypot

import pygame
import pytest

from game.aim.entry import START
from tests.support.players import FRAME, an_app, click, enter, places, press, run_to_rest, write


@pytest.fixture
def app():
    return an_app()


def test_the_game_starts_with_a_shot_that_return_plays(app):
    press(app, "return")
    assert app.session.moving
    run_to_rest(app)
    met = {b for e in app.session.world.log if e.kind == "ball" for b in e.balls}
    assert met == {"white", "red1", "red2"}


def test_right_clears_all_five_boxes_and_edits_the_first(app):
    press(app, "right")
    assert app.session.aim.texts == [""] * 5
    assert app.session.aim.box == 0


def test_left_edits_the_five_boxes_as_they_are(app):
    press(app, "left")
    assert app.session.aim.texts == list(START)
    assert app.session.aim.box == 0


def test_return_walks_through_the_boxes_and_the_fifth_completes_the_entry(app):
    press(app, "right")
    boxes = []
    for text in ("2", "-1", "0.5", "1", "30"):
        boxes.append(app.session.aim.box)
        write(app, text)
        press(app, "return")
    assert boxes == [0, 1, 2, 3, 4]
    assert app.session.aim.box is None
    assert app.session.aim.complete
    shot = app.session.aim.shot
    assert (shot.speed, shot.follow, shot.masse, shot.side, shot.angle) == (2, -1, 0.5, 1, 30)


def test_an_entry_is_good_for_one_shot(app):
    enter(app, "1", "0", "0", "0", "0")
    press(app, "return")
    run_to_rest(app)
    assert app.session.shots == 1
    press(app, "return", "return")
    assert app.session.shots == 1
    press(app, "left", *["return"] * 5, "return")
    assert app.session.shots == 2


def test_the_cue_ball_gets_the_shot_that_was_entered(app):
    enter(app, "2", "-1", "0.5", "1", "90")
    press(app, "return", frames=False)
    app.frame(0)
    white = app.session.world.ball("white")
    assert white.velocity == pytest.approx((0, 2), abs=1e-12)
    # follow turns about the axis left of the way (-x), massé about the way (+y)
    spin = [w * white.radius for w in white.spin]
    assert spin == pytest.approx([1, 0.5, 1], abs=1e-12)


def test_the_read_outs_are_the_three_surface_speeds_of_the_cue_ball(app):
    enter(app, "2", "-1", "0.5", "1.5", "90")
    press(app, "return", frames=False)
    app.frame(0)
    v, w, wz = app.session.readout
    assert (v, wz) == pytest.approx((2, 1.5))
    assert w == pytest.approx(hypot(1, 0.5, 1.5))


def test_backspace_deletes_the_last_character_and_a_selected_text_whole(app):
    press(app, "left")
    press(app, "backspace")
    assert app.session.aim.texts[0] == ""
    write(app, "2.75")
    press(app, "backspace")
    assert app.session.aim.texts[0] == "2.7"


def test_a_digit_in_play_begins_an_entry_and_keeps_the_other_boxes(app):
    press(app, "4")
    assert app.session.aim.texts == ["4", *START[1:]]
    write(app, ".5")
    press(app, "shift+tab")
    write(app, "30")
    press(app, "return", "return")
    assert app.session.shots == 1
    assert app.session.aim.texts == ["4.5", *START[1:4], "30"]


def test_tab_and_shift_tab_go_around_the_boxes(app):
    seen = []
    for key in ("tab", "tab", "shift+tab", "shift+tab", "tab"):
        press(app, key)
        seen.append(app.session.aim.box)
    assert seen == [0, 1, 0, 4, 0]


def test_escape_leaves_editing_without_completing_the_entry(app):
    press(app, "left", "escape")
    assert app.session.aim.box is None
    assert not app.session.aim.complete


def test_a_click_chooses_a_box(app):
    click(app, app.view.sight.layout.fields[3].center)
    assert app.session.aim.box == 3


def test_down_places_one_ball_in_each_quadrant_without_overlap(app):
    for _ in range(50):
        press(app, "down")
        spots = places(app.session)
        assert len({(x > 0, y > 0) for x, y in spots}) == 4
        gaps = [hypot(p[0] - q[0], p[1] - q[1]) for p in spots for q in spots if p is not q]
        assert min(gaps) >= 2 * app.session.world.balls[0].radius
        press(app, "ctrl+return")
        assert app.session.moving


def test_the_seed_decides_where_balls_are_placed():
    def placed(seed):
        app = an_app(seed=seed)
        press(app, "down", "down")
        return places(app.session)

    assert placed(3) == placed(3) != placed(4)


def test_space_stops_all_balls_where_they_are(app):
    press(app, "return")
    for _ in range(20):
        app.frame(FRAME)
    before = places(app.session)
    pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=pygame.K_SPACE, mod=0, unicode=" "))
    app.frame(FRAME)
    assert not app.session.moving
    assert places(app.session) == before
    told = app.session.forecast
    assert told.duration == pytest.approx(app.session.readout_time, abs=1e-12)
    assert all(end <= told.duration for lane in told.lanes for _, end, _ in lane.legs)


def test_a_shot_while_balls_move_gives_the_cue_ball_a_new_way(app):
    press(app, "return")
    for _ in range(40):
        app.frame(FRAME)
    enter(app, "1", "0", "0", "0", "180")
    assert app.session.moving
    press(app, "return", frames=False)
    app.frame(0)
    assert app.session.shots == 2
    assert app.session.world.ball("white").velocity == (-1.0, 0.0)


def test_pause_holds_the_balls_and_full_stop_moves_them_by_one_frame(app):
    press(app, "return", "p")
    held = places(app.session)
    time = app.session.world.time
    for _ in range(5):
        app.frame(FRAME)
    assert places(app.session) == held
    press(app, ".")
    assert app.session.world.time == time + FRAME / 2**16
    press(app, "p")
    assert app.session.world.time > time + FRAME / 2**16


def test_retry_puts_the_balls_back_and_the_same_entry_plays_the_same_shot(app):
    start = places(app.session)
    press(app, "return")
    run_to_rest(app)
    first = places(app.session)
    press(app, "r")
    assert places(app.session) == start
    press(app, "return")
    run_to_rest(app)
    assert places(app.session) == first


def test_one_shot_can_be_repeated_under_another_law_set(app):
    press(app, "return")
    run_to_rest(app)
    first = places(app.session)
    press(app, "r", "l", "return")
    run_to_rest(app)
    assert app.session.law == "thesis"
    assert places(app.session) != first
    press(app, *["l"] * 2, "r", "return")
    run_to_rest(app)
    assert app.session.law == "rigid"
    assert places(app.session) == first


def test_one_shot_can_be_repeated_under_the_stepping_engine(app):
    press(app, "return", "end", "r", "e")
    assert app.session.engine == "thesis"
    press(app, "return")
    assert app.session.moving
    press(app, "space", "e")
    assert app.session.engine == "exact"


def test_end_goes_to_where_the_balls_come_to_rest(app):
    press(app, "return")
    run_to_rest(app)
    rested = places(app.session)
    press(app, "r", "return", "end")
    assert not app.session.moving
    assert places(app.session) == rested


def test_help_holds_the_game_and_any_of_three_keys_closes_it(app):
    press(app, "return", "f1")
    held = places(app.session)
    app.frame(FRAME)
    assert places(app.session) == held
    for key in ("f1", "escape", "return"):
        assert app.session.help
        press(app, key)
        assert not app.session.help
        press(app, "f1")


def test_f2_and_the_corner_of_the_engine_card_change_the_language(app):
    press(app, "f2")
    assert app.session.language == "ko"
    corner = app.view.sight.layout.engine.inflate(-20, -10).bottomright
    click(app, corner)
    assert app.session.language == "en"


def test_closing_the_window_ends_the_game(app):
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    app.frame(FRAME)
    assert app.session.over


def test_text_input_is_on_only_while_a_box_is_edited(app, monkeypatch):
    calls = []
    monkeypatch.setattr(pygame.key, "start_text_input", lambda: calls.append("start"))
    monkeypatch.setattr(pygame.key, "stop_text_input", lambda: calls.append("stop"))
    press(app, "left", "tab", "escape", "p")
    assert calls == ["start", "stop"]


def test_the_button_completes_the_entry_shoots_stops_and_goes_on(app):
    button = app.view.sight.layout.shoot.center
    click(app, app.view.sight.layout.fields[0].center)
    write(app, "1.5")
    click(app, button)
    assert app.session.moving
    click(app, button)
    assert not app.session.moving
    click(app, button)
    assert app.session.aim.box == 0


def test_dragging_sets_power_tip_and_angle_in_the_boxes(app):
    layout = app.view.sight.layout
    click(app, layout.power.center, (layout.power.centerx + 5000, layout.power.centery))
    assert app.session.aim.texts[0] == "8"
    click(app, layout.tip.center, (layout.tip.centerx, layout.tip.y - 500))
    side, follow = float(app.session.aim.texts[3]), float(app.session.aim.texts[1])
    # dragged far outside, the tip stays on the miscue ring: 2.5 V μ / √(1 + μ²) with μ = 0.6
    assert hypot(side, follow) == pytest.approx(2.5 * 8 * 0.6 / hypot(1, 0.6), abs=0.02)
    x, y = layout.to_screen(*app.session.world.ball("white").position)
    click(app, (x, y - 50))
    assert float(app.session.aim.texts[4]) == pytest.approx(90, abs=1.5)
    assert app.session.aim.complete


def test_the_lanes_buttons_go_back_play_and_skip(app):
    strip = app.view.sight.layout.timeline
    from game.render.parts.lanes import buttons

    *_, back, play, ahead = (b.center for b in buttons(strip, app.view.sight.layout.s))
    start = places(app.session)
    click(app, play)
    assert app.session.moving
    click(app, play)
    assert app.session.paused
    click(app, play)
    assert not app.session.paused
    click(app, ahead)
    assert not app.session.moving
    click(app, back)
    assert [app.session.seen[b.name].position for b in app.session.world.balls] == start
    assert places(app.session) != start
    press(app, "r")
    assert places(app.session) == start


def test_characters_typed_faster_than_a_frame_are_neither_lost_nor_doubled(app):
    # text input is still off when SDL makes these events: no TEXTINPUT comes for them
    press(app, "2", ".", "5", frames=False)
    app.frame(FRAME)
    assert app.session.aim.texts[0] == "2.5"
    # and here it is still on: the TEXTINPUT comes although RETURN has left the boxes
    press(app, "tab", "tab", "tab", "tab")
    press(app, "return", "7", frames=False)
    pygame.event.post(pygame.event.Event(pygame.TEXTINPUT, text="7"))
    app.frame(FRAME)
    assert app.session.aim.texts[0] == "7"


def test_the_direction_is_drawn_as_soon_as_there_is_an_angle(app):
    press(app, "right")
    empty = app.view.stage.lines.copy()
    press(app, "shift+tab")
    write(app, "10")
    assert pygame.image.tobytes(empty, "RGB") != pygame.image.tobytes(app.view.stage.lines, "RGB")
