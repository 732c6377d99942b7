"""Print an answer for every position of the shelf; to be run when laws or tables have changed.

python tools/shelf_answers.py [KEY ...]      half a minute each
"""

import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace

from danggu.players.levels import EXPERT, Level
from danggu.players.opponent import Opponent
from danggu.players.positions import SAGU, SHELF, THREE_CUSHION, Position, opening
from danggu.rules.carom import Carom
from danggu.rules.match import Match, Player
from danggu.rules.sagu import Sagu
from danggu.rules.state import GameState
from danggu.rules.stroke import Logged
from danggu.rules.verdict import Rules, Turn, Verdict
from physics import Ball, World, tables

EFFORT = 30_000


@dataclass(frozen=True)
class OneWay:
    """The rules of a game, but a point is one only if it goes the position's way."""

    rules: Rules
    way: tuple[str, ...]
    key = "one_way"
    cues = ("white", "yellow")
    balls = ()

    def start(self, players: int) -> GameState:
        return self.rules.start(players)

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return tuple(what for what in self.rules.targets(turn) if what in self.way)

    def needs(self, turn: Turn) -> int:
        return self.rules.needs(turn)

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        verdict = self.rules.verdict(log, turn)
        if verdict.facts.path == self.way:
            return verdict
        return replace(verdict, made=False, points=min(verdict.points, 0))


def laid(position: Position) -> World:
    """The position on its game's own table."""
    table = tables.MEDIUM_CAROM if position.game == SAGU else tables.MATCH_CAROM_2
    world = table.world()
    for name, at in position.on(table.length, table.width).items():
        world.add(Ball(name, at=at, radius=table.radius, mass=table.mass))
    return world


def answer(position: Position, level: Level = EXPERT) -> str:
    """The most robust stroke that goes the position's way."""
    rules = OneWay(Sagu() if position.game == SAGU else Carom(), position.way)
    thinker = Opponent(laid(position), Match.of(rules, Player("")), level, 1, EFFORT)
    thinker.think(float("inf"))
    aim = thinker.intent.aim
    numbers = ", ".join(f"{x:.2f}" for x in (aim.angle, aim.speed, aim.right, aim.up))
    return f"({numbers})  share {thinker.intent.share:.2f}"


if __name__ == "__main__":
    for place in (*SHELF, opening(SAGU), opening(THREE_CUSHION)):
        if place.key in (sys.argv[1:] or [place.key]):
            print(place.game, place.key, answer(place), flush=True)
