"""The computer at the table: it thinks between frames, shows what it means to do, and strikes.

It sits beside the game, not in it: what it does are actions like a person's, so that a record of
them replays without any thinking.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from random import Random
from time import perf_counter

from danggu.players.opponent import Opponent
from danggu.rules.match import Match
from game.aim.entry import BOXES, plain
from game.session.action import Action
from game.session.session import Game
from game.session.ticks import TICKS
from physics import EventDriven, Shot

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
HURRY = ("skip", "shoot", "fire", "stop", "next")
"""What a person does while the computer thinks that means: strike now."""
AIMING = (
    "edit", "clear", "type", "erase", "delete", "caret", "enter", "leave", "set", "turn", "power",
    "push", "tip", "nudge", "centre", "elevate", "tilt", "thick", "thicker",
)  # fmt: skip
"""What a person does for the next stroke: not on the computer's turn."""
PLACES = 4
"""Decimals of its numbers: what is in the boxes is exactly what is struck."""


class Thinker:
    """Plays the computer's turns; `think` once a frame gives what it wants done."""

    def __init__(self, game: Game, seed: int = 0, virtual: bool = False) -> None:
        self.game, self.seed, self.virtual = game, seed, virtual
        self.mind: Opponent | None = None
        self._about: tuple[Match, int, int] | None = None
        self._hurried = False
        self._since = self._shown_at = self._decided = 0
        self._shown: str | None = None

    @property
    def on(self) -> bool:
        """Is the computer at the table, with nothing else on show that holds the game?"""
        game, contest = self.game, self.game.contest
        held = game.paused or game.moving or game.held
        return contest is not None and contest.level is not None and not held

    def takes(self, action: Action) -> bool:
        """Is this a person's action that the computer's turn leaves undone or takes as "hurry"?

        While that turn is paused too: nobody plays the computer's stroke for it.
        """
        contest = self.game.contest
        if contest is None or contest.level is None or self.game.moving or self.game.held:
            return False
        if action.name in HURRY and self.on:
            self.hurry()
        return action.name in HURRY or action.name in AIMING

    def hurry(self) -> None:
        """Strike at once with the best found so far."""
        self._hurried = self.mind is not None

    def think(self) -> Action | None:
        """Think for a frame's share of time; returns what is to be done now, if anything."""
        if not self.on:
            self._rest()
            return None
        self._take_up()
        assert self.mind is not None
        contest, now = self.game.contest, self.game.tick
        assert contest is not None
        if not (self.mind.done or self._hurried):
            self.mind.think(*self._budget())
        contest.thinking = not self.mind.done
        if self.mind.intent.copies:
            contest.share = self.mind.intent.share
        if self._hurried:
            return self._strike()
        if self.game.shown_shot:
            return Action("next") if now - self._since >= LOOK else None
        return self._show(now)

    def _budget(self) -> tuple[float, Callable[[], float]]:
        return (STEPS - 0.5, count().__next__) if self.virtual else (BUDGET, perf_counter)

    def _rest(self) -> None:
        contest = self.game.contest
        if contest is not None and contest.level is None:
            contest.thinking = False
        if self.game.moving or contest is None:
            self.mind = self._about = None
            self._hurried = False

    def _take_up(self) -> None:
        """Begin to think about the table as it lies, unless that is what it does already."""
        game, contest = self.game, self.game.contest
        assert contest is not None
        assert contest.level is not None
        about = contest.match, game.stamp, id(game.world)
        if about == self._about and self.mind is not None:
            return
        self._about, self._hurried = about, False
        seed = self.seed * 1_000_003 + sum(sheet.strokes for sheet in contest.match.sheets)
        world = game.world.copy()
        world.engine = EventDriven()  # fixed steps would take a hundred times as long
        self.mind = Opponent(world, contest.match, contest.level, seed, EFFORT)
        self._rng = Random(seed + 1)
        self._since = self._shown_at = game.tick
        self._decided, self._shown = 0, None

    def _show(self, now: int) -> Action | None:
        """Put what it intends into the boxes; strike when that has been seen."""
        assert self.mind is not None
        line = _line(self.mind.intent.shot)
        if line != self._shown and (self.mind.done or now - self._shown_at >= GLANCE):
            self._shown, self._shown_at = line, now
            return Action("intend", line)
        if not self.mind.done:
            return None
        self._decided = self._decided or now
        return self._strike() if now - self._decided >= SHOW else None

    def _strike(self) -> Action:
        assert self.mind is not None
        line = _line(self.mind.execute(self._rng))
        self.mind = self._about = None
        self._hurried = False
        return Action("play", line)


def _line(shot: Shot) -> str:
    """The five numbers of a shot as the boxes take them."""
    return " ".join(plain(getattr(shot, name), PLACES) for name in BOXES)
