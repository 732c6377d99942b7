"""A match at the table: who may strike, what a stroke was worth, and the next player's turn.

`Match` is a value, so going back is keeping the old one: what undoes strokes keeps the result of
`Contest.snapshot` beside the places of the balls, and gives both back (`restore`).
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

from danggu.players import lagger, observer, spotting
from danggu.players.levels import Level
from danggu.rules.lag import Lag, winner
from danggu.rules.match import Match
from danggu.rules.race import Race
from danggu.rules.state import BREAK, Call
from danggu.rules.verdict import Verdict
from game.aim.entry import plain
from game.aim.preview import Outcome
from physics import Log, Placed, World, heading

from . import calls, carom_table, first_aim, scorecard
from .scorecard import Card
from .terms import FREE, HUMAN, SKILLS, START, Terms

LAG = ("2.6", "0", "0", "0")
"""Speed and spins in the boxes before a lag: about twice the length of the table."""
HARD = "8"
"""Speed in the boxes before a break, m/s."""


class Standing(NamedTuple):
    """How a match stands between two strokes; `lies`: the balls before the last one."""

    match: Match
    verdict: Verdict | None
    shooter: int
    race: Race
    lies: tuple[Placed, ...] | None = None
    card: Card = ()
    lag: tuple[Lag, ...] | None = None


@dataclass(slots=True)
class Contest:
    """The match that is being played.

    race      racks or frames won
    verdict   on the last stroke, None before the first one and while balls move
    shooter   index of the player who made it
    pending   has a stroke yet to be judged?
    given     does the player at the table have the boxes?  They hold the last stroke until then
    share     of strokes like the one intended that would come off, for the picture: the computer's
    thinking  is the computer still looking for a better one?
    lies      how the balls lay before the last stroke, None before the first one
    card      the visits to the table so far
    lag       those played while it is found who begins, None afterwards
    """

    terms: Terms
    match: Match
    race: Race
    verdict: Verdict | None = None
    shooter: int = 0
    pending: bool = False
    given: bool = False
    share: float | None = None
    thinking: bool = False
    lies: tuple[Placed, ...] | None = None
    card: Card = ()
    lag: tuple[Lag, ...] | None = None
    _before: Standing | None = None
    _entries: dict[int, list[str]] = field(default_factory=dict)
    _broke: set[int] = field(default_factory=set)

    @classmethod
    def of(cls, terms: Terms) -> Contest | None:
        """The match of some terms; None for the free table."""
        if terms.game == FREE:
            return None
        lag = () if terms.lag and len(terms.seats) > 1 else None
        return cls(terms, terms.match(), Race(terms.race, (0,) * len(terms.seats)), lag=lag)

    @property
    def level(self) -> Level | None:
        """The computer's level if it is at the table, None for a person or after the end."""
        if self.match.finished:
            return None
        return SKILLS.get(self.terms.seats[self.match.at].level)

    @property
    def waits(self) -> bool:
        """Is the computer at the table, and another player a person?"""
        return self.level is not None and self.peopled

    @property
    def peopled(self) -> bool:
        """Is any player a person?"""
        return HUMAN in [seat.level for seat in self.terms.seats]

    @property
    def closing(self) -> int:
        """Cushions that the coming stroke needs because it would end the game of 4-ball, or 0."""
        turn = self.match.turn
        return self.match.rules.needs(turn) if "red1" in self.match.rules.balls else 0

    # -- racks ---------------------------------------------------------------------------------

    @property
    def between(self) -> bool:
        """Is a rack over, but not the race?"""
        return self.match.finished and self.race.winner is None and not self.terms.discipline.points

    @property
    def over(self) -> bool:
        """Is there nothing more to be played?"""
        return self.match.finished and not self.between

    @property
    def rack(self) -> int:
        """The number of the rack or frame that is being played, from 1."""
        return sum(self.race.won) + (not self.match.finished or self.match.winner is None)

    def next_rack(self, world: World) -> None:
        """Rack the balls again for the player whose break it is; sheets go on, points do not."""
        sheets = tuple(replace(sheet, score=0) for sheet in self.match.sheets)
        fresh = self.terms.match()
        self.match = replace(fresh, sheets=sheets, at=self.race.breaker)
        self.verdict = self.lies = self._before = None
        self.given = False
        spotting.opened(world, self.match, self.seed)

    @property
    def seed(self) -> int:
        """Draws the next rack: another one for each stroke, and the same one after undo."""
        return self.terms.seed + 7919 * sum(sheet.strokes for sheet in self.match.sheets)

    # -- before a stroke -----------------------------------------------------------------------

    @property
    def in_hand(self) -> str:
        """Where the player may place the cue ball now, as in `GameState.region`, or ""."""
        return "" if self._idle else self.match.state.region

    @property
    def may_call(self) -> frozenset[str]:
        """What the player may declare before the coming stroke: see `calls.allowed`."""
        return frozenset() if self._idle else calls.allowed(self.match)

    @property
    def _idle(self) -> bool:
        """Is there nothing that may be prepared now?"""
        asked = self.match.asked is not None
        return self.match.finished or self.pending or asked or self.lag is not None

    def call(self, call: Call) -> None:
        """Declare this for the coming stroke; ValueError for what cannot be declared."""
        calls.check(self.match, call)
        self.match = self.match.called(call)

    def answer(self, key: str, world: World) -> None:
        """Answer the question with the key of an option; ValueError if there is none such."""
        if self.match.asked is None:
            raise ValueError("there is no question to answer")
        option = self.match.asked.option(key)
        self.match, self.given = self.match.answered(key), False
        if option.restore and self.lies is not None:
            world.recall(self.lies)
        if self.terms.discipline.position:
            carom_table.spot(world, self.match, option.spot)
        else:
            args = self.match, option.spot, option.rack, self.seed
            self.match = spotting.settled(world, *args)

    # -- strokes -------------------------------------------------------------------------------

    def refusal(self, *, moving: bool) -> str:
        """Why nobody may strike now: "moving" "over" "asked" or ""."""
        if self.match.finished:
            return "rack" if self.between else "over"
        if self.match.asked is not None:
            return "asked"
        return "moving" if moving else ""

    def struck(self, texts: list[str], lies: tuple[Placed, ...]) -> None:
        """The stroke in the five texts has been made, with the balls where they lay."""
        self._before = self.snapshot()
        self.lies = lies
        self.shooter, self.verdict = self.match.at, None
        self.pending = self.given = True
        self._entries[self.shooter] = list(texts)
        breaks = self.match.state.phase == BREAK
        (self._broke.add if breaks else self._broke.discard)(self.shooter)

    def judge(self, world: World) -> bool:
        """All balls lie still: judge the stroke in the world's log, after which it is the next
        one's turn; returns whether balls have been laid elsewhere."""
        self.pending = False
        if self.lag is not None:
            self._lagged(world, self.lag)
            return True
        before, lay, rack = self.match, world.layout(), self.rack
        done = observer.seen(world, before)
        verdict = before.ruled(done)
        self._rule(verdict, before)
        self.card = scorecard.after(self.card, before, verdict, rack)
        if self.terms.discipline.position:
            return carom_table.settled(world, before, self.match, self.verdict, self.terms.world())
        self.match = spotting.settled(world, self.match, verdict.spot, verdict.rack, self.seed)
        if before.rules.key == "snooker":
            lie = observer.lie_of(world, verdict, done, before)
            self._rule(before.ruled(lie), before)
        if self.match.winner is not None:
            self.race = self.race.after(self.match.winner)
        return world.layout() != lay

    def open_up(self, world: World) -> None:
        """Lay all balls for the first stroke, or the one ball for the lag."""
        if self.lag is not None:
            lagger.begun(world, self.match)
        elif self.terms.discipline.position:
            carom_table.open_up(world, self.match)
        else:
            spotting.opened(world, self.match, self.seed)

    def _lagged(self, world: World, before: tuple[Lag, ...]) -> None:
        """The lag is over, or the other player's turn, or it is played again."""
        pool = not self.terms.discipline.position
        lags = (*before, lagger.read(world, self.match.cue, pool=pool))
        self.verdict = Verdict("lag" if lags[-1].good else "lag_bad")
        if len(lags) == 1:
            self.lag, self.match = lags, self.match.passed()
        elif (best := winner(*lags)) is None:
            self.lag, self.match = (), self.match.given(0)
            self.verdict = Verdict("lag_again")
        else:
            self.lag, self.match = None, self.match.given(best)
            self.race = replace(self.race, breaker=best)
        self.open_up(world)

    def _rule(self, verdict: Verdict, before: Match) -> None:
        self.verdict, self.match = verdict, before.after(verdict)

    def settled(self, log: Log, now: float) -> Verdict | None:
        """The verdict on the last stroke at a world time, if nothing can change it any more."""
        stroke = self._before
        if stroke is None or stroke.lag is not None or not self.terms.discipline.position:
            return None  # a stroke in a game with pockets counts to its end
        so_far = stroke.match.judged(c for c in log.brief() if c.time <= now)
        return so_far if stroke.match.rules.settles(so_far) else None

    def scores(self, log: Log) -> bool:
        """Would the coming stroke score if this were its log?"""
        return self.lag is None and self.match.judged(log.brief()).made

    def outcome(self, after: World) -> Outcome:
        """What the rules say of the coming stroke, which this copy of the world has played."""
        if self.lag is not None:
            return Outcome(None, "")
        if not self.terms.discipline.position:
            verdict = self.match.ruled(observer.seen(after, self.match))
            return Outcome(None, verdict.reason * verdict.foul)
        verdict = self.match.judged(after.log.brief())
        when = verdict.facts.decided if self.match.rules.settles(verdict) else None
        return Outcome(when, verdict.reason * verdict.foul)

    def seat(self, world: World, *, busy: bool) -> str:
        """Return the cue ball of the player at the table; the boxes follow with the next aim.

        `busy`: what has been typed or completed meanwhile stays in the boxes.
        """
        self.share, self.given = None, busy
        self.match = calls.with_a_cue_ball(self.match, world)
        return self.match.cue

    def boxes(self, world: World) -> list[str] | None:
        """What the player at the table finds in the boxes, aimed at a ball to hit first.

        None for the computer, and for a player who has them already: only once in a turn.
        """
        if self.given or self.level is not None:
            return None
        self.given = True
        if self.lag is not None:
            return [*LAG, "0"]
        breaks = self.match.state.phase == BREAK and not self.terms.discipline.points
        start = [HARD, *START[1:]] if breaks else [*START]
        broke = self.match.at in self._broke  # nobody goes on as hard
        own = start if breaks or broke else self._entries.get(self.match.at, start)
        return [*own[: len(START)], self.angle(world)]

    def angle(self, world: World) -> str:
        """At the nearest ball that may be hit first and can be; at the opening the usual one.

        Degrees; full on it where nothing else is in the way.
        """
        names = self.match.rules.targets(self.match.turn)
        opening = self.match.opening and self.terms.discipline.position
        wanted = names[:1] if opening else names
        return plain(heading(first_aim.way(world, self.match.cue, wanted)))

    # -- going back ----------------------------------------------------------------------------

    def snapshot(self) -> Standing:
        """How the match stands: to be kept before a stroke."""
        own = self.match, self.verdict, self.shooter, self.race, self.lies
        return Standing(*own, self.card, self.lag)

    def restore(self, standing: Standing) -> str:
        """Stand again as then; returns the cue ball of the player at the table."""
        self.match, self.verdict, self.shooter, self.race, self.lies = standing[:5]
        self.card, self.lag = standing[5:]
        self.pending, self.given, self.share = False, True, None
        return self.match.cue

    def take_back(self) -> tuple[list[str] | None, tuple[Placed, ...] | None]:
        """Stand as before the last stroke; returns its numbers for the boxes and where the balls
        lay, None before any."""
        before, lies = self._before, self.lies
        if before is None:
            return None, None
        self.restore(before)
        return self._entries.get(self.match.at), lies
