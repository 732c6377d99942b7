"""What is to be played: the game, who plays it, on which table; one value, one line of text."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass, field, fields
from typing import Any

from danggu.players.levels import LEVELS, Level
from danggu.players.positions import SAGU, THREE_CUSHION, opening
from danggu.rules import GAMES as RULES
from danggu.rules import carom, sagu
from danggu.rules.match import Match, Player
from danggu.rules.verdict import Rules
from game.table import presets
from physics import Ball, World

FREE, FOUR_BALL = "free", "four-ball"
GAMES = (*RULES,)
KEYS = {FOUR_BALL: SAGU, "three-cushion": THREE_CUSHION}
"""What the rules call the games."""
TABLES = {FREE: "medium", FOUR_BALL: "medium", "three-cushion": "match"}
"""The table each game is played on unless another one is asked for."""
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
class Seat:
    """Somebody who plays: a name ("" for the usual one), human or a level, a handicap (수지)."""

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


@dataclass(frozen=True, slots=True)
class Terms:
    """A game, its players and its table; ValueError for what cannot be played.

    `finish`, `penalty` and `floor` are house rules of 4-ball, `bank` and `red_first` of
    three-cushion.  "table" as a cloth or a law is the one that the table comes with.
    """

    game: str = FREE
    seats: tuple[Seat, ...] = field(default_factory=lambda: (Seat(), Seat()))
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
        if self.game == FREE:
            raise ValueError("the free table has no rules")
        if self.game == FOUR_BALL:
            return sagu.Sagu(self.finish, self.penalty, floor_zero=self.floor)
        return carom.Carom(3, self.bank, self.red_first)

    def match(self) -> Match:
        """The match before its first stroke."""
        return Match.of(self.rules, *(Player(seat.name, seat.target) for seat in self.seats))

    def world(self) -> World:
        """The table with the balls on their spots."""
        if self.game == FREE:
            return presets.table_world(self.table)
        kind = presets.TABLES[self.table]
        spots = opening(KEYS[self.game]).on(kind.length, kind.width)
        world = kind.world()
        for name in self.rules.balls:
            world.add(Ball(name, spots[name], radius=kind.radius, mass=kind.mass))
        return world

    def line(self) -> str:
        """Everything in one line of text, which `read` takes back."""
        return json.dumps(asdict(self), ensure_ascii=False, separators=(",", ":"))


def read(line: str) -> Terms:
    """What `Terms.line` has written; ValueError, saying what is wrong, for anything else."""
    try:
        data = json.loads(line)
    except (ValueError, RecursionError):
        raise ValueError("a fixture is written as JSON") from None
    if not isinstance(data, dict) or not isinstance(data.get("seats", []), list):
        raise ValueError("a fixture is an object with a list of seats")
    unknown = set(data) - {f.name for f in fields(Terms)}
    if unknown:
        raise ValueError(f"a fixture has no {min(unknown)!r:.60}")
    try:
        if "seats" in data:
            data["seats"] = tuple(Seat(**seat) for seat in data["seats"])
        return Terms(**data)
    except TypeError as error:
        raise ValueError(f"no such fixture: {error}") from None
