"""Files of the user: regular ones only, replaced whole, and changed by one game at a time."""

from __future__ import annotations

import errno
import os
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from io import FileIO
from pathlib import Path

from physics import whole_files

MOST = 1 << 24
"""Bytes of the largest file that is read: set-ups are a hundred bytes each."""
PATIENCE = 2.0
"""Seconds to wait for another game: one that hangs must not hold this one up."""

regular = whole_files.regular


def folder(found: Callable[..., Path]) -> Path | None:
    """Return the game's folder by a function of platformdirs; None for a user without a home."""
    try:
        path = found("danggu", appauthor=False)
    except RuntimeError:
        return None
    return path if path.is_absolute() else None


def read(path: Path, most: int | None = None) -> str:
    """Return the text of a regular file, with or without a byte order mark.

    FileNotFoundError if there is none; OSError if it is no such file, is longer than `most` bytes
    (MOST), or cannot be read; UnicodeDecodeError if it is no text.
    """
    real, most = whole_files.regular(path), MOST if most is None else most
    with real.open("rb") as file:
        data = file.read(most + 1)
    if len(data) > most:
        raise OSError(errno.EFBIG, f"longer than {most} bytes")
    return data.decode("utf-8-sig")


def write(path: Path, text: str) -> None:
    """Put the text there, all of it or nothing; OSError.  A link stays a link."""
    whole_files.replace(path, text.encode())


def set_aside(path: Path) -> None:
    """Keep what is in a file beside it as .broken; OSError if that cannot be.

    An older .broken is replaced. If that is a link, the link is: what it leads to is not ours.
    """
    data = whole_files.regular(path).read_bytes()
    aside = path.with_name(path.name + ".broken")
    if aside.is_symlink():
        aside.unlink()
    whole_files.replace(aside, data)


def stream(path: str, most: int) -> bytes:
    """Return all that a file holds, or a pipe into which something is writing; OSError.

    A pipe without a writer is empty, a device that never ends is too long.
    """
    wait_not = getattr(os, "O_NONBLOCK", 0)  # only opening it must not wait
    handle = os.open(path, os.O_RDONLY | wait_not | getattr(os, "O_BINARY", 0))
    try:
        if sys.platform != "win32":
            os.set_blocking(handle, True)
        with open(handle, "rb", closefd=False) as file:
            data = file.read(most + 1)
    finally:
        os.close(handle)
    if len(data) > most:
        raise OSError(errno.EFBIG, f"longer than {most} bytes")
    return data


def insist_on_room(path: str) -> None:
    """OSError, saying why, unless a file can be begun there; nothing is changed."""
    real = whole_files.regular(path)
    for place in (real.parent, real) if real.exists() else (real.parent,):
        if not os.access(place, os.W_OK):
            number = errno.EACCES if place.exists() else errno.ENOENT
            raise OSError(number, os.strerror(number), path)
    if real.exists():
        with real.open("rb") as file:
            _claim(file.fileno())


def begun(path: str, head: bytes) -> FileIO:
    """Begin a file that grows, over an old one; OSError, also if another game is writing it."""
    insist_on_room(path)
    whole_files.replace(path, head)
    file = FileIO(whole_files.regular(path), "ab")
    try:
        _claim(file.fileno())
    except OSError:
        file.close()
        raise
    return file


@contextmanager
def alone(path: Path) -> Iterator[None]:
    """Keep other games away from a file while it is read, changed and written again.

    Its folder is made if need be; OSError where that cannot be. Where there are no locks, and when
    another game keeps its lock for longer than PATIENCE, it goes on without.
    """
    real = whole_files.regular(path)
    real.parent.mkdir(parents=True, exist_ok=True)
    handle = _locked(real)
    try:
        yield
    finally:
        if handle is not None:
            os.close(handle)


def _locked(real: Path) -> int | None:
    """Lock the file until what is returned is closed, also by a crash; None without a lock."""
    end = time.monotonic() + PATIENCE
    while True:
        try:
            return _lock(real)
        except BUSY:
            if time.monotonic() > end:
                return None
            time.sleep(0.01)
        except OSError:
            return None


if sys.platform == "win32":
    BUSY = FileExistsError, PermissionError

    def _lock(real: Path) -> int:
        # the file goes when its handle does, even if the process is killed
        flags = os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_TEMPORARY
        return os.open(real.with_name(real.name + ".lock"), flags)

    def _claim(handle: int) -> None:
        """Nothing to do: a file that is open cannot be replaced here."""

else:
    import fcntl

    BUSY = BlockingIOError

    def _lock(real: Path) -> int:
        # the folder's lock: one of the file's own would go with the file when it is replaced
        handle = os.open(real.parent, os.O_RDONLY)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            os.close(handle)
            raise
        return handle

    def _claim(handle: int) -> None:
        """Keep other games from an open file until it is closed; OSError if one has it."""
        try:
            fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise OSError(errno.EBUSY, "another game is writing it") from None
        except OSError:
            return  # a file system without locks
