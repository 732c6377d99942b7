"""Tables without pockets, for one player: positions at random, judged in arrays."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from danggu.players.levels import SLOWEST
from danggu.players.positions import spotted
from danggu.rules.verdict import Turn
from physics import Ball, Outcomes, simulate_many

from .hall import Hall
from .setup import Setup

WORDS = "U32"  # the type of an array of reasons
GAP = 1e-4  # m: at least so far apart are balls that are laid at random


class CannonHall(Hall):
    """Each episode begins with all balls at random; a ball off the table is spotted."""

    bound = 1.0

    def __init__(self, setup: Setup, count: int) -> None:
        super().__init__(setup, count)
        self.world, self.names = setup.world(), self.rules.balls
        table = self.world.table
        for k, name in enumerate(self.names):
            x = table.length * (k + 1) / (len(self.names) + 1) - 0.5 * table.length
            self.world.add(Ball(name, at=(x, 0.0)))
        self.places = np.zeros((count, len(self.names), 2))
        self.turn = Turn(self.names[0])

    @property
    def order(self) -> list[int]:
        return list(range(len(self.names)))

    @property
    def size(self) -> int:
        return 2 * len(self.names)

    def turn_of(self, row: int) -> Turn:
        return self.turn

    def lay(self, rows: Any) -> None:
        table, radius = self.world.table, self.world.balls[0].radius
        half = 0.5 * np.array([table.length, table.width]) - radius
        first, second = np.triu_indices(len(self.names), 1)
        while len(rows):
            drawn = self.chance.uniform(rows, 2 * len(self.names))
            found = (2.0 * drawn.reshape(len(rows), -1, 2) - 1.0) * half
            self.places[rows] = found
            apart = found[:, first] - found[:, second]
            near = (apart**2).sum(axis=2) < (2 * radius + GAP) ** 2
            rows = rows[near.any(axis=1)]

    def put(self, rows: Any, state: Any) -> None:
        found = np.asarray(state, float)
        if found.shape != self.places[rows].shape:
            raise ValueError(f"state must be {self.places[rows].shape}, not {found.shape}")
        if np.isnan(found).any():
            raise ValueError("state must have all balls on the table")
        # one stroke is played from there for its check of the places
        cue, kernel = self.names[0], self.compiled
        simulate_many(self.world, cue, positions=found, speed=SLOWEST, compiled=kernel)
        self.places[rows] = found

    def on(self, rows: Any) -> Any:
        targets = self.rules.targets(self.turn)
        return np.tile([name in targets for name in self.names], (len(rows), 1))

    def ruled(
        self, rows: Any, outcomes: Outcomes, whole: Mapping[int, Outcomes]
    ) -> tuple[Any, Any, Any]:
        found = self.rules.verdicts(outcomes, self.turn)
        found = found._replace(reason=found.reason.astype(WORDS))  # one may be longer than they are
        for k, one in whole.items():
            for column, value in zip(found, self.rules.verdicts(one, self.turn), strict=True):
                column[k] = value[0]
        self.places[rows] = outcomes.positions
        for row in rows[np.isnan(outcomes.positions).any(axis=(1, 2))]:
            self._spot(row)
        over = ~found.made if self.setup.by_inning else np.zeros(len(rows), bool)
        return found.points.astype(float), over, found.reason

    def seen(self, rows: Any) -> Any:
        return self.halves(rows).reshape(len(rows), -1)

    def _spot(self, row: int) -> None:
        """Put what has left the table back on its spots."""
        table, gap = self.world.table, 2 * self.world.balls[0].radius
        lie = dict(zip(self.names, map(tuple, self.places[row].tolist()), strict=True))
        off = tuple(name for name, at in lie.items() if at[0] != at[0])
        placed = spotted(lie, off, self.names[0], table.length, table.width, gap + GAP)
        if len(placed) < len(self.names):  # no spot is free
            self.lay(np.array([row]))
        else:
            self.places[row] = [placed[name] for name in self.names]
