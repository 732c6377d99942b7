"""Files of the user: what may be replaced, and what is left as it is."""

import os
import socket
import stat
from pathlib import Path
from threading import Timer

import pytest

from game.__main__ import new_game
from game.options import Options
from game.replay.game_record import RecordError
from game.replay.recorder import Recorder
from game.settings import user_files
from game.settings.settings import Settings, Store
from game.table.library import Library
from game.table.lineup import read as lineup
from physics import Shot, store
from physics import whole_files as whole

LINE = lineup("danggu1 medium white=-0.5,0.0 red1=0.5,0.25")
CHOSEN = Settings(volume=1)
WAYS = {
    "settings": lambda path: Store(path).save(CHOSEN),
    "settings that are read first": lambda path: loaded(path).save(CHOSEN),
    "set-ups": lambda path: Library(path).put("name", LINE),
    "a shot": lambda path: saved(store.save, Shot(1.0), path),
    "a record": lambda path: saved(Recorder, str(path), Options(), new_game(Options())),
}
"""Every way in which the program replaces a file: true if it has."""


def loaded(path):
    store = Store(path)
    store.load()
    return store


def saved(save, *arguments):
    try:
        save(*arguments)
    except (OSError, RecordError):
        return False
    return True


def a_pipe(path):
    os.mkfifo(path)


def a_socket(path):
    with socket.socket(socket.AF_UNIX) as end:
        end.bind(path.name)  # a whole path may be too long


def a_device(path):
    try:
        os.mknod(path, stat.S_IFCHR | 0o666, os.makedev(1, 3))  # as /dev/null
    except PermissionError:
        pytest.skip("only root can make devices")


@pytest.mark.skipif(os.name != "posix", reason="other systems have no such files")
@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("make", [a_pipe, a_socket, a_device, Path.mkdir])
@pytest.mark.parametrize("linked", [False, True])
def test_what_is_no_regular_file_is_left_alone(tmp_path, monkeypatch, make, way, linked):
    monkeypatch.chdir(tmp_path)
    odd = tmp_path / "odd"
    make(odd)
    path = tmp_path / "link" if linked else odd
    if linked:
        path.symlink_to(odd)
    before = os.lstat(odd)
    assert not WAYS[way](path)
    after = os.lstat(odd)
    assert (after.st_ino, after.st_mode) == (before.st_ino, before.st_mode)
    assert {p.name for p in tmp_path.iterdir()} == {"odd", path.name}


@pytest.mark.parametrize("there", [True, False])
def test_a_link_stays_a_link_and_its_target_is_replaced(tmp_path, there):
    (tmp_path / "dots").mkdir()
    target, link = tmp_path / "dots" / "settings.json", tmp_path / "settings.json"
    if there:
        Store(target).save(Settings())
    link.symlink_to(Path("dots") / "settings.json")
    assert Store(link).save(CHOSEN)
    assert link.is_symlink()
    assert Store(target).load() == CHOSEN
    assert [p.name for p in target.parent.iterdir()] == ["settings.json"]


def test_a_ring_of_links_is_left_alone(tmp_path):
    (tmp_path / "a").symlink_to(tmp_path / "b")
    (tmp_path / "b").symlink_to(tmp_path / "a")
    assert not Store(tmp_path / "a").save(CHOSEN)
    assert (tmp_path / "a").is_symlink()


def test_what_a_link_named_broken_leads_to_is_not_ours(tmp_path):
    path, other = tmp_path / "settings.json", tmp_path / "letter.txt"
    path.write_text("broken")
    other.write_text("dear")
    path.with_name("settings.json.broken").symlink_to(other)
    Store(path).load()
    assert other.read_text() == "dear"
    assert path.with_name("settings.json.broken").read_text() == "broken"
    assert Store(path).load() == Settings()


@pytest.mark.parametrize("make", [Path.mkdir, a_pipe])
def test_a_broken_file_that_cannot_be_set_aside_is_not_replaced(tmp_path, make):
    path = tmp_path / "x.json"
    path.write_text("broken")
    make(path.with_name("x.json.broken"))
    store, library = Store(path), Library(path)
    store.load()
    assert not store.save(CHOSEN)
    assert store.trouble
    assert not library.put("name", LINE)
    assert path.read_text() == "broken"


def test_permissions_are_kept_and_a_new_file_has_those_of_any_new_file(tmp_path):
    path = tmp_path / "settings.json"
    Store(path).save(CHOSEN)
    (tmp_path / "any").write_text("")
    assert path.stat().st_mode == (tmp_path / "any").stat().st_mode
    path.chmod(0o640)
    Store(path).save(Settings())
    assert stat.S_IMODE(path.stat().st_mode) == 0o640


def test_a_file_that_may_not_be_written_is_not_replaced(tmp_path, monkeypatch):
    path = tmp_path / "settings.json"
    Store(path).save(CHOSEN)
    path.chmod(0o444)
    asked = os.access
    monkeypatch.setattr(os, "access", lambda p, how: Path(p) != path and asked(p, how))  # not root
    assert not Store(path).save(Settings())
    assert Store(path).read() == CHOSEN


def test_a_file_left_by_a_process_that_was_killed_is_in_nobodys_way(tmp_path):
    left = tmp_path / f".danggu-{os.getpid()}-0.tmp"
    left.write_text("half")
    whole.replace(tmp_path / "x", b"all")
    assert (tmp_path / "x").read_bytes() == b"all"
    assert left.read_text() == "half"


def test_a_byte_order_mark_does_no_harm(tmp_path):
    path = tmp_path / "settings.json"
    Store(path).save(CHOSEN)
    path.write_bytes(b"\xef\xbb\xbf" + path.read_bytes())
    store = Store(path)
    assert store.load() == CHOSEN
    assert store.faults == []


def test_a_file_without_an_end_is_not_read_to_its_end(tmp_path, monkeypatch):
    monkeypatch.setattr(user_files, "MOST", 10)
    path = tmp_path / "x"
    path.write_text("12345678901")
    with pytest.raises(OSError, match="longer than 10 bytes"):
        user_files.read(path)
    with pytest.raises(OSError, match="longer than 10 bytes"):
        user_files.stream(str(path), 10)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_without_a_writer_is_empty(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    assert user_files.stream(str(tmp_path / "pipe"), 10) == b""


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_is_read_until_its_writer_is_done(tmp_path):
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    reader = os.open(pipe, os.O_RDONLY | os.O_NONBLOCK)
    writer = os.open(pipe, os.O_WRONLY)
    os.write(writer, b"data")
    Timer(0.2, os.close, [writer]).start()
    assert user_files.stream(str(pipe), 10) == b"data"
    os.close(reader)


def test_a_user_without_a_home_plays_and_keeps_nothing(monkeypatch):
    def none(*_, **__):
        raise RuntimeError("could not determine the home directory")

    monkeypatch.setattr("platformdirs.user_config_path", none)
    monkeypatch.setattr("platformdirs.user_data_path", none)
    store, library = Store(), Library()
    assert store.load() == Settings()
    assert not store.save(CHOSEN)
    assert library.items == {}
    assert not library.put("name", LINE)
