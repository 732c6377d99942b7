"""What the games with pockets share."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, ClassVar, TypeVar

from .state import BREAK, KITCHEN, GameState
from .stroke import Logged, Stroke, stroke
from .verdict import Turn, Verdict, Verdicts

if TYPE_CHECKING:
    from physics import Outcomes


T = TypeVar("T")
CUE = "cue"
NUMBERS = tuple(str(number) for number in range(1, 16))


class Pocketed:
    """A game with one cue ball and pockets: no cushion is needed, nothing is settled early."""

    cues: ClassVar[tuple[str, ...]] = (CUE,)
    objects: ClassVar[tuple[str, ...]] = NUMBERS

    @property
    def balls(self) -> tuple[str, ...]:
        return (*self.cues, *self.objects)

    def start(self, players: int) -> GameState:
        """The break: all balls racked, the cue ball in hand behind the head string."""
        none = (0,) * players
        return GameState(BREAK, self.objects, fouls=none, warned=(False,) * players, region=KITCHEN)

    def needs(self, turn: Turn) -> int:
        return 0

    def settles(self, verdict: Verdict) -> bool:
        return False

    def enough(self, turn: Turn, balls: Sequence[str]) -> tuple[str, ...]:
        return ()

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        return self.judge(stroke(log, turn.cue), turn)

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .verdicts import one_by_one

        return one_by_one(self.verdict, outcomes, turn)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        raise NotImplementedError


def put(values: tuple[T, ...], index: int, value: T) -> tuple[T, ...]:
    """The tuple with the value at `index` replaced."""
    return (*values[:index], value, *values[index + 1 :])


def without(state: GameState, gone: Iterable[str]) -> GameState:
    """The state with these balls no longer on the table."""
    away = set(gone)
    return replace(state, left=tuple(ball for ball in state.left if ball not in away))
