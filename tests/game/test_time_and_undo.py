"""Time back and forth, its speed, and undo: what is shown is what the log knows."""

import random
from math import inf

import pygame
import pytest

from game.render.parts import cards, lanes
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.session.ticks import TICKS
from game.table.presets import scene_world, table_world
from game.window.clock import VirtualClock
from tests.support.players import (
    FRAME,
    an_app,
    assert_same_as_anew,
    click,
    enter,
    pixels,
    places,
    press,
    run_to_rest,
    write,
)


@pytest.fixture
def app():
    return an_app()


@pytest.fixture
def rested(app):
    press(app, "return", "end")
    return app


def seen(app):
    """Where the balls are shown."""
    return [app.session.seen[ball.name].position for ball in app.session.world.balls]


def marks(session):
    return [e.time - session.began for e in session.world.log if e.kind != "roll"]


# -- scrubbing -----------------------------------------------------------------------------------


def test_a_moment_shows_the_balls_where_they_were_then(rested):
    session = rested.session
    end = places(session)
    rested.perform(Action("scrub", TICKS))
    assert seen(rested) == [s.position for s in session.world.log.at(session.began + 1.0).values()]
    assert session.readout_time == 1.0
    assert places(session) == end
    press(rested, "end")
    assert seen(rested) == end


def test_dragging_the_timeline_scrubs_and_the_picture_is_the_same_anew(rested):
    layout = rested.view.sight.layout
    track = lanes.track(layout.timeline, layout.s)
    for share in (0.9, 0.1, 0.5, 0.0):
        click(rested, (track.right, track.centery), (track.x + share * track.w, track.centery))
        length = rested.session.world.log[-1].time - rested.session.began
        assert rested.session.readout_time == pytest.approx(share * length, abs=length / track.w)
        assert_same_as_anew(rested)


def test_a_moment_looks_the_same_from_whichever_side_it_is_reached(rested):
    pictures = []
    for before in (0, 3 * TICKS, 9 * TICKS):
        rested.perform(Action("scrub", before))
        rested.frame(FRAME)
        rested.perform(Action("scrub", 2 * TICKS))
        rested.frame(FRAME)
        pictures.append(pixels(rested))
    assert pictures[0] == pictures[1] == pictures[2]


def test_a_row_of_the_log_shows_its_moment(rested):
    layout, session = rested.view.sight.layout, rested.session
    first = max(0, len(marks(session)) + 1 - cards.log_rows(layout.log, layout.s))
    click(rested, cards.log_row(layout.log, layout.s, 2).center)
    assert session.readout_time == pytest.approx(marks(session)[first + 1], abs=2 / TICKS)


def test_steps_by_event_visit_every_event_both_ways(rested):
    times, forth, back = marks(rested.session), [], []
    press(rested, "home")
    for _ in times:
        press(rested, "shift+.")
        forth.append(rested.session.readout_time)
    assert forth == pytest.approx(times, abs=2 / TICKS)
    for _ in times:
        press(rested, "shift+,")
        back.append(rested.session.readout_time)
    assert back == pytest.approx([*times[-2::-1], 0.0], abs=2 / TICKS)


def test_steps_by_frame_go_back_and_forth(rested):
    rested.perform(Action("scrub", TICKS))
    press(rested, ",", ",", ".")
    assert rested.session.timeline.at == TICKS - TICKS // 60


def test_while_balls_roll_one_can_look_back_and_go_on(app):
    press(app, "return")
    for _ in range(60):
        app.frame(FRAME)
    now = places(app.session)
    press(app, "shift+,")
    assert app.session.paused
    assert places(app.session) == now
    assert seen(app) != now
    assert_same_as_anew(app)
    press(app, "p")
    for _ in range(200):
        app.frame(FRAME)
    assert app.session.timeline.at is None
    assert not app.session.paused
    run_to_rest(app)
    straight = an_app()
    press(straight, "return")
    run_to_rest(straight)
    assert places(app.session) == places(straight.session)


def test_pulling_the_timeline_ahead_of_the_balls_lets_them_run_there(app):
    press(app, "return", "p")
    app.perform(Action("scrub", 2 * TICKS))
    assert app.session.world.time == pytest.approx(2.0, abs=1 / TICKS)
    assert app.session.paused


def test_a_shot_is_shown_once_more_at_the_speed_of_time(rested):
    press(rested, "p")
    assert rested.session.timeline.playing
    began = rested.session.readout_time
    for _ in range(30):
        rested.frame(FRAME)
    assert rested.session.readout_time - began == pytest.approx(0.5, abs=0.02)
    assert_same_as_anew(rested)
    press(rested, *["]"] * 3)
    for _ in range(100):
        rested.frame(FRAME)
    assert rested.session.timeline.at is None


