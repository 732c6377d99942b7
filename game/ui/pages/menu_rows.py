"""The rows of the game menu: which there are, what each can be, and the terms that come of it."""

from __future__ import annotations

import unicodedata
from dataclasses import replace
from typing import Any, NamedTuple

from game.session.terms import (
    DISCIPLINES,
    FREE,
    GAMES,
    HOUSE,
    MOST_POINTS,
    RACES,
    SEATS,
    Contestant,
    Terms,
)
from game.table import presets
from game.table.own_table import base, is_own
from game.text.numerals import typed


class MenuRow(NamedTuple):
    """A row: its name, "choice" "text" or "number", and the player it is about (-1: none)."""

    name: str
    kind: str = "choice"
    seat: int = -1


CHOICES: dict[str, tuple[Any, ...]] = {
    "game": GAMES,
    "race": RACES,
    **HOUSE,
    "cloth": tuple(presets.CLOTHS),
    "law": ("table", *presets.LAWS),
}


def rows(terms: Terms) -> list[MenuRow]:
    """The rows that some terms have: the game's at the left, the players' at the right."""
    names = ["game", *DISCIPLINES[terms.game].house, "table", "cloth", "law"]
    left = [MenuRow(name) for name in names]
    if terms.game == FREE:
        return left
    right = [MenuRow("players")]
    for seat in range(len(terms.seats)):
        right += [MenuRow("name", "text", seat), MenuRow("level", "choice", seat)]
        if DISCIPLINES[terms.game].points:
            right += [MenuRow("target", "number", seat)]
    return left + right


def tables(terms: Terms, own: str) -> tuple[str, ...]:
    """The tables to choose from; own: the key of the player's own, or ""."""
    more = dict.fromkeys(key for key in (own, terms.table) if is_own(key))
    return (*terms.tables, *(key for key in more if base(key) in terms.tables))


def stepped(terms: Terms, row: MenuRow, step: int, own: str = "") -> Terms:
    """The terms with a row `step` choices on; own: the key of the player's own table, or ""."""
    if row.name == "players":
        two = (*terms.seats, Contestant())[:2]
        return replace(terms, seats=two if len(terms.seats) == 1 else two[:1])
    if row.seat >= 0:
        return _seated(terms, row, _stepped_seat(terms.seats[row.seat], row, step))
    keys = tables(terms, own) if row.name == "table" else CHOICES[row.name]
    way = (step > 0) - (step < 0)
    value: Any = keys[(keys.index(getattr(terms, row.name)) + way) % len(keys)]
    if row.name == "game":
        return on_its_table(terms, value)
    changed: dict[str, Any] = {row.name: value}
    return replace(terms, **changed)


def on_its_table(terms: Terms, game: str) -> Terms:
    """The terms with another game, on the table that it is usually played on."""
    table = DISCIPLINES[game].table
    return replace(terms, game=game, table=table, cloth="table", law="table")


def _seated(terms: Terms, row: MenuRow, seat: Contestant) -> Terms:
    seats = list(terms.seats)
    seats[row.seat] = seat
    return replace(terms, seats=tuple(seats))


def _stepped_seat(seat: Contestant, row: MenuRow, step: int) -> Contestant:
    if row.name == "level":
        way = (step > 0) - (step < 0)
        return replace(seat, level=SEATS[(SEATS.index(seat.level) + way) % len(SEATS)])
    if row.name == "target":
        return replace(seat, target=min(max(seat.target + step, 1), MOST_POINTS))
    return seat


def text_of(terms: Terms, row: MenuRow) -> str:
    """The text of a row that is typed into."""
    seat = terms.seats[row.seat]
    return seat.name if row.name == "name" else str(seat.target)


def written(terms: Terms, row: MenuRow, text: str) -> Terms:
    """The terms with the text of a name or a number, which is kept within its bounds."""
    seat = terms.seats[row.seat]
    if row.name == "name":
        return _seated(terms, row, replace(seat, name=text.lstrip()))
    number = min(max(int(text or 1), 1), MOST_POINTS)
    return _seated(terms, row, replace(seat, target=number))


def accepted(row: MenuRow, text: str) -> str:
    """What of a text a row takes: a name all that can be seen, a number only digits."""
    if row.name == "name":
        return "".join(c for c in unicodedata.normalize("NFC", text) if c.isprintable())
    plain = typed(text).strip()
    return plain if plain.isascii() and plain.isdecimal() else ""
