"""Playing a record again, and saying whether it comes out the same."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.session.ticks import TICKS
from game.text.quoting import in_a_line, shortly

from .game_record import Record, RecordError, Witness, built_with, digest

LONGEST_ROLL = 3600.0
"""Seconds for which fixed steps move balls without an action when nobody watches: 10 s of work."""


@contextmanager
def excused(name: str, session: Session | None = None) -> Iterator[None]:
    """Turn whatever goes wrong while a record is played into a RecordError that names it.

    A record may be written by hand, and say what no player could do: so any error is the record's.
    """
    try:
        yield
    except RecordError:
        raise
    except Exception as error:
        when = f" after tick {session.tick}" if session is not None else ""
        raise RecordError(f"{name}: cannot be played{when} ({_why(error)})") from error


def _why(error: Exception) -> str:
    kind = "" if isinstance(error, ValueError) else f"{type(error).__name__}: "
    return in_a_line(f"{kind}{error}")


class Replay:
    """A record that is being played into a game that began as the record says."""

    def __init__(self, record: Record, session: Session) -> None:
        self.record, self.session = record, session
        self.paused = self.done = False
        self.shots = 0
        """How many shots are over."""
        self.differs: int | None = None
        """The first shot that came out differently, from 1, or one more than the last: the end."""
        self._next = 0
        self.witness = Witness(session, self._shot)

    @property
    def end(self) -> int:
        """The tick at which it is over."""
        return self.record.last

    def due(self, tick: int) -> Iterator[tuple[int, Action]]:
        """Take the actions up to and including `tick`, in their order."""
        actions = self.record.actions
        while self._next < len(actions) and actions[self._next][0] <= tick:
            self._next += 1
            yield actions[self._next - 1]

    def before(self, action: Action) -> None:
        """An action is about to be done."""
        self.witness.before()

    def after(self) -> None:
        """The action has been done."""
        self.witness.after()

    def passed(self) -> None:
        """Time has passed."""
        self.witness.passed()
        if (
            not self.done
            and self.session.tick >= self.end
            and self._next == len(self.record.actions)
        ):
            self._conclude()

    def close(self) -> None:
        """It was left."""

    def perform(self, action: Action) -> None:
        """Do an action of the record; RecordError if there is none like it."""
        try:
            perform(self.session, action)
        except Exception as error:
            what = (
                f"{self.record.name}: cannot do {shortly(list(action))} at tick {self.session.tick}"
            )
            raise RecordError(f"{what} ({_why(error)})") from error

    def play_to(self, tick: int) -> None:
        """Let time pass up to a tick at once; RecordError if that would take too long."""
        session, since = self.session, self.session.world.time
        while session.tick < tick:
            left = tick - session.tick
            session.advance(min(left, TICKS) if _steps(session) else left)
            self.passed()
            if _steps(session) and session.world.time - since > LONGEST_ROLL:
                still = f"the balls still roll {LONGEST_ROLL:g} s later"
                raise RecordError(f"{self.record.name}: {still}, and there is no action to end it")

    def _shot(self, tick: int, found: str) -> None:
        recorded = self.record.shots
        self.shots += 1
        same = self.shots <= len(recorded) and recorded[self.shots - 1] == found
        if not same and self.differs is None and not self._cut:
            self.differs = self.shots

    @property
    def _cut(self) -> bool:
        """Was the record cut off before this shot was over?"""
        return self.record.end is None and self.shots > len(self.record.shots)

    def _conclude(self) -> None:
        self.done = True
        end = self.record.end
        missing = self.shots < len(self.record.shots)
        if self.differs is None and (missing or (end and end[1] != digest(self.session))):
            self.differs = self.shots + 1

    @property
    def state(self) -> str:
        """How it stands: "playing" "paused" "same" "differs"."""
        if self.differs is not None:
            return "differs"
        return "same" if self.done else "paused" if self.paused else "playing"

    def verdict(self) -> str:
        """Say how it came out, in a sentence."""
        of = len(self.record.shots)
        if self.differs is not None:
            what = f"shot {self.differs} of {of} came out differently"
            if self.differs > of:
                what = f"all {of} shots came out the same, but the balls' end did not"
            return f"{what}\n  recorded with {self.record.built}\n  replayed with {built_with()}"
        if not self.done:
            return f"left after {self.shots} of {of} shots, the same so far"
        cut = " (the record was cut off)" if self.record.end is None else ""
        return f"the same, shots: {self.shots}{cut}"


def _steps(session: Session) -> bool:
    """Does time cost work for as long as it lasts?  Exact events run out, fixed steps do not."""
    return session.engine != "exact" and session.moving and not (session.held or session.paused)


def headless(record: Record, session: Session) -> Replay:
    """Play a record without a window, as fast as it goes; RecordError where that cannot be."""
    replay = Replay(record, session)
    with excused(record.name, session):
        for tick, action in replay.due(record.last):
            replay.play_to(tick)
            replay.before(action)
            replay.perform(action)
            replay.after()
        replay.play_to(record.last)
        replay.passed()
    return replay
