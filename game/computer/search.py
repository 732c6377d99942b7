"""The search of the coach as the game asks for it, in a process that may load the compiler."""

from __future__ import annotations

from typing import Any

from danggu.players import solutions
from danggu.players.levels import Level
from danggu.players.solution import Solution
from danggu.rules.verdict import Rules, Turn
from physics import EventDriven, World


def ways(
    world: World, rules: Rules, turn: Turn, level: Level, seed: int = 0, **how: Any
) -> list[Solution]:
    """The ways to score that a player of the level has, best first: `danggu.players.solutions`."""
    world.engine = EventDriven()  # fixed steps would take a hundred times as long
    return solutions(world, rules, turn, level, seed=seed, **how)
