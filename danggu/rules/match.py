"""A match as a value: a stroke makes a new one, so that undo is keeping the old."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from .state import FRESH, NO_CALL, Call, GameState, Question
from .stroke import Logged, Stroke
from .verdict import Rules, Turn, Verdict


@dataclass(frozen=True, slots=True)
class Player:
    """One of a match.

    name: any text.
    target: the handicap (수지), points to reach, or None to play without end.
    """

    name: str
    target: int | None = None

    def __post_init__(self) -> None:
        if self.target is not None and (type(self.target) is not int or self.target < 1):
            wanted = f"the target of {self.name!r} must be a whole number, 1 or more"
            raise ValueError(f"{wanted}, not {self.target!r:.60}")


@dataclass(frozen=True, slots=True)
class Sheet:
    """A player's score sheet.

    score: points.
    innings: each counts from its first stroke.
    strokes, made, fouls: how many, how many of them scored, how many were fouls.
    best: the high run.
    """

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
    """The state of play: the scores, and which player is at the table.

    rules: of the game.
    players: in the order of play.
    sheets: one for each player.
    at: index of the player at the table.
    visit: strokes made in the present inning.
    run: points made in the present inning.
    winner: index of the player who has won, or None.
    over: whether it has ended without a winner: a draw, or the loss of a lone player.
    state: of the game, besides the scores.
    call: what the player at the table has declared for the coming stroke.
    asked: the question that the player at the table must answer, or None.
    equal: whether all players get the same number of innings (후구): once one has reached the
    target, those later in the order play a last inning from the opening position, and may draw.
    reached: indices of the players who have reached the target, while the last innings are played.
    """

    rules: Rules
    players: tuple[Player, ...]
    sheets: tuple[Sheet, ...]
    at: int = 0
    visit: int = 0
    run: int = 0
    winner: int | None = None
    over: bool = False
    state: GameState = FRESH
    call: Call = NO_CALL
    asked: Question | None = None
    equal: bool = False
    reached: tuple[int, ...] = ()

    @classmethod
    def of(cls, rules: Rules, *players: Player, equal_innings: bool = False) -> Match:
        """A new match; ValueError without players."""
        if not players:
            raise ValueError("a match needs a player")
        state = rules.start(len(players))
        return cls(rules, players, (Sheet(),) * len(players), state=state, equal=equal_innings)

    @property
    def player(self) -> Player:
        return self.players[self.at]

    @property
    def sheet(self) -> Sheet:
        return self.sheets[self.at]

    @property
    def cue(self) -> str:
        """The cue ball of the player at the table."""
        return self.call.cue or self.cue_of(self.at)

    @property
    def inning(self) -> int:
        """The number of the inning that is being played, from 1."""
        return self.sheet.innings + (self.visit == 0)

    @property
    def opening(self) -> bool:
        """Whether the coming stroke is played from the opening position."""
        return not any(sheet.strokes for sheet in self.sheets) or bool(
            self.reached and not self.visit
        )

    @property
    def finished(self) -> bool:
        return self.over or self.winner is not None

    @property
    def next(self) -> int:
        """The index of the player whose turn comes after this one."""
        return (self.at + 1) % len(self.players)

    @property
    def turn(self) -> Turn:
        """What the rules need to know about the coming stroke."""
        return Turn(
            self.cue,
            self.opening,
            self.sheet.score,
            self.player.target,
            self.state,
            self.call,
            self.at,
            len(self.players),
            self.sheets[self.next].score if len(self.players) > 1 else 0,
        )

    def cue_of(self, index: int) -> str:
        """The cue ball of a player; more players than cue balls share them in turn."""
        return self.rules.cues[index % len(self.rules.cues)]

    def missing(self, index: int) -> int | None:
        """Points that a player still needs, or None without a target."""
        target = self.players[index].target
        return None if target is None else max(target - self.sheets[index].score, 0)

    # -- before the stroke ---------------------------------------------------------------------

    def called(self, call: Call) -> Match:
        """The match with this call; ValueError if it names a ball that is not on the table, or one
        to be played that is not the player's cue ball where that is the only one."""
        own, left = self.cue_of(self.at), self.state.left or self.rules.balls
        # where any ball may be played, the cue ball is one of those that count
        any_ball = own in self.rules.start(len(self.players)).left
        lies = left if any_ball else (*self.rules.cues, *left)
        for name in (call.ball, call.cue):
            if name and name not in lies:
                raise ValueError(f"{name!r:.60} is not on the table")
        if call.cue and call.cue != own and not any_ball:
            raise ValueError(f"{call.cue!r:.60} cannot be played: the cue ball is {own!r}")
        return replace(self, call=call)

    def answered(self, key: str) -> Match:
        """The match after this answer; ValueError without a question or such an option."""
        if self.asked is None:
            raise ValueError("there is no question to answer")
        option, question = self.asked.option(key), self.asked
        stays = replace(self, state=option.state, asked=None)
        if option.plays:
            return stays
        return stays.given(self.next if question.shooter else (self.at - 1) % len(self.players))

    # -- the stroke ----------------------------------------------------------------------------

    def judged(self, log: Iterable[Logged]) -> Verdict:
        """The verdict on the log of the coming stroke."""
        return self.rules.verdict(log, self.turn)

    def ruled(self, done: Stroke) -> Verdict:
        """The verdict on the coming stroke, with what a referee saw and how the balls lie."""
        return self.rules.judge(done, self.turn)

    def after(self, verdict: Verdict) -> Match:
        """The match with this stroke played; ValueError if it is over or awaits an answer."""
        if self.finished:
            raise ValueError("the match is over")
        if self.asked is not None and not self.asked.optional:
            raise ValueError("a question must be answered first")
        run = self.run + max(verdict.points, 0)
        played = replace(
            self,
            sheets=self._scored(verdict, run),
            visit=self.visit + 1,
            run=run,
            state=self.state if verdict.state is None else verdict.state,
            call=NO_CALL,
            asked=None,
        )
        return played._ended(verdict) if self._ends(verdict) else played._goes_on(verdict)

    def passed(self) -> Match:
        """The match with the next player at the table; an inning without strokes does not count."""
        return self.given(self.next)

    def given(self, player: int) -> Match:
        """The match with that player at the table."""
        return replace(self, at=player, visit=0, run=0, call=NO_CALL)

    # -- parts ---------------------------------------------------------------------------------

    def _scored(self, verdict: Verdict, run: int) -> tuple[Sheet, ...]:
        sheets = list(self.sheets)
        sheets[self.at] = self.sheet.after(verdict, run, first=self.visit == 0)
        if verdict.gift and len(sheets) > 1:
            other = sheets[self.next]
            sheets[self.next] = replace(other, score=other.score + verdict.gift)
        return tuple(sheets)

    def _ends(self, verdict: Verdict) -> bool:
        return verdict.won or verdict.lost or verdict.drawn or (verdict.passes and self._last)

    @property
    def _last(self) -> bool:
        """Whether this is the last of the innings that make them equal."""
        # the player at index 0 opened the match
        return bool(self.reached) and self.next == 0

    def _ended(self, verdict: Verdict) -> Match:
        reached = (*self.reached, self.at) if verdict.won else self.reached
        if verdict.won and self.equal and self.next != 0:
            return replace(self.passed(), reached=reached)
        if verdict.lost and len(self.players) > 1:
            return replace(self, winner=self.next)
        return replace(self, winner=reached[0]) if len(reached) == 1 else replace(self, over=True)

    def _goes_on(self, verdict: Verdict) -> Match:
        asked = verdict.question
        if asked is not None:
            played = self if asked.shooter else self.passed()
            return replace(played, asked=asked)
        return self.passed() if verdict.passes else self
