"""Whole frames of the computer against itself, with a hand that spots and racks the balls."""

from __future__ import annotations

from dataclasses import dataclass, field
from math import dist
from random import Random

from danggu.players.answers import answer
from danggu.players.hand import GAP, hindrance, usual
from danggu.players.levels import Level
from danggu.players.minds import mind
from danggu.players.plan import Mind, Plan
from danggu.rules import GAMES, RACKS
from danggu.rules.match import Match, Player
from danggu.rules.spots import along, colour_spots
from danggu.rules.verdict import Verdict
from physics import Ball, Placed, World, simulate, tables

TABLES = {"snooker": tables.SNOOKER_12FT, "pyramid": tables.PYRAMID_12FT}
COLOURS = ("yellow", "green", "brown", "blue", "pink", "black")


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
            settle(world, match, option.spot, option.rack, number)
            continue
        thinker = thought(world, match, level, number, effort)
        before = placed(world, match, thinker.plan)
        plan = thinker.played(rng)
        match = match.called(plan.call)
        world = simulate(before, match.cue, plan.shot)
        verdict = match.judged(world.log.contacts())
        played.strokes.append(Stroke(match, thinker, plan, verdict))
        played.match = match = match.after(verdict)
        settle(world, match, verdict.spot, verdict.rack, number)
        if alone and match.at:
            break
    return played


def placed(world: World, match: Match, plan: Plan) -> World:
    """The world with the cue ball where the plan has it."""
    if plan.place is not None:
        assert hindrance(world, match.cue, plan.place, match.state.region) is None
        world.ball(match.cue).placed = Placed(complex(*plan.place))
    return world


def settle(world: World, match: Match, spot: tuple[str, ...], rack: int, seed: int) -> None:
    """Take off what is down, spot and rack what the rules say."""
    if rack:
        _rack(world, match, rack, seed)
    for ball in world.balls:
        if ball.name not in (*match.state.left, "cue") and not ball.gone:
            ball.placed = Placed(complex(*ball.position), height=-2.0)
    for name in dict.fromkeys((*spot, *match.state.left)):
        if name in match.state.left and world.ball(name).gone:
            _spot(world, name)
    cue = world.ball("cue")
    if match.state.region and cue.gone and not match.finished:
        cue.placed = Placed(complex(*usual(world, "cue", match.state.region)))


def _rack(world: World, match: Match, rack: int, seed: int) -> None:
    """Where the cue ball or the last ball would be in the way, it is put elsewhere."""
    table = world.table
    game = next(name for name, kind in RACKS.items() if GAMES[name]().key == match.rules.key)
    balls = table.rack(RACKS[game], disorder=5e-5, seed=seed)
    stays = [b for b in world.balls if b.name != "cue" and not b.gone] if rack == 14 else []
    racked = [ball for ball in balls if ball.name not in {b.name for b in stays}]
    places = sorted(ball.position for ball in balls)[-len(racked) :]
    for ball in racked:
        world.ball(ball.name).placed = Placed(complex(0.0, 0.0), height=-2.0)
    for ball, at in zip(racked, places, strict=True):
        world.ball(ball.name).placed = Placed(complex(*at))
    for name in ("cue", *(b.name for b in stays)):
        ball = world.ball(name)
        if not ball.gone and any(dist(ball.position, at) < 2 * ball.radius + GAP for at in places):
            ball.placed = Placed(complex(*usual(world, name, "kitchen")))


def _spot(world: World, name: str) -> None:
    table = world.table
    others = [b.position for b in world.balls if not b.gone and b.name != name]
    spots, near = table.spots, 2 * table.radius + GAP
    start = spots.get(name, spots.get("foot"))
    if name in COLOURS:
        taken = [c for c in COLOURS if any(dist(at, spots[c]) < near for at in others)]
        start = spots[colour_spots((name,), taken)[name] or name]
    end = 0.5 * table.length - table.radius
    at = along(start, (end, start[1]), others, near) or along(start, (-end, start[1]), others, near)
    world.ball(name).placed = Placed(complex(*at))
