"""What a player has reached in each drill so far, in a file of the user."""

from __future__ import annotations

import json
from pathlib import Path
from typing import NamedTuple

from danggu.players.goals import GOALS, STARS
from game.settings import user_files

FORMAT, VERSION = "danggu drills", 1
MOST = 1 << 40
"""Largest number that is taken as one."""


class Reached(NamedTuple):
    """A player in a drill.

    stars  most so far
    best   m from the middle of the zone, a number in a row or of strokes; None before any
    tries, made  strokes or attempts, and how many came off
    """

    stars: int = 0
    best: float | None = None
    tries: int = 0
    made: int = 0

    def plus(self, drill: str, stars: int, value: float | None, *, made: bool) -> Reached:
        """With one more attempt, and what it reached."""
        best = self.best
        if value is not None and (best is None or GOALS[drill].better(value, best)):
            best = value
        return Reached(max(self.stars, stars), best, self.tries + 1, self.made + made)


class Book:
    """The file; read again before it is written, so that nothing of another game is lost.

    Without a file, what is reached is known until the game ends.
    """

    def __init__(self, path: Path | None = None) -> None:
        self.path = path
        self.trouble = self.faulty = False
        """Could the last attempt not be written?  Could a part of the file not be read?"""
        self._known: dict[str, Reached] | None = None

    def of(self, drill: str) -> Reached:
        """What has been reached in a drill."""
        if self._known is None:
            self._known = self._load()
        return self._known.get(drill, Reached())

    def add(self, drill: str, stars: int, value: float | None, *, made: bool) -> None:
        """Add an attempt."""
        self.of(drill)
        known, self.trouble = dict(self._known or {}), False
        try:
            if self.path is not None:
                with user_files.alone(self.path):
                    known = self._load()
                    if self.faulty:
                        user_files.set_aside(self.path)
                    known[drill] = known.get(drill, Reached()).plus(drill, stars, value, made=made)
                    user_files.write(self.path, _text(known))
                    self._known = known
                    return
        except OSError:
            self.trouble = True
        known[drill] = known.get(drill, Reached()).plus(drill, stars, value, made=made)
        self._known = known

    def _load(self) -> dict[str, Reached]:
        self.faulty = False
        if self.path is None:
            return dict(self._known or {})
        try:
            document = json.loads(user_files.read(self.path))
            drills = document["drills"] if document["format"] == FORMAT else None
        except FileNotFoundError:
            return {}
        except (OSError, ValueError, RecursionError, KeyError, TypeError):
            drills = None
        if not isinstance(drills, dict):
            self.faulty = True
            return {}
        good = {name: Reached(**one) for name, one in drills.items() if _good(one)}
        self.faulty = len(good) < len(drills)
        return good


def _good(one: object) -> bool:
    """Is it what has been reached in a drill?  One that only a later game knows is kept."""
    if not isinstance(one, dict) or {*one} != {*Reached._fields}:
        return False
    counts = (one["stars"], one["tries"], one["made"])
    if not all(type(n) is int and 0 <= n <= MOST for n in counts) or one["stars"] > STARS:
        return False
    best = one["best"]
    return best is None or (type(best) in (int, float) and 0 <= best <= MOST)


def _text(known: dict[str, Reached]) -> str:
    drills = {name: one._asdict() for name, one in known.items()}
    document = {"format": FORMAT, "version": VERSION, "drills": drills}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
