"""Worksheets for a course of mechanics: a scene, a question, and answers that the engine checks.

>>> from danggu import labs
>>> sheet = labs.lab("cradle", seed=7)
>>> bool(sheet.check(leave=sheet.numbers["running"])["leave"])
True

Each lab is a file of its own here. A seed gives every student other numbers, the same on every
machine.
"""

from __future__ import annotations

from . import (
    five_sevenths,
    growth_of_error,
    momentum_energy,
    newtons_cradle,
    pi_by_collisions,
    right_angle,
    rolling_resistance,
    side_and_cushion,
    thesis_cushion,
    thesis_hits,
    thesis_masse,
    thirty_degrees,
    unknown_mass,
)
from .samples import samples
from .shape import Field, Given, Lab, Rows
from .sheet_page import page
from .worksheet import Checked, Worksheet

__all__ = [
    "LABS", "Checked", "Field", "Given", "Lab", "Rows", "Worksheet", "lab", "page", "samples",
]  # fmt: skip

LABS: dict[str, Lab] = {
    lab.name: lab
    for lab in (
        *(module.LAB for module in (
            five_sevenths, right_angle, thirty_degrees, momentum_energy, unknown_mass,
            side_and_cushion, rolling_resistance, newtons_cradle, pi_by_collisions,
            growth_of_error, thesis_masse, thesis_cushion,
        )),
        *thesis_hits.LABS,
    )
}  # fmt: skip
"""In the order of the course; the four figures of the thesis at the end."""


def lab(name: str, seed: int | None = None) -> Worksheet:
    """The worksheet of that lab with the numbers of a seed, or with the usual ones.

    ValueError for a lab that there is not, and for a seed that is no whole number from 0 on.
    """
    if name not in LABS:
        raise ValueError(f"no lab {name!r}: there are {', '.join(LABS)}")
    return Worksheet(LABS[name], seed)


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
