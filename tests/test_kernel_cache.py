"""Where the compiled kernel is kept: made once, kept while in use, and then removed."""

import logging
import os
import time
from pathlib import Path

import pytest

pytest.importorskip("numba", reason="compiled batches need the extra `fast`")
from physics import compiled


@pytest.fixture
def home(tmp_path, monkeypatch):
    """The user's cache; nothing is compiled into it."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(compiled, "load", lambda name, subset: "loaded")
    return tmp_path / "danggu"


def kernel():
    """As a new process asks for it."""
    return compiled._kernel.__wrapped__()


def aged(folder, days):
    """A kernel that was last used so many days ago."""
    (folder / "numba").mkdir(parents=True)
    (folder / "numba" / "many.nbi").write_bytes(b"code")
    then = time.time() - 86400 * days
    os.utime(folder, (then, then))
    return folder


def names(home):
    return {folder.name for folder in home.iterdir()}


def test_a_cold_compile_is_announced_once(home, caplog):
    with caplog.at_level(logging.WARNING, logger="physics"):
        kernel()
        kernel()
    assert caplog.text.count("compiling the kernel") == 1
    assert str(home) in caplog.text


def test_a_new_kernel_removes_those_that_nobody_has_used_for_a_week(home):
    aged(home / "kernel-old", 8)
    aged(home / "kernel-old.4711", 8)  # somebody has not finished removing it
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
    assert (ours / "numba" / "many.nbi").exists()


@pytest.mark.parametrize("way", ["mkdir", "rename"])
def test_a_cache_that_lets_nothing_be_made_or_removed_is_left_alone(way, home, monkeypatch):
    def refuses(*_, **__):
        raise PermissionError

    old = aged(home / "kernel-old", 8)
    monkeypatch.setattr(Path, way, refuses)
    assert kernel() == "loaded"
    assert (old / "numba" / "many.nbi").exists()


def test_of_two_who_remove_the_same_kernel_one_does_and_neither_fails(home, monkeypatch):
    old, rename = aged(home / "kernel-old", 8), Path.rename

    def too_late(path, target):
        rename(path, target)
        return rename(path, target)

    monkeypatch.setattr(Path, "rename", too_late)
    assert kernel() == "loaded"
    assert not old.exists()
