"""What happened on one stroke, read from the event log into one plain value."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from math import inf
from typing import NamedTuple, Protocol

# s.  Two contacts this close are one instant.  Rounding puts a located contact up to 1e-10 m off
# after six ball hits, so 1e-10 s at 1 m/s; a referee's eye is seven orders coarser.
TIE = 1e-9

# m.  A ball that has come no farther than this from a cushion has not left it, so its next contact
# with it is the same one, and the first contact of a ball that lies there is none.  How this number
# was chosen: docs/physics.md, "What counts as a contact".
LEFT = 1e-3

BALL, CUSHION, OFF, POCKET = "ball", "cushion", "off", "pocket"


class Logged(Protocol):
    """The part of a log entry that rules may read.

    `kind` is "ball", "cushion", "off" (a ball has left the table) or "pocket" (it has dropped, and
    `wall` names the pocket); any other kind is ignored.
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
    # an entry written by hand may not say how far the ball had been: then it came from afar
    return getattr(event, "away", inf) > LEFT


@dataclass(frozen=True, slots=True)
class Touch:
    """A contact of the cue ball.

    time: s.
    what: name of the ball or wall that it met.
    cushion: whether that was a wall.
    """

    time: float
    what: str
    cushion: bool


class Rail(NamedTuple):
    """A contact of any ball with a cushion that it had left before.

    time: s.
    ball, wall: names.
    """

    time: float
    ball: str
    wall: str


class Drop(NamedTuple):
    """A ball dropped into a pocket.

    time: s.
    ball, pocket: names.
    """

    time: float
    ball: str
    pocket: str


class Act(NamedTuple):
    """What a referee sees and no log holds.

    ball: name of the ball that it happened to.
    what: a key of the texts: "touched", or "jumps" of a cue ball.
    about: name of the other ball concerned, or "".
    """

    ball: str
    what: str
    about: str = ""


class Zone(NamedTuple):
    """How two object balls lie to the lines of balkline after a stroke.

    ends: "in", both in one zone; "astride", in two zones; "out", one of them in none.
    left: whether one of them was outside that zone at any time during the stroke.
    """

    ends: str = "out"
    left: bool = True


APART = Zone()


@dataclass(frozen=True, slots=True)
class Rest:
    """How the balls lie after the stroke, as far as rules ask.

    touching: pairs of balls that touch.
    snookered: whether the cue ball cannot reach both edges of any ball on in a straight line.
    hidden: name of the ball that snookers the cue ball, or "".
    zone, anchor: of the object balls, among the lines of balkline and among its anchors.
    """

    touching: tuple[tuple[str, str], ...] = ()
    snookered: bool = False
    hidden: str = ""
    zone: Zone = APART
    anchor: Zone = APART


UNSEEN = Rest()


@dataclass(frozen=True, slots=True)
class Stroke:
    """What happened, in order of time.

    touches: of the cue ball.
    off: names of all balls that left the table.
    cue: name of the cue ball.
    rails: contacts of all balls with cushions, as far as they count.
    pocketed: balls that dropped.
    pressed: the wall that the cue ball lay against and was driven into before anything else, or "".
    acts: what a referee saw.
    rest: how the balls lie afterwards.
    """

    touches: tuple[Touch, ...]
    off: tuple[str, ...] = ()
    cue: str = ""
    rails: tuple[Rail, ...] = ()
    pocketed: tuple[Drop, ...] = ()
    pressed: str = ""
    acts: tuple[Act, ...] = ()
    rest: Rest = UNSEEN

    def hits(self) -> dict[str, float]:
        """The balls that were hit, in order, each with the time of its first contact in s."""
        first: dict[str, float] = {}
        for touch in self.touches:
            if not touch.cushion:
                first.setdefault(touch.what, touch.time)
        return first

    @property
    def first(self) -> tuple[str, ...]:
        """The ball that the cue ball hit first: several if at one instant, none if it hit none."""
        hits = self.hits()
        start = min(hits.values(), default=inf)
        return tuple(ball for ball, time in hits.items() if time <= start + TIE)

    @property
    def met(self) -> float:
        """When the cue ball hit the first ball, s; inf if it hit none."""
        return min(self.hits().values(), default=inf)

    @property
    def down(self) -> tuple[str, ...]:
        """The balls that dropped, in order."""
        return tuple(drop.ball for drop in self.pocketed)

    @property
    def lost(self) -> bool:
        """Whether the cue ball dropped or left the table."""
        return self.cue in self.down or self.cue in self.off

    @property
    def gone(self) -> frozenset[str]:
        """All balls that are no longer on the table."""
        return frozenset(self.down) | frozenset(self.off)

    def cushions(self, before: float = inf) -> int:
        """How many cushion contacts came before that time, s, not at the same instant."""
        return sum(touch.cushion and touch.time < before - TIE for touch in self.touches)

    def cushion_at(self, time: float) -> bool:
        """Whether a cushion was met at the same instant as that time, s."""
        return any(touch.cushion and abs(touch.time - time) <= TIE for touch in self.touches)

    def until(self, time: float) -> Stroke:
        """The stroke with the cue ball's touches up to that time, s."""
        return replace(self, touches=tuple(t for t in self.touches if t.time <= time))

    def path(self, until: float = inf) -> tuple[str, ...]:
        """Names of the balls and walls that were met up to that time, s, or at the same instant."""
        return tuple(touch.what for touch in self.touches if touch.time <= until + TIE)


def stroke(log: Iterable[Logged], cue: str) -> Stroke:
    """The log of one stroke, in order of time, seen from the ball named `cue`."""
    touches: list[Touch] = []
    off: list[str] = []
    rails: list[Rail] = []
    pocketed: list[Drop] = []
    pressed = ""
    for event in log:
        if event.kind == CUSHION and event.wall is not None:
            ball = event.balls[0]
            if counts(event):
                rails.append(Rail(event.time, ball, event.wall))
                if ball == cue:
                    touches.append(Touch(event.time, event.wall, cushion=True))
            elif ball == cue and not touches:
                pressed = pressed or event.wall
        elif event.kind == BALL and cue in event.balls:
            a, b = event.balls
            touches.append(Touch(event.time, b if a == cue else a, cushion=False))
        elif event.kind == OFF:
            off += event.balls
        elif event.kind == POCKET:
            pocketed += [Drop(event.time, ball, event.wall or "") for ball in event.balls]
    return Stroke(tuple(touches), tuple(off), cue, tuple(rails), tuple(pocketed), pressed)
