"""The sheet of a match: its visits to the table, one after the other, of all racks."""

from __future__ import annotations

from typing import NamedTuple

from danggu.rules.match import Match
from danggu.rules.state import BREAK
from danggu.rules.verdict import Verdict


class Visit(NamedTuple):
    """A player's turn at the table.

    player   index
    rack     of which rack or frame, from 1
    points   made in it, fouls taken off
    strokes  how many
    made     how many of those scored
    foul     did it end with one?
    spared   how many of the strokes were not meant to score: push outs, safeties, breaks
    won      did it win the rack or frame?
    lost     did it lose it?
    unmeant  how many of the spared strokes scored all the same: breaks
    balls    potted by strokes that scored, in order
    """

    player: int
    rack: int
    points: int
    strokes: int
    made: int
    foul: bool
    spared: int = 0
    won: bool = False
    lost: bool = False
    unmeant: int = 0
    balls: tuple[str, ...] = ()


Card = tuple[Visit, ...]


def after(card: Card, before: Match, verdict: Verdict, rack: int) -> Card:
    """The sheet with one more stroke: of the visit that goes on, or of a new one."""
    own = Visit(before.at, rack, 0, 0, 0, False)
    goes_on = card and before.visit and card[-1].player == before.at and card[-1].rack == rack
    if goes_on:
        own, card = card[-1], card[:-1]
    spared = _spares(before)
    now = Visit(
        own.player,
        rack,
        own.points + verdict.points,
        own.strokes + 1,
        own.made + verdict.made,
        verdict.foul,
        own.spared + spared,
        verdict.won,
        verdict.lost,
        own.unmeant + (spared and verdict.made),
        own.balls + (verdict.down + verdict.spot) * verdict.made,
    )
    return (*card, now)


def running(card: Card, match: Match) -> tuple[str, ...]:
    """The balls potted so far by the player at the table in this visit, in order."""
    goes_on = card and match.visit and card[-1].player == match.at
    return card[-1].balls if goes_on else ()


def _spares(before: Match) -> bool:
    """Was the stroke not meant to score: declared so, or the first one of a rack or frame?"""
    state, call = before.state, before.call
    opens = bool(state.left) and state == before.rules.start(len(before.players))
    return call.safety or call.push or opens or state.phase == BREAK


class Totals(NamedTuple):
    """What a player has done in a match.

    visits, strokes, made, fouls, points, best: the best is the high run or break
    spared: strokes that were not meant to score
    unmeant: how many of these scored all the same
    """

    visits: int = 0
    strokes: int = 0
    made: int = 0
    fouls: int = 0
    points: int = 0
    best: int = 0
    spared: int = 0
    unmeant: int = 0

    @property
    def average(self) -> float:
        """Points a visit."""
        return self.points / self.visits if self.visits else 0.0

    @property
    def share(self) -> float:
        """The part that scored of the strokes meant to."""
        meant = self.strokes - self.spared
        return (self.made - self.unmeant) / meant if meant else 0.0


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
        sum(visit.spared for visit in own),
        sum(visit.unmeant for visit in own),
    )
