"""Settings: a file that may be broken, and what the command line says against it."""

import json
import os
from dataclasses import asdict, fields

import pytest

from game import __main__ as entry
from game import options
from game.app import App
from game.session.session import Notice
from game.settings import settings
from game.settings.settings import FORMAT, VERSION, Settings, Store
from tests.support.players import FREE

SWITCHES = [f.name for f in fields(Settings) if f.default is False]
CHOSEN_ONES = Settings(
    language="ko", table="match", cloth="humid", law="thesis", engine="thesis", aids="short",
    colours="safe", volume=3, keys={"pause": FREE}, size=(1000, 600),
    **dict.fromkeys(SWITCHES, True),
)  # fmt: skip


@pytest.fixture(autouse=True)
def folders(tmp_path, monkeypatch):
    """A home of our own, whose language is English."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("LC_ALL", "C")


@pytest.fixture
def path(tmp_path):
    return tmp_path / "settings.json"


def document(**changes):
    return {
        "format": FORMAT,
        "version": VERSION,
        **asdict(CHOSEN_ONES),
        "size": [1000, 600],
    } | changes


def written(path, content):
    path.write_text(json.dumps(content), encoding="utf-8")
    return Store(path)


# -- the file ------------------------------------------------------------------------------------


def test_what_is_saved_is_what_is_loaded(path):
    assert Store(path).save(CHOSEN_ONES)
    store = Store(path)
    assert store.load() == CHOSEN_ONES
    assert store.faults == []
    assert list(path.parent.iterdir()) == [path]


def test_without_a_file_everything_is_as_usual_and_no_file_appears(path):
    store = Store(path)
    assert store.load() == Settings()
    assert store.faults == []
    assert not path.exists()


def test_somebody_whose_system_is_korean_begins_in_korean(monkeypatch):
    monkeypatch.setenv("LC_ALL", "ko_KR.UTF-8")
    assert settings.start().language == "ko"


BAD = [
    ("language", "fr"), ("table", 7), ("cloth", None), ("law", ["rigid"]), ("engine", "Exact"),
    ("aids", ""), ("colours", {}), ("volume", 11), ("volume", -1), ("volume", True),
    ("volume", 3.5), ("muted", 1), ("still", "yes"), ("fan", 0), ("keys", []), ("size", [1280]),
    ("size", [0, 720]), ("size", ["1280", "720"]), ("size", 1280), ("size", [1e9, 720]),
]  # fmt: skip


@pytest.mark.parametrize(("name", "value"), BAD)
def test_a_bad_value_falls_back_alone_and_the_file_is_kept_beside(path, name, value):
    store = written(path, document(**{name: value}))
    before = path.read_bytes()
    loaded = store.load()
    usual = Settings()
    for field in fields(Settings):
        wanted = usual if field.name == name else CHOSEN_ONES
        assert getattr(loaded, field.name) == getattr(wanted, field.name)
    assert store.faults == [name]
    assert path.with_name("settings.json.broken").read_bytes() == before
    mended = Store(path)
    assert mended.load() == loaded
    assert mended.faults == []


NO_SETTINGS = [b"", b"{", b"[]", b"null", b"\xff\xfe\x00", b"[" * 99999, b'{"language": "ko"}']


@pytest.mark.parametrize("content", NO_SETTINGS)
def test_a_file_that_is_none_is_kept_beside_and_replaced(path, content):
    path.write_bytes(content)
    store = Store(path)
    assert store.load() == Settings()
    assert store.faults == ["format"]
    assert path.with_name("settings.json.broken").read_bytes() == content
    assert Store(path).load() == Settings()


def test_settings_of_a_later_version_are_read_as_far_as_they_are_understood(path):
    store = written(path, document(version=VERSION + 1, weather="fine"))
    assert store.load() == CHOSEN_ONES
    assert store.faults == ["version"]


def test_a_folder_in_place_of_the_file_is_left_alone(path):
    path.mkdir()
    store = Store(path)
    assert store.load() == Settings()
    assert not store.save(Settings(volume=1))
    assert path.is_dir()


def test_saving_that_fails_half_way_leaves_the_old_file_and_nothing_else(path, monkeypatch):
    store = Store(path)
    store.save(CHOSEN_ONES)

    def fails(source, target):
        raise OSError("the disk is full")

    monkeypatch.setattr(os, "replace", fails)
    assert not store.save(Settings())
    assert Store(path).load() == CHOSEN_ONES
    assert list(path.parent.iterdir()) == [path]


def test_nothing_is_written_when_nothing_has_changed(path):
    store = Store(path)
    store.save(CHOSEN_ONES)
    path.unlink()
    assert store.save(CHOSEN_ONES)
    assert not path.exists()


def test_bad_keys_in_the_file_are_named(path):
    store = written(path, document(keys={"pause": "3", "retry": FREE}))
    assert store.load().keys == {"retry": FREE}
    assert store.faults == ["keys.pause"]


# -- the command line ----------------------------------------------------------------------------


def test_settings_fill_in_what_the_command_line_leaves_open():
    said = options.read(["--lang", "en", "--size", "640x360"])
    merged = CHOSEN_ONES.applied(said)
    assert (merged.lang, merged.size) == ("en", (640, 360))
    assert (merged.table, merged.cloth, merged.law, merged.engine) == (
        "match", "humid", "thesis", "thesis",
    )  # fmt: skip


def test_cloth_and_laws_of_another_table_are_not_those_that_were_chosen():
    merged = CHOSEN_ONES.applied(options.read(["--table", "thesis"]))
    assert (merged.table, merged.cloth, merged.law) == ("thesis", "table", None)


def played(tmp_path, lines, *more):
    script = tmp_path / "script.txt"
    script.write_text(lines, encoding="utf-8")
    said = ["--script", str(script), "--frames", "40", "--size", "640x360", *more]
    assert entry.main(said) == 0


def test_what_the_command_line_says_is_not_saved_and_what_the_player_does_is(tmp_path, path):
    written(path, document(keys={})).load()
    played(tmp_path, "0.1 key m\n", "--settings", str(path), "--lang", "en", "--table", "thesis")
    loaded = Store(path).load()
    assert (loaded.language, loaded.table, loaded.law) == ("ko", "match", "thesis")
    assert not loaded.muted
    played(tmp_path, "0.1 key f2\n0.2 key e\n", "--settings", str(path), "--lang", "ko")
    loaded = Store(path).load()
    assert (loaded.language, loaded.engine, loaded.table) == ("en", "exact", "match")


def test_runs_that_nobody_watches_neither_read_nor_write(tmp_path):
    home = settings.folder()
    assert home == tmp_path / "config" / "danggu"
    played(tmp_path, "0.1 key f2\n0.2 key m\n")
    assert not home.exists()
    home.mkdir(parents=True)
    (home / "settings.json").write_text("broken")
    played(tmp_path, "0.1 key f2\n")
    assert [p.name for p in home.iterdir()] == ["settings.json"]


def test_that_the_file_was_broken_is_said_once(path, monkeypatch):
    said = []
    path.write_text("broken")
    monkeypatch.setattr(App, "run", lambda app: said.append(app.session.notice))
    for _ in range(2):
        assert entry.main(["--settings", str(path), "--frames", "1"]) == 0
    assert said == [Notice("settings.broken"), None]
