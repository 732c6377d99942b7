"""Where balls are spotted: which spot, and where on its line if that is taken."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from math import sqrt

from .snooker import COLOURS, value

Point = tuple[float, float]

FOOT, CENTRE, HEAD = "foot", "centre", "head"  # spots of a `physics.tables.Table`


def carom_spots(cue: str, other: str, red: str = "red") -> dict[str, str]:
    """The spot of each ball in three-cushion; `cue` is the ball of the coming stroke (3.7)."""
    return {red: FOOT, cue: HEAD, other: CENTRE}


def respotted(
    balls: Iterable[str], spots: Mapping[str, str], covered: Mapping[str, str]
) -> dict[str, str]:
    """Where each of the balls goes: on its spot, or on that of the ball that covers it.

    spots: the spot of each ball.
    covered: which ball is on each spot that is taken.
    """
    found: dict[str, str] = {}
    taken = dict(covered)
    for ball in balls:
        spot = spots[ball]
        for _ in spots:
            spot = spots[taken[spot]] if spot in taken else spot
        taken[spot] = ball
        found[ball] = spot
    return found


def colour_spots(balls: Iterable[str], taken: Collection[str]) -> dict[str, str]:
    """The colour on whose spot each colour goes, the highest first (3.7): its own, else the highest
    free one; "" if none is free and it goes as near as possible to its own.

    taken: the colours whose spots are occupied.
    """
    found: dict[str, str] = {}
    occupied = set(taken)
    for ball in sorted(balls, key=value, reverse=True):
        free = [spot for spot in (ball, *reversed(COLOURS)) if spot not in occupied]
        found[ball] = free[0] if free else ""
        occupied.add(found[ball])
    return found


def along(start: Point, end: Point, others: Sequence[Point], diameter: float) -> Point | None:
    """The place nearest to `start` on the line to `end` where a ball fits between the others, or
    None; all in m."""
    (x, y), (dx, dy) = start, (end[0] - start[0], end[1] - start[1])
    length = sqrt(dx * dx + dy * dy)
    ux, uy = (dx / length, dy / length) if length else (0.0, 0.0)
    blocked = []
    for ox, oy in others:
        along_line = (ox - x) * ux + (oy - y) * uy
        aside = diameter**2 - ((ox - x) ** 2 + (oy - y) ** 2 - along_line**2)
        if aside > 0:
            blocked.append((along_line - sqrt(aside), along_line + sqrt(aside)))
    reach = 0.0
    for low, high in sorted(blocked):
        if low < reach < high:
            reach = high
    return (x + reach * ux, y + reach * uy) if reach <= length else None
