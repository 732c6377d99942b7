"""A match as a value: a stroke makes a new one, so that undo is keeping the old."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from .stroke import Logged
from .verdict import Rules, Turn, Verdict


@dataclass(frozen=True, slots=True)
class Player:
    """A name and a handicap (수지): the points to reach, or None to play without end."""

    name: str
    target: int | None = None

    def __post_init__(self) -> None:
        if self.target is not None and self.target < 1:
            raise ValueError(f"the target of {self.name!r} must be 1 or more, not {self.target!r}")


@dataclass(frozen=True, slots=True)
class Sheet:
    """A player's score sheet.  An inning counts from its first stroke; `best` is the high run."""

    score: int = 0
    innings: int = 0
    strokes: int = 0
    made: int = 0
    fouls: int = 0
    best: int = 0

    @property
    def average(self) -> float:
        """Points an inning; 0 before the first stroke."""
        return self.score / self.innings if self.innings else 0.0

    def after(self, verdict: Verdict, run: int, *, first: bool) -> Sheet:
        """The sheet with one more stroke, the `first` of its inning or not, in a run of `run`."""
        return Sheet(
            score=self.score + verdict.points,
            innings=self.innings + first,
            strokes=self.strokes + 1,
            made=self.made + verdict.made,
            fouls=self.fouls + verdict.foul,
            best=max(self.best, run),
        )


@dataclass(frozen=True, slots=True)
class Match:
    """Who has what and who is at the table.

    at      index of the player at the table
    visit   strokes made in the present inning
    run     points made in the present inning
    winner  index of the player who has won, or None
    """

    rules: Rules
    players: tuple[Player, ...]
    sheets: tuple[Sheet, ...]
    at: int = 0
    visit: int = 0
    run: int = 0
    winner: int | None = None

    @classmethod
    def of(cls, rules: Rules, *players: Player) -> Match:
        """A new match; ValueError without players."""
        if not players:
            raise ValueError("a match needs a player")
        return cls(rules, players, (Sheet(),) * len(players))

    @property
    def player(self) -> Player:
        return self.players[self.at]

    @property
    def sheet(self) -> Sheet:
        return self.sheets[self.at]

    @property
    def cue(self) -> str:
        """The cue ball of the player at the table."""
        return self.cue_of(self.at)

    @property
    def inning(self) -> int:
        """The number of the inning that is being played, from 1."""
        return self.sheet.innings + (self.visit == 0)

    @property
    def opening(self) -> bool:
        """Whether nobody has played a stroke yet."""
        return not any(sheet.strokes for sheet in self.sheets)

    @property
    def finished(self) -> bool:
        return self.winner is not None

    @property
    def turn(self) -> Turn:
        """What the rules need to know about the coming stroke."""
        return Turn(self.cue, self.opening, self.sheet.score, self.player.target)

    def cue_of(self, index: int) -> str:
        """The cue ball of a player; more players than cue balls share them in turn."""
        return self.rules.cues[index % len(self.rules.cues)]

    def missing(self, index: int) -> int | None:
        """Points that a player still needs, or None without a target."""
        target = self.players[index].target
        return None if target is None else max(target - self.sheets[index].score, 0)

    def judged(self, log: Iterable[Logged]) -> Verdict:
        """The verdict on the log of the coming stroke."""
        return self.rules.verdict(log, self.turn)

    def after(self, verdict: Verdict) -> Match:
        """The match with this stroke played; ValueError if it was over."""
        if self.finished:
            raise ValueError("the match is over")
        run = self.run + max(verdict.points, 0)
        sheet = self.sheet.after(verdict, run, first=self.visit == 0)
        sheets = (*self.sheets[: self.at], sheet, *self.sheets[self.at + 1 :])
        played = replace(self, sheets=sheets, visit=self.visit + 1, run=run)
        if verdict.won:
            return replace(played, winner=self.at)
        return played.passed() if verdict.passes else played

    def passed(self) -> Match:
        """The next player's turn; an inning without a stroke does not count."""
        return replace(self, at=(self.at + 1) % len(self.players), visit=0, run=0)
