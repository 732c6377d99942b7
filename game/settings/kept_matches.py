"""Matches that can be gone on with, in a file of the user that other games may be using too."""

from __future__ import annotations

import json
from pathlib import Path

from game.session import saved

from . import user_files

FORMAT, VERSION = "danggu matches", 1
MOST = 8
"""Matches that are kept: the oldest goes."""
Found = dict[str, str]


class KeptMatches:
    """Saved matches by the number of the game that plays them, the newest last.

    Each game writes its own alone; the file is replaced whole, and a broken one is kept beside as
    .broken.
    """

    def __init__(self, path: Path | None) -> None:
        self.path = path
        self.trouble = ""
        """Why the last match could not be written, or ""."""
        self.faulty = False
        """Could a part of the file not be read?"""

    def lines(self) -> tuple[str, ...]:
        """The lines of the matches that can be read, the one that was saved last first."""
        return (*reversed(self._load().values()),)

    def put(self, own: str, text: str) -> bool:
        """Keep a match under a game's own number; returns whether it is in the file."""
        return self._change(own, text)

    def drop(self, own: str) -> bool:
        """Forget a match that is over, or has been taken up."""
        return self._change(own, "")

    def taken_up(self, text: str, own: str) -> bool:
        """A saved match is being played by this game now."""
        for number, line in self._load().items():
            if line == text and number != own:
                return self.drop(number)
        return True

    def _change(self, own: str, text: str) -> bool:
        if self.path is None:
            return False
        try:
            with user_files.alone(self.path):
                found = self._load()
                if self.faulty:
                    user_files.set_aside(self.path)
                found.pop(own, None)
                if text:
                    found[own] = text
                kept = dict(list(found.items())[-MOST:])
                user_files.write(self.path, _text(kept))
        except OSError as error:
            self.trouble = error.strerror or str(error)
            return False
        self.trouble = ""
        return True

    def _load(self) -> Found:
        """The matches that can be read."""
        self.faulty = False
        if self.path is None:
            return {}
        try:
            document = json.loads(user_files.read(self.path))
            lines = document["matches"] if document["format"] == FORMAT else None
        except FileNotFoundError:
            return {}
        except (OSError, ValueError, RecursionError, KeyError, TypeError):
            self.faulty = True
            return {}
        if not isinstance(lines, dict):
            self.faulty = True
            return {}
        good = {own: line for own, line in lines.items() if _reads(line)}
        self.faulty = len(good) < len(lines)
        return good


def _reads(line: object) -> bool:
    try:
        saved.read(line if isinstance(line, str) else "")
    except ValueError:
        return False
    return True


def _text(found: Found) -> str:
    document = {"format": FORMAT, "version": VERSION, "matches": found}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
