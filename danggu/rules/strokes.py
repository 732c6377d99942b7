"""What happened on many strokes: the cue ball's part in the contacts of a batch, in arrays."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .stroke import TIE
from .verdicts import number

if TYPE_CHECKING:
    from physics import Outcomes

HIT, RAIL, POCKET, OFF = 1, 2, 3, 4  # kinds of contacts in `physics.Outcomes`


class Strokes:
    """The strokes of a batch, as far as games without pockets ask; all times in s.

    met: (shots, balls), when the cue ball first hit each ball; inf if it never did.
    first, last: (shots,), when it hit the first ball that it hit, and when the last one; `first`
    is inf, and `last` -inf, if it hit none.
    hits: (shots,), how many balls it hit.
    off: (shots,), whether a ball left the table.
    own: number of the cue ball.
    pressed: (shots,), whether it lay against a cushion and was driven into it before all else.
    """

    def __init__(self, outcomes: Outcomes, cue: str) -> None:
        """ValueError if there is no ball of that name."""
        own = number(outcomes, cue)
        self.shots, self._names = len(outcomes.contacts), outcomes.balls
        kept = outcomes.contacts["kind"] != 0
        rows, lines = np.nonzero(kept)[0], outcomes.contacts[kept]
        kind, ball, other = lines["kind"], lines["first"], lines["second"]
        self._end = np.full(self.shots, -np.inf)
        np.maximum.at(self._end, rows, lines["time"])
        self.off = self._any(rows[kind == OFF])
        hit = (kind == HIT) & ((ball == own) | (other == own))
        rail = (kind == RAIL) & (ball == own)
        again = rail & lines["again"]
        rail &= ~lines["again"]
        partner = np.where(ball[hit] == own, other[hit], ball[hit])
        met = np.full(self.shots * len(self._names), np.inf)
        np.minimum.at(met, rows[hit] * len(self._names) + partner, lines["time"][hit])
        self.met = met.reshape(self.shots, len(self._names))
        self.own, self._lines, self._rows_of = own, lines, rows
        known = np.isfinite(self.met)
        self.hits = known.sum(axis=1)
        self.first = self.met.min(axis=1)
        self.last = np.where(known, self.met, -np.inf).max(axis=1)
        self._rows, self._times = rows[rail], lines["time"][rail]
        self.pressed = self._pressed(rows, np.flatnonzero(hit | rail), np.flatnonzero(again))

    def _any(self, rows: Any) -> Any:
        """(shots,): is it one of the rows?"""
        found = np.zeros(self.shots, bool)
        found[rows] = True
        return found

    def _pressed(self, rows: Any, touches: Any, again: Any) -> Any:
        """(shots,): does a contact with a cushion not left yet come before every touch?"""
        first = np.full((2, self.shots), len(rows))
        for line, places in zip(first, (touches, again), strict=True):
            np.minimum.at(line, rows[places], places)
        return first[1] < first[0]

    def hit(self, ball: str) -> Any:
        """(shots,): when the cue ball first hit that ball, s; inf if it never did."""
        if ball not in self._names:
            return np.full(self.shots, np.inf)
        return self.met[:, self._names.index(ball)]

    def cushions(self, before: Any) -> Any:
        """(shots,): how many cushions the cue ball met before that time, not at the same instant.

        before: (shots,) s."""
        rows = self._rows[self._times < before[self._rows] - TIE]
        return np.bincount(rows, minlength=self.shots)

    def cushion_at(self, time: Any) -> Any:
        """(shots,): did it meet a cushion at the same instant as that time, (shots,) s?"""
        return self._any(self._rows[abs(self._times - time[self._rows]) <= TIE])

    def past(self, time: Any) -> Any:
        """(shots,): do the contacts kept reach past that time, (shots,) s?"""
        return self._end > time + TIE
