"""Cannon games with three balls: straight rail, one-cushion and three-cushion are one rule."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from math import inf
from typing import TYPE_CHECKING

from .reasons import BANK, CANNON, INTO_CUSHION, OPENING_BANK, OPENING_NOT_RED
from .state import FRESH, GameState, Option, Question
from .stroke import TIE, Logged, Stroke, stroke
from .verdict import (
    FEW_CUSHIONS,
    NO_BALL,
    OFF_TABLE,
    ONE_BALL,
    SAME_INSTANT,
    Turn,
    Verdict,
    Verdicts,
    facts,
)

if TYPE_CHECKING:
    from physics import Outcomes


PLAY_ON, RESPOT = "play_on", "respot"
KEYS = {0: "straight", 1: "one_cushion", 3: "three_cushion"}


@dataclass(frozen=True, slots=True)
class Carom:
    """A point for both other balls, the second one after enough cushions.

    cushions: cushion contacts needed, 3, 1 or 0.
    bank: points of a cannon that met a cushion before the first ball (the PBA gives 2).
    red_first: the opening stroke must hit the red before the other ball.
    penalty: points that a foul costs; federations take none.
    floor_zero: the score never falls below zero.
    umb: the rules of the UMB: the opening stroke goes to the red directly (3.3), the cushion that
    the cue ball lies against may not be played (4.1), and balls that touch the cue ball may be
    spotted (3.7).
    cues: names of the cue balls, in the order of play.
    red: name of the red.
    """

    cushions: int = 3
    bank: int = 1
    red_first: bool = True
    penalty: int = 0
    floor_zero: bool = True
    umb: bool = False
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

    def start(self, players: int) -> GameState:
        return FRESH

    def targets(self, turn: Turn) -> tuple[str, ...]:
        if turn.opening and self.red_first:
            return (self.red,)
        return tuple(ball for ball in self.balls if ball != turn.cue)

    def needs(self, turn: Turn) -> int:
        return self.cushions

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        return self.judge(stroke(log, turn.cue), turn)

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        from .cannons import carom_verdicts

        return carom_verdicts(self, outcomes, turn)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        return self.asked(done, turn, self.cannon(done, turn))

    def asked(self, done: Stroke, turn: Turn, verdict: Verdict) -> Verdict:
        """The verdict, with a question if a ball touches the next cue ball: are balls spotted, in
        three-cushion those that touch, in the other games all (UMB 3.7)?"""
        after = (turn.player + verdict.passes) % turn.players
        cue = self.cues[after % len(self.cues)]
        touch = {ball for pair in done.rest.touching if cue in pair for ball in pair}
        if not self.umb or not touch or verdict.won:
            return verdict
        state = turn.state if verdict.state is None else verdict.state
        spot = tuple(b for b in self.balls if b in touch or self.cushions != 3)
        spotted = replace(state, zone="", anchor="")
        options = (Option(PLAY_ON, True, state), Option(RESPOT, True, spotted, spot=spot))
        return replace(verdict, question=Question(options, not verdict.passes, optional=True))

    def cannon(self, done: Stroke, turn: Turn) -> Verdict:
        """The verdict on the stroke, before any question about touching balls."""
        hits = done.hits()
        if done.off or done.acts:
            return self._foul(done.acts[0].what if done.acts else OFF_TABLE, turn, done, None)
        if self.umb and done.pressed:
            return self._foul(INTO_CUSHION, turn, done, None)
        first = min(hits.values(), default=None)
        if first is None:
            return Verdict(NO_BALL, facts=facts(done))
        opened = not (turn.opening and self.red_first)
        if not opened and hits.get(self.red, inf) > first + TIE:
            return self._foul(OPENING_NOT_RED, turn, done, first)
        if not opened and self.umb and done.cushions(first):
            return Verdict(OPENING_BANK, facts=facts(done, first))
        if len(hits) == 1:
            return Verdict(ONE_BALL, facts=facts(done))
        return self._both(done, max(hits.values()), turn)

    def settles(self, verdict: Verdict) -> bool:
        """The second ball settles it, as does a first one that the opening stroke may not hit."""
        return verdict.reason not in (NO_BALL, ONE_BALL)

    def enough(self, turn: Turn, balls: Sequence[str]) -> tuple[str, ...]:
        return tuple(ball for ball in balls if ball != turn.cue)

    def _foul(self, reason: str, turn: Turn, done: Stroke, decided: float | None) -> Verdict:
        loss = turn.loss(self.penalty, floor_zero=self.floor_zero)
        spot = done.off if self.cushions == 3 or not done.off else self.balls
        return Verdict(reason, loss, foul=True, facts=facts(done, decided), spot=spot)

    def _both(self, done: Stroke, second: float, turn: Turn) -> Verdict:
        seen = facts(done, second)
        if seen.cushions < self.cushions:
            late = seen.cushions == self.cushions - 1 and done.cushion_at(second)
            return Verdict(SAME_INSTANT if late else FEW_CUSHIONS, facts=seen)
        points, reason = (self.bank, BANK) if seen.bank else (1, CANNON)
        won = turn.reached(points)
        return Verdict(reason, points, made=True, passes=False, won=won, facts=seen)
