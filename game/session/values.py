"""What value each action takes: what a record says is held to it before anything is done."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import isfinite

from game.aim.entry import BOXES
from game.table import lineup, presets
from game.text import LANGUAGES
from game.text.quoting import shortly

from . import terms
from .action import Action

SHEETS = ("", "settings", "menu", "shelf", "rules", "ask")
LARGEST = 1e6
"""Size of a number in an action: more than any box, table or angle has room for."""
FARTHEST = 1 << 32
"""Ticks to which a shot may be scrubbed: 18 hours."""
MOST_STEPS = 100
Check = Callable[[object], str]
"""Returns what was expected instead of a value, or "" if it is good."""


def fault(action: Action) -> str:
    """Say what is wrong with an action that a record says was done, or ""."""
    if not isinstance(action.name, str) or action.name not in VALUES:
        return f"there is no action {shortly(list(action))}"
    wanted = VALUES[action.name](action.value)
    said = "nothing" if action.value is None else shortly(action.value)
    return f"{action.name} takes {wanted}, not {said}" if wanted else ""


def _nothing(value: object) -> str:
    return "" if value is None else "no value"


def _text(value: object) -> str:
    return "" if type(value) is str else "text"


def _whole(least: int, most: int) -> Check:
    def check(value: object) -> str:
        good = type(value) is int and least <= value <= most
        return "" if good else f"a whole number from {least} to {most}"

    return check


def _numbers(count: int) -> Check:
    def check(value: object) -> str:
        good = isinstance(value, str) and len(value.split()) == count
        good = good and all(map(_is_number, str(value).split()))
        return "" if good else f"{count} number{'s' * (count > 1)} as text"

    return check


def _is_number(word: str) -> bool:
    try:
        number = float(word)
    except ValueError:
        return False
    return isfinite(number) and abs(number) <= LARGEST


def _boxes(value: object) -> str:
    """Pairs of a box and a number."""
    words = value.split() if isinstance(value, str) else []
    names, numbers = words[::2], words[1::2]
    good = words and len(names) == len(numbers) and {*names} <= {*BOXES}
    return "" if good and all(map(_is_number, numbers)) else "boxes and their numbers as text"


def _caret(value: object) -> str:
    """Where the caret of a text field goes."""
    if type(value) is int:
        return "" if 0 <= value <= FARTHEST else f"a whole number from 0 to {FARTHEST}"
    step = value.removeprefix("+") if isinstance(value, str) else ""
    good = step in ("left", "right", "home", "end", "back", "ahead") or value == "all"
    return "" if good else "a place in the text"


def _one_of(keys: Iterable[str], *, needed: bool = False) -> Check:
    known = (*keys,)

    def check(value: object) -> str:
        good = value in known if isinstance(value, str) else value is None and not needed
        return "" if good else f"one of {', '.join(repr(key) for key in known)}"

    return check


def _line(read: Callable[[str], object], what: str) -> Check:
    def check(value: object) -> str:
        try:
            return "" if isinstance(value, str) and read(value) else what
        except ValueError as error:
            return f"{what} ({error})"

    return check


_ONCE = dict.fromkeys(
    (
        "clear", "erase", "enter", "leave", "shoot", "fire", "place", "stop", "retry", "undo",
        "redo", "pause", "frame", "back", "home", "skip", "centre", "help", "settings", "next",
        "arrange", "delete",
    ),
    _nothing,
)  # fmt: skip
_NUMBER, _PAIR, _SHOT = _numbers(1), _numbers(2), _numbers(len(BOXES))
VALUES: dict[str, Check] = {
    **_ONCE,
    **dict.fromkeys(("turn", "power", "push", "tilt", "elevate"), _NUMBER),
    **dict.fromkeys(("tip", "nudge", "move"), _PAIR),
    **dict.fromkeys(("intend", "play"), _SHOT),
    **dict.fromkeys(("type", "hold"), _text), "caret": _caret,
    "edit": _whole(0, len(BOXES) - 1), "set": _boxes,
    "thick": _whole(-7, 7), "thicker": _whole(-1, 1), "faster": _whole(-MOST_STEPS, MOST_STEPS),
    "event": _whole(-1, 1), "scrub": _whole(0, FARTHEST),
    "engine": _one_of(presets.ENGINES), "law": _one_of(presets.LAWS),
    "cloth": _one_of(presets.CLOTHS), "table": _one_of(presets.TABLES),
    "language": _one_of(LANGUAGES),
    "sheet": _one_of(SHEETS), "scene": _one_of(presets.SCENES, needed=True),
    "match": _line(terms.read, "a fixture"), "line": _line(lineup.read, "a set-up"),
}  # fmt: skip
"""By the names of the actions. The player's own settings are not here: no record changes them."""
