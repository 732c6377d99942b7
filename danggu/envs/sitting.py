"""One table with its match: what a stroke does to both, without a window and without questions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import nan
from typing import Any

from danggu.players.observer import lie_of
from danggu.players.positions import SAGU, THREE_CUSHION, opening, spotted
from danggu.players.spotting import lay, opened, settled, take
from danggu.rules.lie import touching
from danggu.rules.match import Match, Player
from danggu.rules.pocketed import CUE
from danggu.rules.stroke import Rest, stroke
from danggu.rules.verdict import NO_BALL, Verdict
from physics import Ball, Contact

from .setup import FOUR_BALL, Setup

GAP = 1e-4  # m: between a ball that is spotted and others


class Sitting:
    """A match at one table; a question is answered by its first option, and a cue ball in hand goes
    to its usual place.

    world: the table with the balls where they lie now.
    match: how it stands.
    verdict: on the last stroke, if there has been one.
    """

    def __init__(self, setup: Setup, players: int, target: int | None = None) -> None:
        self.setup, self.world = setup, setup.world()
        goal = None if setup.racked else target
        self._players = [Player(str(k), goal) for k in range(players)]
        self.open(0)
        self.names = tuple(ball.name for ball in self.world.balls)

    def open(self, seed: int) -> None:
        """Begin another match, with a rack drawn from the seed."""
        self.seed, self.verdict = seed, Verdict(NO_BALL)
        self.match = Match.of(self.setup.rules, *self._players)
        if self.setup.racked:
            opened(self.world, self.match, seed)
            return
        game = SAGU if self.setup.game == FOUR_BALL else THREE_CUSHION
        table = self.world.table
        for name, at in opening(game, self.match.cue).on(table.length, table.width).items():
            if name not in {ball.name for ball in self.world.balls}:
                self.world.add(Ball(name, at))
            lay(self.world, name, at)

    @property
    def places(self) -> list[Any]:
        """Of all balls, (x, y) m; NaN for one that is not on the table."""
        return [(nan, nan) if ball.gone else ball.position for ball in self.world.balls]

    def after(self, contacts: Sequence[Contact], places: Sequence[Sequence[float]]) -> Verdict:
        """Judge a stroke with these contacts, after which the balls lie at these places, and lay
        them for the next one."""
        for ball, at in zip(self.world.balls, places, strict=True):
            if at[0] == at[0]:
                lay(self.world, ball.name, (at[0], at[1]))
            else:
                take(self.world, ball.name)
        before = self.match
        lies = {ball.name: ball.position for ball in self.world.balls if not ball.gone}
        rest = Rest(touching(lies, 2 * self.world.balls[0].radius))
        done = replace(stroke(contacts, before.cue), rest=rest)
        self.verdict = verdict = before.ruled(done)
        self.match = before.after(verdict)
        if not self.setup.racked:
            self._spot(verdict.facts.off)
            return verdict
        self.match = settled(self.world, self.match, verdict.spot, verdict.rack, self.seed)
        if before.rules.key == "snooker":
            self.verdict = before.ruled(lie_of(self.world, verdict, done, before))
            self.match = before.after(self.verdict)
        self._answer()
        return self.verdict

    def _answer(self) -> None:
        while self.match.asked is not None and not self.match.finished:
            option = self.match.asked.options[0]
            self.match = self.match.answered(option.key)
            self.match = settled(self.world, self.match, option.spot, option.rack, self.seed)
        # nobody nominates a free ball, so none is given
        self.match = replace(self.match, state=replace(self.match.state, free=False))

    def _spot(self, off: tuple[str, ...]) -> None:
        """Put balls that have left a table without pockets on their spots."""
        if off:
            table, gap = self.world.table, 2 * self.world.balls[0].radius + GAP
            lie = {ball.name: ball.position for ball in self.world.balls}
            cue = self.match.cue
            for name, at in spotted(lie, off, cue, table.length, table.width, gap).items():
                lay(self.world, name, at)

    @property
    def in_hand(self) -> bool:
        return bool(self.match.state.region) and self.match.cue == CUE
