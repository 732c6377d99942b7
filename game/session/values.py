"""What value a command takes: what a record says is held to it before anything is done."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from math import isfinite
from typing import NamedTuple

from game.aim.entry import BOXES

LARGEST = 1e6
"""Size of a number in an action: more than any box, table or angle has room for."""
FARTHEST = 1 << 32
"""Ticks to which a shot may be scrubbed: 18 hours."""
MOST_STEPS = 100


class Value(NamedTuple):
    """A kind of value.

    label  how it is written in a list of commands
    fault  returns what was expected instead of a value, or "" if it is good
    """

    label: str
    fault: Callable[[object], str]


def _nothing(value: object) -> str:
    return "" if value is None else "no value"


def text(label: str) -> Value:
    """Any text."""
    return Value(label, lambda value: "" if type(value) is str else "text")


def whole(label: str, least: int, most: int) -> Value:
    """A whole number within bounds."""

    def fault(value: object) -> str:
        good = type(value) is int and least <= value <= most
        return "" if good else f"a whole number from {least} to {most}"

    return Value(label, fault)


def numbers(label: str, count: int) -> Value:
    """So many numbers, written as one text."""

    def fault(value: object) -> str:
        good = isinstance(value, str) and len(value.split()) == count
        good = good and all(map(_is_number, str(value).split()))
        return "" if good else f"{count} number{'s' * (count > 1)} as text"

    return Value(label, fault)


def _is_number(word: str) -> bool:
    try:
        number = float(word)
    except ValueError:
        return False
    return isfinite(number) and abs(number) <= LARGEST


def _boxes(value: object) -> str:
    """Pairs of a box and a number."""
    words = value.split() if isinstance(value, str) else []
    names, figures = words[::2], words[1::2]
    good = words and len(names) == len(figures) and {*names} <= {*BOXES}
    return "" if good and all(map(_is_number, figures)) else "boxes and their numbers as text"


def _caret(value: object) -> str:
    """Where the caret of a text field goes."""
    if type(value) is int:
        return "" if 0 <= value <= FARTHEST else f"a whole number from 0 to {FARTHEST}"
    step = value.removeprefix("+") if isinstance(value, str) else ""
    good = step in ("left", "right", "home", "end", "back", "ahead") or value == "all"
    return "" if good else "a place in the text"


def one_of(label: str, keys: Iterable[str], *, needed: bool = False) -> Value:
    """One of some keys, or no value unless one is needed."""
    known = (*keys,)

    def fault(value: object) -> str:
        good = value in known if isinstance(value, str) else value is None and not needed
        return "" if good else f"one of {', '.join(repr(key) for key in known)}"

    return Value(label, fault)


def key_in(label: str, known: Mapping[str, object], *, needed: bool = False) -> Value:
    """A key of some things, of which not all need be listed, or no value unless one is needed."""
    listed = one_of(label, known, needed=needed)

    def fault(value: object) -> str:
        return "" if isinstance(value, str) and value in known else listed.fault(value)

    return Value(label, fault)


def line(label: str, read: Callable[[str], object], what: str) -> Value:
    """A text that a function reads; its ValueError says what is wrong."""

    def fault(value: object) -> str:
        try:
            return "" if isinstance(value, str) and read(value) else what
        except ValueError as error:
            return f"{what} ({error})"

    return Value(label, fault)


NOTHING = Value("", _nothing)
BOX_NUMBERS = Value('"BOX NUMBER ..."', _boxes)
PLACE = Value("PLACE", _caret)
