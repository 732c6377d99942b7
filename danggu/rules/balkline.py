"""Straight rail and balkline: cannons, but not too many in one zone (UMB 5.1, 5.3 and 5.4)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from .carom import Carom
from .state import GameState
from .stroke import Stroke, Zone
from .verdict import Turn, Verdict

IN, ASTRIDE, OUT = "in", "astride", "out"
COME_IN, IN_THERE = "come_in", "in_there"
REMAINED = "remained"
STRAIGHT_RAIL = "straight_rail"

Point = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Balkline(Carom):
    """Cannons without a cushion, of which only `limit` may be made with both balls in one zone.

    cushions: always 0.
    bank: points of a cannon that met a cushion before the first ball (the PBA gives 2).
    red_first: the opening stroke must hit the red before the other ball.
    penalty: points that a foul costs; federations take none.
    floor_zero: the score never falls below zero.
    umb: the rules of the UMB: the opening stroke goes to the red directly (3.3), the cushion that
    the cue ball lies against may not be played (4.1), and balls that touch the cue ball may be
    spotted (3.7).
    cues: names of the cue balls, in the order of play.
    red: name of the red.
    name: "straight_rail" (zones in the corners), or "balkline" with the distance of the lines in
    cm and the limit.
    limit: 2, the second cannon must drive a ball out of the zone; 1, the first.
    """

    cushions: int = 0
    umb: bool = True
    name: str = STRAIGHT_RAIL
    limit: int = 2

    def __post_init__(self) -> None:
        Carom.__post_init__(self)
        if self.limit not in (1, 2) or self.cushions:
            raise ValueError(f"limit must be 1 or 2, not {self.limit!r}, without cushions")

    @property
    def key(self) -> str:
        return self.name

    def cannon(self, done: Stroke, turn: Turn) -> Verdict:
        verdict = Carom.cannon(self, done, turn)
        rest = done.rest
        if not verdict.made:
            # an inning begins as if the balls had just entered the zone
            state = self._state(turn, self.after("", rest.zone), self.after("", rest.anchor))
            return replace(verdict, state=state)
        zone = self.after(turn.state.zone, rest.zone)
        anchor = self.after(turn.state.anchor, rest.anchor)
        if REMAINED in (zone, anchor):
            fresh = self._state(turn, self.after("", rest.zone), self.after("", rest.anchor))
            return Verdict(REMAINED, foul=True, facts=verdict.facts, state=fresh)
        return replace(verdict, state=self._state(turn, zone, anchor))

    def _state(self, turn: Turn, zone: str, anchor: str) -> GameState:
        return replace(turn.state, zone=zone, anchor=anchor)

    def after(self, before: str, zone: Zone) -> str:
        """What is announced after a cannon, or REMAINED if it was one too many."""
        if zone.ends != IN:
            return ASTRIDE if zone.ends == ASTRIDE else ""
        if zone.left or before not in (COME_IN, IN_THERE):
            return COME_IN if self.limit == 2 else IN_THERE
        return IN_THERE if before == COME_IN else REMAINED


# -- geometry --------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Area:
    """A convex zone. Its boundary belongs to it, so a ball on a line counts as in both zones, the
    case that is worse for the player (5.1.3).

    corners: (x, y) of each, anticlockwise, m.
    """

    corners: tuple[Point, ...]

    def holds(self, at: Point) -> bool:
        """Whether the point lies inside or on the boundary."""
        ends = (*self.corners[1:], self.corners[0])
        return all(
            (bx - ax) * (at[1] - ay) >= (by - ay) * (at[0] - ax)
            for (ax, ay), (bx, by) in zip(self.corners, ends, strict=True)
        )


def rectangle(x: Point, y: Point) -> Area:
    """From x[0] to x[1] and from y[0] to y[1], m."""
    return Area(((x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])))


def corners(length: float, width: float) -> tuple[Area, ...]:
    """The four barred corners of straight rail on a playing area centred at (0, 0), m: triangles
    with legs a quarter of each side long (71 cm and 35.5 cm on a match table)."""
    a, b = length / 2, width / 2
    found = []
    for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        tip, on_x, on_y = (sx * a, sy * b), (sx * a / 2, sy * b), (sx * a, sy * b / 2)
        found.append(Area((tip, on_x, on_y) if sx * sy > 0 else (tip, on_y, on_x)))
    return tuple(found)


def squares(length: float, width: float, apart: float) -> tuple[Area, ...]:
    """The nine zones of balkline, between lines `apart` m from each cushion."""
    xs = (-length / 2, -length / 2 + apart, length / 2 - apart, length / 2)
    ys = (-width / 2, -width / 2 + apart, width / 2 - apart, width / 2)
    return tuple(
        rectangle((xs[i], xs[i + 1]), (ys[j], ys[j + 1])) for i in range(3) for j in range(3)
    )


def anchors(length: float, width: float, apart: float, side: float = 0.178) -> tuple[Area, ...]:
    """The eight anchors: squares at the cushions, halved by the ends of the lines, m."""
    a, b, half = length / 2, width / 2, side / 2
    found = []
    for x in (-a + apart, a - apart):
        found += [rectangle((x - half, x + half), y) for y in ((-b, side - b), (b - side, b))]
    for y in (-b + apart, b - apart):
        found += [rectangle(x, (y - half, y + half)) for x in ((-a, side - a), (a - side, a))]
    return tuple(found)


def zone(areas: Sequence[Area], first: Sequence[Point], second: Sequence[Point]) -> Zone:
    """How two balls lie, given the path of each: its points (x, y) in m, from first to last."""
    both = [area for area in areas if area.holds(first[-1]) and area.holds(second[-1])]
    if not both:
        held = [any(area.holds(way[-1]) for area in areas) for way in (first, second)]
        return Zone(ASTRIDE if all(held) else OUT)
    stays = any(all(area.holds(at) for at in (*first, *second)) for area in both)
    return Zone(IN, not stays)
