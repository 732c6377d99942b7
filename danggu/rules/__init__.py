"""The games: what a stroke is worth, and how a match stands.

Everything for people is a key of the texts; the rules read nothing but the event log.
"""

from __future__ import annotations

from collections.abc import Callable

from .carom import Carom
from .free import Free
from .sagu import Sagu
from .verdict import Rules

GAMES: dict[str, Callable[..., Rules]] = {
    "free": Free,
    "four-ball": Sagu,
    "three-cushion": Carom,
}
"""Each game by its name, and what makes its rules: the usual ones, without arguments."""