def test_the_next_entry_shows_the_present_again(rested):
    rested.perform(Action("scrub", 0))
    press(rested, "left")
    assert rested.session.timeline.at is None
    assert seen(rested) == places(rested.session)


# -- the speed of time ---------------------------------------------------------------------------


@pytest.mark.parametrize("steps", [-3, -2, -1, 1, 2, 3])
def test_time_passes_as_fast_as_it_says(steps):
    session = Session(table_world("medium"))
    perform(session, Action("fire"))
    perform(session, Action("faster", steps))
    session.advance(TICKS // 2)
    assert session.world.time == pytest.approx(0.5 * 2.0**steps, abs=2 / TICKS)
    assert session.timeline.label == (f"×{2**steps}" if steps > 0 else f"×1/{2**-steps}")


def test_brackets_and_the_drawn_signs_change_the_speed(app):
    strip, s = app.view.sight.layout.timeline, app.view.sight.layout.s
    press(app, *["["] * 5)
    assert app.session.timeline.label == "×1/8"
    slower, faster = lanes.rate_halves(strip, s)
    for _ in range(9):
        click(app, faster.center)
    assert app.session.timeline.label == "×8"
    click(app, slower.center)
    assert app.session.timeline.label == "×4"
    assert_same_as_anew(app)


def test_slow_and_fast_shots_end_alike_at_any_frame_rate():
    ends = set()
    for fps in (30, 60, 144):
        session, clock = Session(table_world("medium")), VirtualClock(fps)
        perform(session, Action("fire"))
        perform(session, Action("faster", -2))
        while session.tick < 2 * TICKS:
            session.advance(clock.frame(True))
        perform(session, Action("faster", 4))
        while session.moving:
            session.advance(clock.frame(True))
        ends.add(tuple(places(session)))
    assert len(ends) == 1


@pytest.mark.parametrize("cut", [1, 7, 1092])
def test_the_speed_leaves_no_part_of_a_tick_behind(cut):
    session = Session(table_world("medium"))
    perform(session, Action("fire"))
    perform(session, Action("faster", -3))
    for _ in range(4096 // cut):
        session.advance(cut)
    assert session.world.time == session.tick // 8 / TICKS


# -- undo ----------------------------------------------------------------------------------------


def test_undo_takes_back_a_shot_with_its_numbers_and_redo_plays_it_again(app):
    start = places(app.session)
    enter(app, "2", "1", "0", "0.5", "70")
    press(app, "return", "end")
    end, told = places(app.session), list(app.session.world.log)
    press(app, "left")
    write(app, "1")
    press(app, "escape", "z")
    assert places(app.session) == start
    assert app.session.aim.texts == ["2", "1", "0", "0.5", "70"]
    assert app.session.aim.complete
    assert app.session.shots == 0
    press(app, "y")
    assert places(app.session) == end
    assert app.session.shots == 1
    assert [e.time - app.session.began for e in app.session.world.log] == pytest.approx(
        [e.time for e in told], abs=1e-9
    )


def test_undo_and_redo_have_no_limit(app):
    laid = [places(app.session)]
    for k in range(30):
        press(app, "down" if k % 3 else "ctrl+return", "end")
        laid.append(places(app.session))
    for was in laid[-2::-1]:
        press(app, "z")
        assert places(app.session) == was
    press(app, "z")
    assert app.session.notice.key == "undo"
    for will in laid[1:]:
        press(app, "shift+z")
        assert places(app.session) == will
    press(app, "ctrl+y")
    assert app.session.notice.key == "redo"


def test_a_new_shot_forgets_what_was_undone(app):
    press(app, "down", "z", "ctrl+return", "end")
    assert app.session.history.future == []


def test_undo_in_the_middle_of_a_shot_goes_back_to_before_it(app):
    start = places(app.session)
    press(app, "return")
    for _ in range(20):
        app.frame(FRAME)
    press(app, "z")
    assert places(app.session) == start
    assert not app.session.moving
    assert_same_as_anew(app)


def test_aiming_alone_is_nothing_to_undo(app):
    press(app, "q", "t", "c", "l", "e")
    assert app.session.history.past == []


def test_another_table_begins_another_history(app):
    press(app, "down")
    app.perform(Action("table", "match"))
    assert app.session.history.past == []


def test_the_buttons_of_the_strip_undo_and_redo(app):
    start = places(app.session)
    press(app, "down")
    laid = places(app.session)
    undo, redo, *_ = lanes.buttons(app.view.sight.layout.timeline, app.view.sight.layout.s)
    click(app, undo.center)
    assert places(app.session) == start
    click(app, redo.center)
    assert places(app.session) == laid


# -- laws ----------------------------------------------------------------------------------------


def test_mathavans_cushion_has_the_nose_of_the_table(app):
    app.perform(Action("law", "mathavan"))
    law = app.session.world.cushion_law
    assert type(law).__name__ == "MathavanCushion"
    assert law.nose == app.session.came_with.cushion_law.nose


def test_the_badge_says_when_a_law_may_add_energy(app):
    from game.input.captions import words
    from game.ui.panels.parts import badge

    said = words("en")["law.creates"]
    assert said not in badge(app.session, words("en"))[1]
    app.perform(Action("law", "thesis"))
    assert said in badge(app.session, words("en"))[1]


# -- anything at all -----------------------------------------------------------------------------

NAMES = [
    "left", "right", "up", "down", "space", "return", "tab", "escape", "backspace", "home", "end",
    "pageup", "pagedown", *"abcefgklmpqrtwyz,.[]0123456789-",
]  # fmt: skip
MODS = (0, 0, 0, pygame.KMOD_SHIFT, pygame.KMOD_CTRL, pygame.KMOD_ALT)


def anything(rng, size):
    """A random event of keys, text, mouse or wheel, as SDL would send it."""
    at = rng.randrange(size[0]), rng.randrange(size[1])
    kind = rng.choice((pygame.KEYDOWN,) * 5 + (pygame.TEXTINPUT,) + (pygame.MOUSEMOTION,) * 2 + (
        pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP, pygame.MOUSEWHEEL
    ))  # fmt: skip
    if kind == pygame.KEYDOWN:
        name = rng.choice(NAMES)
        key = ord(name) if len(name) == 1 else getattr(pygame, f"K_{name.upper()}")
        char = name if len(name) == 1 else ""
        return pygame.event.Event(kind, key=key, mod=rng.choice(MODS), unicode=char)
    if kind == pygame.TEXTINPUT:
        return pygame.event.Event(kind, text=rng.choice("0123456789.-+e가"))
    if kind == pygame.MOUSEWHEEL:
        return pygame.event.Event(kind, x=0, y=rng.choice((-3, -1, 1, 2)), flipped=False)
    return pygame.event.Event(kind, pos=at, button=1, rel=(0, 0), buttons=(1, 0, 0))


def play_anything(seed, count, every):
    """Send random events, four a frame; every so many frames the picture must equal a new one."""
    size = (640, 360)
    rng, app = random.Random(seed), an_app(size=size)
    for k in range(count // 4):
        for _ in range(4):
            app.handle(anything(rng, size))
        app.frame(rng.choice((FRAME, FRAME, 6 * FRAME)))
        if k % every == 0:
            assert_same_as_anew(app)
        if app.session.over:
            app.session.over = False
    positions = [p for at in places(app.session) for p in at]
    assert all(p == p and abs(p) < 2 for p in positions)


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.stress)])
def test_random_events_neither_crash_the_game_nor_spoil_the_picture(seed):
    play_anything(seed, 2_000 if seed == 1 else 5_000, 50)


