"""The player's own table in the folder of what a user has made, as `physics.tables` keeps one."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from game.table import library, own_table, presets
from physics import tables

from . import user_files

NAME = "my table"


class OwnTableFile:
    """The file, read when first asked for; and the folder beside it, for tracks.

    fault  why a file that is there cannot be used, or ""
    """

    def __init__(self, folder: Path | None = None) -> None:
        self._folder, self.fault = folder, ""
        self._key: str | None = None

    @property
    def folder(self) -> Path | None:
        """Where everything is; None for a user without a home."""
        return self._folder or library.folder()

    @property
    def tracks_folder(self) -> str:
        """Where files of tracks are looked for; "" for a user without a home."""
        return "" if self.folder is None else str(self.folder / "tracks")

    @property
    def tracks(self) -> list[Path]:
        """The files in the folder for tracks, by name."""
        if not self.tracks_folder:
            return []
        try:
            return sorted(p for p in Path(self.tracks_folder).iterdir() if p.suffix == ".csv")
        except OSError:
            return []

    @property
    def key(self) -> str:
        """The key of the table, "" if there is none that can be used."""
        if self._key is None:
            self._key = self._read()
        return self._key

    def _read(self) -> str:
        path = self._path()
        if path is None or not path.exists():
            return ""
        try:
            return read(path)
        except (ValueError, OSError) as error:
            self.fault = str(error)
            return ""

    def _path(self) -> Path | None:
        return None if self.folder is None else self.folder / "my-table.json"

    def save(self, key: str) -> str:
        """Keep a table, over an older one; returns why that cannot be, or "".

        A file that cannot be read is kept beside as .broken.
        """
        path, broken = self._path(), not self.key and bool(self.fault)
        if path is None:
            return "there is no home folder"
        try:
            with user_files.alone(path):
                if broken:
                    user_files.set_aside(path)
                tables.save(replace(presets.TABLES[key], name=NAME), path)
        except OSError as error:
            return error.strerror or str(error)
        self._key, self.fault = key, ""
        return ""


def read(path: Path) -> str:
    """The key of the table in a file; ValueError names the file and what is wrong, or OSError."""
    user_files.read(path)  # of a device or a file without end nothing is taken
    try:
        return own_table.key_of(tables.load(path), presets.TABLES)
    except ValueError as error:
        said = str(error)
        raise ValueError(said if str(path) in said else f"{path}: {said}") from None
