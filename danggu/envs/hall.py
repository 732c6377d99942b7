"""A hall: so many tables of one game, played side by side; an environment is one with one table."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from danggu.rules import Verdicts
from danggu.rules.verdict import Turn
from physics import Outcomes, World, simulate_many

from .actions import aims_of, checked
from .chance import Chance
from .noise import DRAWS, Noise, noise_of
from .setup import Setup

KEPT, ALL = 64, 10_000  # contacts of a stroke: of nearly every one, and of any


class Struck(NamedTuple):
    """What strokes on some tables came to, (strokes,) each.

    rewards: points by the rules.
    terminated, truncated: whether the episode is over, by the rules or by the limit.
    reasons: keys of the verdicts.
    """

    rewards: Any
    terminated: Any
    truncated: Any
    reasons: Any


class Hall(ABC):
    """Tables of one game; `rows` are the numbers of those concerned, in ascending order.

    places: (tables, balls, 2) m, NaN for a ball that is not on the table; the cue ball first.
    strokes: (tables,), how many have been played in this episode.
    """

    names: tuple[str, ...]
    world: World
    bound: float  # of the numbers that are observed

    def __init__(self, setup: Setup, count: int) -> None:
        if type(count) is not int or count < 1:
            raise ValueError(f"num_envs must be a whole number above 0, not {count!r:.60}")
        self.setup, self.count, self.rules = setup, count, setup.rules
        self.noise, self.compiled = noise_of(setup.noise), setup.kernel(count)
        self.strokes = np.zeros(count, int)
        self.chance = Chance(np.zeros(count, np.uint64))

    def seed(self, rows: Any, keys: Any) -> None:
        """Let the chance of these tables begin at these keys, (rows,) uint64."""
        self.chance.keys[rows], self.chance.drawn[rows] = keys, 0

    def deal(self, rows: Any) -> None:
        """Begin another episode on these tables."""
        self.strokes[rows] = 0
        self.lay(rows)

    def put(self, rows: Any, state: Any) -> None:
        """Lay the balls of these tables at (rows, balls, 2) m; ValueError where that cannot be."""
        raise ValueError(f"options['state'] is for games without pockets, not {self.setup.game}")

    def strike(self, rows: Any, actions: Any) -> Struck:
        """Play one stroke on each of these tables; ValueError for actions that are none."""
        given = checked(actions, len(rows))
        errors, places = self.chance.normal(rows, DRAWS), self.places[rows]
        shots = self._shots(rows, given, self.noise, errors)
        played = self._played(shots, places)
        long = np.flatnonzero(played.dropped).tolist()
        whole = {k: self._played(shots[[k]], places[[k]], ALL) for k in long}
        self.strokes[rows] += 1
        rewards, over, reasons = self.ruled(rows, played, whole)
        late = ~over & (self.strokes[rows] >= self.setup.limit)
        return Struck(rewards, over, late, reasons)

    def tried(self, row: int, actions: Any) -> Verdicts:
        """What each of these actions would bring at that table without noise; nothing changes."""
        rows = np.full(len(actions), row)
        given, none = checked(actions, len(rows)), np.zeros((len(rows), DRAWS))
        shots = self._shots(rows, given, Noise(), none)
        return self.rules.verdicts(self._played(shots, self.places[rows]), self.turn_of(row))

    def _shots(self, rows: Any, given: Any, noise: Noise, errors: Any) -> Any:
        """(rows, 6): what actions come to with these errors."""
        radius, how = self.world.balls[0].radius, self.setup.aim
        pace, on = self.setup.pace, self.on(rows)
        return noise.shots(
            aims_of(given, self.places[rows], on, 2 * radius, pace, how), errors, radius
        )

    def _played(self, shots: Any, places: Any, contacts: int = KEPT) -> Outcomes:
        own = self.order
        laid = np.empty_like(places)
        laid[:, own] = places
        return simulate_many(
            self.world, self.names[own[0]], shots, positions=laid, contacts=contacts,
            compiled=self.compiled,
        )  # fmt: skip

    # -- what games differ in ------------------------------------------------------------------

    places: Any

    @property
    @abstractmethod
    def order(self) -> list[int]:
        """The number in the world of each ball as it is observed: the cue ball's first."""

    @property
    @abstractmethod
    def size(self) -> int:
        """How many numbers are observed."""

    @abstractmethod
    def turn_of(self, row: int) -> Turn:
        """What the rules know of the coming stroke at that table."""

    @abstractmethod
    def lay(self, rows: Any) -> None:
        """Lay the balls as an episode begins."""

    @abstractmethod
    def on(self, rows: Any) -> Any:
        """(rows, balls): which balls may be aimed at; always some."""

    @abstractmethod
    def ruled(
        self, rows: Any, outcomes: Outcomes, whole: Mapping[int, Outcomes]
    ) -> tuple[Any, Any, Any]:
        """Judge the strokes and lay the balls for the next: rewards, which episodes are over, and
        the reasons.

        whole: of strokes of which contacts were dropped, by their place among the rows, each one
        with all of them.
        """

    @abstractmethod
    def seen(self, rows: Any) -> Any:
        """(rows, size) float32: what is observed."""

    def halves(self, rows: Any) -> Any:
        """(rows, balls, 2) float32: the places in halves of the table, 0 for a ball that is not on
        it."""
        table = self.world.table
        there = self.places[rows] / (0.5 * np.array([table.length, table.width]))
        return np.clip(np.nan_to_num(there), -self.bound, self.bound).astype(np.float32)
