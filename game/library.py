"""Set-ups that the player has saved by name, in a file that may be broken."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

from . import files
from .lineup import LineError, Lineup, read

FORMAT, VERSION = "danggu set-ups", 1
LONGEST_NAME = 24


def folder() -> Path:
    """The platform's folder for what a user has made."""
    from platformdirs import user_data_path

    return user_data_path("danggu", appauthor=False)


class Library:
    """Names and set-ups, in the order in which they were saved; loaded when first asked for."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self.faulty = 0
        """How many of the saved set-ups could not be read."""
        self._items: dict[str, Lineup] | None = None

    @property
    def items(self) -> dict[str, Lineup]:
        """The set-ups by name."""
        if self._items is None:
            self._items = self._load()
        return self._items

    def put(self, name: str, lineup: Lineup) -> bool:
        """Keep a set-up under a name, over an older one; returns whether it is in the file."""
        name = " ".join(name.split())[:LONGEST_NAME]
        if not name:
            return False
        self.items.pop(name, None)
        self.items[name] = lineup
        return self._save()

    def remove(self, name: str) -> bool:
        """Forget a set-up; returns whether the file has forgotten it too."""
        self.items.pop(name, None)
        return self._save()

    def _file(self) -> Path:
        self.path = self.path or folder() / "set-ups.json"
        return self.path

    def _load(self) -> dict[str, Lineup]:
        try:
            text = self._file().read_text(encoding="utf-8")
        except FileNotFoundError:
            return {}
        except (OSError, UnicodeDecodeError):
            text = ""
        try:
            document = json.loads(text)
            lines = document["set-ups"] if document["format"] == FORMAT else None
        except (ValueError, RecursionError, KeyError, TypeError):
            lines = None
        found: dict[str, Lineup] = {}
        for name, line in lines.items() if isinstance(lines, dict) else ():
            try:
                found[name[:LONGEST_NAME]] = read(line)
            except (LineError, AttributeError, TypeError):
                self.faulty += 1
        if not isinstance(lines, dict) or self.faulty:
            self.faulty = self.faulty or 1
            self._set_aside()
        return found

    def _set_aside(self) -> None:
        """Keep the broken file beside the good one that will be written."""
        file = self._file()
        try:
            shutil.copyfile(file, file.with_name(file.name + ".broken"))
        except OSError:
            return  # a folder, or a file nobody may read: it stays as it is

    def _save(self) -> bool:
        lines = {name: lineup.line() for name, lineup in self.items.items()}
        document = {"format": FORMAT, "version": VERSION, "set-ups": lines}
        try:
            file = self._file()
            file.parent.mkdir(parents=True, exist_ok=True)
            files.write(file, json.dumps(document, indent=1, ensure_ascii=False) + "\n")
        except OSError:
            return False
        return True
