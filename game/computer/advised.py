"""A mind that lets a process beside the game search, and thinks itself until that has an answer."""

from __future__ import annotations

from collections.abc import Callable
from random import Random
from time import perf_counter

from danggu.players.levels import Level
from danggu.players.plan import Mind, Plan
from danggu.players.solution import Solution
from danggu.rules.match import Match
from physics import World

from .aide import Aide

PATIENCE = 2.0
"""Seconds for which it waits for the answer when it has thought itself: the first one may take
longer, while the process compiles."""


class Advised:
    """Plays what the coach plays at its level; what `own` has found if that does not come."""

    def __init__(self, own: Mind, aide: Aide, world: World, match: Match, level: Level) -> None:
        self.own, self.level, self._aide = own, level, aide
        self._radius = world.ball(match.cue).radius
        seed = sum(sheet.strokes for sheet in match.sheets)
        self._ticket: int | None = aide.ask(world, match.rules, match.turn, level, seed)
        self._way: Solution | None = None
        self._until: float | None = None

    @property
    def done(self) -> bool:
        """Is there nothing left to think about?"""
        return self._way is not None or (self.own.done and self._ticket is None)

    @property
    def plan(self) -> Plan:
        """The best so far, as it is meant."""
        return self.own.plan if self._way is None else Plan(self._way.shot, self._way.call)

    @property
    def share(self) -> float | None:
        """How many of its strokes like this one would score."""
        return self.own.share if self._way is None else self._way.share

    def think(self, budget: float, clock: Callable[[], float] = perf_counter) -> bool:
        """Work for about `budget` s, or see whether the answer has come; whether it is done."""
        news = None if self._ticket is None else self._aide.look(self._ticket)
        if news is not None:
            self._ticket = None
            self._way = next(iter(news.value), None) if news.kind == "done" else None
        if self._way is None and not self.own.done:
            self.own.think(budget, clock)
        elif self._ticket is not None:
            self._wait(clock())
        return self.done

    def _wait(self, now: float) -> None:
        self._until = now + PATIENCE if self._until is None else self._until
        if now >= self._until:
            self._ticket = None

    def played(self, rng: Random) -> Plan:
        """The plan with the level's error in its stroke, drawn from `rng`."""
        if self._way is None:
            return self.own.played(rng)
        return Plan(self.level.missed(self._way.aim, rng, self._radius).shot(), self._way.call)
