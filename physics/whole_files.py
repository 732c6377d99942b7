"""Files are replaced whole: a reader finds the old text or the new one, never a part."""

import errno
import os
import stat
from contextlib import suppress
from pathlib import Path


def regular(path: str | os.PathLike[str]) -> Path:
    """The regular file that a path leads to, or would create; OSError for anything else.

    A symlink stands for the file it leads to. Devices, pipes, sockets and folders are refused: to
    replace one by a file would destroy it, and to read one might never end.
    """
    real = Path(os.path.realpath(path))
    try:
        mode = os.lstat(real).st_mode
    except FileNotFoundError:
        return real
    if not stat.S_ISREG(mode):
        raise OSError(errno.EINVAL, "not a regular file", os.fspath(path))
    return real


def writable(path: str | os.PathLike[str]) -> Path:
    """The file that `replace` would write; OSError, with its name, if that must fail."""
    real = regular(path)
    if not real.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), os.fspath(path))
    if real.exists() and not os.access(real, os.W_OK):
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), os.fspath(path))
    return real


def replace(path: str | os.PathLike[str], data: bytes) -> None:
    """Put the bytes there, all of them or none; OSError where that cannot be.

    A link stays a link, and the file it leads to is replaced. An old file's permissions and owner
    are kept, and one that may not be written is not replaced. What is written is on the disk
    before it takes the old file's place.
    """
    real = writable(path)
    old = os.stat(real) if real.exists() else None
    handle, temporary = _beside(real)
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        if old is not None:
            _resemble(temporary, old)
        os.replace(temporary, real)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise


def _beside(real: Path) -> tuple[int, Path]:
    """A new file in the same folder, open for writing, with the permissions of any new file."""
    flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | getattr(os, "O_BINARY", 0)
    number = 0
    while True:
        path = real.parent / f".danggu-{os.getpid()}-{number}.tmp"
        try:
            return os.open(path, flags, 0o666), path
        except FileExistsError:
            number += 1  # another thread's, or left by a process that was killed


def _resemble(path: Path, old: os.stat_result) -> None:
    new = os.stat(path)
    if hasattr(os, "chown") and (new.st_uid, new.st_gid) != (old.st_uid, old.st_gid):
        with suppress(PermissionError):  # only root may give a file away
            os.chown(path, old.st_uid, old.st_gid)
    os.chmod(path, stat.S_IMODE(old.st_mode))
