"""Russian pyramid: eight balls win, and the cue ball may be pocketed off another ball."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

from . import pool
from .pocketed import CUE, NUMBERS, Pocketed, without
from .state import ANYWHERE, AS_IT_LIES, FRESH, HOUSE, PLAY, GameState, Option, Question
from .stroke import Stroke
from .verdict import NO_BALL, OFF_TABLE, Turn, Verdict, facts

FREE, DYNAMIC, COMBINED = "free", "dynamic", "combined"
IN_HAND = {FREE: AS_IT_LIES, DYNAMIC: ANYWHERE, COMBINED: HOUSE}
MINUS, GIFT, TAKE = "minus", "gift", "take"
WON, LOST, DRAWN = "game_won", "game_lost", "game_drawn"
GOAL = 8


@dataclass(frozen=True, slots=True)
class Pyramid(Pocketed):
    """One game to eight balls, or to the players' targets.

    kind: "free", any ball may be played, and `Call.cue` says which; "dynamic" and "combined", only
    the cue ball; if it is fairly pocketed, the player removes another ball instead and places the
    cue ball anywhere ("dynamic") or in the house ("combined").
    penalty: for a foul: "minus", a point is lost and a ball goes back; "gift", the opponent gets a
    point; "take", the opponent gets a point by removing a ball from the table.
    """

    kind: str = FREE
    penalty: str = MINUS
    objects: ClassVar[tuple[str, ...]] = NUMBERS

    def __post_init__(self) -> None:
        if self.kind not in IN_HAND:
            raise ValueError(f"kind must be one of {(*IN_HAND,)}, not {self.kind!r:.60}")
        if self.penalty not in (MINUS, GIFT, TAKE):
            said = (MINUS, GIFT, TAKE)
            raise ValueError(f"penalty must be one of {said}, not {self.penalty!r:.60}")

    @property
    def key(self) -> str:
        return f"{self.kind}_pyramid"

    def start(self, players: int) -> GameState:
        left = (*self.objects, CUE) if self.kind == FREE else self.objects
        return replace(Pocketed.start(self, players), left=left, region=HOUSE)

    def targets(self, turn: Turn) -> tuple[str, ...]:
        return tuple(ball for ball in turn.state.left if ball != turn.cue)

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        foul = self._foul(done)
        return self._fouled(done, turn, foul) if foul else self._fair(done, turn)

    def _foul(self, done: Stroke) -> str:
        """No ball hit, a ball off the table, or none driven to a cushion or into a pocket."""
        if done.off:
            return OFF_TABLE
        if done.acts:
            return done.acts[0].what
        if not done.first:
            return NO_BALL
        return "" if pool.railed(done) else pool.NO_RAIL

    def _fair(self, done: Stroke, turn: Turn) -> Verdict:
        points = len(done.down)
        state = replace(without(turn.state, done.down), phase=PLAY, region=AS_IT_LIES)
        own = self.kind != FREE and done.cue in done.down
        if own:
            state = replace(state, region=IN_HAND[self.kind])
        verdict = Verdict(
            pool.POTTED if points else pool.MISSED,
            points,
            made=points > 0,
            passes=not points,
            facts=facts(done),
            down=done.down,
            state=state,
        )
        return self._counted(_taken(verdict, shooter=True) if own else verdict, turn)

    def _fouled(self, done: Stroke, turn: Turn, foul: str) -> Verdict:
        gone = tuple(ball for ball in dict.fromkeys((*done.down, *done.off)))
        spot = tuple(ball for ball in gone if ball != CUE or self.kind == FREE)
        region = HOUSE if done.lost and self.kind != FREE else AS_IT_LIES
        state = replace(turn.state, phase=PLAY, region=region)
        verdict = Verdict(foul, foul=True, facts=facts(done), spot=spot, state=state)
        if self.penalty == MINUS:
            back = tuple(ball for ball in self.objects if ball not in state.left)[:1]
            state = replace(state, left=(*state.left, *back))
            return replace(verdict, points=-1, spot=(*spot, *back), state=state)
        verdict = replace(verdict, gift=1)
        if self.penalty == TAKE:
            verdict = _taken(verdict, shooter=False)
        return self._counted(verdict, turn)

    def _counted(self, verdict: Verdict, turn: Turn) -> Verdict:
        """The verdict, ending the game at eight balls or when no ball is left."""
        goal = turn.target or GOAL
        own, other = turn.score + verdict.points, turn.against + verdict.gift
        left = verdict.state.left if verdict.state is not None else ()
        playable = len(left) > (self.kind == FREE)
        if playable and own < goal and other < goal:
            return verdict
        won, lost = own > other, own < other
        reason = WON if won else LOST if lost else DRAWN
        drawn = not (won or lost)
        return replace(verdict, reason=reason, won=won, lost=lost, drawn=drawn, question=None)


def _taken(verdict: Verdict, *, shooter: bool) -> Verdict:
    """The verdict, asking which ball to remove; the last one is removed without asking."""
    state = FRESH if verdict.state is None else verdict.state
    balls = [ball for ball in state.left if ball != CUE]
    if len(balls) <= 1:
        return replace(verdict, state=without(state, balls))
    options = tuple(Option(ball, True, without(state, (ball,))) for ball in balls)
    return replace(verdict, question=Question(options, shooter))
