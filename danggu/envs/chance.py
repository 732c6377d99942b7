"""Chance for many tables at once: each has a stream of its own, whatever the others draw.

A number is a function of the table's key and of how many it has drawn, so a table alone and one of
a thousand draw the same bits, and no generator is kept for each (splitmix64: Steele, Lea and Flood,
2014).
"""

from __future__ import annotations

from typing import Any

import numpy as np

STEP, FIRST, SECOND = (
    np.array(word, np.uint64)
    for word in (0x9E3779B97F4A7C15, 0xBF58476D1CE4E5B9, 0x94D049BB133111EB)
)


def mixed(words: Any) -> Any:
    """Each 64-bit word as another one, with no likeness left."""
    for shift, factor in ((30, FIRST), (27, SECOND)):
        words = (words ^ (words >> np.uint64(shift))) * factor
    return words ^ (words >> np.uint64(31))


class Chance:
    """The streams of some tables; `rows` are the numbers of those that draw.

    keys: (tables,) uint64, where each stream starts.
    """

    def __init__(self, keys: Any) -> None:
        self.keys = np.array(keys, np.uint64)
        self.drawn = np.zeros(len(self.keys), np.uint64)

    def words(self, rows: Any, count: int) -> Any:
        """(rows, count) of 64 random bits each."""
        steps = self.drawn[rows][:, None] + np.arange(1, count + 1, dtype=np.uint64)
        self.drawn[rows] += np.uint64(count)
        return mixed(self.keys[rows][:, None] + steps * STEP)

    def uniform(self, rows: Any, count: int) -> Any:
        """(rows, count) numbers from 0 to 1, without 1."""
        return (self.words(rows, count) >> np.uint64(11)) * 2.0**-53

    def normal(self, rows: Any, count: int) -> Any:
        """(rows, count) normal numbers: of mean 0 and deviation 1."""
        radius, turn = np.split(self.uniform(rows, 2 * count), 2, axis=1)
        # a stretch of memory without gaps, of which the last bit does not depend on its length
        far, turn = np.log(1.0 - radius), np.cos(2.0 * np.pi * np.ascontiguousarray(turn))
        return np.sqrt(-2.0 * far) * turn
