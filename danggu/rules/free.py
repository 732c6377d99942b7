"""A table without rules: every stroke is told, none is judged."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from .stroke import Logged, stroke
from .verdict import Turn, Verdict, facts

FREE = "free"


@dataclass(frozen=True, slots=True)
class Free:
    """The same player stays at the table for ever; `balls` are whatever lies on it."""

    balls: tuple[str, ...] = ("white", "yellow", "red1", "red2")
    cues: tuple[str, ...] = ("white",)

    @property
    def key(self) -> str:
        return FREE

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return tuple(ball for ball in self.balls if ball != turn.cue)

    def needs(self, turn: Turn) -> int:
        return 0

    def settles(self, verdict: Verdict) -> bool:
        return False

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        return Verdict(FREE, passes=False, facts=facts(stroke(log, turn.cue)))
