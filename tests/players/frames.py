"""Whole frames of the computer against itself."""

from __future__ import annotations

from dataclasses import dataclass, field
from random import Random

from danggu.players.answers import answer
from danggu.players.hand import hindrance, usual
from danggu.players.levels import Level
from danggu.players.minds import mind
from danggu.players.plan import Mind, Plan
from danggu.players.spotting import settled
from danggu.rules import GAMES, RACKS
from danggu.rules.match import Match, Player
from danggu.rules.verdict import Verdict
from physics import Ball, Placed, World, simulate, tables

TABLES = {"snooker": tables.SNOOKER_12FT, "pyramid": tables.PYRAMID_12FT}


@dataclass(slots=True)
class Stroke:
    """One of a frame: the match before it, whose mind it was, what was played and came of it."""

    match: Match
    mind: Mind
    plan: Plan
    verdict: Verdict


@dataclass(slots=True)
class Frame:
    """How it went."""

    match: Match
    strokes: list[Stroke] = field(default_factory=list)
    answers: list[str] = field(default_factory=list)


def racked(game: str, seed: int = 1, target: int | None = None) -> tuple[World, Match]:
    table = TABLES.get(RACKS[game], tables.pool(9))
    world = table.world()
    match = Match.of(GAMES[game](), Player("a", target), Player("b", target))
    world.add(Ball("cue", (-0.25 * table.length, 0.0)))
    for ball in table.rack(RACKS[game], disorder=5e-5, seed=seed):
        world.add(ball)
    world.ball("cue").position = usual(world, "cue", match.state.region)
    return world, match


def thought(world: World, match: Match, level: Level, seed: int, effort: int) -> Mind:
    """A mind that has thought to the end."""
    thinker = mind(world, match, level, seed, effort)
    while not thinker.think(1.0):
        pass
    return thinker


def frame(
    game: str, levels: tuple[Level, Level], seed: int, effort: int, most: int = 300,
    target: int | None = None, alone: bool = False,
) -> Frame:  # fmt: skip
    """Played until it is decided, or for so many strokes; `alone`: while the first player stays."""
    world, match = racked(game, seed, target)
    before, rng = world, Random(seed)
    played = Frame(match)
    while not match.finished and len(played.strokes) < most:
        number = len(played.strokes) + 1000 * seed
        level = levels[match.at]
        if match.asked is not None:
            key = answer(world, match, level)
            played.answers.append(key)
            option, match = match.asked.option(key), match.answered(key)
            world = before if option.restore else world
            match = settled(world, match, option.spot, option.rack, number)
            continue
        thinker = thought(world, match, level, number, effort)
        before = placed(world, match, thinker.plan)
        plan = thinker.played(rng)
        match = match.called(plan.call)
        world = simulate(before, match.cue, plan.shot)
        verdict = match.judged(world.log.contacts())
        played.strokes.append(Stroke(match, thinker, plan, verdict))
        match = settled(world, match.after(verdict), verdict.spot, verdict.rack, number)
        played.match = match
        if alone and match.at:
            break
    return played


def placed(world: World, match: Match, plan: Plan) -> World:
    """The world with the cue ball where the plan has it."""
    if plan.place is not None:
        assert hindrance(world, match.cue, plan.place, match.state.region) is None
        world.ball(match.cue).placed = Placed(complex(*plan.place))
    return world
