"""The ways to pot: strokes at each ball and pocket that a player sees, tried many at once."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from math import degrees, radians
from typing import Any, NamedTuple

import numpy as np

from danggu.rules.match import Match, Player
from danggu.rules.verdict import Rules, Turn
from physics import World, heading

from .bench import Bench
from .chances import Eye, Route
from .declaring import declared
from .draws import spread
from .errors import SPIN, attempt, missed
from .knockout import Contenders, knockout
from .levels import Level
from .lies import lie_and_targets
from .opponent import LEAST
from .potting import FASTEST, speed_for
from .solution import Solution, Tip
from .tolerances import into, thickness, tolerance, tried

KEPT = 200  # contacts of a stroke: of nearly every one but a break
THROWN = radians(5.0)  # by which a hit turns the object ball at most
FURTHER, FASTER = 0.5, 5.0  # the tip's farthest offset, radii, and the fastest of the slowest speed
LOOKED = 12  # positions that are looked at
DRAWN, RACED, MEASURED = 0.35, 0.4, 1_000  # parts of the budget, and copies at most


class PotSearch(NamedTuple):
    """What pots are looked for on.

    world: with the balls.
    match: how the game stands.
    eye: of the player.
    compiled: as `solutions` has it.
    """

    world: World
    match: Match
    eye: Eye
    compiled: bool | None


def pot_ways(
    world: World, rules: Rules, turn: Turn, level: Level, budget: int, most: int,
    compiled: bool | None, rng: np.random.Generator,
) -> list[Solution]:  # fmt: skip
    """The ways to pot, the one first after which most is to be expected; ValueError without
    pockets."""
    if world.table is None or world.table.pockets is None:
        raise ValueError(f"a table with pockets is needed for {rules.key}")
    names = [Player(str(k)) for k in range(turn.players)]
    match = replace(Match.of(rules, *names), state=turn.state, at=turn.player, call=turn.call)
    here = PotSearch(world, match, Eye(world.table, level), compiled)
    lie, targets = lie_and_targets(world, match)
    cue = complex(*world.ball(turn.cue).position)
    routes = sorted(here.eye.ways(cue, lie, targets), key=lambda way: -way.chance)[:most]
    found = [_way(here, turn, way, level, budget // len(routes), rng) for way in routes]
    return sorted((way for way in found if way), key=lambda way: -way.worth)


def _way(
    here: PotSearch, turn: Turn, way: Route, level: Level, budget: int, rng: np.random.Generator
) -> Solution | None:
    """The best stroke that pots that ball there; None if none does."""
    pocket = way.opening.hole.name
    turn = replace(turn, call=declared(here.match, way.ball, pocket))
    bench = Bench(here.world, here.match.rules, turn, here.compiled, kept=KEPT)
    bench.pot = way.ball, pocket
    shots = _draws(bench, way, int(DRAWN * budget), rng)
    good = bench.play(shots, paths=True)
    if not good.made.any():
        return None
    field, error = Contenders.of(shots[good.made], good.paths), level.or_more(LEAST)
    one = knockout(bench, field, error, int(RACED * budget), 1, rng).take([0])
    copies = max(1, min(MEASURED, int((1.0 - DRAWN - RACED) * budget)))
    done = bench.play(missed(one.shots, level, copies, bench.radius, rng))
    after, share = _after(here, bench, one.shots, error, rng), float(one.worth[0])
    cue, aim = turn.cue, attempt(one.shots[0])
    linear = tolerance(here.world, cue, aim, into(cue, way))
    return Solution(
        path=bench.pot, aim=aim, share=float(done.made.mean()), copies=copies,
        gain=float(done.gain.mean()), after=after,
        worth=share * (1.0 + (after or 0.0)), thickness=thickness(here.world, cue, aim),
        tip=Tip.of(aim.right, aim.up, bench.radius),
        tolerance=linear and tried(bench, aim, linear), call=turn.call,
    )  # fmt: skip


def _draws(bench: Bench, way: Route, count: int, rng: np.random.Generator) -> Any:
    """(count, 6) shots at that ball."""
    even = spread(1, count, rng)[0]
    line = way.ghost - complex(*bench.world.ball(bench.turn.cue).position)
    turns = way.run / (2.0 * bench.radius * way.cut)  # of the ball, a degree of the aim
    aside = degrees(way.opening.half + THROWN) / turns
    slow = speed_for(bench.world, way)
    speed = np.minimum(FASTEST, slow * FASTER ** even[:, 3])
    out, around = FURTHER * np.sqrt(even[:, 4]), 2.0 * np.pi * even[:, 5]
    angle, none = heading(line) + aside * (2.0 * even[:, 0] - 1.0), np.zeros(count)
    up, right = SPIN * speed * out * np.sin(around), SPIN * speed * out * np.cos(around)
    return np.stack([speed, angle, up, none, right, none], axis=1)


def _after(
    here: PotSearch, bench: Bench, shots: Any, level: Level, rng: np.random.Generator
) -> float | None:
    """How likely the next pot is, as the player sees it, in the positions that the stroke leaves
    when it scores; None where it wins, or where none has."""
    copies = missed(shots, level, 2 * LOOKED, bench.radius, rng)
    seen = [*_outlooks(here, bench, copies)][:LOOKED]
    return float(np.mean(seen)) if seen else None


def _outlooks(here: PotSearch, bench: Bench, shots: Any) -> Iterator[float]:
    match = here.match.called(bench.turn.call)
    for places, verdict in bench.verdicts(shots):
        then = match.after(verdict)
        if not verdict.made or then.finished or then.asked is not None:
            continue
        lie = {
            name: complex(*at)
            for name, at in zip(bench.names, places.tolist(), strict=True)
            if at[0] == at[0]
        }
        cue = lie.pop(then.cue, None)
        on = [name for name in then.rules.targets(then.turn) if name in lie]
        if cue is not None:
            yield max((way.chance for way in here.eye.ways(cue, lie, on)), default=0.0)
