"""What many shots are worth by the rules of a game, and with the errors of a player."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor
from dataclasses import astuple
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from physics import Ball, Shot, World, simulate_many

from .players.errors import missed
from .players.levels import level_of
from .rules.verdict import Rules, Turn

if TYPE_CHECKING:
    from .players.levels import Level

__all__ = ["Scores", "scores"]

KEPT = 40  # contacts: most shots have fewer
ALL = 10_000
PIECE = 20_000  # shots of which contacts are kept at once: 13 MB


class Scores(NamedTuple):
    """What shots are worth: means over the copies of each, (shots,).

    points: the change of score.
    made, fouls: the share that scored, and the share that were fouls.
    """

    points: Any
    made: Any
    fouls: Any


def scores(
    world: World, ball: Ball | str, shots: Any, rules: Rules, *, level: Level | str | None = None,
    copies: int = 1, seed: int | None = 0, executor: Executor | None = None,
    progress: Callable[[int], object] | None = None, early: bool = False,
) -> Scores:  # fmt: skip
    """What each of the shots at `ball` is worth by the rules, from the world as it is.

    shots: `Shot`s, or an array (shots, 6) or (shots, 5), as `simulate_many` takes them.
    level: of the player, or its key; each shot is then played `copies` times with its errors,
    drawn from the seed. None: as it is.
    executor, progress: as in `simulate_many`; a copy is a shot.
    early: end each shot when its verdict is settled. That changes no verdict: only the contacts
    after it are not played.
    ValueError for what `simulate_many` refuses, and for copies that are none.
    """
    if type(copies) is not int or copies < 1:
        raise ValueError(f"copies must be a whole number above 0, not {copies!r:.60}")
    rng, cue, shots = np.random.default_rng(seed), world.ball(ball), _table(shots)
    copies, turn = copies if level else 1, Turn(cue=cue.name)
    until = rules.enough(turn, [each.name for each in world.balls]) if early else ()
    how: Any = {"executor": executor, "progress": progress, "until": until}
    worth = np.empty((len(shots), copies, 3))
    step = max(1, PIECE // copies)
    for k in range(0, len(shots), step):
        table = shots[k : k + step]
        if level is not None:
            table = missed(table, level_of(level), copies, cue.radius, rng)
        worth[k : k + step] = _judged(world, turn, table, rules, how).reshape(-1, copies, 3)
    return Scores(*worth.mean(axis=1).T)


def _table(shots: Any) -> Any:
    """(shots, 6): of `Shot`s, or of rows of six numbers, or of five without the climb."""
    if not isinstance(shots, np.ndarray):
        shots = [astuple(shot) if isinstance(shot, Shot) else shot for shot in shots]
    if not len(shots):
        return np.empty((0, 6))
    table = np.asarray(shots, float)
    if table.ndim != 2 or table.shape[1] not in (5, 6):
        raise ValueError(f"shots must be Shots or rows of 5 or 6 numbers, not {table.shape}")
    return table if table.shape[1] == 6 else np.column_stack([table, np.zeros(len(table))])


def _judged(world: World, turn: Turn, table: Any, rules: Rules, how: dict[str, Any]) -> Any:
    """(shots, 3): points, made and foul of each."""
    outcomes = simulate_many(world, turn.cue, table, contacts=KEPT, **how)
    found = rules.verdicts(outcomes, turn)
    worth = np.column_stack([found.points, found.made, found.foul]).astype(float)
    for k in np.flatnonzero(~found.certain):
        log = simulate_many(world, turn.cue, table[k : k + 1], contacts=ALL).log(0)
        verdict = rules.verdict(log, turn)
        worth[k] = verdict.points, verdict.made, verdict.foul
    return worth
