"""What a game decides about a stroke: the turn that is judged, and the verdict."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from .state import FRESH, NO_CALL, Call, GameState, Question
from .stroke import Logged, Stroke

if TYPE_CHECKING:
    from physics import Outcomes

# Reasons that every game shares; each is a key of the texts, as all reasons are.
OFF_TABLE = "off_table"
ONE_BALL = "one_ball"
NO_BALL = "no_ball"
FEW_CUSHIONS = "few_cushions"
SAME_INSTANT = "same_instant"  # the last cushion needed and the last ball were met together


@dataclass(frozen=True, slots=True)
class Turn:
    """The circumstances of a stroke.

    cue: name of the cue ball.
    opening: whether it is played from the opening position.
    score: of the player, before the stroke.
    target: the player's handicap (수지), or None to play without end.
    state: of the game, besides the scores.
    call: what the player has declared.
    player: index of the player at the table.
    players: how many there are.
    against: score of the next player.
    """

    cue: str = "white"
    opening: bool = False
    score: int = 0
    target: int | None = None
    state: GameState = FRESH
    call: Call = NO_CALL
    player: int = 0
    players: int = 2
    against: int = 0

    def loss(self, penalty: int, *, floor_zero: bool) -> int:
        """The change of score that `penalty` points make, 0 or below."""
        return -min(penalty, max(self.score, 0)) if floor_zero else -penalty

    def reached(self, points: int) -> bool:
        """Whether `points` more bring the player to the target."""
        return self.target is not None and self.score + points >= self.target


@dataclass(frozen=True, slots=True)
class Facts:
    """What happened, up to the contact that decided the stroke, or all of it where none did.

    hits: the balls hit, in order, each once, over the whole stroke.
    cushions: cushion contacts of the cue ball.
    bank: those of them before the first ball.
    path: names of balls and walls as they were met.
    decided: when, s, or None.
    off: balls that left the table: they are to be spotted.
    """

    hits: tuple[str, ...] = ()
    cushions: int = 0
    bank: int = 0
    path: tuple[str, ...] = ()
    decided: float | None = None
    off: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Verdict:
    """The outcome of a stroke.

    reason: a key of the texts.
    points: the change of score.
    made, foul: whether it scored, whether it was a foul.
    passes: whether the turn passes to the next player.
    won: whether it won the match.
    facts: what happened.
    gift: points for the next player.
    lost: whether the next player wins by it.
    drawn: whether it ended the match in a draw.
    down: names of the balls that stay pocketed.
    spot: names of the balls that are spotted.
    rack: how many balls are racked before the next stroke, 0 for none.
    state: of the game afterwards, None if unchanged.
    question: what a player may choose before play goes on, or None.
    """

    reason: str
    points: int = 0
    made: bool = False
    foul: bool = False
    passes: bool = True
    won: bool = False
    facts: Facts = Facts()
    gift: int = 0
    lost: bool = False
    drawn: bool = False
    down: tuple[str, ...] = ()
    spot: tuple[str, ...] = ()
    rack: int = 0
    state: GameState | None = None
    question: Question | None = None


class Verdicts(NamedTuple):
    """What `Rules.verdicts` returns: of each shot what `Verdict` has of it, (shots,) each.

    points: the change of score.
    made, foul: whether it scored, whether it was a foul.
    reason: a key of the texts.
    certain: whether the verdict stands whatever happened after the contacts that were kept; always
    where none was dropped.
    """

    points: Any
    made: Any
    foul: Any
    reason: Any
    certain: Any


class Rules(Protocol):
    """A game: its key, its cue balls in the order of play, and how it judges a stroke."""

    @property
    def key(self) -> str: ...
    @property
    def cues(self) -> tuple[str, ...]: ...
    @property
    def balls(self) -> tuple[str, ...]: ...
    def start(self, players: int) -> GameState:
        """The state of the game before its first stroke."""
        ...

    def targets(self, turn: Turn) -> tuple[str, ...]:
        """The balls that this stroke may hit first."""
        ...

    def needs(self, turn: Turn) -> int:
        """How many cushions this stroke must meet before its last ball."""
        ...

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        """The verdict on a stroke, given the log of its events alone, in order of time."""
        ...

    def verdicts(self, outcomes: Outcomes, turn: Turn) -> Verdicts:
        """The verdicts on all shots of a batch, each as `verdict` has it by the contacts that the
        batch has kept of that shot; ValueError if it has no cue ball of the turn."""
        ...

    def judge(self, done: Stroke, turn: Turn) -> Verdict:
        """The verdict on a stroke that has been read from its log."""
        ...

    def settles(self, verdict: Verdict) -> bool:
        """Whether no later contact can change a verdict on a stroke that is still running."""
        ...

    def enough(self, turn: Turn, balls: Sequence[str]) -> tuple[str, ...]:
        """Of the balls on the table those that settle a stroke: when the cue ball has met all of
        them, only a ball that leaves the table can change the verdict.  (): none do."""
        ...


def facts(done: Stroke, decided: float | None = None) -> Facts:
    """The facts of a stroke that was decided at the time `decided`."""
    hits = done.hits()
    until = inf if decided is None else decided
    first = min(hits.values(), default=until)
    return Facts(
        hits=tuple(hits),
        cushions=done.cushions(until),
        bank=done.cushions(min(first, until)),
        path=done.path(until),
        decided=decided,
        off=done.off,
    )
