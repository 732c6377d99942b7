"""What is marked on a table for its games: spots, the line of the opening shot, regions, racks.

All are seen from the head of the table (snooker's baulk), which is its western end: left is north.
Sources are in docs/tables.md.
"""

from collections.abc import Callable
from typing import NamedTuple

from .regions import Box, HalfDisc, Region

BESIDE = 0.1825  # m from the head spot, to both sides: the spots of carom's opening shot
BAULK, D, BLACK = 0.737, 0.292, 0.324  # m: snooker's, from the baulk cushion and the top one

Point = tuple[float, float]


class Markings(NamedTuple):
    """What is marked on a table, and what is racked on it.

    spots: (x, y) by name, m.
    line: x of the head string, baulk line or line of the house, m.
    regions: where the centre of a ball in hand may be, by name.
    racks: by name.
    """

    spots: dict[str, Point]
    line: float | None
    regions: dict[str, Region]
    racks: tuple[str, ...]


def _bed(x: float, y: float, radius: float, line: float | None = None) -> Box:
    """Where a ball fits between the cushions, or as far as a line, which is not in it."""
    east = x - radius if line is None else line
    return Box(radius - x, east, radius - y, y - radius, line is not None)


def carom(x: float, y: float, radius: float) -> Markings:
    """Half of a table's length and width, and its balls' radius, m, as for the other kinds."""
    spots = {"head": (-0.5 * x, 0.0), "centre": (0.0, 0.0), "foot": (0.5 * x, 0.0)}
    spots |= {"left": (-0.5 * x, BESIDE), "right": (-0.5 * x, -BESIDE)}
    return Markings(spots, -0.5 * x, {"anywhere": _bed(x, y, radius)}, ())


def pool(x: float, y: float, radius: float) -> Markings:
    """The kitchen is behind the head string, which does not belong to it (WPA 8.1)."""
    line = -0.5 * x
    spots = {"head": (line, 0.0), "centre": (0.0, 0.0), "foot": (0.5 * x, 0.0)}
    regions: dict[str, Region] = {
        "anywhere": _bed(x, y, radius), "kitchen": _bed(x, y, radius, line)
    }  # fmt: skip
    return Markings(spots, line, regions, ("8-ball", "9-ball", "10-ball", "14.1"))


def snooker(x: float, y: float, radius: float) -> Markings:
    """A spot has the name of its colour."""
    line = BAULK - x
    spots = {
        "yellow": (line, -D), "green": (line, D), "brown": (line, 0.0),
        "blue": (0.0, 0.0), "pink": (0.5 * x, 0.0), "black": (x - BLACK, 0.0),
    }  # fmt: skip
    baulk = Box(radius - x, line, radius - y, y - radius)
    regions: dict[str, Region] = {
        "anywhere": _bed(x, y, radius), "baulk": baulk, "D": HalfDisc((line, 0.0), D)
    }  # fmt: skip
    return Markings(spots, line, regions, ("snooker",))


def pyramid(x: float, y: float, radius: float) -> Markings:
    """The house is behind the line through the front spot, which is called the head spot here as on
    other tables, and the back spot the foot spot."""
    line = -0.5 * x
    spots = {"head": (line, 0.0), "centre": (0.0, 0.0), "foot": (0.5 * x, 0.0)}
    regions: dict[str, Region] = {
        "anywhere": _bed(x, y, radius), "house": Box(radius - x, line, radius - y, y - radius)
    }  # fmt: skip
    return Markings(spots, line, regions, ("pyramid",))


MARKINGS: dict[str, Callable[[float, float, float], Markings]] = {
    kind.__name__: kind for kind in (carom, pool, snooker, pyramid)
}
