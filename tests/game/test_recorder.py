"""Writing a record: what becomes of an old one, of a full disk, of two games and of a viewer."""

import json
import os
import subprocess
import sys

import pytest

from game import __main__ as entry
from game.__main__ import new_game
from game.app import App
from game.replay.game_record import RecordError, read
from game.replay.recorder import Recorder
from game.replay.replay import headless
from game.session.action import Action
from game.session.session import Notice
from game.settings.settings import Settings, Store
from game.table.library import Library
from game.table.lineup import read as lineup
from game.text import LANGUAGES
from tests.support.players import FRAME, an_app, press
from tests.support.records import OPTIONS, lines, recorded, replayed, shown


@pytest.fixture
def path(tmp_path):
    return tmp_path / "game.rec"


def begun(path):
    session = new_game(OPTIONS)
    return App(session, OPTIONS, journal=Recorder(str(path), OPTIONS, session))


# -- an old record -------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "said",
    [
        ["--script", "none.txt"],
        ["--game", "four-ball", "--players", "a,b,c"],
        ["--setup", "danggu1 nowhere"],
        ["--settings", "."],
    ],
)
def test_a_game_that_cannot_begin_leaves_an_old_record_as_it_is(path, said, capsys):
    path.write_text("old")
    assert entry.main(["--record", str(path), "--frames", "1", *said]) == 2
    assert path.read_text() == "old"
    assert [p.name for p in path.parent.iterdir()] == ["game.rec"]


def test_a_game_without_a_window_leaves_an_old_record_as_it_is(path, monkeypatch, capsys):
    path.write_text("old")
    monkeypatch.setenv("SDL_VIDEODRIVER", "none")
    assert entry.main(["--record", str(path)]) == 2
    assert "cannot open a window" in capsys.readouterr().err
    assert path.read_text() == "old"


def test_an_old_record_stays_until_the_first_action_and_is_replaced_by_a_whole_one(path):
    path.write_text("old")
    app = begun(path)
    app.frame(FRAME)
    assert path.read_text() == "old"
    press(app, "return")
    assert [line.get("do") for line in lines(path)] == [None, ["shoot"]]
    app.close()
    assert "end" in lines(path)[-1]


def test_a_game_in_which_nothing_was_done_has_a_record_too(path, capsys):
    assert entry.main(["--record", str(path), "--frames", "3"]) == 0
    assert replayed(path) == 0


def test_a_record_behind_a_link_is_written_where_the_link_leads(tmp_path, path):
    path.symlink_to(tmp_path / "far.rec")
    begun(path).close()
    assert path.is_symlink()
    assert len(lines(tmp_path / "far.rec")) == 2


def test_a_name_that_utf_8_cannot_write_is_recorded(path):
    app = begun(path)
    app.perform(Action("hold", "a\ud800b\u2028"))
    app.close()
    played = read(str(path), OPTIONS)
    assert played.actions[-1][1] == Action("hold", "a\ud800b\u2028")


# -- a full disk ---------------------------------------------------------------------------------


def test_on_a_full_disk_the_game_goes_on_and_its_record_ends(path, monkeypatch):
    app = begun(path)
    press(app, "return")
    whole = path.read_bytes()

    def full(file, data):
        file.write(data[:10])
        raise OSError(28, "No space left on device")

    class Full:
        def __init__(self, file):
            self.file = file

        def __getattr__(self, name):
            return getattr(self.file, name)

        def write(self, data):
            return full(self.file, data)

    app.journal._file = Full(app.journal._file)
    press(app, "space")
    assert app.session.notice == Notice("record.cut", error=True)
    assert app.journal.fault.endswith("No space left on device")
    press(app, "p")
    assert app.session.notice is None
    app.close()
    assert path.read_bytes() == whole
    replay = headless(read(str(path), OPTIONS), new_game(OPTIONS))
    assert replay.state == "same"


@pytest.mark.skipif(os.name != "posix", reason="files of limited size")
def test_a_full_disk_is_told_at_the_end_and_loses_no_settings(tmp_path, path):
    script = tmp_path / "script.txt"
    turns = [f"{1 + k / 20:.2f} key q" for k in range(100)]
    script.write_text("\n".join(["0.1 key m", "0.2 key return", "0.3 key space", *turns]))
    code = (
        "import resource, sys; from game.__main__ import main\n"
        "resource.setrlimit(resource.RLIMIT_FSIZE, (3000, 3000))\n"
        "sys.exit(main(sys.argv[1:]))\n"
    )
    said = ["--script", str(script), "--record", str(path), "--frames", "700"]
    settings = tmp_path / "settings.json"
    done = subprocess.run(
        [sys.executable, "-c", code, *said, "--settings", str(settings)],
        capture_output=True, text=True, timeout=60,
    )  # fmt: skip
    assert done.returncode == 2
    assert done.stderr.startswith(f"danggu: record {str(path)!r} was cut off at ")
    assert len(done.stderr.splitlines()) == 1
    assert Store(settings).load().muted
    assert path.read_bytes().endswith(b"\n")
    assert replayed(path) == 0


# -- two games -----------------------------------------------------------------------------------


@pytest.mark.skipif(os.name != "posix", reason="elsewhere an open file cannot be replaced at all")
def test_a_record_that_another_game_is_writing_is_refused(path):
    app = begun(path)
    press(app, "return")
    with pytest.raises(RecordError, match="another game is writing it"):
        begun(path)
    app.close()
    begun(path).close()


# -- watching ------------------------------------------------------------------------------------


def test_watching_a_replay_changes_nothing_of_the_viewers(tmp_path, monkeypatch, capsys):
    record = recorded(tmp_path)
    found = lines(record)
    found.insert(1, {"tick": 0, "do": ["language", "ko"]})
    found.insert(1, {"tick": 0, "do": ["table", "match"]})
    found.insert(1, {"tick": 0, "do": ["settings"]})
    found.insert(2, {"tick": 0, "do": ["settings"]})
    record.write_text("".join(json.dumps(line) + "\n" for line in found))
    folder = tmp_path / "own"
    folder.mkdir()
    settings, setups = folder / "settings.json", folder / "set-ups.json"
    Store(settings).save(Settings(volume=3))
    Library(setups).put("a", lineup("danggu1 medium white=0,0"))
    before = [(p.stat().st_mtime_ns, p.read_bytes()) for p in (settings, setups)]
    monkeypatch.setattr("game.table.library.folder", lambda: folder)
    assert shown(record, "--settings", str(settings)) == 3
    assert [(p.stat().st_mtime_ns, p.read_bytes()) for p in (settings, setups)] == before
    settings.write_text("broken")
    assert shown(record, "--settings", str(settings)) == 3
    assert settings.read_text() == "broken"
    assert {p.name for p in folder.iterdir()} == {"settings.json", "set-ups.json"}


def test_a_replay_without_a_window_ends_with_its_record(tmp_path, capsys):
    record = recorded(tmp_path)
    assert entry.main(["--replay", str(record)]) == 0
    assert entry.main(["--replay", str(record), "--stats"]) == 0
    assert "the same, shots: 5" in capsys.readouterr().out


def test_a_notice_of_the_recorder_has_its_words_in_every_language():
    for language in LANGUAGES:
        app = an_app(lang=language)
        app.session.notice = Notice("record.cut", error=True)
        app.session.version += 1
        app.session.news += 1
        assert app.render()
