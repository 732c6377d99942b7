"""What the cue ball did on one stroke, read from the event log."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf
from typing import Protocol

# s.  Two contacts this close are one instant.  Rounding puts a located contact up to 1e-10 m off
# after six ball hits, so 1e-10 s at 1 m/s; a referee's eye is seven orders coarser.
TIE = 1e-9

# m.  A ball that has come no farther than this from a cushion has not left it, so its next contact
# with it is the same one, and the first contact of a ball that lies there is none.  How this number
# was chosen: docs/physics.md, "What counts as a contact".
LEFT = 1e-3

BALL, CUSHION, OFF = "ball", "cushion", "off"


class Logged(Protocol):
    """The part of a log entry that rules may read.

    `kind` is "ball", "cushion" or "off" (a ball has left the table); any other kind is ignored.
    """

    @property
    def time(self) -> float: ...
    @property
    def kind(self) -> str: ...
    @property
    def balls(self) -> tuple[str, ...]: ...
    @property
    def wall(self) -> str | None: ...
    @property
    def away(self) -> float:
        """At a cushion, m: the greatest gap since they last touched, or since the stroke began;
        inf at anything else."""
        ...


def counts(event: Logged) -> bool:
    """Whether it is a contact of its own, and not one with a cushion that has not been left."""
    # entries written by hand may not say how far the ball had been: it came from afar
    return getattr(event, "away", inf) > LEFT


@dataclass(frozen=True, slots=True)
class Touch:
    """The cue ball met `what`, a ball or a wall by name, at `time` s."""

    time: float
    what: str
    cushion: bool


@dataclass(frozen=True, slots=True)
class Stroke:
    """Touches of the cue ball in order of time, and the balls that left the table."""

    touches: tuple[Touch, ...]
    off: tuple[str, ...] = ()

    def hits(self) -> dict[str, float]:
        """The balls that were hit, in order, each with the time of its first contact in s."""
        first: dict[str, float] = {}
        for touch in self.touches:
            if not touch.cushion:
                first.setdefault(touch.what, touch.time)
        return first

    def cushions(self, before: float = inf) -> int:
        """How many cushion contacts came before `before`, not at that instant."""
        return sum(touch.cushion and touch.time < before - TIE for touch in self.touches)

    def cushion_at(self, time: float) -> bool:
        """Whether a cushion was met at the very instant `time`."""
        return any(touch.cushion and abs(touch.time - time) <= TIE for touch in self.touches)

    def until(self, time: float) -> Stroke:
        """As much of it as had happened by then, s."""
        return Stroke(tuple(touch for touch in self.touches if touch.time <= time), self.off)

    def path(self, until: float = inf) -> tuple[str, ...]:
        """The names of all that was met up to and at the instant `until`."""
        return tuple(touch.what for touch in self.touches if touch.time <= until + TIE)


def stroke(log: Iterable[Logged], cue: str) -> Stroke:
    """The log of one stroke, in order of time, seen from the ball named `cue`."""
    touches: list[Touch] = []
    off: list[str] = []
    for event in log:
        if event.kind == OFF:
            off += event.balls
        elif cue not in event.balls:
            continue
        elif event.kind == CUSHION and event.wall is not None and counts(event):
            touches.append(Touch(event.time, event.wall, cushion=True))
        elif event.kind == BALL:
            a, b = event.balls
            touches.append(Touch(event.time, b if a == cue else a, cushion=False))
    return Stroke(tuple(touches), tuple(off))
