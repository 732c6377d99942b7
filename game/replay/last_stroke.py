"""The last stroke as it can be kept: how the balls lay, what was played, how it came to rest."""

from __future__ import annotations

from game.session.session import Session
from game.table import shared
from game.table.lineup import LineError, Lineup, of
from game.table.shared import UNKNOWN, SharedShot
from physics import Placed

from .game_record import digest


class LastStroke:
    """Looks at a session after each thing that happens, and never changes it."""

    def __init__(self, session: Session) -> None:
        self.session = session
        self.shot: SharedShot | None = None
        """The last stroke as a replay; None where it cannot be one: balls moved when it began."""
        self.came: bool | None = None
        """Has a replay that was opened come out the same?  None before it is over."""
        self._expected = self._end = ""
        self._world, self._shots, self._moved = session.world, session.shots, session.moving

    def opened(self, text: str) -> None:
        """A shot is about to be opened: a replay says how it has to end."""
        self._expected, self.came = shared.read(text).end.strip(UNKNOWN), None

    def note(self) -> bool:
        """Look at the session; returns whether a replay that was opened has just ended."""
        session = self.session
        if session.world is not self._world or session.shots != self._shots:
            # by an action that has struck, and changed neither boxes nor balls beside that
            struck = session.shots > self._shots or session.world is not self._world
            begun = struck and session.shots > 0 and not self._moved
            self.shot, self._end = self._stroke() if begun else None, ""
            self._world, self._shots = session.world, session.shots
        self._moved = session.moving
        if session.moving or self.shot is None or self._end:
            return False
        self._end = digest(session)
        known = bool(self._expected)
        if known:
            self.came, self._expected = self._expected == self._end, ""
        return known

    def replay(self) -> SharedShot | None:
        """The last stroke with its end, if it is over; None where there is none to keep."""
        if self.shot is None:
            return None
        unsure = self.session.moving or not self._end or self.shot.end == UNKNOWN
        end = UNKNOWN if unsure else self._end
        return SharedShot(self.shot.lineup, self.shot.kit, self.shot.cue, end)

    def aimed(self) -> SharedShot:
        """How the balls lie now, with the shot in the boxes if it is one."""
        session = self.session
        texts = session.aim.texts if session.aim.shot else ()
        laid = of(session.world, session.table, texts)
        return SharedShot(laid, _kit(session), session.cue)

    def current(self) -> SharedShot:
        """What is on show: the last stroke, or else the one that is aimed."""
        return (self.replay() if self.session.shown_shot else None) or self.aimed()

    def _stroke(self) -> SharedShot | None:
        session = self.session
        names = [ball.name for ball in session.world.balls]
        lies = dict(zip(names, session.lies, strict=True))
        balls = {name: p for name, p in lies.items() if p.height >= 0.0}
        places = tuple((n, (p.position.real, p.position.imag)) for n, p in balls.items())
        down = tuple(name for name in names if name not in balls)
        laid = Lineup(session.table, places, (*session.aim.texts,), down)
        try:
            shared.read(laid.line())
        except LineError:
            return None  # such as a ball in the air, or boxes that are no shot any more
        end = "" if all(map(_still, balls.values())) else UNKNOWN
        return SharedShot(laid, _kit(session), session.shooter, end)


def _kit(session: Session) -> tuple[tuple[str, str], ...]:
    """What a session is played with; laws of a scene's own are left to the scene."""
    own = {"engine": session.engine, "law": session.law, "cloth": session.cloth}
    return tuple((name, key) for name, key in own.items() if key in shared.CHOICES[name])


def _still(ball: Placed) -> bool:
    return not (ball.velocity or ball.roll or ball.side or ball.climb)
