"""A coach: the ways to score from a position, searched for with many strokes at once.

Aims are drawn, those that score play a knock-out with the errors of a level, and the
best stroke of each path is measured on fresh errors.  docs/players.md says how well that plays.
"""

from __future__ import annotations

from math import inf
from typing import Any

import numpy as np

from danggu.rules.verdict import Rules, Turn
from physics import World, simulate

from .bench import Bench
from .candidates import CUSHIONS, DIRECT
from .draws import draws
from .errors import SPIN, missed
from .knockout import Field, knockout
from .levels import Attempt, Level
from .opponent import LEAST
from .solution import Solution, Tip
from .tolerances import thickness, tolerance

COMPILED, INTERPRETED = 60_000, 3_000  # strokes tried: a third of a second, and a whole one
DRAWN, RACED = 0.4, 0.4  # parts of the budget; the rest measures
ENOUGH = 400  # scoring aims after which no more are drawn
PIECE = 4096  # aims that are drawn at once


def solutions(
    world: World, rules: Rules, turn: Turn, level: Level, budget: int | None = None, *,
    seed: int = 0, most: int = 8, compiled: bool | None = None,
) -> list[Solution]:  # fmt: skip
    """The ways to score that a search finds, the one that it would play first; [] if it finds none.

    Each has another path: the balls and cushions that the cue ball meets, in their order.

    world: with the balls at rest, all those of the game; it stays as it is.
    turn: whose stroke it is; `Match.turn` has it.
    level: how well the stroke is carried out.
    budget: strokes tried at most; None: 60 000 if numba is there (a third of a second), else 3 000
    (a second).
    seed: the outcome depends on it and the other arguments alone, not on time.
    most: ways that are returned at most.
    compiled: by the compiled kernel? None: where numba is installed.
    ValueError if there is no ball to play with.
    """
    bench = Bench(world, rules, turn, compiled)
    total = budget or (COMPILED if bench.compiled else INTERPRETED)
    rng = np.random.default_rng(seed)
    found = _drawn(bench, int(DRAWN * total), rng)
    if not len(found.shots):
        return []
    field = knockout(bench, found, level.or_more(LEAST), int(RACED * total), most, rng)
    copies = max(1, (total - bench.played) // len(field.shots))
    return [_measured(bench, field.take([k]), level, copies, rng) for k in range(len(field.shots))]


def _drawn(bench: Bench, count: int, rng: np.random.Generator) -> Field:
    """Aims that score, as they are meant."""
    style = CUSHIONS if bench.rules.needs(bench.turn) else DIRECT
    own = [bench.names.index(bench.turn.cue)]
    on = [k for k, b in enumerate(bench.names) if b in bench.rules.targets(bench.turn)]
    places = bench.places[None]
    found, end = Field.of(np.empty((0, 6)), []), bench.played + count
    while bench.played < end and len(found.shots) < ENOUGH:
        n = min(PIECE, end - bench.played)
        shots = draws(places[:, own[0]], places[:, on], bench.radius, style, n, rng)[0]
        tried = bench.play(shots, paths=True)
        found = found.joined(Field.of(shots[tried.made], tried.paths))
    return found.take(slice(0, ENOUGH))


def _measured(
    bench: Bench, one: Field, level: Level, copies: int, rng: np.random.Generator
) -> Solution:
    """What is known of a stroke, its share on fresh errors."""
    tried = bench.play(missed(one.shots, level, copies, bench.radius, rng))
    aim = attempt(one.shots[0])
    cue, world = bench.turn.cue, bench.world
    log = simulate(world, cue, aim.shot()).log
    decided = bench.rules.verdict(log.contacts(), bench.turn).facts.decided
    return Solution(
        path=one.paths[0], aim=aim, share=float(tried.made.mean()), copies=copies,
        gain=float(tried.gain.mean()), after=None, worth=float(one.worth[0]),
        thickness=thickness(world, cue, aim), tip=Tip.of(aim.right, aim.up, bench.radius),
        tolerance=tolerance(world, cue, aim, decided or inf),
    )  # fmt: skip


def attempt(shot: Any) -> Attempt:
    """The aim of a shot (6,) without massé."""
    speed, angle, follow, _, side, _ = shot.tolist()
    return Attempt(angle, speed, side / (SPIN * speed), follow / (SPIN * speed))
