"""The cannon games over arrays: the rules of `carom` and `sagu`, for all shots at once."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import reasons
from .stroke import TIE
from .strokes import Strokes
from .verdict import FEW_CUSHIONS, NO_BALL, OFF_TABLE, ONE_BALL, SAME_INSTANT, Turn, Verdicts
from .verdicts import Ruling, joined, pieces

if TYPE_CHECKING:
    from physics import Outcomes


def carom_verdicts(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    """As `Carom.judge` has them."""
    return joined([_carom(rules, piece, turn) for piece in pieces(outcomes)])


def sagu_verdicts(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    """As `Sagu.judge` has them."""
    return joined([_sagu(rules, piece, turn) for piece in pieces(outcomes)])


def _carom(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    done, ruling = Strokes(outcomes, turn.cue), Ruling(len(outcomes.times))
    loss = turn.loss(rules.penalty, floor_zero=rules.floor_zero)
    ruling.rule(done.off, OFF_TABLE, loss, foul=True)
    if rules.umb:
        ruling.rule(done.pressed, reasons.INTO_CUSHION, loss, foul=True)
    ruling.rule(done.hits == 0, NO_BALL)
    every = (done.hits > 1) & (done.hits == len(outcomes.balls) - 1)
    settled = done.pressed & rules.umb | every & done.past(done.last)
    if turn.opening and rules.red_first:
        wrong = done.hit(rules.red) > done.first + TIE
        ruling.rule(wrong, reasons.OPENING_NOT_RED, loss, foul=True)
        if rules.umb:
            wrong |= done.cushions(done.first) > 0
            ruling.rule(wrong, reasons.OPENING_BANK)
        settled |= wrong & (done.hits > 0) & done.past(done.first)
    ruling.rule(done.hits == 1, ONE_BALL)
    _second(ruling, done, done.last, rules.cushions)
    ruling.rule(done.cushions(done.first) > 0, reasons.BANK, rules.bank, made=True)
    ruling.rule(True, reasons.CANNON, 1, made=True)
    return ruling.verdicts(outcomes, settled, done.off)


def _sagu(rules: Any, outcomes: Outcomes, turn: Turn) -> Verdicts:
    done, ruling = Strokes(outcomes, turn.cue), Ruling(len(outcomes.times))
    loss, cushions = turn.loss(rules.penalty, floor_zero=rules.floor_zero), rules.needs(turn)
    reds = np.stack([done.hit(red) for red in rules.reds])
    opponent = np.isfinite([done.hit(cue) for cue in rules.cues]).any(axis=0)
    count = np.isfinite(reds).sum(axis=0)
    ruling.rule(done.off, OFF_TABLE, loss, foul=True)
    ruling.rule(opponent, reasons.OPPONENT_BALL, loss, foul=True)
    ruling.rule(count == 0, reasons.NO_RED, loss, foul=True)
    ruling.rule(count == 1, reasons.ONE_RED)
    _second(ruling, done, reds.max(axis=0), cushions)
    extra = cushions > 0 and rules.extra
    reason = reasons.BOTH_REDS_3C if cushions else reasons.BOTH_REDS
    ruling.rule(True, reason, 0 if extra else 1, made=True)
    return ruling.verdicts(outcomes, opponent, done.off)


def _second(ruling: Ruling, done: Strokes, second: np.ndarray, cushions: int) -> None:
    """Too few cushions before the second ball, which was hit at that time, (shots,) s."""
    if cushions == 0:
        return
    found = done.cushions(second)
    late = (found == cushions - 1) & done.cushion_at(second)
    ruling.rule(late, SAME_INSTANT)
    ruling.rule(found < cushions, FEW_CUSHIONS)
