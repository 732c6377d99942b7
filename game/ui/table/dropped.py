"""Which balls have left the table at the moment on show, and how those that just did still fall.

It follows from the log alone, so a fall looks the same live, played again and scrubbed.
"""

from __future__ import annotations

from math import exp, hypot
from typing import NamedTuple

from game.render.table.balls import Spot
from game.render.table.wells import DEEP
from game.session.session import Session
from game.session.ticks import TICKS
from physics import Ball, Event, State

GRAVITY = 9.81
TIP, QUICK = 0.06, 3.0
"""Seconds that a ball takes to tip over the edge when it hardly moves, and how much sooner a fast
one does."""
PULL, PULLED = 2.5, 0.12
"""How the edge pushes it on, m/s², and for how many seconds."""
CLEAR = 0.9
"""How near to the wall of the hole its middle comes, in its own radii."""
AWAY, FLIES = -1.0, 0.35
"""The height that says that a ball is not to be seen, m; how long one is that left the table, s."""
LONGEST = 1.0
"""Seconds within which every fall is over."""


class Hole(NamedTuple):
    """Where a ball falls: the middle and the radius, m."""

    middle: complex
    radius: float


class Dropped:
    """The balls that are gone during one shot; `fine`: is it of interest which ones rest?"""

    def __init__(self, holes: dict[str, Hole], *, fine: bool = False) -> None:
        self._holes, self._fine = holes, fine
        self._shot: object = None
        self._seen = 0
        self._events: dict[str, Event] = {}
        self._rested: int | None = None
        """The session's tick when all balls were first seen to lie still, or None."""

    def take_over(self, other: Dropped) -> None:
        """Go on with what another one has seen."""
        self._rested = other._rested

    def falls(self, session: Session) -> bool:
        """Does a ball still fall, though nothing on the table moves?"""
        self.follow(session)
        if session.timeline.at is not None or self._rested is None or not self._events:
            return False
        if session.tick - self._rested > LONGEST * TICKS:  # at rest this costs nothing
            return False
        return any(AWAY < spot.height < 0.0 for spot in self.spots(session))

    def spots(self, session: Session) -> list[Spot]:
        """Where all balls are, in their order; those that are not to be seen lie at AWAY."""
        self.follow(session)
        now, live = session.timeline.moment, session.timeline.at is None
        seen = {} if live else session.seen
        if live and self._rested is not None:  # the world's time stands, but the last ball falls on
            now += (session.tick - self._rested) / TICKS
        found = []
        for i, ball in enumerate(session.world.balls):
            event = self._events.get(ball.name) if self._events else None
            state = ball if live else seen[ball.name]
            if event is not None and event.time <= now and (ball.gone or not live):
                found.append(self._falls(i, ball.radius, event, now - event.time))
            elif event is None and ball.gone:
                found.append(Spot(i, state.position, AWAY))
            else:
                still = self._fine and _still(state, lies=ball.lies if live else None)
                found.append(Spot(i, state.position, state.height, still))
        return found

    def follow(self, session: Session) -> None:
        """Note what has left since the last time, and since when nothing moves."""
        if session.moving:
            self._rested = None
        elif self._rested is None:
            self._rested = session.tick
        shot, log = (session.stamp, session.began), session.world.log
        if shot != self._shot or self._seen > len(log):
            self._shot, self._seen, self._events = shot, 0, {}
        if self._seen < len(log):
            for event in session.timeline.events[self._seen :]:
                if event.kind in ("pocket", "off"):
                    self._events[event.balls[0]] = event
            self._seen = len(log)

    def _falls(self, index: int, radius: float, event: Event, t: float) -> Spot:
        state = event.before[0]
        p, v = complex(*state.position), complex(*state.velocity)
        hole = self._holes.get(event.wall or "") if event.kind == "pocket" else None
        if hole is None:
            at = p + v * t
            return Spot(index, (at.real, at.imag), state.height if t < FLIES else AWAY)
        at, depth = fallen(hole, radius, p, v, t)
        return Spot(index, (at.real, at.imag), -depth if depth < DEEP else AWAY)


def _still(state: Ball | State, *, lies: bool | None) -> bool:
    """Does a ball neither move nor turn?  `lies`: whether it moves, if that is known."""
    return not ((any(state.velocity) if lies is None else not lies) or any(state.spin))


def fallen(hole: Hole, radius: float, p: complex, v: complex, t: float) -> tuple[complex, float]:
    """Where a ball is, and how deep, m, `t` seconds after it came over the edge at p with v.

    The edge tips it on, the wall holds it, and it falls freely once it has tipped over.
    """
    inward = hole.middle - p
    pushed = min(t, PULLED)
    way = inward / abs(inward) if inward else 0j
    at = p + v * t + way * PULL * pushed * (t - 0.5 * pushed)
    room = max(hole.radius - CLEAR * radius, 0.25 * radius)
    off = at - hole.middle
    start = max(room, abs(p - hole.middle))
    if abs(off) > start or (abs(off) > room and (off.conjugate() * v).real > 0.0):
        at = hole.middle + off / abs(off) * room
    free = max(0.0, t - TIP * exp(-QUICK * hypot(v.real, v.imag)))
    return at, 0.5 * GRAVITY * free * free
