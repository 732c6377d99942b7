"""What every lab has: numbers, a scene made of them, fields for answers, and what is true."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

from physics import World

Numbers = Mapping[str, float]
Cell = float | int | str
Figure = list[World]
"""Worlds that have been played, to be drawn over one another."""


class Given(NamedTuple):
    """A number that a worksheet begins with.

    name: by which the scene and the text know it.
    unit: its sign, or "".
    usual: its value where no seed is given.
    low, high, step: the values from which a seed chooses.
    hidden: is it for the student to find?
    """

    name: str
    unit: str
    usual: float
    low: float
    high: float
    step: float
    hidden: bool = False

    def drawn(self, chance: random.Random) -> float:
        """One of its values."""
        count = round((self.high - self.low) / self.step) + 1
        return round(self.low + self.step * int(count * chance.random()), 9)


class Field(NamedTuple):
    """A number that is asked for.

    name: by which it is answered.
    unit: its sign, or "".
    within: how far from the engine's value an answer may be, as a share of it.
    slack: the same in the field's unit; the greater of the two counts.
    """

    name: str
    unit: str
    within: float = 0.03
    slack: float = 0.0

    def takes(self, answer: float, truth: float) -> bool:
        """Is the answer near enough?"""
        # a hair more: an answer at the very edge is not to be lost by rounding
        return abs(answer - truth) <= max(self.slack, self.within * abs(truth)) * (1.0 + 1e-9)


class Rows(NamedTuple):
    """A table of measured numbers.

    heads: of its columns: a word of the texts, or one and its unit in brackets: "speed (m/s)".
    rows: numbers, and words of the texts.
    """

    heads: Sequence[str]
    rows: Sequence[Sequence[Cell]]


@dataclass(frozen=True, slots=True)
class Lab:
    """A lab: what a worksheet is made from.

    name: by which it is asked for.
    given: the numbers that it begins with.
    fields: what is asked.
    scene: a world with these numbers, its shot just struck.
    play: lets it run for as long as the lab needs.
    truth: of a played world, the value of each field.
    table: of a played world, what was measured.
    others: more played worlds for the picture, drawn over the first.
    axes: of the graph that the student draws, two words as `Rows.heads` has them, or none.
    """

    name: str
    given: tuple[Given, ...]
    fields: tuple[Field, ...]
    scene: Callable[[Numbers], World]
    truth: Callable[[World, Numbers], dict[str, float]]
    table: Callable[[World, Numbers], Rows]
    play: Callable[[World], None] = World.run
    others: Callable[[Numbers], Figure] = lambda _: []
    axes: tuple[str, ...] = ()

    def numbers(self, seed: int | None) -> dict[str, float]:
        """Those of a seed, or the usual ones; the same on every machine."""
        chance = random.Random(f"{self.name} {seed}")
        drawn = {one.name: one.drawn(chance) for one in self.given}
        return drawn if seed is not None else {one.name: one.usual for one in self.given}
