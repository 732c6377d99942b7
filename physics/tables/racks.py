"""How balls are racked for a game: in which rows, in which order, how tightly.

The orders are those of the rules (docs/tables.md). Chance comes from a seed alone, and gives the
same rack on every machine.
"""

from collections.abc import Callable, Iterator, Mapping
from itertools import combinations
from math import sqrt
from operator import index
from typing import Any, NamedTuple

from physics.checks import nonnegative

from .regions import EDGE, Region

TRIANGLE, DIAMOND, SMALL = (1, 2, 3, 4, 5), (1, 2, 3, 2, 1), (1, 2, 3, 4)
STRIPES = range(9, 16)
PINK_GAP = 5e-4  # m, of snooker's first red from the pink: near, but farther than a hit is long
WORD = (1 << 64) - 1


def _any(order: list[int]) -> bool:
    return True


def _corners_differ(order: list[int]) -> bool:
    """Of the two corners at the back one is a solid and one a stripe."""
    return (order[10] in STRIPES) != (order[14] in STRIPES)


class Rack(NamedTuple):
    """How the balls of a game are racked.

    rows: balls in each, from the apex on.
    spot: where the apex lies.
    order: row by row, each from the left as the breaker sees it.
    fixed: the places that a seed does not shuffle.
    legal: do the rules allow an order?
    """

    rows: tuple[int, ...]
    spot: str
    order: tuple[int, ...]
    fixed: frozenset[int]
    legal: Callable[[list[int]], bool] = _any


ALL = frozenset(range(15))
RACKS = {
    "8-ball": Rack(
        TRIANGLE, "foot", (1, 9, 2, 10, 8, 3, 4, 14, 7, 11, 12, 6, 15, 13, 5), frozenset({4}),
        _corners_differ,
    ),
    "9-ball": Rack(DIAMOND, "foot", (1, 2, 3, 4, 9, 5, 6, 7, 8), frozenset({0, 4})),
    "10-ball": Rack(SMALL, "foot", (1, 2, 3, 4, 10, 5, 6, 7, 8, 9), frozenset({0, 4})),
    "14.1": Rack(TRIANGLE, "foot", tuple(range(1, 16)), frozenset()),
    "snooker": Rack(TRIANGLE, "pink", tuple(range(1, 16)), ALL),
    "pyramid": Rack(TRIANGLE, "foot", (4, 5, 6, 7, 15, 8, 9, 14, 13, 10, 2, 1, 12, 11, 3), ALL),
}  # fmt: skip


def racked(
    kind: str, radius: float, gap: float, disorder: float, seed: int | None
) -> tuple[str, list[tuple[str, complex]]]:
    """The spot, and names and places of the balls, m from it, the apex towards the west.

    gap: between neighbours, m; disorder: how far a ball may lie off its place, m. Places are then
    2 disorder farther apart, so that no two balls overlap. Without a seed the order is a standard
    one. ValueError for a gap or a disorder below zero, and for disorder without a seed.
    """
    gap, disorder = nonnegative("rack gap", gap), nonnegative("rack disorder", disorder)
    if seed is None and disorder > 0.0:
        raise ValueError(f"rack disorder {disorder!r} needs a seed, so that it can be had again")
    rack, draw = RACKS[kind], None if seed is None else chance(seed)
    order = list(rack.order) if draw is None else _shuffled(rack, draw)
    places = _places(rack.rows, 2.0 * radius + gap + 2.0 * disorder)
    if draw is not None and disorder > 0.0:
        places = [at + disorder * _in_a_disc(draw) for at in places]
    red = kind == "snooker"  # reds, behind the pink
    behind = 2.0 * radius + PINK_GAP + disorder if red else 0.0
    return rack.spot, [
        (f"red{n}" if red else f"{n}", at + behind) for n, at in zip(order, places, strict=True)
    ]


def insist_on_room(places: Mapping[str, tuple[float, float]], bed: Region, radius: float) -> None:
    """ValueError, naming the balls, if a ball lies off the bed or in another one; all in m."""
    for name, at in places.items():
        if not bed.contains(at):
            raise ValueError(f"the rack has no room: {name!r} would be off the table at {at}")
    for (name, (x, y)), (other, (x2, y2)) in combinations(places.items(), 2):
        across, up = x2 - x, y2 - y
        if sqrt(across * across + up * up) < 2.0 * radius - EDGE:
            raise ValueError(f"the rack has no room: {name!r} would overlap {other!r}")


def _places(rows: tuple[int, ...], pitch: float) -> list[complex]:
    """A lattice of equal triangles, symmetric about its axis to the last bit."""
    return [
        complex(row * pitch * sqrt(0.75), (0.5 * (count - 1) - place) * pitch)
        for row, count in enumerate(rows)
        for place in range(count)
    ]


def _shuffled(rack: Rack, draw: Iterator[float]) -> list[int]:
    """Every legal order is as likely as any other."""
    loose = [k for k in range(len(rack.order)) if k not in rack.fixed]
    order = list(rack.order)
    while True:
        for i in range(len(loose) - 1, 0, -1):
            j = int(next(draw) * (i + 1))
            a, b = loose[i], loose[j]
            order[a], order[b] = order[b], order[a]
        if rack.legal(order):
            return order


def _in_a_disc(draw: Iterator[float]) -> complex:
    """A point of the unit disc."""
    while True:
        p = complex(2.0 * next(draw) - 1.0, 2.0 * next(draw) - 1.0)
        if p.real * p.real + p.imag * p.imag <= 1.0:
            return p


def chance(seed: int) -> Iterator[float]:
    """Numbers from 0 to below 1: splitmix64 (Steele, Lea and Flood 2014).

    ValueError for a seed that is not a whole number.
    """
    state = _whole(seed)

    def stream(state: int) -> Iterator[float]:
        while True:
            state = (state + 0x9E3779B97F4A7C15) & WORD
            z = ((state ^ (state >> 30)) * 0xBF58476D1CE4E5B9) & WORD
            z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & WORD
            yield ((z ^ (z >> 31)) >> 11) * 2.0**-53

    return stream(state & WORD)


def _whole(seed: Any) -> int:
    """It as an int, if it is one of Python's or NumPy's."""
    if not isinstance(seed, bool):
        try:
            return index(seed)
        except TypeError:
            pass
    raise ValueError(f"rack seed must be a whole number, not {seed!r}")