@pytest.mark.stress
def test_a_hundred_thousand_random_events_neither_crash_nor_freeze_the_game():
    play_anything(3, 100_000, 500)


def test_a_match_begun_while_balls_roll_leaves_nothing_of_before_to_undo():
    session = Session(table_world("match"), table="match")
    perform(session, Action("fire"))
    session.advance(TICKS // 10)
    perform(session, Action("match", '{"game":"four-ball"}'))
    before = session.world.layout()
    perform(session, Action("undo"))
    assert session.world.layout() == before
    assert session.notice.key == "undo"


def test_the_next_event_of_a_ball_that_only_spins_is_none():
    session = Session(table_world("medium"))
    perform(session, Action("set", "speed 0.05 follow 0 side 9 angle 180"))
    perform(session, Action("fire"))
    session.advance(5 * TICKS)
    ball, time = session.world.ball("white"), session.world.time
    assert (ball.phase, session.world.next_event) == ("resting", inf)
    assert ball.spin[2] != 0.0
    perform(session, Action("event", 1))
    assert session.moving
    assert session.world.time == time


def test_a_shot_without_an_end_is_scrubbed_on_by_five_minutes_at_most():
    session = Session(scene_world("cradle"), table="cradle")
    perform(session, Action("scrub", 10**30))
    assert session.world.time == pytest.approx(300.0, abs=1.0)


def test_a_stroke_that_cannot_be_read_is_not_played():
    session = Session(table_world("medium"))
    perform(session, Action("play", "0 0 0 0 0"))
    assert not session.moving
    assert session.shots == 0
