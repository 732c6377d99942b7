"""Goals of the drills: what a stroke has to do, and how many stars what comes of it is worth.

A stroke is judged by its log and by where the balls lie, never by the numbers that were played.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import dist
from typing import NamedTuple

from danggu.rules.carom import Carom
from danggu.rules.sagu import Sagu
from danggu.rules.stroke import Stroke
from danggu.rules.verdict import Rules, Turn

from .drills import DRILLS, POOL, PYRAMID, SNOOKER
from .positions import SAGU, SHELF, THREE_CUSHION, Place, Position, metres, opening

ZONE, ROW, RUN, CLEAR = "zone", "row", "run", "clear"
RINGS = 0.6, 0.25
"""Radii of the rings of a zone, in diamonds along the table."""
STARS = 3
CAROM: dict[str, Rules] = {SAGU: Sagu(), THREE_CUSHION: Carom(red_first=False)}


class Goal(NamedTuple):
    """What a drill asks for.

    kind: "zone", a stroke that is made, with the cue ball in a ring; "row", so many in a row from
    the same lie; "run", so many in a row from where the balls come to lie; "clear", all balls of
    `order` down, in so few strokes.
    steps: what is asked for one, two and three stars; not of a zone.
    zone: middle of the rings, in diamonds.
    order: names of the balls to be cleared, each to be hit first in its turn.
    """

    kind: str
    steps: tuple[int, ...] = ()
    zone: Place = (0.0, 0.0)
    order: tuple[str, ...] = ()

    @property
    def restarts(self) -> bool:
        """Does an attempt take several strokes, so that one taken back begins it again?"""
        return self.kind in (RUN, CLEAR)

    def stars(self, value: float) -> int:
        """Stars for what has been reached: a number in a row, or of strokes for a clear table."""
        if self.kind == CLEAR:
            return sum(value <= step for step in self.steps)
        return sum(value >= step for step in self.steps)

    def rings(self, length: float) -> tuple[float, float]:
        """Radii of the rings on a table of that length, m."""
        return RINGS[0] * length / 8, RINGS[1] * length / 8

    def off(self, at: Place, length: float, width: float) -> float:
        """How far from the middle of the zone a place is, m."""
        return dist(at, metres(self.zone, length, width))

    def ringed(self, off: float, length: float) -> int:
        """Stars for a stroke that was made and whose cue ball is that far off, m."""
        return 1 + sum(off <= ring for ring in self.rings(length))

    def better(self, one: float, other: float) -> bool:
        """Is one value better than another: a shorter way, fewer strokes, or more in a row?"""
        return one < other if self.kind in (ZONE, CLEAR) else one > other


def _zone(x: float, y: float) -> Goal:
    return Goal(ZONE, zone=(x, y))


def _row(*steps: int) -> Goal:
    return Goal(ROW, steps or (1, 3, 5))


def _run(*steps: int) -> Goal:
    return Goal(RUN, steps)


COLOURS = ("yellow", "green", "brown", "blue", "pink", "black")
_POOL = {
    "stop": _zone(6.2, 2.2), "stop_long": _zone(5.3, 1.1), "draw": _zone(4.75, 0.75),
    "follow": _row(), "cut_30": _zone(6.8, 1.35), "cut_45": _row(), "cut_60": _row(1, 2, 4),
    "rail": _row(), "side_pocket": _zone(4.8, 3.2), "side_cut": _row(),
    "combination": _row(1, 2, 3), "bank": _row(1, 2, 3),
    "position": Goal(CLEAR, (8, 5, 3), order=("1", "2", "3")),
    "side_spin": _zone(6.55, 3.35),
}  # fmt: skip
_SNOOKER = {
    "black": _zone(6.55, 1.9), "blue": _row(), "pink": _zone(6.05, 1.7), "long_pot": _row(1, 2, 3),
    "stun": _zone(5.45, 3.25), "screw": _zone(5.85, 2.4), "follow": _row(), "red_black": _row(),
    "cushion_red": _zone(7.3, 3.1), "plant": _row(1, 2, 3), "middle": _row(),
    "colours": Goal(CLEAR, (18, 11, 6), order=COLOURS), "line_up": _run(2, 4, 7),
}  # fmt: skip
_PYRAMID = {
    "straight": _row(), "side_pocket": _row(), "side_cut": _row(1, 2, 4), "cut": _zone(6.7, 2.5),
    "stop": _zone(7.05, 3.05), "follow": _row(), "own_side": _row(1, 2, 3),
    "own_thin": _row(1, 2, 3), "hanger": _zone(6.5, 3.65), "combination": _row(1, 2, 3),
    "rail": _zone(7.65, 2.55), "hanger_side": _zone(5.05, 2.9),
}  # fmt: skip
_SAGU = {"opening": _run(1, 3, 6), "gather": _run(2, 4, 8), "rail_nurse": _run(2, 5, 10)}
_THREE = {"opening": _run(1, 2, 4)}
POSITIONS: dict[str, Position] = {
    f"{p.game}.{p.key}": p for p in (opening(SAGU), opening(THREE_CUSHION), *SHELF, *DRILLS)
}
"""The drills by family and key: "pool.stop"."""
_OWN = {SAGU: _SAGU, THREE_CUSHION: _THREE, POOL: _POOL, SNOOKER: _SNOOKER, PYRAMID: _PYRAMID}
_USUAL = {THREE_CUSHION: _row(1, 2, 3)}
GOALS: dict[str, Goal] = {
    name: _OWN[p.game].get(p.key) or _USUAL.get(p.game) or _row() for name, p in POSITIONS.items()
}
"""The goal of each drill."""


class DrillOutcome(NamedTuple):
    """What one stroke of a drill came to.

    made: whether it is a point, or the pot that was asked for.
    off: how far the cue ball is from the middle of the zone, m; None without a zone.
    done: whether all balls that were to be cleared are down.
    """

    made: bool
    off: float | None = None
    done: bool = False


def outcome(
    name: str, done: Stroke, lies: Mapping[str, Place], size: tuple[float, float]
) -> DrillOutcome:
    """Judge a stroke of a drill.

    lies: places of the balls that are left on the table, m, by name; size: its length and width.
    KeyError if there is no drill of that name.
    """
    position, goal = POSITIONS[name], GOALS[name]
    if position.game in CAROM:
        return DrillOutcome(CAROM[position.game].judge(done, Turn(cue=done.cue)).made)
    if goal.kind == CLEAR:
        return _cleared(goal.order, done, lies)
    if goal.kind == RUN:
        return DrillOutcome(bool(done.down) and not done.lost)
    made = _potted(position.way, done)
    if goal.kind == ZONE and done.cue in lies:
        return DrillOutcome(made, goal.off(lies[done.cue], *size))
    return DrillOutcome(made)


def _potted(way: Sequence[str], done: Stroke) -> bool:
    """Has the ball dropped that was to, into its pocket, off the one to be hit first?"""
    first, ball, pocket = way
    drops = {(drop.ball, drop.pocket) for drop in done.pocketed}
    lost = done.lost and ball != done.cue
    return done.first[:1] == (first,) and (ball, pocket) in drops and not lost


def _cleared(order: Sequence[str], done: Stroke, lies: Mapping[str, Place]) -> DrillOutcome:
    """A stroke at balls in their order: the next one is hit first, and the cue ball stays up."""
    left = [ball for ball in order if ball in lies or ball in done.gone]
    good = not done.lost and bool(left) and done.first[:1] == (left[0],)
    return DrillOutcome(good, done=good and not any(ball in lies for ball in order))
