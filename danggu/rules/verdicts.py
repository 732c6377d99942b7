"""Verdicts over arrays: those of every shot of a batch at once, by the contacts it has kept."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

from physics import Outcomes

from .verdict import Turn, Verdict, Verdicts

PIECE = 4096  # shots that are judged at once: their contacts stay in the processor's cache


def joined(parts: Sequence[Verdicts]) -> Verdicts:
    """The verdicts on one batch after the other, as one."""
    return Verdicts(*map(np.concatenate, zip(*parts, strict=True)))


def pieces(outcomes: Outcomes) -> Iterator[Outcomes]:
    """The batch in pieces of a few thousand shots, one at least."""
    for k in range(0, max(len(outcomes.times), 1), PIECE):
        cut = slice(k, k + PIECE)
        yield outcomes._replace(
            positions=outcomes.positions[cut], times=outcomes.times[cut],
            events=outcomes.events[cut], contacts=outcomes.contacts[cut],
            dropped=outcomes.dropped[cut],
        )  # fmt: skip


class Ruling:
    """Verdicts being found: the first rule that applies to a shot decides it.

    open: (shots,), those that no rule has decided yet.
    """

    def __init__(self, shots: int) -> None:
        self.open = np.ones(shots, bool)
        self._points, self._code = np.zeros(shots, int), np.zeros(shots, np.intp)
        self._made, self._foul = np.zeros(shots, bool), np.zeros(shots, bool)
        self._reasons = [""]

    def rule(
        self, where: Any, reason: str, points: int = 0, *, made: bool = False, foul: bool = False
    ) -> None:
        """Decide those still open where the rule applies, (shots,) or True for all of them."""
        mine = self.open & where
        self._points[mine], self._made[mine], self._foul[mine] = points, made, foul
        self._code[mine] = len(self._reasons)
        self._reasons.append(reason)
        self.open &= ~mine

    def verdicts(self, outcomes: Outcomes, settled: Any, off: Any) -> Verdicts:
        """The verdicts, which stand where nothing was dropped, a ball left the table, or the stroke
        was settled and no ball can have left it since."""
        here = np.isfinite(outcomes.positions).all(axis=(1, 2))
        certain = (outcomes.dropped == 0) | off | (settled & here)
        reason = np.array(self._reasons)[self._code]
        return Verdicts(self._points, self._made, self._foul, reason, certain)


def number(outcomes: Outcomes, cue: str) -> int:
    """The number of the cue ball; ValueError if there is no ball of that name."""
    if cue not in outcomes.balls:
        raise ValueError(f"there is no ball {cue!r:.60} among {', '.join(outcomes.balls)}")
    return outcomes.balls.index(cue)


def alike(outcomes: Outcomes, reason: str) -> Verdicts:
    """The same verdict on every shot: nothing scored, and no foul."""
    ruling = Ruling(len(outcomes.times))
    ruling.rule(True, reason)
    return ruling.verdicts(outcomes, True, True)


def one_by_one(
    verdict: Callable[[list[Any], Turn], Verdict], outcomes: Outcomes, turn: Turn
) -> Verdicts:
    """The verdicts of any game: the one that `verdict` has on the contacts of each shot."""
    number(outcomes, turn.cue)
    found = [verdict(outcomes.log(k), turn) for k in range(len(outcomes.times))]
    return Verdicts(
        np.array([each.points for each in found], int),
        np.array([each.made for each in found], bool),
        np.array([each.foul for each in found], bool),
        np.array([each.reason for each in found], str),
        outcomes.dropped == 0,
    )
