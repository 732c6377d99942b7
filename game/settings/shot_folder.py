"""The user's folder of shots: a small text file each, which can be sent and read anywhere."""

from __future__ import annotations

import re
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from game.table import shared
from game.table.library import free, plain
from game.table.lineup import LineError
from game.table.shared import SharedShot

from . import user_files

ENDS = ".txt"
MOST = 500
"""Files that are listed at most, the newest first."""
LARGEST = 1 << 14
"""Bytes of a file at most: a shot at 22 balls has a thousand."""
LONGEST = 60
"""Characters of a name at most: file systems take 255 bytes."""
UNFIT = re.compile(r'[\\/:*?"<>|\x00-\x1f]')
"""Characters that some file system does not take in a name."""


class KeptShot(NamedTuple):
    """A file of the folder: its name without its ending, and the shot, None for a broken one."""

    name: str
    shot: SharedShot | None


class ShotFolder:
    """The files; other games may be adding to them, so the folder is read whenever it is shown."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        """None where there is no place for any: then nothing is kept."""

    def shots(self) -> list[KeptShot]:
        """All shots, the newest first; broken files among them."""
        return [KeptShot(file.stem, _read(file)) for file in self._files()[:MOST]]

    def save(self, name: str, shot: SharedShot) -> str:
        """Keep a shot; returns the name that it got, numbered if there is one of that name already.

        OSError if it cannot be, ValueError for a name of nothing that can be drawn.
        """
        name = fit(name)
        if not name:
            raise ValueError("a shot is kept under a name")
        if self.path is None:
            raise OSError("there is no home folder")
        with user_files.alone(self.path / "any"):
            # names that differ in capitals alone are one file on some systems
            taken = {file.stem.casefold() for file in self._files()}
            name = name if name.casefold() not in taken else free(name.casefold(), taken)
            user_files.write(self.path / (name + ENDS), shot.line() + "\n")
        return name

    def remove(self, name: str) -> bool:
        """Delete a shot; returns whether there is none of that name now."""
        if self.path is None:
            return False
        file = self.path / (name + ENDS)
        with suppress(OSError):
            file.unlink(missing_ok=True)
        return not file.exists()

    def _files(self) -> list[Path]:
        if self.path is None:
            return []
        try:
            found = [file for file in self.path.iterdir() if file.suffix == ENDS]
        except OSError:
            return []
        return sorted(found, key=lambda file: (-_written(file), file.name))


def fit(name: str) -> str:
    """Return a name as a file can have it: what some system does not take becomes a dash."""
    return UNFIT.sub("-", plain(name))[:LONGEST].strip(" .")


def _written(file: Path) -> float:
    """When, s; long ago for a link that leads nowhere, and for what another game has deleted."""
    try:
        return file.stat().st_mtime
    except OSError:
        return 0.0


def _read(file: Path) -> SharedShot | None:
    try:
        return shared.read(user_files.read(file, LARGEST))
    except (OSError, UnicodeDecodeError, LineError):
        return None
