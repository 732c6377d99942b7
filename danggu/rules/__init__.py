"""The games: what a stroke is worth, and how a match stands.

Everything for people is a key of the texts; the rules read nothing but what happened, which
`stroke` takes from the event log.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import stroke as stroke
from .balkline import Balkline
from .carom import Carom
from .eight_ball import EightBall
from .free import Free
from .nine_ball import NineBall
from .pyramid import COMBINED, DYNAMIC, Pyramid
from .sagu import Sagu
from .snooker import Snooker
from .straight_pool import StraightPool
from .ten_ball import TenBall
from .verdict import Rules, Verdicts

if TYPE_CHECKING:
    from .match import Match, Player
    from .stroke import Stroke
    from .verdict import Turn, Verdict

__all__ = [
    "GAMES", "Balkline", "Carom", "EightBall", "Free", "Match", "NineBall", "Player", "Pyramid",
    "Rules", "Sagu", "Snooker", "StraightPool", "Stroke", "TenBall", "Turn", "Verdict",
    "Verdicts", "stroke",
]  # fmt: skip

HOMES = {"Match": "match", "Player": "match", "Stroke": "stroke", "Turn": "verdict",
         "Verdict": "verdict", "Verdicts": "verdicts"}  # fmt: skip

GAMES: dict[str, Callable[..., Rules]] = {
    "free": Free,
    "four-ball": Sagu,
    "three-cushion": Carom,
    "one-cushion": partial(Carom, 1),
    "straight-rail": Balkline,
    "balkline-47/1": partial(Balkline, name="balkline_47_1", limit=1),
    "balkline-47/2": partial(Balkline, name="balkline_47_2"),
    "balkline-71/2": partial(Balkline, name="balkline_71_2"),
    "8-ball": EightBall,
    "9-ball": NineBall,
    "10-ball": TenBall,
    "14.1": StraightPool,
    "snooker": Snooker,
    "free-pyramid": Pyramid,
    "dynamic-pyramid": partial(Pyramid, DYNAMIC),
    "combined-pyramid": partial(Pyramid, COMBINED),
}
"""Each game by its name, and what makes its rules: the usual ones, without arguments."""

RACKS = {
    **{game: game for game in ("8-ball", "9-ball", "10-ball", "14.1", "snooker")},
    **dict.fromkeys(("free-pyramid", "dynamic-pyramid", "combined-pyramid"), "pyramid"),
}
"""What `physics.tables.Table.rack` racks for a game; the others have no rack."""


def __getattr__(name: str) -> Any:
    """What a match is made of is imported on first use."""
    if name in HOMES:
        return getattr(import_module(f".{HOMES[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    """The public names, so that completion finds no other."""
    return [*__all__]
