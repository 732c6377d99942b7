"""The computer at the table: it thinks between frames, shows what it means to do, and strikes.

It sits beside the game, not in it: what it does are actions like a person's, so that a record of
them replays without any thinking.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from random import Random
from time import perf_counter

from danggu.players import lagger
from danggu.players.answers import answer
from danggu.players.minds import mind
from danggu.players.plan import Mind, Plan
from danggu.players.spotting import KINDS
from danggu.rules.match import Match
from game.aim.entry import BOXES, plain
from game.session.action import Action
from game.session.commands import COMMANDS
from game.session.session import Session
from game.session.ticks import TICKS
from physics import EventDriven, Shot

from .advised import Advised
from .aide import Aide

BUDGET = 0.009
"""Seconds of thinking in a frame of 16.7 ms."""
STEPS = 8
"""Simulations in a frame whose time is counted and not measured."""
EFFORT = 900
"""Aims tried at most: what remains to be found after these is not worth the waiting."""
LOOK = TICKS * 6 // 5
"""How long the last stroke stays on show before the computer's intention replaces it."""
SHOW = TICKS
"""How long the decided stroke is shown before it is made."""
GLANCE = TICKS // 5
"""How often what it intends is shown while it changes."""
PLACES = 4
"""Decimals of its numbers: what is in the boxes is exactly what is struck."""


