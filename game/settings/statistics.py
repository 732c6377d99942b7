"""What each player has done in each game so far, added up in a file of the user."""

from __future__ import annotations

import json
from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from game.session.scorecard import Totals

from . import user_files

FORMAT, VERSION = "danggu statistics", 1
MOST = 1 << 40
"""Largest number that is taken as one."""


class Figures(NamedTuple):
    """A player in a game.

    matches, won  how many
    visits, strokes, made, fouls, points, best  as in `Totals`, of all matches; strokes and made
    are those that were meant to score
    """

    matches: int = 0
    won: int = 0
    visits: int = 0
    strokes: int = 0
    made: int = 0
    fouls: int = 0
    points: int = 0
    best: int = 0

    def plus(self, one: Totals, *, won: bool) -> Figures:
        """With one more match."""
        return Figures(
            self.matches + 1,
            self.won + won,
            self.visits + one.visits,
            self.strokes + one.strokes - one.spared,
            self.made + one.made - one.unmeant,
            self.fouls + one.fouls,
            self.points + one.points,
            max(self.best, one.best),
        )

    @property
    def average(self) -> float:
        """Points a visit."""
        return self.points / self.visits if self.visits else 0.0

    @property
    def share(self) -> float:
        """The part of the strokes that scored: the pot rate."""
        return self.made / self.strokes if self.strokes else 0.0


def kept_name(name: str, index: int) -> str:
    """Under which name the figures of a seat are kept: where none is given, "Player 1" or 2."""
    return name or f"Player {index + 1}"


Records = dict[str, dict[str, Figures]]
"""By player and game."""


class Statistics:
    """The file; read again before it is written, so that nothing of another game is lost."""

    def __init__(self, path: Path | None) -> None:
        self.path = path
        self.trouble = ""
        """Why the last match could not be added, or ""."""
        self.faulty = False
        """Could a part of the file not be read?"""

    def of(self, player: str, game: str) -> Figures:
        """What a player has done in a game."""
        return self.load().get(player, {}).get(game, Figures())

    def add(self, game: str, done: Mapping[str, tuple[Totals, bool]]) -> bool:
        """Add a match: of each player the totals, and whether it was won; is it in the file?"""
        if self.path is None or not done:
            return False
        try:
            with user_files.alone(self.path):
                found = self.load()
                if self.faulty:
                    user_files.set_aside(self.path)
                for player, (one, won) in done.items():
                    games = found.setdefault(player, {})
                    games[game] = games.get(game, Figures()).plus(one, won=won)
                user_files.write(self.path, _text(found))
        except OSError as error:
            self.trouble = error.strerror or str(error)
            return False
        self.trouble = ""
        return True

    def load(self) -> Records:
        """All records that can be read."""
        self.faulty = False
        if self.path is None:
            return {}
        try:
            document = json.loads(user_files.read(self.path))
            players = document["players"] if document["format"] == FORMAT else None
        except FileNotFoundError:
            return {}
        except (OSError, ValueError, RecursionError, KeyError, TypeError):
            players = None
        if not isinstance(players, dict):
            self.faulty = True
            return {}
        return {name: self._games(games) for name, games in players.items()}

    def _games(self, games: object) -> dict[str, Figures]:
        found: dict[str, Figures] = {}
        if not isinstance(games, dict):
            self.faulty = True
            return found
        for game, numbers in games.items():
            if _good(numbers):
                found[game] = Figures(**numbers)
            else:
                self.faulty = True
        return found


def _good(numbers: object) -> bool:
    if not isinstance(numbers, dict) or {*numbers} != {*Figures._fields}:
        return False
    return all(type(n) is int and abs(n) <= MOST for n in numbers.values())


def _text(found: Records) -> str:
    players = {
        name: {game: one._asdict() for game, one in games.items()} for name, games in found.items()
    }
    document = {"format": FORMAT, "version": VERSION, "players": players}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
