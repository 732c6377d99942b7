"""Strokes tried on copies of the table, and what came of them."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from danggu.rules.state import Call
from danggu.rules.verdict import Verdict
from physics import World, simulate

from .chances import Route
from .levels import Attempt, Level
from .starts import Start, laid
from .worth import Worth


@dataclass(slots=True)
class Candidate:
    """A stroke in the running.

    start, call, aim: how it is played, without error.
    pots: whether it means to score, or else to leave nothing.
    worth: of the stroke as it is meant, times the chance that it comes off as far as known.
    way: along which it pots, or None.
    copies: with the level's error, that were tried.
    total: what they were worth in all.
    good: those that scored or, if it means to leave nothing, were no foul.
    """

    start: Start
    call: Call
    aim: Attempt
    pots: bool
    worth: float
    way: Route | None = None
    copies: int = 0
    total: float = 0.0
    good: int = 0

    @property
    def merit(self) -> float:
        """What it may be expected to be worth: what was meant counts as one copy."""
        return (self.total + self.worth) / (self.copies + 1)


@dataclass(slots=True)
class Sequel:
    """What came of a stroke.

    verdict: on it.
    worth: of it, to the player who made it.
    world: after it, at rest.
    """

    verdict: Verdict
    worth: float
    world: World


@dataclass(slots=True)
class Trials:
    """Plays strokes of a match from any start.

    world: as it lies before the stroke.
    judge: of what comes of them.
    radius: of the ball that is played, m.
    tried: how many strokes have been played.
    """

    world: World
    judge: Worth
    radius: float
    tried: int = 0
    _laid: dict[tuple[str, complex], World] = field(default_factory=dict)

    def play(self, start: Start, call: Call, aim: Attempt) -> Sequel | None:
        """None for what the engine cannot follow, or cannot be placed or declared so."""
        self.tried += 1
        try:
            match = start.match.called(call)
            after = simulate(self._table(start), match.cue, aim.shot())
            verdict = match.judged(after.log.brief())
            return Sequel(verdict, self.judge.after(match, verdict, after), after)
        except (ValueError, RuntimeError):
            return None

    def copy(self, one: Candidate, level: Level, rng: Random) -> None:
        """Try it once with an error."""
        done = self.play(one.start, one.call, level.missed(one.aim, rng, self.radius))
        one.copies += 1
        if done is not None:
            one.total += done.worth
            one.good += done.verdict.made if one.pots else not done.verdict.foul

    def _table(self, start: Start) -> World:
        key = start.match.cue, start.at
        if key not in self._laid:
            self._laid[key] = laid(self.world, start)
        return self._laid[key]
