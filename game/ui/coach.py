"""The coach beside the table: asked with a key, it searches in a process of its own."""

from __future__ import annotations

from collections.abc import Callable
from math import inf
from time import perf_counter

from danggu.players.levels import LEVELS
from danggu.players.solution import Solution
from danggu.rules import GAMES
from danggu.rules.state import NO_CALL, Call
from danggu.rules.verdict import Rules, Turn
from game.aim import advice
from game.computer.aide import Aide
from game.computer.search import ways
from game.session.action import Action
from game.session.session import Session

FREE = ("three-cushion", "four-ball")
"""What is played on the free table, by its balls."""
LONG = 4.0
"""Seconds after which it says why it takes so long: the first search on a machine compiles."""


class Coach:
    """The ways to score from the position on the table, and the search for them."""

    def __init__(self, clock: Callable[[], float] = perf_counter) -> None:
        self.aide = Aide(ways)
        self._clock = clock
        self._long = inf
        self._ticket: int | None = None
        self._asked = 0
        self._about: object = None
        self._ways: list[Solution] = []
        self._place = 0

    @property
    def searching(self) -> bool:
        """Is the search going on?"""
        return self._ticket is not None

    def look(self, session: Session, level: str) -> list[Action]:
        """What the game is to do: the next way, if the coach was asked for it or has found it.

        Ways from where the balls do not lie any more are forgotten.
        """
        steps, self._asked = session.coaching - self._asked, session.coaching
        if self._about is not None and self._about != _about(session, level):
            self._forget()
        if steps:
            return self._step(session, level, steps)
        news = None if self._ticket is None else self.aide.look(self._ticket)
        if news is None:
            self._wait(session)
            return []
        self._ticket = None
        self._ways = news.value if news.kind == "done" else []
        if self._ways:
            self._place = 0
            return self._shown(session, level)
        session.say("coach.none" if news.kind == "done" else "coach.failed", error=True)
        return []

    def close(self) -> None:
        """End the search, and its process."""
        self.aide.close()

    def _step(self, session: Session, level: str, steps: int) -> list[Action]:
        if self._ways:
            self._place = (self._place + steps) % len(self._ways)
            return self._shown(session, level)
        found = played(session)
        if found is None:
            session.say("coach.game", error=True)
            return []
        session.say("coach.searching", about=level)
        if self._ticket is None:
            self._about = _about(session, level)
            skill = next(one for one in LEVELS if one.key == level)
            self._ticket = self.aide.ask(session.world.copy(), *found, skill)
            self._long = self._clock() + LONG
        return []

    def _wait(self, session: Session) -> None:
        if self._ticket is not None and self._clock() >= self._long:
            self._long = inf
            session.say("coach.long")

    def _shown(self, session: Session, level: str) -> list[Action]:
        """Declare what has to be declared, then show the way, so that the last word is of that."""
        way = self._ways[self._place]
        said = advice.of(way, self._place + 1, len(self._ways), level)
        return [*calls(session, way.call), Action("suggest", said.line())]

    def _forget(self) -> None:
        if self._ticket is not None:
            self.aide.forget()
        self._ticket, self._ways, self._about = None, [], None


def calls(session: Session, wanted: Call) -> list[Action]:
    """What is to be said before a stroke with this call, beyond what has been said already."""
    if session.contest is None:
        return []
    now, may = session.contest.match.call, session.contest.may_call
    words = (("ball", wanted.ball, now.ball), ("pocket", wanted.pocket, now.pocket))
    return [
        Action("call", f"{word} {name}")
        for word, name, said in words
        if name and word in may and name != said
    ]


def played(session: Session) -> tuple[Rules, Turn] | None:
    """The game and whose stroke it is; on the free table by its balls, None if by no game's."""
    if session.contest is not None:
        match = session.contest.match
        return match.rules, match.turn
    names = {ball.name for ball in session.world.balls}
    for game in FREE:
        rules = GAMES[game]()
        if names == {*rules.balls} and session.cue in rules.cues:
            return rules, Turn(session.cue)
    return None


def _about(session: Session, level: str) -> object:
    """What a search is for: whatever has been called, for it calls what it needs."""
    match = None if session.contest is None else session.contest.match.called(NO_CALL)
    return id(session.world), session.cue, tuple(session.world.layout()), match, level
