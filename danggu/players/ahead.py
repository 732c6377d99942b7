"""One stroke ahead: of strokes in the running, those that leave the best positions."""

from __future__ import annotations

from typing import Any

import numpy as np

from .bench import Bench
from .candidates import Style
from .errors import missed
from .knockout import Contenders
from .levels import Level
from .outlook import DRAWN, ROUNDS, firsts, outlook

COST = DRAWN + 1.7 * sum(keep * copies for keep, copies in ROUNDS)  # strokes a position, about
# Of the positions that are looked at, parts for the first round and so on; each time half of the
# strokes are left.
PARTS = (0.35, 0.35, 0.3)
HOPELESS = 0.75  # of the best share: what is below is not looked at
WIDEST = 4  # copies for each position that is wanted, at most


class Ahead:
    """Strokes in the running and what is known of the positions they leave.

    field: the strokes, of which copies have been tried.
    count, total, square: (strokes,), positions looked at, the sum of their outlooks and of the
    squares of these.
    """

    def __init__(self, field: Contenders) -> None:
        self.field = field
        self.count, self.total, self.square = np.zeros((3, len(field.shots)))

    @property
    def after(self) -> Any:
        """(strokes,): the mean outlook of each, drawn to that of all as far as it is uncertain;
        NaN where none is known.

        Positions scatter more than strokes differ: the mean of a few says little (the estimator of
        James and Stein, 1961).
        """
        known = self.count > 0
        if not known.any():
            return np.full(len(self.count), np.nan)
        count, total = np.maximum(self.count, 1.0), self.total.sum() / self.count.sum()
        means = np.where(known, self.total / count, total)
        scatter = (self.square - count * means**2)[known].sum() / max(
            1.0, (count - 1.0)[known].sum()
        )
        errors = max(scatter, 1e-6) / count
        between = max(0.0, float(means[known].var() - errors[known].mean()))
        return total + (means - total) * between / (between + errors)

    @property
    def worth(self) -> Any:
        """(strokes,): points to be expected in this inning, if it goes on as it does on average."""
        after, share = self.after, self.field.worth
        if np.isnan(after).all():
            return share
        return share * (1.0 + after / (1.0 - min(float(after.mean()), 0.95)))

    def look(self, rows: Any, positions: int, here: Bench, then: Bench, style: Style,
             level: Level, rng: np.random.Generator) -> None:  # fmt: skip
        """Look at so many positions that each of these strokes leaves when it scores."""
        shots, field = self.field.shots[rows], self.field
        share = np.clip(field.worth[rows].mean(), 1.0 / WIDEST, 1.0)
        copies = int(np.ceil(positions / share))
        tried = here.play(missed(shots, level, copies, here.radius, rng))
        field.copies[rows] += copies
        field.gain[rows] += tried.gain.reshape(len(rows), copies).sum(axis=1)
        good = np.flatnonzero(tried.made & np.isfinite(tried.places).all(axis=(1, 2)))
        good = good[firsts(good // copies, np.zeros(len(good)), positions)]
        found, of = outlook(then, tried.places[good], style, level, rng), rows[good // copies]
        for column, value in ((self.count, 1.0), (self.total, found), (self.square, found**2)):
            np.add.at(column, of, value)


def looked(
    field: Contenders, here: Bench, then: Bench, style: Style, level: Level, budget: int,
    rng: np.random.Generator,
) -> Ahead:  # fmt: skip
    """The strokes, the best by far looked at most; `then` is the bench for the stroke after."""
    found = Ahead(field)
    rows = np.flatnonzero(field.worth >= HOPELESS * field.worth.max())
    for part in PARTS:
        positions = max(1, int(part * budget / (COST * len(rows))))
        found.look(rows, positions, here, then, style, level, rng)
        rows = rows[np.argsort(-found.worth[rows], kind="stable")][: max(1, len(rows) // 2)]
    return found
