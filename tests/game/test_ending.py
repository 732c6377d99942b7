"""How a game ends from outside: signals, and where no window can be opened."""

import os
import signal
import subprocess
import sys
import time

import pytest

from game import __main__ as entry
from game.settings.settings import Store
from game.window import signals
from tests.support.records import lines
from tests.support.sampling import mostly

DANGGU = [sys.executable, "-m", "game"]
NAMES = [name for name in signals.NAMES if hasattr(signal, name)]
posix = pytest.mark.skipif(os.name != "posix", reason="signals of Unix")


def begun(tmp_path, *more):
    """A game that has been played for a moment: a process."""
    script = tmp_path / "script.txt"
    script.write_text("0.1 key m\n0.2 key return\n0.3 key q\n")
    record = tmp_path / "game.rec"
    said = ["--script", script, "--record", record, "--settings", tmp_path / "settings.json"]
    session = subprocess.Popen([*DANGGU, *map(str, said), *more], stderr=subprocess.PIPE, text=True)
    end = time.monotonic() + 30
    while time.monotonic() < end and not (record.exists() and "turn" in record.read_text()):
        time.sleep(0.02)
    return session


@posix
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("times", [1, 5])
def test_a_signal_keeps_the_settings_and_ends_the_record_in_order(tmp_path, name, times):
    session = begun(tmp_path)
    for _ in range(times):
        session.send_signal(getattr(signal, name))
    _, err = session.communicate(timeout=30)
    assert err == ""
    assert session.returncode in (0, 130)
    assert session.returncode == 0 or times > 1
    assert Store(tmp_path / "settings.json").read().muted
    assert "end" in lines(tmp_path / "game.rec")[-1]


@posix
def test_a_game_that_is_killed_leaves_a_record_of_what_was_played(tmp_path, capsys):
    session = begun(tmp_path)
    session.kill()
    session.communicate(timeout=30)
    assert lines(tmp_path / "game.rec")[-1]["do"] == ["turn", "1"]
    assert entry.main(["--replay", str(tmp_path / "game.rec")]) == 0
    assert "the record was cut off" in capsys.readouterr().out


@posix
def test_a_hangup_that_the_shell_ignores_is_ignored(tmp_path):
    before = signal.signal(signal.SIGHUP, signal.SIG_IGN)  # as nohup does
    try:
        session = begun(tmp_path, "--fps", "30")
    finally:
        signal.signal(signal.SIGHUP, before)
    session.send_signal(signal.SIGHUP)
    time.sleep(0.3)
    assert session.poll() is None
    session.send_signal(signal.SIGTERM)
    session.communicate(timeout=30)
    assert session.returncode == 0


@posix
@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    "where", mostly(["physics", "numpy", "pygame", "game.app"], quick=("pygame",))
)
def test_a_signal_while_the_program_starts_ends_it_without_a_traceback(name, where):
    code = (
        "import os, signal, sys, game.__main__ as entry\n"
        "class Interrupts:\n"
        "    def find_spec(self, name, *_):\n"
        f"        if name == {where!r}:\n"
        f"            os.kill(os.getpid(), signal.{name})\n"
        "sys.meta_path.insert(0, Interrupts())\n"
        "sys.exit(entry.main([]))\n"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
    assert done.returncode == (130 if name == "SIGINT" else 0)
    assert done.stderr == ""


@posix
def test_a_replay_that_is_ended_by_a_signal_has_not_come_out_the_same(tmp_path):
    record = tmp_path / "x.rec"
    record.write_text('{"format":"danggu record","version":1,"ticks":65536,"setup":{}}\n')
    code = (
        "import os, signal, sys, game.__main__ as entry, game.replay.replay\n"
        "def late(*_): os.kill(os.getpid(), signal.SIGTERM)\n"
        "game.replay.replay.headless = late\n"
        "sys.exit(entry.main(sys.argv[1:]))\n"
    )
    said = ["--replay", str(record), "--headless"]
    done = subprocess.run([sys.executable, "-c", code, *said], capture_output=True, timeout=60)
    assert done.returncode == 130


def test_the_handlers_of_before_are_put_back():
    before = [signal.getsignal(getattr(signal, name)) for name in NAMES]
    with signals.orderly():
        signals.ignore()
    assert [signal.getsignal(getattr(signal, name)) for name in NAMES] == before


# -- no window -----------------------------------------------------------------------------------

ABSENT = ("DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER", "XDG_RUNTIME_DIR")
nowhere = pytest.mark.skipif(not sys.platform.startswith("linux"), reason="X11 and Wayland")


def run(tmp_path, *said, **environment):
    kept = {name: value for name, value in os.environ.items() if name not in ABSENT}
    home = {"XDG_CONFIG_HOME": str(tmp_path), "XDG_DATA_HOME": str(tmp_path)}
    return subprocess.run(
        [*DANGGU, *said], env={**kept, **home, **environment},
        capture_output=True, text=True, timeout=60,
    )  # fmt: skip


@nowhere
@pytest.mark.parametrize("environment", [{}, {"DISPLAY": ":987"}])
@pytest.mark.parametrize("said", [[], ["--lang", "ko"], ["--fps", "30"]])
def test_without_a_display_the_game_says_so_and_ends(tmp_path, environment, said):
    done = run(tmp_path, *said, **environment)
    assert done.returncode == 2
    assert "danggu: cannot open a window: no display (" in done.stderr
    shown = "DISPLAY is ':987'" if environment else "no DISPLAY"
    assert f"{shown}, no WAYLAND_DISPLAY" in done.stderr
    assert list(tmp_path.iterdir()) == []


@nowhere
def test_a_display_that_does_not_work_is_no_reason_to_play_unseen(tmp_path):
    done = run(tmp_path, SDL_VIDEODRIVER="x11")
    assert done.returncode == 2
    assert "danggu: cannot open a window: " in done.stderr


@nowhere
@pytest.mark.parametrize(
    ("said", "environment"),
    [
        (["--frames", "3"], {}),
        (["--frames", "3"], {"SDL_VIDEODRIVER": "dummy"}),
        (["--frames", "3"], {"SDL_VIDEODRIVER": "offscreen"}),
        (["--version"], {}),
    ],
)
def test_what_needs_no_window_runs_without_a_display(tmp_path, said, environment):
    assert run(tmp_path, *said, **environment).returncode == 0
