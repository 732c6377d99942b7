"""The outlook from a position: how likely its best stroke scores, found by a small search; for many
positions at once."""

from __future__ import annotations

from typing import Any

import numpy as np

from .bench import Bench
from .candidates import Style
from .draws import draws
from .errors import missed
from .knockout import middles
from .levels import Level

DRAWN = 240  # aims at each position
# Of those that score so many are tried, with so many copies of each, round by round; after a round
# the middles of what scored around each join them.
ROUNDS = ((12, 4), (4, 12), (3, 24))


def outlook(bench: Bench, places: Any, style: Style, level: Level, rng: np.random.Generator) -> Any:
    """(n,): the share of the best stroke that a small search finds from each of n positions.

    places: (n, balls, 2) m.
    Too low for every position, since a larger search finds more, but in the right order on average.
    """
    own, on = bench.own, bench.on
    shots = draws(places[:, own], places[:, on], bench.radius, style, DRAWN, rng)
    found = bench.play(shots.reshape(-1, 6), np.repeat(places, DRAWN, axis=0)).made
    rows, number = np.nonzero(found.reshape(shots.shape[:2]))
    shots, merit, best = shots[rows, number], np.zeros(len(rows)), np.zeros(len(places))
    for keep, copies in ROUNDS:
        chosen = firsts(rows, merit, keep)
        rows, shots = rows[chosen], shots[chosen]
        if not len(rows):
            break
        tries = missed(shots, level, copies, bench.radius, rng)
        made = bench.play(tries, np.repeat(places[rows], copies, axis=0)).made
        made = made.reshape(len(rows), copies)
        merit = made.mean(axis=1)
        best[:] = 0.0
        np.maximum.at(best, rows, merit)
        some = merit > 0.0
        more = middles(tries.reshape(*made.shape, 6)[some], made[some])
        rows, shots = np.concatenate([rows, rows[some]]), np.concatenate([shots, more])
        merit = np.concatenate([merit, merit[some]])
    return best


def firsts(rows: Any, merit: Any, keep: int) -> Any:
    """The numbers of those that are among the best `keep` of their row."""
    order = np.lexsort((-merit, rows))
    sorted_rows = rows[order]
    first = np.searchsorted(sorted_rows, sorted_rows)
    return order[np.arange(len(order)) - first < keep]
