"""A shot in time: which moment of it is on show, and how fast time passes.

The timeline is live, at the world's own moment, unless it has been put somewhere into the past:
then the picture shows what the log knows of that moment, and the world waits.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field
from math import ceil, isfinite

from danggu.rules.stroke import counts
from physics import Event, World

from .ticks import TICKS, seconds

RATES = (1, 2, 4, 8, 16, 32, 64)
"""Speeds of time in eighths: from an eighth to eight times."""
USUAL = 8
HEEDED = ("ball", "cushion", "rest", "pocket", "off")
"""Kinds of events that a player is told of; any other is passed over."""
FRAME = TICKS // 60
"""What a single frame is while time stands."""
LONGEST_SHOT = 300
"""Seconds after which a shot that is to be skipped, or scrubbed on, is left running."""


@dataclass(slots=True)
class Timeline:
    """The last shot of a world; nothing here lets time pass in the world itself.

    began    world time at which the shot began, s
    moving   do the balls move?
    shown    is this shot on show, rather than the next one?
    paused   is time held while the balls move?
    at       ticks since the shot began that are on show, None while live
    playing  does the past run on, once it is on show?
    rate     speed of time, eighths
    part     eighths of a tick that have not passed yet: no frame rate loses any
    stamp    goes up whenever something other than time has changed what will happen
    _known   the events of the log as far as they have been asked for, and of which shot they are
    """

    world: World
    began: float
    moving: bool = False
    shown: bool = False
    paused: bool = False
    at: int | None = None
    playing: bool = False
    rate: int = USUAL
    part: int = 0
    stamp: int = 0
    _known: tuple[object, list[Event]] = field(default=(None, []))

    # -- what is on show -----------------------------------------------------------------------

    @property
    def length(self) -> int:
        """Ticks from the shot's beginning to the world's present."""
        return max(0, self.ticks(self.world.time))

    @property
    def end(self) -> int:
        """Ticks from the shot's beginning to the last thing that happened, or the present."""
        log = self.world.log
        if self.moving or not len(log):
            return self.length
        return max(0, self.ticks(log[-1].time))

    @property
    def now(self) -> int:
        """The ticks on show."""
        return self.end if self.at is None else self.at

    @property
    def moment(self) -> float:
        """World time on show, s."""
        return self.world.time if self.at is None else self.began + seconds(self.at)

    @property
    def runs(self) -> bool:
        """Do the balls run before the player's eyes, for the first time or once more?"""
        if self.at is not None:
            return self.playing
        return self.shown and self.moving

    @property
    def events(self) -> Sequence[Event]:
        """The shot's events, worked out of the log once, which takes some 25 µs each."""
        shot, log = (self.stamp, self.began), self.world.log
        if self._known[0] != shot or len(self._known[1]) > len(log):
            self._known = shot, []
        known = self._known[1]
        known += log[len(known) :]
        return known

    @property
    def notable(self) -> list[Event]:
        """The events that matter to a player, but for cushions that were not left."""
        return [event for event in self.events if event.kind in HEEDED and counts(event)]

    @property
    def passed(self) -> int:
        """How many events have passed at the moment on show."""
        if self.at is None:
            return len(self.world.log)
        return bisect_right(self.events, self.moment, key=lambda event: event.time)

    @property
    def label(self) -> str:
        """The speed as it is written: ×1/8 ... ×8."""
        return f"×{self.rate // 8}" if self.rate >= USUAL else f"×1/{USUAL // self.rate}"

    def ticks(self, time: float) -> int:
        """Ticks from the shot's beginning to a world time, rounded up."""
        return ceil((time - self.began) * TICKS)

    # -- another moment ------------------------------------------------------------------------

    def live(self) -> None:
        """Show the world as it is."""
        self.at, self.playing = None, False

    def restart(self) -> None:
        """A new shot begins now, or the balls have been put elsewhere."""
        self.live()
        self.world.log.clear()
        self.began = self.world.time

    def review(self, *, editing: bool) -> bool:
        """Show the last shot, if there is one that can be shown; returns whether there is."""
        if not self.shown and not self.moving and len(self.world.log) and not editing:
            self.shown = True
        return self.shown

    def seek(self, ticks: int) -> int:
        """Show the moment `ticks` after the shot began; returns for how many balls must roll first.

        A shot without an end goes on by LONGEST_SHOT at most.
        """
        last, self.playing = self.end, False
        self.paused = self.paused or self.moving
        if ticks > last and self.moving:
            self.at = None
            return min(ticks - last, LONGEST_SHOT * TICKS)
        self.at = max(0, ticks) if ticks < last else None
        return 0

    def pause(self, *, editing: bool) -> bool:
        """Hold or go on; after the shot, show it once more: returns whether that is so."""
        if (self.moving and self.at is None) or not self.review(editing=editing):
            self.paused = not self.paused
            return False
        if self.at is None:
            self.at, self.playing = 0, False
        self.playing = not self.playing
        return True

    def next_event(self, way: int) -> int | None:
        """Ticks of the next event (1), also of one foreseen, or of the one before (-1), if any."""
        at = self.now
        marks = sorted({max(0, self.ticks(event.time)) for event in self.notable})
        if way < 0:
            return max((mark for mark in marks if mark < at), default=0)
        if ahead := [mark for mark in marks if mark > at]:
            return ahead[0]
        if self.moving and isfinite(self.world.next_event):  # a ball that only spins has none
            return max(at + 1, self.ticks(self.world.next_event))
        return None

    def faster(self, steps: int) -> None:
        """Let time pass faster by so many steps, or slower."""
        place = RATES.index(self.rate) + steps
        self.rate = RATES[min(max(place, 0), len(RATES) - 1)]

    def advance(self, ticks: int) -> int | None:
        """Let `ticks` pass on the clock; returns for how many the balls roll, None if they do not.

        While the past is shown again they roll with what is left of the frame at its end: frames
        differ in length, and nothing of one may be lost.
        """
        if self.at is None:
            return self._share(ticks) if self.moving and not self.paused else None
        if not self.playing:
            return None
        self.at += self._share(ticks)
        beyond = self.at - self.end
        if beyond < 0:
            return None
        self.live()
        self.paused = False
        return beyond

    def _share(self, ticks: int) -> int:
        """The ticks that pass in the shot while `ticks` pass on the clock."""
        whole, self.part = divmod(ticks * self.rate + self.part, USUAL)
        return whole
