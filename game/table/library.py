"""Set-ups that the player has saved by name, in a file that may be broken or shared."""

from __future__ import annotations

import json
from collections.abc import Callable, Container, Iterable
from itertools import count
from pathlib import Path

from game.settings import user_files
from game.text.quoting import drawable

from .lineup import LineError, Lineup, read

FORMAT, VERSION = "danggu set-ups", 1
LONGEST_NAME = 24
"""Characters of a name that a message repeats; the name itself may be longer."""
Items = dict[str, Lineup]


def folder() -> Path | None:
    """The platform's folder for what a user has made; None for a user without a home."""
    from platformdirs import user_data_path

    return user_files.folder(user_data_path)


class Library:
    """Names and set-ups, in the order in which they were saved; loaded when first asked for.

    Nothing is written before something is saved or removed; then the file is read again, so what
    another game has saved meanwhile stays.
    """

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self.faulty = 0
        """How many of the saved set-ups could not be read."""
        self._items: Items | None = None

    @property
    def items(self) -> Items:
        """The set-ups by name."""
        if self._items is None:
            try:
                self._items, self.faulty = _load(self._file())
            except FileNotFoundError:
                self._items = {}
            except OSError:
                self._items, self.faulty = {}, 1
        return self._items

    def put(self, name: str, lineup: Lineup) -> bool:
        """Keep a set-up under a name, over an older one; returns whether it is in the file.

        One that another game has saved under this name stays, and this one's name gets a number.
        """
        name = plain(name)
        if not name:
            return False
        known = self.items.get(name)

        def change(items: Items) -> None:
            if items.get(name) == known:
                items.pop(name, None)
            items[free(name, items)] = lineup

        return self._change(change)

    def remove(self, name: str) -> bool:
        """Forget a set-up; returns whether the file has forgotten it too.

        One that another game has saved under this name stays.
        """
        known = self.items.get(name)

        def change(items: Items) -> None:
            if items.get(name) == known:
                items.pop(name, None)

        return self._change(change)

    def _file(self) -> Path:
        """Where they are kept; OSError for a user without a home."""
        if self.path is None:
            home = folder()
            if home is None:
                raise OSError("there is no home folder")
            self.path = home / "set-ups.json"
        return self.path

    def _change(self, change: Callable[[Items], object]) -> bool:
        """Change what is known, and what is in the file; returns whether both are so now."""
        items = dict(self.items)
        try:
            file = self._file()
            with user_files.alone(file):
                try:
                    items, faulty = _load(file)
                    if faulty:
                        user_files.set_aside(file)
                        items = {**self.items, **items}
                except FileNotFoundError:
                    pass
                change(items)
                user_files.write(file, _text(items))
        except OSError:
            change(self.items)
            return False
        self._items = items
        return True


def plain(name: str) -> str:
    """Return a name as it can be shown: single spaces, and a sign for what cannot be drawn."""
    return drawable(" ".join(name.split()))


def free(name: str, taken: Container[str]) -> str:
    """Return the name, or with a number if it is taken."""
    numbered = (f"{name} ({n})" for n in count(2))
    return name if name not in taken else next(n for n in numbered if n not in taken)


def _load(file: Path) -> tuple[Items, int]:
    """The set-ups in a file, and how many cannot be read; OSError if it cannot."""
    try:
        document = json.loads(user_files.read(file), object_pairs_hook=_named)
        lines = document["set-ups"] if document["format"] == FORMAT else None
    except (ValueError, RecursionError, KeyError, TypeError):
        return {}, 1
    if not isinstance(lines, dict):
        return {}, 1
    found: Items = {}
    faulty = int(document.get("version") != VERSION)
    for name, line in lines.items():
        try:
            lineup = read(line)
        except (LineError, AttributeError, TypeError):
            faulty += 1
        else:
            found[free(plain(name), found)] = lineup
    return found, faulty


def _named(pairs: Iterable[tuple[str, object]]) -> dict[str, object]:
    """An object of JSON in which names that are there twice get numbers."""
    found: dict[str, object] = {}
    for name, value in pairs:
        found[free(name, found)] = value
    return found


def _text(items: Items) -> str:
    lines = {name: lineup.line() for name, lineup in items.items()}
    document = {"format": FORMAT, "version": VERSION, "set-ups": lines}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
