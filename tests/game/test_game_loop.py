"""The loop: the same outcome however time is cut, nothing done when nothing changes."""

import random
import subprocess
import sys

import pygame
import pytest

from game import __main__ as entry
from game.aim.entry import Aim
from game.replay.script import parse
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Notice, Session
from game.session.ticks import TICKS, shares
from game.table.presets import SCENES, table_world
from game.window.clock import LONGEST, RealClock, VirtualClock
from physics import EventDriven, simulate
from physics.log import Log
from tests.support.players import (
    FRAME,
    TWO_SHOTS,
    an_app,
    assert_same_as_anew,
    click,
    places,
    press,
    run_to_rest,
    write,
)


def end_of(fps, substeps):
    """Where the balls rest after two shots, the second while they move."""
    app = an_app(fps=fps, substeps=substeps)
    app.script = parse(TWO_SHOTS)
    app.view.draw = lambda surface: []  # drawing changes nothing, and takes most of the time
    clock = VirtualClock(fps)
    while app.session.tick < 14 * TICKS:
        app.frame(clock.frame(True))
    assert app.session.shots == 2
    assert not app.session.moving
    return places(app.session)


def test_frame_rate_and_substeps_leave_no_trace_in_the_outcome():
    ways = [(30, 1), (60, 1), (60, 2), (60, 6), (60, 7), (144, 6), (144, 1)]
    ends = {tuple(end_of(fps, n)) for fps, n in ways}
    assert len(ends) == 1


@pytest.mark.parametrize("ticks", [0, 1, 5, 6, 7, 1092, 6553])
@pytest.mark.parametrize("n", [1, 2, 6, 7])
def test_shares_of_a_frame_add_up_and_none_is_empty(ticks, n):
    parts = list(shares(ticks, n))
    assert sum(parts) == ticks
    assert all(part > 0 for part in parts)
    assert len(parts) == min(n, ticks)


@pytest.mark.parametrize("fps", [30, 60, 144])
def test_a_virtual_second_is_a_second(fps):
    clock = VirtualClock(fps)
    assert sum(clock.frame(True) for _ in range(fps)) == TICKS


def test_a_slow_frame_does_not_make_the_game_race():
    clock = RealClock(1000)
    clock.frame(True)
    pygame.time.wait(250)
    assert clock.frame(True) == LONGEST


def test_physics_is_called_n_times_a_frame():
    for n in (1, 6):
        app = an_app(substeps=n)
        press(app, "return")
        before = app.session.calls
        app.frame(FRAME)
        assert app.session.calls - before == n


def test_nothing_is_drawn_and_no_physics_called_when_nothing_changes():
    app = an_app()
    press(app, "return")
    run_to_rest(app)
    app.frame(FRAME)
    drawn, calls, skipped = app.stats.drawn, app.session.calls, app.stats.skipped
    for _ in range(100):
        app.frame(FRAME)
    assert (app.stats.drawn, app.session.calls) == (drawn, calls)
    assert app.stats.skipped == skipped + 100


def scripted(tmp_path, *arguments):
    path = tmp_path / "s.txt"
    path.write_text("0 key return\n", encoding="utf-8")
    return entry.main(["--script", str(path), "--stats", *arguments])


def test_a_scripted_shot_runs_headless_and_tells_what_it_did(tmp_path, capsys):
    picture = tmp_path / "x.png"
    assert scripted(tmp_path, "--frames", "120", "--screenshot", str(picture)) == 0
    said = capsys.readouterr().out
    world = table_world("medium")
    events = [e for e in simulate(world, "white", Aim().shot).log if e.time <= 2.0]
    wanted = f"frames drawn 120, frames skipped 0, physics calls 720, events {len(events)},"
    assert wanted in said
    assert pygame.image.load(str(picture)).get_size() == (1280, 720)


def test_headless_runs_are_the_same_picture_every_time(tmp_path):
    pictures = []
    for name in ("a.png", "b.png"):
        assert scripted(tmp_path, "--frames", "90", "--screenshot", str(tmp_path / name)) == 0
        pictures.append((tmp_path / name).read_bytes())
    assert pictures[0] == pictures[1]


