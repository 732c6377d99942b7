"""The sheet of a match: its visits to the table, one after the other, of all racks."""

from __future__ import annotations

from typing import NamedTuple

from danggu.rules.match import Match
from danggu.rules.verdict import Verdict


class Visit(NamedTuple):
    """A player's turn at the table.

    player   index
    rack     of which rack or frame, from 1
    points   made in it, fouls taken off
    strokes  how many
    made     how many of those scored
    foul     did it end with one?
    """

    player: int
    rack: int
    points: int
    strokes: int
    made: int
    foul: bool


Card = tuple[Visit, ...]


def after(card: Card, before: Match, verdict: Verdict, rack: int) -> Card:
    """The sheet with one more stroke: of the visit that goes on, or of a new one."""
    own = Visit(before.at, rack, 0, 0, 0, False)
    goes_on = card and before.visit and card[-1].player == before.at and card[-1].rack == rack
    if goes_on:
        own, card = card[-1], card[:-1]
    now = Visit(
        own.player,
        rack,
        own.points + verdict.points,
        own.strokes + 1,
        own.made + verdict.made,
        verdict.foul,
    )
    return (*card, now)


class Totals(NamedTuple):
    """What a player has done in a match.

    visits, strokes, made, fouls, points, best: the best is the high run or break
    """

    visits: int = 0
    strokes: int = 0
    made: int = 0
    fouls: int = 0
    points: int = 0
    best: int = 0

    @property
    def average(self) -> float:
        """Points a visit."""
        return self.points / self.visits if self.visits else 0.0

    @property
    def share(self) -> float:
        """The part of the strokes that scored."""
        return self.made / self.strokes if self.strokes else 0.0


def totals(card: Card, player: int) -> Totals:
    """What a player has done; where no points are counted, balls potted in a visit are its run."""
    own = [visit for visit in card if visit.player == player]
    counted = any(visit.points for visit in card)
    return Totals(
        len(own),
        sum(visit.strokes for visit in own),
        sum(visit.made for visit in own),
        sum(visit.foul for visit in own),
        sum(visit.points if counted else visit.made for visit in own),
        max((visit.points if counted else visit.made for visit in own), default=0),
    )
