"""Four-ball (사구): both reds with the own ball, and never the opponent's.

No federation governs these rules; what differs from house to house is an option.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from .reasons import BOTH_REDS, BOTH_REDS_3C, NO_RED, ONE_RED, OPPONENT_BALL
from .state import FRESH, GameState
from .stroke import Logged, Stroke, stroke
from .verdict import FEW_CUSHIONS, OFF_TABLE, SAME_INSTANT, Facts, Turn, Verdict, Verdicts, facts

if TYPE_CHECKING:
    from physics import Outcomes


NONE, LAST_POINT_3C, EXTRA_3C = "none", "last_point_3c", "extra_3c"
FINISHES = (NONE, LAST_POINT_3C, EXTRA_3C)


@dataclass(frozen=True, slots=True)
class Sagu:
    """The game with its house rules.

    finish: how it ends: "none", at the target; "last_point_3c", the last point must come off three
    cushions; "extra_3c", after the last point one more stroke off three cushions.
    penalty: points that a foul costs.
    floor_zero: the score never falls below zero.
    cues: names of the cue balls, in the order of play.
    reds: names of the reds.
    """

    finish: str = EXTRA_3C
    penalty: int = 1
    floor_zero: bool = True
    cues: tuple[str, ...] = ("white", "yellow")
    reds: tuple[str, str] = ("red1", "red2")

    def __post_init__(self) -> None:
        if self.finish not in FINISHES:
            raise ValueError(f"finish must be one of {FINISHES}, not {self.finish!r}")
        if self.penalty < 0:
            raise ValueError(f"penalty must not be negative, not {self.penalty!r}")

    @property
    def key(self) -> str:
        return "sagu"

    @property
    def balls(self) -> tuple[str, ...]:
        return self.cues + self.reds

    def start(self, players: int) -> GameState:
        return FRESH

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return self.reds

    def needs(self, turn: Turn) -> int:
        """Three cushions where the stroke would end the game, else none."""
        last = {NONE: None, LAST_POINT_3C: 1, EXTRA_3C: 0}[self.finish]
        closing = turn.target is not None and last is not None and turn.reached(last)
        return 3 if closing else 0

    @property
    def extra(self) -> bool:
        """Is the last stroke one off three cushions that is worth nothing?"""
        return self.finish == EXTRA_3C

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        return self.judge(stroke(log, turn.cue), turn)

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .cannons import sagu_verdicts

        return sagu_verdicts(self, outcomes, turn)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        hits = done.hits()
        opponent = min((hits[cue] for cue in self.cues if cue in hits), default=None)
        reds = sorted(hits[red] for red in self.reds if red in hits)
        if done.off or done.acts:
            return self._foul(done.acts[0].what if done.acts else OFF_TABLE, turn, facts(done))
        if opponent is not None:
            return self._foul(OPPONENT_BALL, turn, facts(done, opponent))
        if not reds:
            return self._foul(NO_RED, turn, facts(done))
        if len(reds) == 1:
            return Verdict(ONE_RED, facts=facts(done))
        return self._both(done, reds[1], turn)

    def settles(self, verdict: Verdict) -> bool:
        """A foul on the opponent's ball stays; a point is open while that ball may yet be met."""
        return verdict.reason in (OPPONENT_BALL, OFF_TABLE)

    def enough(self, turn: Turn, balls: Sequence[str]) -> tuple[str, ...]:
        others = tuple(cue for cue in self.cues if cue != turn.cue and cue in balls)
        return others if len(others) == 1 else ()

    def _foul(self, reason: str, turn: Turn, seen: Facts) -> Verdict:
        return Verdict(
            reason,
            turn.loss(self.penalty, floor_zero=self.floor_zero),
            foul=True,
            facts=seen,
            spot=seen.off,
        )

    def _both(self, done: Stroke, second: float, turn: Turn) -> Verdict:
        seen = facts(done, second)
        cushions = self.needs(turn)
        if seen.cushions < cushions:
            late = seen.cushions == cushions - 1 and done.cushion_at(second)
            return Verdict(SAME_INSTANT if late else FEW_CUSHIONS, facts=seen)
        extra = cushions > 0 and self.extra
        won = extra or (not self.extra and turn.reached(1))
        reason = BOTH_REDS_3C if cushions else BOTH_REDS
        return Verdict(reason, 0 if extra else 1, made=True, passes=False, won=won, facts=seen)
