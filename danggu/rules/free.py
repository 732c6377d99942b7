"""A table without rules: every stroke is described, none is judged."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .state import FRESH, GameState
from .stroke import Logged, Stroke, stroke
from .verdict import Turn, Verdict, Verdicts, facts

if TYPE_CHECKING:
    from physics import Outcomes


FREE = "free"


@dataclass(frozen=True, slots=True)
class Free:
    """The same player stays at the table.

    balls: names of all balls on the table.
    cues: names of the cue balls, in the order of play.
    """

    balls: tuple[str, ...] = ("white", "yellow", "red1", "red2")
    cues: tuple[str, ...] = ("white",)

    @property
    def key(self) -> str:
        return FREE

    def start(self, players: int) -> GameState:
        return FRESH

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return tuple(ball for ball in self.balls if ball != turn.cue)

    def needs(self, turn: Turn) -> int:
        return 0

    def settles(self, verdict: Verdict) -> bool:
        return False

    def enough(self, turn: Turn, balls: Sequence[str]) -> tuple[str, ...]:
        return ()

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        return self.judge(stroke(log, turn.cue), turn)

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .verdicts import alike

        return alike(outcomes, FREE)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        return Verdict(FREE, passes=False, facts=facts(done))
