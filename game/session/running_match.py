"""A match at the table: who may strike, what a stroke was worth, and the next player's turn.

`Match` is a value, so going back is keeping the old one: whoever undoes strokes keeps what
`Contest.snapshot` returns beside the places of the balls, and gives both back (`restore`).
"""

from __future__ import annotations

from dataclasses import dataclass, field
from math import dist
from typing import TYPE_CHECKING, NamedTuple

from danggu.players.levels import Level
from danggu.rules.match import Match
from danggu.rules.verdict import Verdict
from game.aim.entry import plain
from game.aim.preview import Outcome
from physics import heading

from . import moves, timeline
from .terms import FREE, HUMAN, SKILLS, START, Fixture

if TYPE_CHECKING:
    from physics import Log

    from .session import Game


class Standing(NamedTuple):
    """How a match stands between two strokes."""

    match: Match
    verdict: Verdict | None
    shooter: int


@dataclass(slots=True)
class Contest:
    """The match that is being played.

    verdict  on the last stroke, None before the first one and while balls move
    shooter  index of the player who made it
    pending  whether a stroke has yet to be judged
    given    whether the player at the table has the boxes; they hold the last stroke until then
    share    of strokes like the one intended that would score, for the picture: the computer's
    """

    fixture: Fixture
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
    def of(cls, fixture: Fixture) -> Contest | None:
        """The match of a fixture; None for the free table."""
        return None if fixture.game == FREE else cls(fixture, fixture.match())

    @property
    def level(self) -> Level | None:
        """The computer's level if it is at the table, None for a person or after the end."""
        if self.match.finished:
            return None
        return SKILLS.get(self.fixture.seats[self.match.at].level)

    @property
    def waits(self) -> bool:
        """Is the computer at the table, and somebody else a person?"""
        levels = [seat.level for seat in self.fixture.seats]
        return self.level is not None and HUMAN in levels

    @property
    def closing(self) -> int:
        """Cushions that the coming stroke needs because it would end the game of 4-ball, or 0."""
        turn = self.match.turn
        return self.match.rules.needs(turn) if "red1" in self.match.rules.balls else 0

    # -- strokes -------------------------------------------------------------------------------

    def refusal(self, game: Game) -> str:
        """Why nobody may strike now: "moving" "over" or ""."""
        if self.match.finished:
            return "over"
        return "moving" if game.moving else ""

    def struck(self, texts: list[str]) -> None:
        """The stroke in the five texts has been made."""
        self._before = self.snapshot()
        self.shooter, self.verdict = self.match.at, None
        self.pending = self.given = True
        self._entries[self.shooter] = list(texts)

    def rested(self, game: Game) -> None:
        """All balls lie still: judge the stroke, and let the next player have the cue ball."""
        if not self.pending:
            return
        self.pending, game.notice = False, None
        self.verdict = self.match.judged(game.world.log.contacts())
        self.match = self.match.after(self.verdict)
        if self.verdict.facts.off:
            moves.spot(game, self.fixture.world())
        self.seat(game)

    def settled(self, game: Game) -> Verdict | None:
        """The verdict on the stroke at the moment on show, if nothing can change it any more."""
        stroke, now = self._before, timeline.moment(game)
        if stroke is None or not game.shown_shot:
            return None
        so_far = stroke.match.judged(c for c in game.world.log.contacts() if c.time <= now)
        return so_far if stroke.match.rules.settles(so_far) else None

    def outcome(self, log: Log) -> Outcome | None:
        """When the coming stroke would be settled if this were its log, and whether by a foul."""
        verdict = self.match.judged(log.contacts())
        when = verdict.facts.decided if self.match.rules.settles(verdict) else None
        return None if when is None else Outcome(when, verdict.foul)

    def seat(self, game: Game) -> None:
        """Give the cue ball to the player at the table; the boxes follow with the next aim.

        What somebody has typed or completed meanwhile stays.
        """
        game.cue = self.match.cue
        self.share = None
        self.given = game.aim.box is not None or game.aim.complete

    def give_boxes(self, game: Game) -> None:
        """Let the player at the table have the boxes, aimed at a ball to hit first; only once."""
        if self.given or self.level is not None:
            return
        self.given = True
        speed_and_spins = self._entries.get(self.match.at, [*START])[: len(START)]
        game.aim.texts = [*speed_and_spins, self._angle(game)]

    def _angle(self, game: Game) -> str:
        """Full on the nearest ball that may be hit first, at the opening the usual one, degrees."""
        spots = {ball.name: ball.position for ball in game.world.balls}
        x, y = own = spots[self.match.cue]
        names = self.match.rules.targets(self.match.turn)[: 1 if self.match.opening else None]
        to = min((spots[name] for name in names), key=lambda at: dist(at, own))
        return plain(heading(complex(to[0] - x, to[1] - y)))

    # -- going back ----------------------------------------------------------------------------

    def snapshot(self) -> Standing:
        """How the match stands: to be kept before a stroke."""
        return Standing(self.match, self.verdict, self.shooter)

    def restore(self, game: Game, standing: Standing) -> None:
        """Stand again as then, with the boxes as they are; the balls are not moved."""
        self.match, self.verdict, self.shooter = standing
        self.pending, self.given, self.share = False, True, None
        game.cue = self.match.cue

    def take_back(self, game: Game) -> None:
        """Stand as before the last stroke, whose numbers go back into the boxes."""
        if self._before is not None:
            self.restore(game, self._before)
            game.aim.texts = list(self._entries.get(self.match.at, game.aim.texts))


def kept(game: Game) -> Standing | None:
    """What the history of a game keeps of its match."""
    return game.contest.snapshot() if game.contest is not None else None


def give_back(game: Game, standing: object) -> None:
    """Stand as the history has kept it."""
    if game.contest is not None and isinstance(standing, Standing):
        game.contest.restore(game, standing)
