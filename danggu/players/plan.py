"""What an opponent is asked for: where it places the ball, what it declares, how it strikes."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass
from random import Random
from time import perf_counter
from typing import Protocol

from danggu.rules.state import NO_CALL, Call
from physics import Shot

Point = tuple[float, float]
Work = Generator[None, None, None]
"""A search that stops after each simulation."""


@dataclass(frozen=True, slots=True)
class Plan:
    """A turn as an opponent wants it played.

    shot: the stroke.
    call: what it declares before; `call.cue` is the ball that it plays where any may be.
    place: where it puts the cue ball in hand first, (x, y) in m; None to leave it where it lies.
    """

    shot: Shot
    call: Call = NO_CALL
    place: Point | None = None


class Mind(Protocol):
    """Something that thinks about the coming stroke, a little at a time."""

    @property
    def done(self) -> bool:
        """Is there nothing left to think about?"""
        ...

    @property
    def plan(self) -> Plan:
        """The best so far, as it is meant; there is one from the beginning."""
        ...

    @property
    def share(self) -> float | None:
        """How many of its strokes like this one would succeed, 0 to 1; None while unknown."""
        ...

    def think(self, budget: float, clock: Callable[[], float] = perf_counter) -> bool:
        """Work for about `budget` s; whether it is done. The plan depends on no budget."""
        ...

    def played(self, rng: Random) -> Plan:
        """The plan with the level's error in its stroke, drawn from `rng`."""
        ...


class Searching:
    """What minds share: a search that is worked on a little at a time."""

    done = False
    _work: Work

    def think(self, budget: float, clock: Callable[[], float] = perf_counter) -> bool:
        """Work for `budget` s, and one simulation at least; whether there is nothing left to do."""
        end = clock() + budget
        while not self.done:
            self.done = next(self._work, True) is True
            if clock() >= end:
                break
        return self.done
