"""What is to be played: the game, who plays it, on which table; one value, one line of text."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import asdict, dataclass, field, fields
from typing import Any, NamedTuple

from danggu.players.levels import LEVELS, Level
from danggu.players.positions import SAGU, THREE_CUSHION, opening
from danggu.players.spotting import opened
from danggu.rules import GAMES as GAMES_OF_RULES
from danggu.rules import sagu
from danggu.rules.match import Match, Player
from danggu.rules.pyramid import GIFT, MINUS, TAKE
from danggu.rules.verdict import Rules
from game.table import presets
from game.table.own_table import base
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


@dataclass(frozen=True, slots=True)
class Terms:
    """A game, its players and its table; ValueError for what cannot be played.

    "table" as a cloth or a law is the one that the table comes with; the house rules of other games
    than the one played mean nothing. `race` is the racks or frames to win, `lag`: who begins is
    found by a lag, `hints`: the coach may be asked; `seed` draws the racks.
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
    umb: bool = False
    equal: bool = False
    race: int = 1
    early: bool = False
    miss: bool = True
    ball_back: str = "minus"
    lag: bool = False
    hints: bool = True
    seed: int = 0

    def __post_init__(self) -> None:
        known: dict[str, tuple[Any, ...]] = {
            "game": GAMES, "cloth": (*presets.CLOTHS,), "law": ("table", *presets.LAWS),
            "engine": (*presets.ENGINES,), "race": RACES, **HOUSE,
        }  # fmt: skip
        known["table"] = self.tables if self.game in GAMES else ()
        if isinstance(self.table, str) and base(self.table) in known["table"]:
            known["table"] += (self.table,) * (self.table in presets.TABLES)
        for name, values in known.items():
            value = getattr(self, name)
            if value not in values or (isinstance(value, bool) != isinstance(values[0], bool)):
                said = ", ".join(map(str, values))
                raise ValueError(f"{name} must be one of {said}, not {value!r:.60}")
        if type(self.seed) is not int or not 0 <= self.seed < 1 << 32:
            raise ValueError(f"seed must be a whole number below 2**32, not {self.seed!r:.60}")
        if len(self.seats) not in (1, 2):
            raise ValueError(f"players must be 1 or 2, not {len(self.seats)}")

    @property
    def discipline(self) -> Discipline:
        """What the program knows of the game."""
        return DISCIPLINES[self.game]

    @property
    def tables(self) -> tuple[str, ...]:
        """The tables that the game can be played on."""
        return self.discipline.tables or (*presets.TABLES,)

    @property
    def rules(self) -> Rules:
        """The rules of the game; ValueError for the free table, which has none."""
        make = self.discipline.rules
        if make is None:
            raise ValueError("the free table has no rules")
        return make(self)

    def match(self) -> Match:
        """The match before its first stroke."""
        goals = self.discipline.points
        players = (Player(seat.name, seat.target if goals else None) for seat in self.seats)
        return Match.of(self.rules, *players, equal_innings=self.equal and goals)

    def world(self) -> World:
        """The table with the balls on their spots, or racked."""
        if self.game == FREE:
            return presets.table_world(self.table)
        kind = presets.TABLES[self.table]
        world = kind.world()
        if not self.discipline.position:
            opened(world, self.match(), self.seed)
            return world
        spots = opening(self.discipline.position).on(kind.length, kind.width)
        for name in self.rules.balls:
            world.add(Ball(name, spots[name], radius=kind.radius, mass=kind.mass))
        return world

    def line(self) -> str:
        """Everything in one line of text, which `read` takes back."""
        return json.dumps(asdict(self), ensure_ascii=False, separators=(",", ":"))


class Discipline(NamedTuple):
    """What the program knows of a game beside its rules.

    table     the one that it is played on unless another one is asked for
    position  its opening, as `players.positions` calls the game; "" if balls are racked
    house     the fields of `Terms` that are its house rules
    rules     makes its rules of terms
    tables    those that it can be played on; () for any
    points    do players have a number of points to reach?
    """

    table: str
    position: str = ""
    house: tuple[str, ...] = ()
    rules: Callable[[Terms], Rules] | None = None
    tables: tuple[str, ...] = ()
    points: bool = True


def _carom(table: str, name: str, *house: str, **how: Any) -> Discipline:
    """A game with three balls; `how` are the fields of its rules that are no house rule."""

    def rules(terms: Terms) -> Rules:
        own = {key: getattr(terms, key) for key in house}
        return GAMES_OF_RULES[name](**own, **how)

    return Discipline(table, THREE_CUSHION, (*house, "equal", *ALWAYS), rules, CAROM)


def _racked(tables: tuple[str, ...], name: str, *house: str, **more: Any) -> Discipline:
    """A game that begins with a rack; `house` are the rules' fields, or pairs "ours>theirs"."""

    def rules(terms: Terms) -> Rules:
        own = [key.partition(">") for key in house]
        return GAMES_OF_RULES[name](**{to or ours: getattr(terms, ours) for ours, _, to in own})

    race = () if more.get("points") else ("race",)
    fields_ = (*race, *(key.partition(">")[0] for key in house), *ALWAYS)
    return Discipline(tables[0], "", fields_, rules, tables, bool(more.get("points")))


ALWAYS = "lag", "hints"
"""House rules of every game."""
CAROM, POOL = (*presets.CAROM,), (*presets.POOL,)
PYRAMID = ("pyramid",)
RACES = tuple(range(1, 16))
HOUSE: dict[str, tuple[Any, ...]] = {
    "finish": FINISHES, "penalty": PENALTIES, "bank": BANKS, "floor": (True, False),
    "red_first": (True, False), "lag": (True, False), "umb": (True, False), "equal": (True, False),
    "hints": (True, False), "early": (True, False), "miss": (True, False),
    "ball_back": (MINUS, GIFT, TAKE),
}  # fmt: skip
"""What each house rule can be."""
DISCIPLINES = {
    FREE: Discipline("medium"),
    FOUR_BALL: Discipline(
        "medium",
        SAGU,
        ("finish", "penalty", "floor", "equal", *ALWAYS),
        lambda terms: sagu.Sagu(terms.finish, terms.penalty, floor_zero=terms.floor),
        CAROM,
    ),
    "three-cushion": _carom("match", "three-cushion", "bank", "red_first", "umb"),
    "one-cushion": _carom("match", "one-cushion", "red_first", "umb"),
    "straight-rail": _carom("match", "straight-rail", "red_first"),
    "balkline-47/1": _carom("match", "balkline-47/1", "red_first"),
    "balkline-47/2": _carom("match", "balkline-47/2", "red_first"),
    "balkline-71/2": _carom("match", "balkline-71/2", "red_first"),
    "8-ball": _racked(POOL, "8-ball"),
    "9-ball": _racked(POOL, "9-ball"),
    "10-ball": _racked(POOL, "10-ball", "early"),
    "14.1": _racked(POOL, "14.1", points=True),
    "snooker": _racked(("snooker",), "snooker", "miss"),
    "free-pyramid": _racked(PYRAMID, "free-pyramid", "ball_back>penalty"),
    "dynamic-pyramid": _racked(PYRAMID, "dynamic-pyramid", "ball_back>penalty"),
    "combined-pyramid": _racked(PYRAMID, "combined-pyramid", "ball_back>penalty"),
}
"""By the names that `danggu.rules.GAMES` gives the games."""
GAMES = (*DISCIPLINES,)
"""The games that have a table in the window."""


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