def test_quit_in_a_script_ends_before_the_frames_are_over(tmp_path, capsys):
    path = tmp_path / "s.txt"
    path.write_text("0.5 quit  # enough\n", encoding="utf-8")
    assert entry.main(["--script", str(path), "--frames", "1000", "--stats"]) == 0
    assert "game time 0.50 s" in capsys.readouterr().out


@pytest.mark.parametrize("scene", SCENES)
def test_every_scene_can_be_played_in_the_game(scene):
    app = an_app(scene=scene)
    began_moving = app.session.moving
    for _ in range(30):
        app.frame(FRAME)
    assert app.stats.drawn > (20 if began_moving else 0)


def test_a_scene_that_begins_in_motion_shows_its_shot_in_the_boxes_and_can_be_retried():
    app = an_app(scene="thesis_1")
    assert [float(t) for t in app.session.aim.texts] == [2, -10, 5, 0, 0]
    run_to_rest(app)
    first = places(app.session)
    press(app, "r")
    assert app.session.moving
    run_to_rest(app)
    assert places(app.session) == first


def test_an_action_nobody_knows_is_an_error():
    with pytest.raises(KeyError):
        perform(Session(table_world("medium")), Action("dance"))


def test_actions_replayed_at_their_ticks_give_the_same_game():
    app = an_app()
    app.script = parse(TWO_SHOTS)
    while app.session.tick < 4 * TICKS:
        app.frame(FRAME)
    again = Session(table_world("medium"), substeps=1)
    for tick, action in app.actions:
        again.advance(tick - again.tick)
        perform(again, action)
    again.advance(app.session.tick - again.tick)
    assert places(again) == places(app.session)


KEYS = [
    "left", "right", "down", "space", "return", "tab", "escape", "backspace", "p", ".", "e", "l",
    "r", "f1", "f2", "end", "ctrl+return", "shift+tab", "up", "a", "x", "-", "3",
]  # fmt: skip


@pytest.mark.parametrize(("seed", "scene"), [(4, None), (2, "thesis_3a"), (5, "single")])
def test_random_events_neither_crash_the_game_nor_spoil_the_picture(seed, scene):
    rng, app = random.Random(seed), an_app(size=(640, 360), scene=scene)
    for k in range(400):
        if k % 20 == 0:
            assert_same_as_anew(app)
        match rng.randrange(5):
            case 0 | 1:
                press(app, rng.choice(KEYS))
            case 2:
                write(app, rng.choice("0123456789.-+e가nf"))
            case 3:
                click(app, (rng.randrange(960), rng.randrange(540)))
            case _:
                at, to = ((rng.randrange(960), rng.randrange(540)) for _ in range(2))
                click(app, at, to)
    assert not app.session.over


def test_starting_the_game_loads_neither_numba_nor_matplotlib():
    code = (
        "import sys; from game.__main__ import main; main(['--frames', '1'])\n"
        "heavy = {'numba', 'matplotlib', 'scipy', 'pkg_resources'}\n"
        "sys.exit(', '.join(heavy & set(sys.modules)) or None)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.stderr == ""
    assert done.returncode == 0


def test_a_shot_with_too_many_events_is_stopped_with_a_message_and_the_game_goes_on():
    app = an_app()
    app.session.world.engine = EventDriven(budget=3)
    press(app, "return")
    for _ in range(200):
        app.frame(FRAME)
    assert not app.session.moving
    assert app.session.notice == Notice("budget", error=True)
    app.session.world.engine = EventDriven()
    press(app, "r", "return")
    assert app.session.moving


def test_events_are_worked_out_of_the_log_once_and_once_more_at_rest(monkeypatch):
    made, whole = [], Log._event

    def counted(log, *raw):
        made.append(raw)
        return whole(log, *raw)

    monkeypatch.setattr(Log, "_event", counted)
    app = an_app(scene="rack15")
    run_to_rest(app)
    press(app, "n")  # the list is drawn anew
    log = app.session.world.log
    # the last one is looked at again to see how long the shot has lasted
    assert 60 < len(log) <= len(made) <= 2 * len(log) + 10


def test_what_is_told_of_a_shot_is_what_its_log_says_also_after_undo():
    app = an_app()
    press(app, "return")
    for then in ((), ("space",), ("z", "return"), ("r", "ctrl+return"), ("home",), ("end",)):
        press(app, *then)
        for _ in range(40):
            app.frame(FRAME)
            assert list(app.session.timeline.events) == list(app.session.world.log)
