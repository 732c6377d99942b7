"""A knock-out: of many strokes that score, those which bear a level's error best, path by path."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from .bench import Bench
from .errors import missed
from .levels import Level

ROUNDS = 5
STAYING = 3  # strokes at the end for each path that stays
FEWEST = 4  # copies of each stroke in a round


class Contenders(NamedTuple):
    """Strokes in the running, (strokes,) each.

    shots: (strokes, 6).
    paths: what the cue ball meets.
    copies: with the level's error, that were tried.
    gain: what they brought in all.
    """

    shots: Any
    paths: Any
    copies: Any
    gain: Any

    @classmethod
    def of(cls, shots: Any, paths: list[tuple[str, ...]]) -> Contenders:
        """These, of which no copies have been tried."""
        named = np.empty(len(shots), object)
        named[:] = paths
        return cls(shots, named, np.zeros(len(shots)), np.zeros(len(shots)))

    def take(self, rows: Any) -> Contenders:
        return Contenders(*(column[rows] for column in self))

    def joined(self, other: Contenders) -> Contenders:
        return Contenders(*map(np.concatenate, zip(self, other, strict=True)))

    @property
    def worth(self) -> Any:
        """Points to be expected, as if one more copy had brought none."""
        return self.gain / (self.copies + 1.0)


def knockout(
    bench: Bench, field: Contenders, level: Level, budget: int, paths: int, rng: np.random.Generator
) -> Contenders:
    """The best strokes, three times as many as `paths`, the best first; the best paths are among
    them."""
    share, last = budget // ROUNDS, STAYING * paths
    sizes = np.geomspace(len(field.shots), last, ROUNDS + 1)
    for size in sizes[1:].round().astype(int):
        copies = max(FEWEST, share // (2 * len(field.shots)))
        field, centres = _round(bench, field, level, copies, paths, rng)
        field = best(field, max(size, paths), paths)
        done = int(field.copies.max(initial=0.0))
        if len(centres.shots):  # as many copies of the newcomers as of the others
            centres, _ = _round(bench, centres, level, done, paths, rng)
            field = best(field.joined(centres), max(size, paths), paths)
    return best(field, last, paths)


def best(field: Contenders, keep: int, paths: int) -> Contenders:
    """The best `keep` strokes, the best first; the best of each of the best paths among them."""
    order = np.argsort(-field.worth, kind="stable").tolist()
    chosen = first_of_each(field.paths, order)[:paths]
    chosen += [row for row in order if row not in set(chosen)]
    return field.take(sorted(chosen[:keep], key=lambda row: -field.worth[row]))


def first_of_each(paths: Any, order: list[int]) -> list[int]:
    """The first of each path, in that order."""
    found: dict[tuple[str, ...], int] = {}
    for row in order:
        found.setdefault(paths[row], row)
    return [*found.values()]


def _round(
    bench: Bench, field: Contenders, level: Level, copies: int, paths: int, rng: np.random.Generator
) -> tuple[Contenders, Contenders]:
    """The field with so many more copies of each, and the middles of what scored around the best
    and around the best of each of the best paths."""
    shots = missed(field.shots, level, copies, bench.radius, rng)
    tried = bench.play(shots)
    made = tried.made.reshape(len(field.shots), copies)
    gain = field.gain + tried.gain.reshape(made.shape).sum(axis=1)
    after = field._replace(copies=field.copies + copies, gain=gain)
    order = np.argsort(-after.worth, kind="stable").tolist()
    firsts = first_of_each(field.paths, order)[:paths]
    rows = np.array([*dict.fromkeys([*order[: len(made) // 4], *firsts])], int)
    rows = rows[made[rows].sum(axis=1) > 1]
    centres = middles(shots.reshape(*made.shape, 6)[rows], made[rows])
    if not len(rows):
        return after, after.take(rows)
    found = bench.play(centres, paths=True)
    return after, Contenders.of(centres[found.made], found.paths)


def middles(shots: Any, made: Any) -> Any:
    """(strokes, 6): the middle of the copies of each that scored: farther from where it fails."""
    weights = made / made.sum(axis=1, keepdims=True)
    numbers = shots / np.where([False, False, True, False, True, False], shots[..., :1], 1.0)
    found = (weights[..., None] * numbers).sum(axis=1)
    found[:, [2, 4]] *= found[:, :1]
    return found
