"""A drill that is practised: it judges each stroke, counts, and keeps the best.

It looks at a session after each thing that happens and never changes it: what is taken back, moved
by hand or laid again is seen by how the balls lie.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from danggu.players.goals import CLEAR, GOALS, RUN, ZONE, DrillOutcome, Goal, outcome
from danggu.rules.stroke import stroke
from game.session.session import Session
from game.table import presets
from physics import Placed

from .book import Book, Reached

READY, ROLLING, AWAY, OVER = "ready", "rolling", "away", "over"
"""Before a stroke that counts; while it rolls; the balls lie as in no attempt; it is over."""


class Result(NamedTuple):
    """What the last stroke that counted came to.

    made, stars  did it come off, and what is it worth so far?
    off    m from the middle of the zone; None without one
    value  reached in the attempt: in a row, or strokes
    best   is it better than everything before?
    """

    made: bool
    stars: int
    off: float | None
    value: int
    best: bool


class Trainer:
    """The drill in use.

    drill   its name, "" for none
    state   READY ROLLING AWAY or OVER
    count   strokes made in a row, or played in an attempt to clear the table
    result  of the last stroke that counted, None before it
    """

    def __init__(self, session: Session, book: Book | None = None) -> None:
        self.session, self.book = session, book or Book()
        self.drill, self.state, self.count = "", READY, 0
        self.result: Result | None = None
        self._world, self._shots, self._moved = session.world, session.shots, session.moving
        self._version = -1
        """The session's when it was looked at last."""
        self._start: Sequence[Placed] = ()
        self._from: Sequence[Placed] = ()
        """How the balls must lie for the next stroke to count."""

    @property
    def goal(self) -> Goal:
        """What the drill asks for; KeyError without one."""
        return GOALS[self.drill]

    @property
    def reached(self) -> Reached:
        """The best so far."""
        return self.book.of(self.drill)

    @property
    def restarts(self) -> bool:
        """Is it the whole drill that has to be laid again, rather than the last stroke's lie?"""
        return bool(self.drill) and (self.goal.restarts or self.session.lies != self._start)

    @property
    def version(self) -> object:
        """Changes whenever something to be seen of the drill has."""
        return self.drill, self.state, self.count, self.result, self.reached

    def begin(self, drill: str) -> None:
        """A drill has just been laid: a streak in the same one goes on, an attempt starts again."""
        again = drill == self.drill and not GOALS[drill].restarts
        self.drill, self.state = drill, READY
        self.count, self.result = (self.count, self.result) if again else (0, None)
        session = self.session
        self._world, self._shots, self._moved = session.world, session.shots, session.moving
        self._start = self._from = session.world.layout()
        self._version = -1

    def end(self) -> None:
        """It is no drill any more that lies on the table."""
        self.drill, self.result, self.count = "", None, 0

    def note(self) -> bool:
        """Look at the session; returns whether a stroke has just been judged."""
        session = self.session
        if not self.drill or session.version == self._version:
            return False
        self._version = session.version
        if session.world is not self._world or session.contest is not None:
            self.end()
            return False
        if session.shots != self._shots:
            struck = session.shots > self._shots and not self._moved
            counts = struck and self.state != OVER and session.lies == self._from
            self.state = ROLLING if counts else AWAY
            self._shots = session.shots
        self._moved = session.moving
        if session.moving:
            return False
        if self.state == ROLLING:
            self._judge()
            return True
        self._look()
        return False

    def _look(self) -> None:
        """Do the balls lie so that a stroke counts?"""
        lies = self.session.world.layout()
        if self.state in (AWAY, OVER) and lies == self._start:
            self._restart()
        elif self.state == READY and lies != self._from:
            self.state = AWAY

    def _restart(self) -> None:
        self.state, self._from = READY, self._start
        if self.goal.restarts:
            self.count, self.result = 0, None

    def _judge(self) -> None:
        session, goal = self.session, self.goal
        lies = {b.name: b.position for b in session.world.balls if not b.gone}
        done = stroke(session.world.log.contacts(), session.shooter)
        size = presets.size(session.world)
        found = outcome(self.drill, done, lies, size)
        if goal.kind == ZONE:
            self._ringed(found, size[0])
        elif goal.kind == CLEAR:
            self._cleared(found)
        else:
            self._counted(found)

    def _ringed(self, found: DrillOutcome, length: float) -> None:
        off = found.off if found.made else None
        stars = self.goal.ringed(off, length) if off is not None else int(found.made)
        self._keep(found.made, stars, off, off)
        self.count = self.count + 1 if found.made else 0
        self.state = AWAY

    def _counted(self, found: DrillOutcome) -> None:
        """One more in a row, or the end of it."""
        self.count = self.count + 1 if found.made else 0
        reached = float(self.count)
        if found.made or self.goal.kind != RUN:
            self._keep(found.made, self.goal.stars(reached), None, reached or None)
        else:
            ended = self.result.value if self.result is not None else 0
            self._keep(False, self.goal.stars(ended), None, None, ended)
        if self.goal.kind == RUN:
            self._from = self.session.world.layout()
            self.state = READY if found.made else OVER
        else:
            self.state = AWAY

    def _cleared(self, found: DrillOutcome) -> None:
        self.count += 1
        ended = found.done or not found.made
        stars = self.goal.stars(self.count) if found.done else 0
        if ended:
            self._keep(found.done, stars, None, float(self.count) if found.done else None)
        else:
            self.result = Result(True, 0, None, self.count, False)
        self._from = self.session.world.layout()
        self.state = OVER if ended else READY

    def _keep(
        self, made: bool, stars: int, off: float | None, value: float | None, count: int = -1
    ) -> None:
        before = self.reached
        self.book.add(self.drill, stars if value is not None or made else 0, value, made=made)
        best = value is not None and self.reached.best != before.best
        self.result = Result(made, stars, off, self.count if count < 0 else count, best)
