"""Tables with a match each, of any game: racks played alone, or two players taking turns."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from danggu.rules.state import BREAK
from danggu.rules.verdict import Turn, Verdict
from physics import Outcomes

from .hall import Hall
from .setup import Setup
from .sitting import Sitting

RACK_GAMES = ("eight_ball", "nine_ball", "ten_ball")  # games whose only point is the rack
BALL, MORE = 4, 2  # numbers that are observed of each ball of a game with pockets, and besides


class MatchHall(Hall):
    """Strokes are judged one by one by the rules of the match. All tables have one cue ball."""

    def __init__(
        self, setup: Setup, count: int, players: int = 1, target: int | None = None
    ) -> None:
        super().__init__(setup, count)
        self.sittings = [Sitting(setup, players, target) for _ in range(count)]
        self.world, self.names = self.sittings[0].world.copy(), self.sittings[0].names
        self.bound = 1.25 if setup.racked else 1.0  # a ball may lie in the jaws of a pocket
        self.places = np.zeros((count, len(self.names), 2))
        self._gather(np.arange(count))

    @property
    def order(self) -> list[int]:
        own = self.names.index(self.sittings[0].match.cue)
        return [own, *(k for k in range(len(self.names)) if k != own)]

    @property
    def size(self) -> int:
        return BALL * len(self.names) + MORE if self.setup.racked else 2 * len(self.names)

    def turn_of(self, row: int) -> Turn:
        return self.sittings[row].match.turn

    def lay(self, rows: Any) -> None:
        for row, word in zip(rows, self.chance.words(rows, 1)[:, 0], strict=True):
            self.sittings[row].open(int(word) >> 32)
        self._gather(rows)

    def on(self, rows: Any) -> Any:
        """Those that may be hit first; if none of them is on the table, all that are."""
        here = ~np.isnan(self.places[rows, :, 0])
        here[:, 0] = False
        matches = [self.sittings[row].match for row in rows]
        targets = [{*match.rules.targets(match.turn)} for match in matches]
        names = [self.names[k] for k in self.order]
        legal = here & np.array([[name in on for name in names] for on in targets])
        return np.where(legal.any(axis=1, keepdims=True), legal, here)

    def ruled(
        self, rows: Any, outcomes: Outcomes, whole: Mapping[int, Outcomes]
    ) -> tuple[Any, Any, Any]:
        rewards, over, reasons = np.zeros(len(rows)), np.zeros(len(rows), bool), []
        for k, row in enumerate(rows):
            sitting = self.sittings[row]
            log = whole[k].log(0) if k in whole else outcomes.log(k)
            verdict = sitting.after(log, outcomes.positions[k].tolist())
            rewards[k] = worth(self.rules.key, verdict) - verdict.gift
            passes = verdict.passes and self.setup.by_inning
            over[k] = sitting.match.finished or passes
            reasons.append(verdict.reason)
        self._gather(rows)
        return rewards, over, np.array(reasons, str)

    def seen(self, rows: Any) -> Any:
        if not self.setup.racked:
            return self.halves(rows).reshape(len(rows), -1)
        here, states = ~np.isnan(self.places[rows, :, 0]), [self.sittings[row] for row in rows]
        balls = np.concatenate(
            [self.halves(rows), here[:, :, None], (here & self.on(rows))[:, :, None]], axis=2
        )
        more = [[one.in_hand, one.match.state.phase == BREAK] for one in states]
        return np.concatenate([balls.reshape(len(rows), -1), more], axis=1).astype(np.float32)

    def _gather(self, rows: Any) -> None:
        order = self.order
        for row in rows:
            self.places[row] = np.array(self.sittings[row].places)[order]


def worth(key: str, verdict: Verdict) -> float:
    """What a verdict brings the shooter: points or, where the rack is the only one, 1 for winning
    it and -1 for losing it."""
    if key in RACK_GAMES:
        return float(verdict.won) - float(verdict.lost)
    return float(verdict.points)
