"""The player's own table from a file of tracks: which coefficients they show, and how well."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from physics import Ball, Fit, Track, World, fit, tables, tracks

from . import own_table, presets

UNKNOWN = ("cloth.slide", "cloth.roll", "cushion.e", "cushion.mu")
"""What is looked for: what tables differ in, and most tracks show."""
NOISE = 5e-4
"""Metres by which a camera errs."""
MM = 1e3


class FitRow(NamedTuple):
    """A coefficient: its name, what it was before, what has been found, standard deviation."""

    name: str
    before: float
    found: float
    error: float


class FitReport(NamedTuple):
    """What has come of a fit.

    key     of the table
    tracks  how many there were
    misfit  rms of a coordinate, mm
    rows    what has been found
    unseen  what the tracks do not show: the name, and why not
    """

    key: str
    tracks: int
    misfit: float
    rows: tuple[FitRow, ...]
    unseen: tuple[tuple[str, str], ...]


def fitted(tell: Callable[[object], None], path: str, base: str) -> FitReport:
    """Fit a table to the tracks in a file, beginning with another one; tells of what it looks for.

    ValueError names what is wrong, with the line where it is one; OSError where there is no file.
    """
    table = presets.TABLES[base]
    world, seen = _read(path, table)
    unknown = [name for name in UNKNOWN if name in dict(own_table.numbers(table))]
    unseen: list[tuple[str, str]] = []
    while True:
        tell((len(seen), (*unknown,)))
        try:
            found = fit(world, seen, unknown)
        except ValueError as error:
            name = _unseen(str(error), unknown)
            if not name or len(unknown) == 1:
                raise
            unknown.remove(name)
            unseen.append((name, str(error)))
        else:
            return _report(found, table, base, unseen)


def _read(path: str, table: tables.Table) -> tuple[World, list[Track]]:
    """The table with the balls of the file, and its tracks."""
    if not Path(path).is_file():
        raise ValueError(f"{path}: there is no such file")
    world = table.world()
    for k, name in enumerate(tracks.balls(path)):
        place = (-0.4 * table.length + 2.5 * k * table.radius, 0.0)
        world.add(Ball(name, place, radius=table.radius, mass=table.mass))
    return world, tracks.read(path, world, NOISE)


def _unseen(said: str, unknown: list[str]) -> str:
    """Which of the unknown a fit says that the tracks do not show, or "" if it says another thing.

    Its messages are all that says so.
    """
    begins = "the tracks do not show ", "the tracks do not tell "
    return next((n for n in unknown for b in begins if said.startswith(f"{b}{n!r}")), "")


def _report(found: Fit, table: tables.Table, base: str, unseen: list[tuple[str, str]]) -> FitReport:
    values = {name: float(value) for name, value in zip(found.names, found.values, strict=True)}
    errors = dict(zip(found.names, map(float, found.errors), strict=True))
    before = dict(own_table.numbers(table))
    rows = tuple(FitRow(name, before[name], values[name], errors[name]) for name in found.names)
    made = own_table.with_numbers(table, values)
    key = own_table.key_of(made, {base: table})
    return FitReport(key, len(found.strokes), MM * found.misfit, rows, (*unseen,))
