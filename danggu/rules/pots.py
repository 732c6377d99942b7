"""8-, 9- and 10-ball over arrays: the rules of `pool` and of each game, for all shots at once."""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING, Any

import numpy as np

from . import pool, reasons
from .state import BREAK
from .stroke import TIE
from .strokes import OFF, POCKET, RAIL, Strokes
from .verdict import NO_BALL, OFF_TABLE, Turn, Verdicts
from .verdicts import Ruling, joined, pieces

if TYPE_CHECKING:
    from physics import Outcomes

Faults = list[tuple[Any, str]]


class Pots(Strokes):
    """The strokes of a batch, as far as pool asks.

    down, gone: (shots, balls), which balls dropped, and which are no longer on the table.
    lost: (shots,), whether the cue ball is one of them.
    potted: (shots,), whether an object ball dropped.
    driven: (shots,), how many object balls met a rail, or are gone.
    """

    def __init__(self, outcomes: Outcomes, cue: str) -> None:
        super().__init__(outcomes, cue)
        self._walls = outcomes.walls
        kind = self._lines["kind"]
        rails = (kind == RAIL) & ~self._lines["again"]
        self.down = self._which(kind == POCKET)
        self.gone = self.down | self._which(kind == OFF)
        self.lost = self.gone[:, self.own]
        self.potted = np.delete(self.down, self.own, axis=1).any(axis=1)
        driven = self.gone | self._which(rails)
        self.driven = np.delete(driven, self.own, axis=1).sum(axis=1)
        late = rails & (self._lines["time"] > self.first[self._rows_of] + TIE)
        self._railed = self.down.any(axis=1) | self._any(self._rows_of[late])
        self._firsts = self.met <= self.first[:, None] + TIE
        self._firsts &= np.isfinite(self.met)

    def _which(self, where: Any) -> Any:
        """(shots, balls): those that such a contact happened to."""
        found = np.zeros(self.met.shape, bool)
        found[self._rows_of[where], self._lines["first"][where]] = True
        return found

    def among(self, names: Collection[str]) -> Any:
        """(balls,): which of them have such a name."""
        return np.array([name in names for name in self._names])

    def faults(self, legal: Collection[str] | None = None, *, rail: bool = True) -> Faults:
        """Which shots were which foul, the first that applies, as `pool.fault` has it."""
        found: Faults = [(self.lost, pool.SCRATCH), (self.off, OFF_TABLE)]
        if legal is not None or rail:
            found.append((self.hits == 0, NO_BALL))
        if legal is not None:
            found.append((~(self._firsts & self.among(legal)).any(axis=1), pool.WRONG_BALL))
        if rail:
            found.append((~self._railed, pool.NO_RAIL))
        return found

    def called(self, turn: Turn) -> Any:
        """(shots, balls): the ball that dropped as called, if one did, as `pool.called` has it."""
        call, none = turn.call, np.zeros(self.met.shape, bool)
        if call.safety or call.push:
            return none
        single = self._firsts & (self._firsts.sum(axis=1) == 1)[:, None]
        meant = none | self.among((call.ball,)) if call.ball else single
        there = np.array([call.pocket in ("", wall or "") for wall in self._walls])
        drops = self._lines["kind"] == POCKET
        drops[drops] = there[self._lines["second"][drops]]
        found = meant & self._which(drops)
        found[:, self.own] = False
        return found


def nine_ball_verdicts(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    """As `NineBall.judge` has them."""
    return joined([_nine(rules, piece, turn) for piece in pieces(outcomes)])


def ten_ball_verdicts(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    """As `TenBall.judge` has them."""
    return joined([_ten(rules, piece, turn) for piece in pieces(outcomes)])


def eight_ball_verdicts(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    """As `EightBall.judge` has them."""
    judge = _broken if turn.state.phase == BREAK else _eight
    return joined([judge(rules, piece, turn) for piece in pieces(outcomes)])


def _nine(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    done, ruling = _rotation(rules, outcomes, turn)
    won = done.down & done.among((rules.money,))
    ruling.rule(won.any(axis=1), pool.RACK_WON, made=True)
    ruling.rule(done.potted, pool.POTTED, made=True)
    ruling.rule(True, pool.MISSED)
    return ruling.verdicts(outcomes, False, False)


def _ten(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    done, ruling = _rotation(rules, outcomes, turn)
    made = done.potted
    if turn.state.phase != BREAK:
        called = done.called(turn)
        made = called.any(axis=1)
        if rules.early or turn.state.left == (rules.money,):
            won = (called & done.among((rules.money,))).any(axis=1)
            ruling.rule(won, pool.RACK_WON, made=True)
    ruling.rule(made, pool.POTTED, made=True)
    ruling.rule(done.potted, pool.SLOP)
    ruling.rule(True, pool.SAFE if turn.call.safety else pool.MISSED)
    return ruling.verdicts(outcomes, False, False)


def _rotation(rules: Any, outcomes: Outcomes, turn: Turn) -> tuple[Pots, Ruling]:
    """The fouls of 9-ball and 10-ball, and a push out."""
    done, ruling = Pots(outcomes, turn.cue), Ruling(len(outcomes.times))
    pushes = rules.pushes(turn)
    faults = done.faults(rail=False) if pushes else done.faults(rules.targets(turn))
    if turn.state.phase == BREAK and not pushes:
        few = ~done.down.any(axis=1) & (done.driven < pool.TO_BREAK)
        faults.append((few, pool.FEW_RAILS))
    fouls = pool.counted(turn.state, turn, foul=True, warns=rules.warns).fouls[turn.player]
    for where, foul in faults:
        ruling.rule(where, pool.THREE_FOULS if fouls >= 3 else foul, foul=True)
    if pushes:
        ruling.rule(True, pool.PUSHED)
    return done, ruling


def _eight(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    done, ruling = Pots(outcomes, turn.cue), Ruling(len(outcomes.times))
    legal, eight = rules.targets(turn), done.among((reasons.EIGHT,))
    for where, foul in done.faults(legal):
        ruling.rule(where, foul, foul=True)
    called = done.called(turn)
    if legal == (reasons.EIGHT,):
        ruling.rule((called & eight).any(axis=1), pool.RACK_WON, made=True)
    ruling.rule((done.gone & eight).any(axis=1), pool.RACK_LOST)
    ruling.rule((called & done.among(legal)).any(axis=1), pool.POTTED, made=True)
    ruling.rule(True, pool.SAFE if turn.call.safety else pool.MISSED)
    return ruling.verdicts(outcomes, False, False)


def _broken(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    done, ruling = Pots(outcomes, turn.cue), Ruling(len(outcomes.times))
    faults = done.faults()
    eight = (done.gone & done.among((reasons.EIGHT,))).any(axis=1)
    illegal = ~eight & ~done.potted & (done.driven < pool.TO_BREAK)
    foul = np.any([where for where, _ in faults], axis=0)
    ruling.rule(illegal & foul, reasons.ILLEGAL_BREAK, foul=True)
    ruling.rule(illegal, reasons.ILLEGAL_BREAK)
    for where, name in faults:
        ruling.rule(where, name, foul=True)
    ruling.rule(eight, reasons.EIGHT_ON_BREAK)
    ruling.rule(done.potted, pool.POTTED, made=True)
    ruling.rule(True, pool.MISSED)
    return ruling.verdicts(outcomes, False, False)
