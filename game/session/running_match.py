"""A match at the table: who may strike, what a stroke was worth, and the next player's turn.

`Match` is a value, so going back is keeping the old one: what undoes strokes keeps the result of
`Contest.snapshot` beside the places of the balls, and gives both back (`restore`).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import dist
from typing import NamedTuple

from danggu.players.levels import Level
from danggu.rules.match import Match
from danggu.rules.verdict import Verdict
from game.aim.entry import plain
from game.aim.preview import Outcome
from physics import Log, World, heading

from .terms import FREE, HUMAN, SKILLS, START, Terms


class Standing(NamedTuple):
    """How a match stands between two strokes."""

    match: Match
    verdict: Verdict | None
    shooter: int


@dataclass(slots=True)
class Contest:
    """The match that is being played.

    verdict   on the last stroke, None before the first one and while balls move
    shooter   index of the player who made it
    pending   has a stroke yet to be judged?
    given     does the player at the table have the boxes?  They hold the last stroke until then
    share     of strokes like the one intended that would score, for the picture: the computer's
    thinking  is the computer still looking for a better one?
    """

    terms: Terms
    match: Match
    verdict: Verdict | None = None
    shooter: int = 0
    pending: bool = False
    given: bool = False
    share: float | None = None
    thinking: bool = False
    _before: Standing | None = None
    _entries: dict[int, list[str]] = field(default_factory=dict)

    @classmethod
    def of(cls, terms: Terms) -> Contest | None:
        """The match of some terms; None for the free table."""
        return None if terms.game == FREE else cls(terms, terms.match())

    @property
    def level(self) -> Level | None:
        """The computer's level if it is at the table, None for a person or after the end."""
        if self.match.finished:
            return None
        return SKILLS.get(self.terms.seats[self.match.at].level)

    @property
    def waits(self) -> bool:
        """Is the computer at the table, and another player a person?"""
        levels = [seat.level for seat in self.terms.seats]
        return self.level is not None and HUMAN in levels

    @property
    def closing(self) -> int:
        """Cushions that the coming stroke needs because it would end the game of 4-ball, or 0."""
        turn = self.match.turn
        return self.match.rules.needs(turn) if "red1" in self.match.rules.balls else 0

    # -- strokes -------------------------------------------------------------------------------

    def refusal(self, *, moving: bool) -> str:
        """Why nobody may strike now: "moving" "over" or ""."""
        if self.match.finished:
            return "over"
        return "moving" if moving else ""

    def struck(self, texts: list[str]) -> None:
        """The stroke in the five texts has been made."""
        self._before = self.snapshot()
        self.shooter, self.verdict = self.match.at, None
        self.pending = self.given = True
        self._entries[self.shooter] = list(texts)

    def judge(self, log: Log) -> Verdict:
        """All balls lie still: judge the stroke in a log, after which it is the next one's turn."""
        self.pending = False
        self.verdict = self.match.judged(log.contacts())
        self.match = self.match.after(self.verdict)
        return self.verdict

    def settled(self, log: Log, now: float) -> Verdict | None:
        """The verdict on the last stroke at a world time, if nothing can change it any more."""
        stroke = self._before
        if stroke is None:
            return None
        so_far = stroke.match.judged(c for c in log.contacts() if c.time <= now)
        return so_far if stroke.match.rules.settles(so_far) else None

    def scores(self, log: Log) -> bool:
        """Would the coming stroke score if this were its log?"""
        return self.match.judged(log.contacts()).made

    def outcome(self, log: Log) -> Outcome | None:
        """When the coming stroke would be settled if this were its log, and whether by a foul."""
        verdict = self.match.judged(log.contacts())
        when = verdict.facts.decided if self.match.rules.settles(verdict) else None
        return None if when is None else Outcome(when, verdict.foul)

    def seat(self, *, busy: bool) -> str:
        """Return the cue ball of the player at the table; the boxes follow with the next aim.

        `busy`: what has been typed or completed meanwhile stays in the boxes.
        """
        self.share, self.given = None, busy
        return self.match.cue

    def boxes(self, world: World) -> list[str] | None:
        """What the player at the table finds in the boxes, aimed at a ball to hit first.

        None for the computer, and for a player who has them already: only once in a turn.
        """
        if self.given or self.level is not None:
            return None
        self.given = True
        speed_and_spins = self._entries.get(self.match.at, [*START])[: len(START)]
        return [*speed_and_spins, self._angle(world)]

    def _angle(self, world: World) -> str:
        """Full on the nearest ball that may be hit first, at the opening the usual one, degrees."""
        spots = {ball.name: ball.position for ball in world.balls}
        x, y = own = spots[self.match.cue]
        names = self.match.rules.targets(self.match.turn)[: 1 if self.match.opening else None]
        to = min((spots[name] for name in names), key=lambda at: dist(at, own))
        return plain(heading(complex(to[0] - x, to[1] - y)))

    # -- going back ----------------------------------------------------------------------------

    def snapshot(self) -> Standing:
        """How the match stands: to be kept before a stroke."""
        return Standing(self.match, self.verdict, self.shooter)

    def restore(self, standing: Standing) -> str:
        """Stand again as then; returns the cue ball of the player at the table."""
        self.match, self.verdict, self.shooter = standing
        self.pending, self.given, self.share = False, True, None
        return self.match.cue

    def take_back(self) -> list[str] | None:
        """Stand as before the last stroke; returns its numbers for the boxes, None before any."""
        if self._before is None:
            return None
        self.restore(self._before)
        return self._entries.get(self.match.at)
