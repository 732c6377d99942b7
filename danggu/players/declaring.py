"""What a player has to say before a stroke, in each game."""

from __future__ import annotations

from dataclasses import replace

from danggu.rules.match import Match
from danggu.rules.snooker import COLOUR
from danggu.rules.state import BREAK, Call

CALLED = ("eight_ball", "ten_ball", "straight_pool")
"""Games in which ball and pocket are called, or a safety."""
FREE_PYRAMID = "free_pyramid"


def declared(match: Match, ball: str = "", pocket: str = "", *, safety: bool = False) -> Call:
    """The call of a stroke at that ball, and no more than the game knows."""
    key, state = match.rules.key, match.state
    if key in CALLED:
        if state.phase == BREAK and key != "straight_pool":
            return Call()
        return Call(safety=True) if safety else Call(ball, pocket)
    if key == "snooker":
        return _nominated(match, ball)
    return Call(cue=match.cue) if key == FREE_PYRAMID else Call()


def _nominated(match: Match, ball: str) -> Call:
    """A colour, or a free ball if it would not be on anyhow."""
    if match.state.on == COLOUR:
        return Call(ball)
    plain = replace(match, state=replace(match.state, free=False))
    on = plain.rules.targets(plain.turn)
    return Call(ball) if match.state.free and ball not in on else Call()