class Thinker:
    """Plays the computer's turns; `think` once a frame gives what it wants done.

    `aide` is the process that searches; not where steps are counted, for its answers come when
    they come.
    """

    def __init__(
        self, session: Session, seed: int = 0, virtual: bool = False, aide: Aide | None = None
    ) -> None:
        self.session, self.seed, self.virtual = session, seed, virtual
        self.aide = None if virtual else aide
        self.mind: Mind | None = None
        self._queue: list[Action] = []
        self._about: tuple[Match, int, int] | None = None
        self._hurried = False
        self._since = self._shown_at = self._decided = 0
        self._shown: str | None = None
        self._own = False
        """Was the last thing done its own, so that what it thinks about has not changed?"""

    @property
    def on(self) -> bool:
        """Is the computer at the table, with nothing else on show that holds the game?"""
        session, contest = self.session, self.session.contest
        held = session.paused or session.moving or session.held
        return contest is not None and contest.level is not None and not held

    def takes(self, action: Action) -> bool:
        """Is this a person's action that the computer's turn leaves undone or takes as "hurry"?

        While that turn is paused too: nobody plays the computer's stroke for it.
        """
        contest = self.session.contest
        if contest is None or contest.level is None or self.session.moving or self.session.held:
            return False
        command = COMMANDS[action.name]
        if command.hurries and self.on:
            self.hurry()
        return command.hurries or command.aims

    def hurry(self) -> None:
        """Strike at once with the best found so far."""
        contest = self.session.contest
        asked = contest is not None and contest.match.asked is not None
        self._hurried = self.mind is not None or asked

    def think(self) -> Action | None:
        """Think for a frame's share of time; returns what is to be done now, if anything."""
        if self._racks():
            return Action("next")
        if not self.on:
            self._rest()
            return None
        if self._queue:
            return self._queue.pop(0)
        if self.session.contest is not None and self.session.contest.match.asked is not None:
            return self._answer()
        if self.session.contest is not None and self.session.contest.lag is not None:
            return self._lag()
        self._take_up()
        assert self.mind is not None
        contest, now = self.session.contest, self.session.tick
        assert contest is not None
        if not (self.mind.done or self._hurried):
            self.mind.think(*self._budget())
        self.session.muse(not self.mind.done, self.mind.share)
        if self._hurried:
            return self._strike()
        if self.session.shown_shot:
            return Action("next") if now - self._since >= LOOK else None
        return self._show(now)

    def _budget(self) -> tuple[float, Callable[[], float]]:
        return (STEPS - 0.5, count().__next__) if self.virtual else (BUDGET, perf_counter)

    def _rest(self) -> None:
        contest = self.session.contest
        if contest is not None and contest.level is None:
            self.session.muse(False, None)
        if self.session.moving or contest is None:
            self.mind = self._about = None
            self._queue = []
            self._hurried = False

    def _take_up(self) -> None:
        """Begin to think about the table as it lies, unless that is what it does already."""
        session, contest = self.session, self.session.contest
        assert contest is not None
        assert contest.level is not None
        about = contest.match, session.stamp, id(session.world)
        if self._own and self.mind is not None:  # it has only prepared its stroke
            self._about, self._own = about, False
        if about == self._about and self.mind is not None:
            return
        self._about, self._hurried = about, False
        seed = self.seed * 1_000_003 + sum(sheet.strokes for sheet in contest.match.sheets)
        world = session.world.copy()
        world.engine = EventDriven()  # fixed steps would take a hundred times as long
        self.mind = mind(world, contest.match, contest.level, seed, EFFORT)
        if self.aide is not None and contest.match.rules.key not in KINDS:
            self.mind = Advised(self.mind, self.aide, world, contest.match, contest.level)
        self._rng = Random(seed + 1)
        self._since = self._shown_at = session.tick
        self._decided, self._shown = 0, None

    def _show(self, now: int) -> Action | None:
        """Put what it intends into the boxes; strike when that has been seen."""
        assert self.mind is not None
        line = _line(self.mind.plan.shot)
        if self.mind.done and (prepared := self._prepared(self.mind.plan)):
            self._shown = None
            return prepared
        if line != self._shown and (self.mind.done or now - self._shown_at >= GLANCE):
            self._shown, self._shown_at = line, now
            return Action("intend", line)
        if not self.mind.done:
            return None
        self._decided = self._decided or now
        return self._strike() if now - self._decided >= SHOW else None

    def _strike(self) -> Action:
        assert self.mind is not None
        plan = self.mind.played(self._rng)
        self._queue = [*self._steps(plan), Action("play", _line(plan.shot))]
        self.mind = self._about = None
        self._hurried = False
        return self._queue.pop(0)

    def _prepared(self, plan: Plan) -> Action | None:
        """The next thing that has to be done before the stroke can be shown as it is meant."""
        steps = self._steps(plan)
        if steps:
            self._own = True
        return steps[0] if steps else None

    def _steps(self, plan: Plan) -> list[Action]:
        """What is to be done before the stroke: the ball put where it is wanted, and calls."""
        session, contest = self.session, self.session.contest
        assert contest is not None
        found, now = [], contest.match.call
        if plan.call.cue and plan.call.cue != contest.match.cue:
            found.append(Action("call", f"cue {plan.call.cue}"))
        at = session.world.ball(contest.match.cue).position
        if plan.place is not None and contest.in_hand and _place(plan.place) != _place(at):
            found.append(Action("put", _place(plan.place)))
        for word, name in (("ball", plan.call.ball), ("pocket", plan.call.pocket)):
            if name and word in contest.may_call and getattr(now, word) != name:
                found.append(Action("call", f"{word} {name}"))
        said = [w for w in ("safety", "push") if getattr(plan.call, w) and not getattr(now, w)]
        return [*found, *(Action("call", word) for word in said if word in contest.may_call)]

    def _answer(self) -> Action | None:
        """Answer the question of the match, once it has been seen."""
        session, contest = self.session, self.session.contest
        assert contest is not None
        assert contest.level is not None
        if not (self._looked_at(contest.match) or self._hurried):
            return None
        self._hurried = False
        return Action("answer", answer(session.world, contest.match, contest.level))

    def _lag(self) -> Action | None:
        """Play for the first stroke, once the table has been seen."""
        session, contest = self.session, self.session.contest
        assert contest is not None
        assert contest.level is not None
        if not self._looked_at(contest.match):
            return None
        rng = Random(self.seed + 7 * session.shots)
        world = session.world.copy()
        world.engine = EventDriven()
        return Action("play", _line(lagger.shot(world, session.cue, contest.level, rng)))

    def _racks(self) -> bool:
        """Is it time that the computers rack again, with nobody there who could?"""
        session, contest = self.session, self.session.contest
        if contest is None or not contest.between or contest.peopled:
            return False
        if session.paused or session.moving or session.held:
            return False
        return self._looked_at(contest.match)

    def _looked_at(self, match: Match) -> bool:
        """Has the table as it lies now been on show for long enough?"""
        session = self.session
        about = match, session.stamp, id(session.world)
        if about != self._about:
            self._about, self._since = about, session.tick
        return session.tick - self._since >= LOOK


def _place(at: tuple[float, float]) -> str:
    """A place as commands take it, m."""
    return f"{at[0]!r} {at[1]!r}"


def _line(shot: Shot) -> str:
    """The five numbers of a shot as the boxes take them."""
    return " ".join(plain(getattr(shot, name), PLACES) for name in BOXES)
