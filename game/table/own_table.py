"""A table of the player's own: one of the tables with other coefficients, all named by its key.

The key goes wherever that of a table does, into records, set-ups and saved matches, so these come
out the same where nobody has the file: "match+cloth.slide=0.21,cushion.e=0.87,…".
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import fields, replace
from functools import lru_cache
from math import isfinite
from typing import Any

from physics import tables

from .unlisted import Unlisted

MARK = "+"
PARTS = {"cloth": "cloth", "cushion": "cushion_law", "ball": "ball_law"}
"""What has coefficients: by the first word of their names, the field of a table."""
LONGEST = 1000
"""Characters of a key at most."""


class Tables(Unlisted[tables.Table]):
    """Tables by their keys; those of the player's own are known by theirs, and not listed."""

    def __missing__(self, key: str) -> tables.Table:
        known = self.get(base(key))
        if known is None:
            raise KeyError(key)
        try:
            return _made(base(key), known, key)
        except ValueError as error:
            raise KeyError(f"{key!r:.60}: {error}") from None


def base(key: str) -> str:
    """The key of the table that another one is made from: itself, if it is none of a player's."""
    return key.partition(MARK)[0]


def is_own(key: str) -> bool:
    """Is it the key of a table of the player's own?"""
    return MARK in key


@lru_cache(maxsize=64)
def _made(name: str, known: tables.Table, key: str) -> tables.Table:
    """The table that a key names; ValueError says what is wrong with it."""
    if not is_own(key) or len(key) > LONGEST:
        raise ValueError("no such table")
    wanted, there = dict(_values(key)), dict(numbers(known))
    for missing in there.keys() - wanted.keys():
        raise ValueError(f"{missing} is missing")
    for other in wanted.keys() - there.keys():
        raise ValueError(f"table {name!r} has no {other:.40}")
    return with_numbers(known, wanted)


def _values(key: str) -> Iterator[tuple[str, float]]:
    for word in key.partition(MARK)[2].split(","):
        name, _, text = word.partition("=")
        try:
            number = float(text)
        except ValueError:
            raise ValueError(f"{word:.40} is no coefficient") from None
        if not isfinite(number):
            raise ValueError(f"{name:.40} must be finite")
        yield name, number


def numbers(table: tables.Table) -> Iterator[tuple[str, float]]:
    """Every coefficient that is a number, by its name."""
    for part, attribute in PARTS.items():
        thing: Any = getattr(table, attribute)
        for one in fields(thing):
            if isinstance(number := getattr(thing, one.name), float):
                yield f"{part}.{one.name}", number


def with_numbers(table: tables.Table, wanted: Mapping[str, float]) -> tables.Table:
    """The table with other coefficients; ValueError, naming it, for one that cannot be."""
    changed: dict[str, Any] = {}
    for part, attribute in PARTS.items():
        own = {n.partition(".")[2]: x for n, x in wanted.items() if n.startswith(f"{part}.")}
        changed[attribute] = replace(getattr(table, attribute), **own)
    return replace(table, **changed)


def key_of(table: tables.Table, among: Mapping[str, tables.Table]) -> str:
    """The key of a table: of the first that differs in coefficients alone, and these.

    ValueError, naming what it is, for a table that is like none of them.
    """
    there = dict(numbers(table))
    words = [f"{name}={number!r}" for name, number in there.items()]
    for name, known in among.items():
        if there.keys() != dict(numbers(known)).keys():
            continue
        if replace(with_numbers(known, there), name=table.name) == table:
            return f"{name}{MARK}{','.join(words)}"
    kinds = f"{type(table.cushion_law).__name__}, {type(table.ball_law).__name__}"
    raise ValueError(f"{table.length:g} × {table.width:g} m, {kinds}: the game has no such table")
