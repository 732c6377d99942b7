"""What a player declares before a stroke: which ball and pocket, a safety, a push out."""

from __future__ import annotations

from dataclasses import replace

from danggu.players.declaring import CALLED, FREE_PYRAMID
from danggu.rules.match import Match
from danggu.rules.snooker import COLOUR, COLOURS, RED
from danggu.rules.snooker import kind as colour_of
from danggu.rules.state import BREAK, SECOND, Call
from physics import World

ROTATION = {"nine_ball", "ten_ball"}


def allowed(match: Match) -> frozenset[str]:
    """What may be declared before the coming stroke: "ball" "pocket" "safety" "push" "cue"."""
    key, state = match.rules.key, match.state
    found: set[str] = set()
    if key in CALLED and (state.phase != BREAK or key == "straight_pool"):
        found |= {"ball", "pocket", "safety"}
    if key in ROTATION and state.phase == SECOND:
        found.add("push")
    if key == "snooker" and (state.free or state.on == COLOUR):
        found.add("ball")
    if key == FREE_PYRAMID:
        found.add("cue")
    return frozenset(found)


def check(match: Match, call: Call) -> None:
    """ValueError for what cannot be declared; its text is a key of the texts."""
    may = allowed(match)
    for name in ("ball", "pocket", "safety", "push"):
        if getattr(call, name) and name not in may:
            raise ValueError("call.none")
    if call.ball and call.ball not in match.state.left:
        raise ValueError("call.down")
    if call.ball and call.ball not in balls(match):
        raise ValueError("call.ball")
    if call.cue and call.cue != match.cue_of(match.at) and "cue" not in may:
        raise ValueError("call.cue")
    if call.cue and "cue" in may and call.cue not in match.state.left:
        raise ValueError("call.down")


def balls(match: Match) -> tuple[str, ...]:
    """The balls that may be nominated, in the order in which keys go through them."""
    state = match.state
    if match.rules.key != "snooker":
        targets = match.rules.targets(match.turn)
        return targets if match.rules.key == "eight_ball" else state.left
    if state.on == COLOUR:
        return tuple(ball for ball in COLOURS if ball in state.left)
    on = state.on or RED
    return tuple(ball for ball in state.left if colour_of(ball) != on)


def after(names: tuple[str, ...], now: str, way: int) -> str:
    """The name that follows, or "" after the last one and before the first one."""
    every = ("", *names)
    return every[(every.index(now) + way) % len(every)] if now in every else every[1:][:1][0]


def with_a_cue_ball(match: Match, world: World) -> Match:
    """The match with a ball to play: where the cue ball is down (free pyramid), another one."""
    if match.rules.key != FREE_PYRAMID or match.finished or not world.ball(match.cue).gone:
        return match
    left = [ball.name for ball in world.balls if not ball.gone]
    return match.called(replace(match.call, cue=left[0])) if left else match
