"""Where the compiled kernel is kept: made once, kept while in use, and then removed."""

import logging
import os
import time
from pathlib import Path

import pytest

pytest.importorskip("numba", reason="compiled batches need the extra `fast`")
from physics import Shot, scenes, simulate_many
from physics.batch import compiled


@pytest.fixture
def home(tmp_path, monkeypatch):
    """The user's cache; nothing is compiled into it."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(compiled, "load", lambda name, subset: "loaded")
    monkeypatch.setattr(compiled, "_play_nothing", lambda package: None)
    return tmp_path / "danggu"


def kernel():
    """As a new process asks for it."""
    return compiled._kernel.__wrapped__()


def finished(folder):
    """As numba leaves it; the name is of its making."""
    (folder / "kernel_1a").mkdir(parents=True)
    (folder / "kernel_1a" / "calendar.many-99.py311.nbi").write_bytes(b"code")


def aged(folder, days):
    """A kernel that was last used so many days ago."""
    finished(folder)
    then = time.time() - 86400 * days
    os.utime(folder, (then, then))
    return folder


def names(home):
    return {folder.name for folder in home.iterdir()}


def test_a_cold_compile_is_announced_until_one_has_come_to_its_end(home, caplog):
    with caplog.at_level(logging.WARNING, logger="physics"):
        kernel()  # broken off
        kernel()  # or begun by another process meanwhile
        assert caplog.text.count("compiling the kernel") == 2
        finished(compiled.cache_folder())
        kernel()
    assert caplog.text.count("compiling the kernel") == 2
    assert str(home) in caplog.text


def test_numba_leaves_what_the_announcement_looks_for():
    simulate_many(scenes.carom(), "white", [Shot(1.0)], compiled=True)
    assert any(compiled.cache_folder().glob(compiled.DONE))


@pytest.mark.parametrize("name", ["calendar.py", "compiled.py", "binding.py"])
def test_an_edit_of_the_kernel_or_of_how_it_is_compiled_asks_for_a_new_one(name, monkeypatch):
    before, read = compiled.cache_folder(), Path.read_bytes
    monkeypatch.setattr(Path, "read_bytes", lambda path: read(path) + b"#" * (path.name == name))
    assert compiled.cache_folder() != before


def test_a_new_kernel_removes_those_not_used_for_a_week(home):
    aged(home / "kernel-old", 8)
    aged(home / "kernel-old.4711", 8)  # another process is still removing it
    aged(home / "kernel-other-install", 6)
    aged(home / "settings", 100)
    kernel()
    assert names(home) == {compiled.cache_folder().name, "kernel-other-install", "settings"}


def test_a_kernel_in_use_stays_young_and_removes_nothing(home):
    ours = aged(compiled.cache_folder(), 8)
    aged(home / "kernel-old", 8)
    kernel()
    assert names(home) == {ours.name, "kernel-old"}
    assert time.time() - ours.stat().st_mtime < 3600.0
    assert (ours / "kernel_1a" / "calendar.many-99.py311.nbi").exists()


@pytest.mark.parametrize("way", ["mkdir", "rename"])
def test_a_cache_that_lets_nothing_be_made_or_removed_is_left_alone(way, home, monkeypatch):
    def refuses(*_, **__):
        raise PermissionError

    old = aged(home / "kernel-old", 8)
    monkeypatch.setattr(Path, way, refuses)
    assert kernel() == "loaded"
    assert (old / "kernel_1a" / "calendar.many-99.py311.nbi").exists()


def test_of_two_processes_that_remove_the_same_kernel_one_does_and_neither_fails(home, monkeypatch):
    old, rename = aged(home / "kernel-old", 8), Path.rename

    def too_late(path, target):
        rename(path, target)
        return rename(path, target)

    monkeypatch.setattr(Path, "rename", too_late)
    assert kernel() == "loaded"
    assert not old.exists()


def test_code_with_checked_bounds_is_kept_apart(home, monkeypatch):
    from numba.core import config

    folder = compiled.cache_folder()
    monkeypatch.setattr(config, "BOUNDSCHECK", 1)
    assert compiled.cache_folder() != folder
