"""Options that cannot be meant together: they are refused, for to ignore one would be a guess."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from itertools import combinations

from .session import terms
from .text.quoting import in_a_line

VIEW = frozenset(
    {"lang", "size", "fps", "frames", "script", "screenshot", "stats", "version"}
    | {"settings", "record", "replay", "headless", "given", "edition"}
)
"""Options that leave no trace in what the balls do, or say it elsewhere: a record leaves them out
of what it began with."""
LAID = ("setup", "scene", "game", "table")
"""Options that say which balls lie where: each says all of it, but a game may choose its table."""
MATCH = ("finish", "handicap", "level", "players")
"""Options that mean nothing without a match."""
WINDOW = ("lang", "size", "fps", "frames", "script", "screenshot", "stats", "settings")
"""Options that mean nothing without a window."""
FILES = ("record", "replay", "script", "screenshot", "settings")
Found = Mapping[str, object]


def contradiction(found: Found) -> str:
    """Say which of the options that were found cannot be meant together, and why, or ""."""
    return next(_contradictions(found), "")


def _contradictions(found: Found) -> Iterator[str]:
    laid = [name for name in LAID if name in found and found[name] != terms.FREE]
    for one, other in combinations(laid, 2):
        if (one, other) != ("game", "table"):
            yield f"{_said(found, one, other)}: each says which balls lie where"
    yield from _idle(found)
    if "record" in found and "replay" in found:
        yield f"{_said(found, 'record', 'replay')}: a replay is not recorded"
    if "replay" in found and (lost := sorted(found.keys() - VIEW)):
        yield f"{_said(found, 'replay', *lost)}: a record says that itself"
    if "headless" in found:
        if "replay" not in found:
            yield "--headless: needs --replay FILE"
        if lost := [name for name in WINDOW if name in found]:
            yield f"{_said(found, 'headless', *lost)}: there is no window"
    for one, other in combinations([name for name in FILES if name in found], 2):
        if os.path.realpath(str(found[one])) == os.path.realpath(str(found[other])):
            yield f"{_said(found, one, other)}: one file for both"


def _idle(found: Found) -> Iterator[str]:
    """Options of a match that would do nothing in the game that is asked for."""
    game = found.get("game", terms.FREE)
    if game == terms.FREE and (lost := [name for name in MATCH if name in found]):
        rules = " or ".join(name for name in terms.GAMES if name != terms.FREE)
        yield f"{_said(found, *lost)}: needs --game {rules}"
    elif "finish" in found and "finish" not in terms.DISCIPLINES[str(game)].house:
        yield f"{_said(found, 'finish')}: needs --game {terms.FOUR_BALL}"
    elif "handicap" in found and not terms.DISCIPLINES[str(game)].points:
        yield f"{_said(found, 'handicap')}: --game {game} is won by racks or frames, not points"


def _said(found: Found, *names: str) -> str:
    """The options as they were written, long values cut short."""
    values = {name: found[name] for name in names}
    return " and ".join(
        f"--{name} {in_a_line(value, 40)}" if isinstance(value, str | int) and value is not True
        else f"--{name}"
        for name, value in values.items()
    )  # fmt: skip
