"""Cannon games with three balls: straight rail, one-cushion and three-cushion are one rule."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf

from .stroke import TIE, Logged, Stroke, stroke
from .verdict import FEW_CUSHIONS, NO_BALL, OFF_TABLE, ONE_BALL, SAME_INSTANT, Turn, Verdict, facts

CANNON, BANK = "cannon", "bank_cannon"
OPENING_NOT_RED = "opening_not_red"
KEYS = {0: "straight", 1: "one_cushion", 3: "three_cushion"}


@dataclass(frozen=True, slots=True)
class Carom:
    """Both other balls, the second one after `cushions` cushion contacts: 3, 1 or 0.

    bank        points of a cannon that met a cushion before the first ball (the PBA gives 2)
    red_first   the opening stroke must hit the red before the other ball
    penalty     points that a foul costs; federations take none
    floor_zero  the score never falls below zero
    """

    cushions: int = 3
    bank: int = 1
    red_first: bool = True
    penalty: int = 0
    floor_zero: bool = True
    cues: tuple[str, ...] = ("white", "yellow")
    red: str = "red"

    def __post_init__(self) -> None:
        if self.cushions not in KEYS:
            raise ValueError(f"cushions must be one of {tuple(KEYS)}, not {self.cushions!r}")
        if self.penalty < 0 or self.bank < 1:
            raise ValueError(f"no such points: penalty {self.penalty!r}, bank {self.bank!r}")

    @property
    def key(self) -> str:
        return KEYS[self.cushions]

    @property
    def balls(self) -> tuple[str, ...]:
        return (*self.cues, self.red)

    def targets(self, turn: Turn) -> tuple[str, ...]:
        if turn.opening and self.red_first:
            return (self.red,)
        return tuple(ball for ball in self.balls if ball != turn.cue)

    def needs(self, turn: Turn) -> int:
        return self.cushions

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        done = stroke(log, turn.cue)
        hits = done.hits()
        if done.off:
            return self._foul(OFF_TABLE, turn, done, None)
        first = min(hits.values(), default=None)
        if first is None:
            return Verdict(NO_BALL, facts=facts(done))
        opened = not (turn.opening and self.red_first)
        if not opened and hits.get(self.red, inf) > first + TIE:
            return self._foul(OPENING_NOT_RED, turn, done, first)
        if len(hits) == 1:
            return Verdict(ONE_BALL, facts=facts(done))
        return self._both(done, max(hits.values()), turn)

    def settles(self, verdict: Verdict) -> bool:
        """The second ball settles all, and so does a first one that the opening may not hit."""
        return verdict.reason not in (NO_BALL, ONE_BALL)

    def _foul(self, reason: str, turn: Turn, done: Stroke, decided: float | None) -> Verdict:
        loss = turn.loss(self.penalty, floor_zero=self.floor_zero)
        return Verdict(reason, loss, foul=True, facts=facts(done, decided))

    def _both(self, done: Stroke, second: float, turn: Turn) -> Verdict:
        seen = facts(done, second)
        if seen.cushions < self.cushions:
            late = seen.cushions == self.cushions - 1 and done.cushion_at(second)
            return Verdict(SAME_INSTANT if late else FEW_CUSHIONS, facts=seen)
        points, reason = (self.bank, BANK) if seen.bank else (1, CANNON)
        won = turn.reached(points)
        return Verdict(reason, points, made=True, passes=False, won=won, facts=seen)
