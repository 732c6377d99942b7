"""A worksheet: a lab with one student's numbers, which asks and checks."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from math import isfinite
from typing import NamedTuple

from physics import World

from . import text
from .shape import Field, Figure, Lab, Rows

MOST = 2**63 - 1  # seed


class Checked(NamedTuple):
    """What has become of an answer.

    field: its name.
    answer: the number that was given.
    right: is it near enough to what the engine says?
    way: what is wrong: +1 it is too large, -1 too small; 0 if it is right.
    """

    field: str
    answer: float
    right: bool
    way: int

    def __bool__(self) -> bool:
        return self.right


class Worksheet:
    """A lab with the numbers of a seed; without a seed, with the usual ones.

    What is true is computed by playing the scene, when it is first asked for. ValueError for a seed
    that is no whole number from 0 on.
    """

    def __init__(self, lab: Lab, seed: int | None = None) -> None:
        if seed is not None and (type(seed) is not int or not 0 <= seed <= MOST):
            raise ValueError(f"the seed must be a whole number from 0 on, not {seed!r}")
        self.lab, self.seed = lab, seed
        self.numbers = lab.numbers(seed)

    def __repr__(self) -> str:
        seed = "" if self.seed is None else f", seed={self.seed}"
        return f"lab({self.lab.name!r}{seed})"

    @property
    def name(self) -> str:
        """Of the lab."""
        return self.lab.name

    @property
    def fields(self) -> tuple[Field, ...]:
        """What is asked."""
        return self.lab.fields

    def world(self) -> World:
        """The scene, its shot just struck."""
        return self.lab.scene(self.numbers)

    @cached_property
    def after(self) -> World:
        """The scene as it is when it has been played."""
        world = self.world()
        self.lab.play(world)
        return world

    @cached_property
    def truth(self) -> dict[str, float]:
        """The engine's value of each field."""
        return self.lab.truth(self.after, self.numbers)

    def table(self) -> Rows:
        """What was measured."""
        return self.lab.table(self.after, self.numbers)

    def figure(self) -> Figure:
        """The played worlds of the picture, the scene's own first."""
        return [self.after, *self.lab.others(self.numbers)]

    def title(self, language: str = "en") -> str:
        """Its name for people."""
        return text.of(language)[f"{self.name}.title"]

    def question(self, language: str = "en") -> str:
        """What it is about and what is asked, in paragraphs, with this worksheet's numbers."""
        return text.of(language)[f"{self.name}.ask"].format(**self.numbers)

    def label(self, field: str, language: str = "en") -> str:
        """What a field asks for, in words."""
        return text.of(language)[f"{self.name}.{field}"].format(**self.numbers)

    def check(
        self, answers: Mapping[str, object] | None = None, **more: object
    ) -> dict[str, Checked]:
        """What has become of each answer, a number or its text, by the name of its field.

        ValueError for a field that there is not, and for an answer that is no finite number.
        """
        given = {**(answers or {}), **more}
        return {name: self._checked(name, value) for name, value in given.items()}

    def _checked(self, name: str, value: object) -> Checked:
        field = next((field for field in self.fields if field.name == name), None)
        if field is None:
            known = ", ".join(field.name for field in self.fields)
            raise ValueError(f"lab {self.name!r} has no field {name!r}: there are {known}")
        answer, truth = number(name, value), self.truth[name]
        right = field.takes(answer, truth)
        return Checked(name, answer, right, 0 if right else 1 if answer > truth else -1)


def number(name: str, value: object) -> float:
    """An answer as a number: the typographic minus and spaces around are taken, too."""
    try:
        found = float(value.replace("−", "-") if isinstance(value, str) else value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        found = float("nan")
    if isinstance(value, bool) or not isfinite(found):
        raise ValueError(f"{name}: an answer is a number, not {value!r:.40}")
    return found
