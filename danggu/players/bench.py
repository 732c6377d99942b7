"""A bench for strokes: any number of them from one position or from many, judged in arrays."""

from __future__ import annotations

import importlib.util
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

from danggu.rules.strokes import POCKET
from danggu.rules.verdict import Rules, Turn, Verdict
from physics import Outcomes, World, simulate_many

KEPT = 40  # contacts of a stroke: enough to decide it


class Tried(NamedTuple):
    """What came of some strokes, (strokes,) each.

    made: whether it scored.
    gain: points, and 1 for a stroke that scores without any.
    places: (strokes, balls, 2) m, where the balls came to rest.
    paths: of each that scored, where they were asked for, what the cue ball met.
    """

    made: Any
    gain: Any
    places: Any
    paths: list[tuple[str, ...]]


class Bench:
    """Plays strokes of one turn.

    world: as it lies before the stroke; a copy, at rest.
    own, on: the number of the cue ball, and of the balls that may be hit first.
    kept: how many contacts of a stroke are kept.
    pot: the ball and the pocket that it has to drop into to score, None for any way to score.
    played: how many strokes have been played.
    """

    pot: tuple[str, str] | None = None

    def __init__(
        self, world: World, rules: Rules, turn: Turn, compiled: bool | None, kept: int = KEPT
    ) -> None:
        """ValueError if there is no ball to play with."""
        self.world, self.rules, self.turn = world.copy(), rules, turn
        names = [ball.name for ball in world.balls if not ball.gone]
        if turn.cue not in names:
            raise ValueError(f"there is no ball {turn.cue!r} to play with")
        self.names = tuple(ball.name for ball in world.balls)
        self.own = self.names.index(turn.cue)
        self.on = [k for k, name in enumerate(self.names) if name in rules.targets(turn)]
        self.radius = world.ball(turn.cue).radius
        self.compiled = self._quick() if compiled is None else compiled
        self.kept, self.played = kept, 0

    @property
    def places(self) -> Any:
        """(balls, 2) m: where the balls lie; NaN for one that is not on the table."""
        gone = (np.nan, np.nan)
        return np.array([gone if b.gone else b.position for b in self.world.balls])

    def play(self, shots: Any, positions: Any = None, *, paths: bool = False) -> Tried:
        """Play these, (strokes, 6), from where the balls lie, or from (strokes, balls, 2) m."""
        self.played += len(shots)
        try:
            outcomes = simulate_many(
                self.world, self.turn.cue, shots, positions=positions, contacts=self.kept,
                compiled=self.compiled,
            )  # fmt: skip
        except RuntimeError:  # one of them is a stroke that the engine cannot follow
            return self._halved(shots, positions, paths)
        found = self.rules.verdicts(outcomes, self.turn)
        made = found.made & found.certain
        if self.pot is not None:
            made &= self._potted(outcomes)
        gain = np.where(made, np.maximum(found.points, 1), np.minimum(found.points, 0))
        ways = [self._path(outcomes.log(int(k))) for k in np.flatnonzero(made)] if paths else []
        return Tried(made, gain, outcomes.positions, ways)

    def _halved(self, shots: Any, positions: Any, paths: bool) -> Tried:
        self.played -= len(shots)
        if len(shots) == 1:
            return Tried(np.zeros(1, bool), np.zeros(1), self.places[None] * np.nan, [])
        half = len(shots) // 2
        parts = [
            self.play(shots[cut], None if positions is None else positions[cut], paths=paths)
            for cut in (slice(0, half), slice(half, None))
        ]
        made, gain, places = (np.concatenate([part[k] for part in parts]) for k in range(3))
        return Tried(made, gain, places, parts[0].paths + parts[1].paths)

    def verdicts(self, shots: Any) -> Iterator[tuple[Any, Verdict]]:
        """Where the balls lie after each of these, (balls, 2) m, and the whole verdict on it."""
        cue = self.turn.cue
        done = simulate_many(self.world, cue, shots, contacts=self.kept, compiled=self.compiled)
        for k, places in enumerate(done.positions):
            yield places, self.rules.verdict(done.log(k), self.turn)

    def _potted(self, outcomes: Outcomes) -> Any:
        ball, pocket = self.pot or ("", "")
        there = [wall == pocket for wall in outcomes.walls]
        drops = outcomes.contacts["kind"] == POCKET
        drops &= outcomes.contacts["first"] == self.names.index(ball)
        drops[drops] = np.array(there)[outcomes.contacts["second"][drops]]
        return drops.any(axis=1)

    def _path(self, log: Any) -> tuple[str, ...]:
        return self.pot or self.rules.verdict(log, self.turn).facts.path

    def _quick(self) -> bool | None:
        """Whether the compiled kernel plays this world: if numba is there and all its laws can."""
        if importlib.util.find_spec("numba") is None:
            return False
        try:
            simulate_many(self.world, self.turn.cue, speed=1.0, compiled=True)
        except (ValueError, RuntimeError):
            return None
        return True
