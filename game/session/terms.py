"""What is to be played: the game, who plays it, on which table; one value, one line of text."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, fields
from typing import Any, NamedTuple

from danggu.players.levels import LEVELS, Level
from danggu.players.positions import SAGU, THREE_CUSHION, opening
from danggu.rules import carom, sagu
from danggu.rules.match import Match, Player
from danggu.rules.verdict import Rules
from game.table import presets
from physics import Ball, World

FREE, FOUR_BALL = "free", "four-ball"
HUMAN = "human"
SKILLS: dict[str, Level] = {level.key: level for level in LEVELS}
SEATS = (HUMAN, *SKILLS)
FINISHES, EXTRA_3C = sagu.FINISHES, sagu.EXTRA_3C
LONGEST_NAME = 16
MOST_POINTS = 200
PENALTIES = (0, 1, 2)
BANKS = (1, 2)
START = ("2.5", "0", "0", "0")
"""Speed and spins that a player has in the boxes before the first stroke."""


@dataclass(frozen=True, slots=True)
class Contestant:
    """A player: a name ("" for the usual one), human or a level, a handicap (수지)."""

    name: str = ""
    level: str = HUMAN
    target: int = 10

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or len(self.name) > LONGEST_NAME:
            raise ValueError(f"a name has at most {LONGEST_NAME} characters, not {self.name!r:.60}")
        if any(c == "\0" or "\ud800" <= c <= "\udfff" for c in self.name):
            raise ValueError(f"a name has only characters that can be drawn, not {self.name!r}")
        if self.level not in SEATS:
            raise ValueError(f"level must be one of {', '.join(SEATS)}, not {self.level!r:.60}")
        if type(self.target) is not int or not 1 <= self.target <= MOST_POINTS:
            raise ValueError(f"a handicap is 1 to {MOST_POINTS}, not {self.target!r:.60}")


class Discipline(NamedTuple):
    """What the program knows of a game beside its rules.

    table     the one that it is played on unless another one is asked for
    position  its opening, as `players.positions` calls the game
    house     the fields of `Terms` that are its house rules
    rules     makes its rules of terms
    """

    table: str
    position: str = ""
    house: tuple[str, ...] = ()
    rules: Callable[[Terms], Rules] | None = None


@dataclass(frozen=True, slots=True)
class Terms:
    """A game, its players and its table; ValueError for what cannot be played.

    "table" as a cloth or a law is the one that the table comes with; the house rules of other games
    than the one played mean nothing.
    """

    game: str = FREE
    seats: tuple[Contestant, ...] = field(default_factory=lambda: (Contestant(), Contestant()))
    table: str = "medium"
    cloth: str = "table"
    law: str = "table"
    engine: str = "exact"
    finish: str = EXTRA_3C
    penalty: int = 1
    floor: bool = True
    bank: int = 1
    red_first: bool = True

    def __post_init__(self) -> None:
        known: dict[str, tuple[Any, ...]] = {
            "game": GAMES, "table": (*presets.TABLES,), "cloth": (*presets.CLOTHS,),
            "law": ("table", *presets.LAWS), "engine": (*presets.ENGINES,), "finish": FINISHES,
            "penalty": PENALTIES, "bank": BANKS, "floor": (True, False), "red_first": (True, False),
        }  # fmt: skip
        for name, values in known.items():
            if getattr(self, name) not in values:
                said = ", ".join(map(str, values))
                raise ValueError(f"{name} must be one of {said}, not {getattr(self, name)!r:.60}")
        if len(self.seats) not in (1, 2):
            raise ValueError(f"players must be 1 or 2, not {len(self.seats)}")

    @property
    def rules(self) -> Rules:
        """The rules of the game; ValueError for the free table, which has none."""
        make = DISCIPLINES[self.game].rules
        if make is None:
            raise ValueError("the free table has no rules")
        return make(self)

    def match(self) -> Match:
        """The match before its first stroke."""
        return Match.of(self.rules, *(Player(seat.name, seat.target) for seat in self.seats))

    def world(self) -> World:
        """The table with the balls on their spots."""
        if self.game == FREE:
            return presets.table_world(self.table)
        kind = presets.TABLES[self.table]
        spots = opening(DISCIPLINES[self.game].position).on(kind.length, kind.width)
        world = kind.world()
        for name in self.rules.balls:
            world.add(Ball(name, spots[name], radius=kind.radius, mass=kind.mass))
        return world

    def line(self) -> str:
        """Everything in one line of text, which `read` takes back."""
        return json.dumps(asdict(self), ensure_ascii=False, separators=(",", ":"))


DISCIPLINES = {
    FREE: Discipline("medium"),
    FOUR_BALL: Discipline(
        "medium",
        SAGU,
        ("finish", "penalty", "floor"),
        lambda terms: sagu.Sagu(terms.finish, terms.penalty, floor_zero=terms.floor),
    ),
    "three-cushion": Discipline(
        "match",
        THREE_CUSHION,
        ("bank", "red_first"),
        lambda terms: carom.Carom(3, terms.bank, terms.red_first),
    ),
}
"""By the names that `danggu.rules.GAMES` gives the games."""
GAMES = (*DISCIPLINES,)
"""The games that have a table in the window; `danggu.rules` knows more."""


def read(line: str) -> Terms:
    """What `Terms.line` has written; ValueError, saying what is wrong, for anything else."""
    try:
        data = json.loads(line)
    except (ValueError, RecursionError):
        raise ValueError("the terms of a match are written as JSON") from None
    if not isinstance(data, dict) or not isinstance(data.get("seats", []), list):
        raise ValueError("the terms of a match are an object with a list of seats")
    unknown = set(data) - {f.name for f in fields(Terms)}
    if unknown:
        raise ValueError(f"the terms of a match have no {min(unknown)!r:.60}")
    try:
        if "seats" in data:
            data["seats"] = tuple(Contestant(**seat) for seat in data["seats"])
        return Terms(**data)
    except TypeError as error:
        raise ValueError(f"no such terms: {error}") from None
