"""Drills as set-ups: the balls of a position, and a stroke that only points the way."""

from __future__ import annotations

from functools import lru_cache
from math import atan2, degrees

from danggu.players.goals import GOALS, POSITIONS

from . import lineup
from .lineup import Lineup

NAMES = tuple(GOALS)
"""Families and keys, "pool.stop"."""
SOFT = "2"
"""Speed in the boxes at first, m/s: it is the player that finds the stroke."""


@lru_cache(maxsize=1)
def _ready() -> dict[str, Lineup]:
    return {f"{ready.group}.{ready.key}": ready.lineup for ready in lineup.shelf()}


def laid(name: str) -> Lineup:
    """The set-up of a drill, aimed full at the ball to be hit first; KeyError if there is none."""
    found, position = _ready()[name], POSITIONS[name]
    places = dict(found.balls)
    first = next((what for what in position.way if what in places), None)
    x, y = places[position.cue]
    at = places[first] if first is not None else (0.0, 0.0)
    angle = f"{degrees(atan2(at[1] - y, at[0] - x)):.2f}"
    return Lineup(found.table, found.balls, (SOFT, "0", "0", "0", angle), found.down)
