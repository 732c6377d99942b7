"""The fouls of pool and what a call is: the general rules of the WPA (sections 1, 6 and 8)."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from .pocketed import put
from .state import ANYWHERE, SECOND, GameState, Option, Question
from .stroke import TIE, Stroke
from .verdict import NO_BALL, OFF_TABLE, Turn

SCRATCH, WRONG_BALL, NO_RAIL, FEW_RAILS = "scratch", "wrong_ball", "no_rail", "few_rails"
POTTED, SAFE, MISSED, SLOP, PUSHED = "potted", "safe", "missed", "not_as_called", "pushed_out"
THREE_FOULS, RACK_WON, RACK_LOST = "three_fouls", "rack_won", "rack_lost"
ACCEPT, AGAIN = "accept", "offender_again"
TO_BREAK = 4  # balls that a break must drive to rails if none drops

Legal = Collection[str]


def fault(done: Stroke, legal: Legal | None = None, *, rail: bool = True) -> str:
    """Which foul it was, "" for none.

    legal: the balls that may be hit first; None for any or, without `rail`, for no hit at all.
    rail: whether a ball must meet a rail or drop after the first contact.
    """
    if spoilt := spoiled(done):
        return spoilt
    if (legal is not None or rail) and not done.first:
        return NO_BALL
    # a split hit is good: it cannot be seen which ball was first
    if legal is not None and not any(ball in legal for ball in done.first):
        return WRONG_BALL
    return NO_RAIL if rail and not railed(done) else ""


def spoiled(done: Stroke) -> str:
    """Which foul it was whatever has been hit: the cue ball down, a ball off, or an act; or ""."""
    if done.lost:
        return SCRATCH
    if done.off:
        return OFF_TABLE
    return done.acts[0].what if done.acts else ""


def railed(done: Stroke) -> bool:
    """Whether a ball dropped, or any ball met a rail, after the first contact."""
    return bool(done.down) or any(rail.time > done.met + TIE for rail in done.rails)


def driven(done: Stroke) -> int:
    """How many object balls met a rail, dropped, or left the table (WPA 8.4)."""
    return len(({rail.ball for rail in done.rails} | done.gone) - {done.cue})


def objects(done: Stroke) -> tuple[str, ...]:
    """The object balls that dropped, in order."""
    return tuple(ball for ball in done.down if ball != done.cue)


def called(done: Stroke, turn: Turn) -> str:
    """The ball that dropped as called, or "".

    Without a call the obvious shot is meant (WPA 1.6): the ball that is hit first.
    """
    call = turn.call
    if call.safety or call.push:
        return ""
    ball = call.ball or (done.first[0] if len(done.first) == 1 else "")
    for drop in done.pocketed:
        if drop.ball == ball != done.cue and call.pocket in ("", drop.pocket):
            return ball
    return ""


def counted(state: GameState, turn: Turn, *, foul: bool, warns: bool) -> GameState:
    """The state with one more consecutive foul, or with none after a fair stroke.

    A third foul counts only after a warning (WPA 6.14), which with `warns` the second one brings.
    """
    before = state.fouls[turn.player] if state.fouls else 0
    heeded = bool(state.warned) and state.warned[turn.player]
    fouls = min(before + 1, 3 if heeded else 2) if foul else 0
    if not state.fouls:
        state = replace(state, fouls=(0,) * turn.players, warned=(False,) * turn.players)
    return replace(
        state,
        fouls=put(state.fouls, turn.player, fouls),
        warned=put(state.warned, turn.player, fouls == 2 and (warns or heeded)),
    )


def handed(state: GameState) -> GameState:
    """The state with the cue ball in hand anywhere."""
    return replace(state, region=ANYWHERE)


def shoot_or_return(state: GameState) -> Question:
    """Whether the opponent shoots from here or has the other player shoot again."""
    plain = replace(state, phase="" if state.phase == SECOND else state.phase)
    return Question((Option("shoot", True, plain), Option(AGAIN, False, plain)))
