"""What a game decides about a stroke: the turn that is judged, and the verdict."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import inf
from typing import Protocol

from .stroke import Logged, Stroke

# Reasons that every game shares; each is a key of the texts, as all reasons are.
OFF_TABLE = "off_table"
ONE_BALL = "one_ball"
NO_BALL = "no_ball"
FEW_CUSHIONS = "few_cushions"
SAME_INSTANT = "same_instant"  # the last cushion needed, and the last ball


@dataclass(frozen=True, slots=True)
class Turn:
    """Who plays what: the cue ball, whether this opens the match, the score before the stroke.

    `target` is the player's handicap (수지), or None to play without end.
    """

    cue: str = "white"
    opening: bool = False
    score: int = 0
    target: int | None = None

    def loss(self, penalty: int, *, floor_zero: bool) -> int:
        """The change of score that `penalty` points make, 0 or below."""
        return -min(penalty, max(self.score, 0)) if floor_zero else -penalty

    def reached(self, points: int) -> bool:
        """Whether `points` more bring the player to the target."""
        return self.target is not None and self.score + points >= self.target


@dataclass(frozen=True, slots=True)
class Facts:
    """What happened, up to the contact that decided the stroke, or all of it where none did.

    hits      the balls hit, in order, each once, over the whole stroke
    cushions  cushion contacts of the cue ball
    bank      those of them before the first ball
    path      names of balls and walls as they were met
    decided   when, in s, or None
    off       balls that left the table: they are to be spotted
    """

    hits: tuple[str, ...] = ()
    cushions: int = 0
    bank: int = 0
    path: tuple[str, ...] = ()
    decided: float | None = None
    off: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Verdict:
    """The outcome of a stroke.  `reason` is a key of the texts, `points` the change of score."""

    reason: str
    points: int = 0
    made: bool = False
    foul: bool = False
    passes: bool = True
    won: bool = False
    facts: Facts = Facts()


class Rules(Protocol):
    """A game: its key, its cue balls in the order of play, and how it judges a stroke."""

    @property
    def key(self) -> str: ...
    @property
    def cues(self) -> tuple[str, ...]: ...
    @property
    def balls(self) -> tuple[str, ...]: ...
    def targets(self, turn: Turn) -> tuple[str, ...]:
        """The balls that this stroke may hit first."""
        ...

    def needs(self, turn: Turn) -> int:
        """The cushions that this stroke has to meet before its last ball."""
        ...

    def verdict(self, log: Iterable[Logged], turn: Turn) -> Verdict:
        """What the stroke was worth: `log` holds its events alone, in order of time."""
        ...

    def settles(self, verdict: Verdict) -> bool:
        """Whether a verdict on a stroke that still runs is its last: no contact can change it."""
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
