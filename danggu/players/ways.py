"""A coach: the ways to score from a position, searched for with many strokes at once.

Aims are drawn, those that score play a knock-out with the errors of a level, and the
best stroke of each path is measured on fresh errors.  docs/players.md says how well that plays.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from math import inf

import numpy as np

from danggu.rules.verdict import Rules, Turn
from physics import World, simulate

from .ahead import Ahead, looked
from .bench import Bench
from .candidates import CUSHIONS, DIRECT, Style
from .draws import draws
from .errors import attempt, missed
from .knockout import Contenders, first_of_each, knockout
from .levels import Level, level_of
from .opponent import LEAST
from .pot_ways import pot_ways
from .solution import Solution, Tip
from .spotting import KINDS
from .tolerances import thickness, tolerance, tried, until

COMPILED, INTERPRETED = 160_000, 3_000  # strokes tried: less than a second, and a second or two
AHEAD = 40_000  # strokes from which on positions are looked at
# Parts of the budget for drawing aims, for the knock-out and for positions, below that number and
# from it on; the rest measures.
ONE, TWO = (0.4, 0.45, 0.0), (0.12, 0.15, 0.63)
SLOWER = 8  # times as long as in other games a stroke takes with pockets and their rules
ENOUGH = 600  # scoring aims after which no more are drawn
PATHS = 8  # in the knock-out, at least
WITNESSES = 40  # copies of a stroke that show by which path it mostly scores
MEASURED = 2_000  # fresh copies of a stroke at most
PIECE = 4096  # aims that are drawn at once
FURTHER = 0.5  # radii: the tip's distance from the centre, to which the best strokes go


def solutions(
    world: World, rules: Rules, turn: Turn, level: Level | str, budget: int | None = None, *,
    seed: int = 0, most: int = 8, plies: int = 2, compiled: bool | None = None,
) -> list[Solution]:  # fmt: skip
    """The ways to score that a search finds, the one that it would play first; [] if it finds none.

    Each has another path: the balls and cushions that the cue ball meets, in their order; with
    pockets the ball that is potted and its pocket.

    world: with the balls at rest, all those of the game; it stays as it is.
    turn: whose stroke it is; `Match.turn` has it.
    level: how well the stroke is carried out: a `Level`, or the key of one, as "expert".
    budget: strokes tried, about; None: 160 000, with pockets 20 000, if numba is there (under a
    second), else 3 000 (a second or two).
    seed: from 0 on; the outcome depends on it and the other arguments alone, not on time.
    most: ways that are returned at most.
    plies: 2, the positions that a stroke leaves count too, if the budget is 40 000 at least; 1,
    they do not.
    compiled: by the compiled kernel (ImportError without numba)? None: where numba is installed.
    ValueError without a ball to play with, if one moves, and for a number that is none.
    """
    _check(world, rules, turn, budget, most, plies, seed)
    bench, rng = Bench(world, rules, turn, compiled), np.random.default_rng(seed)
    total, level = budget or (COMPILED if bench.compiled else INTERPRETED), level_of(level)
    if rules.key in KINDS:
        total = budget or (COMPILED // SLOWER if bench.compiled else INTERPRETED)
        return pot_ways(world, rules, turn, level, total, most, bench.compiled, rng)
    drawn, raced, looks = (int(part * total) for part in (TWO if total >= AHEAD else ONE))
    found = _drawn(bench, drawn, rng)
    if not len(found.shots):
        return []
    error = level.or_more(LEAST)
    running = Ahead(knockout(bench, found, error, raced, max(most, PATHS), rng))
    if plies > 1 and looks and not _last(bench, running.field):
        score = replace(turn, opening=False, score=turn.score + 1)
        then = Bench(world, rules, score, bench.compiled)
        running = looked(running.field, bench, then, _style(then), error, looks, rng)
    rows = _distinct(bench, running, error, most, rng)
    copies = max(1, min(MEASURED, (total - drawn - raced - looks) // len(rows)))
    return [_measured(bench, running, row, level, copies, rng) for row in rows]


def _check(
    world: World, rules: Rules, turn: Turn, budget: int | None, most: int, plies: int, seed: int
) -> None:
    if isinstance(rules, type | str) or not isinstance(turn, Turn):
        raise ValueError("solutions needs rules such as GAMES['three-cushion'](), and a Turn")
    if not world.at_rest:
        raise ValueError("solutions needs a world whose balls are at rest")
    for name, number in (("budget", 1 if budget is None else budget), ("most", most)):
        if type(number) is not int or number < 1:
            raise ValueError(f"solutions {name} must be a whole number above 0, not {number!r:.60}")
    if plies not in (1, 2):
        raise ValueError(f"solutions plies must be 1 or 2, not {plies!r:.60}")
    if type(seed) is not int or seed < 0:
        raise ValueError(f"solutions seed must be a whole number from 0 on, not {seed!r:.60}")


def _style(bench: Bench) -> Style:
    style = CUSHIONS if bench.rules.needs(bench.turn) else DIRECT
    return replace(style, tip=FURTHER)


def _drawn(bench: Bench, count: int, rng: np.random.Generator) -> Contenders:
    """Aims that score, as they are meant."""
    places, style = bench.places[None], _style(bench)
    found, end = Contenders.of(np.empty((0, 6)), []), bench.played + count
    while bench.played < end and len(found.shots) < ENOUGH:
        n = min(PIECE, end - bench.played)
        shots = draws(places[:, bench.own], places[:, bench.on], bench.radius, style, n, rng)[0]
        tried = bench.play(shots, paths=True)
        found = found.joined(Contenders.of(shots[tried.made], tried.paths))
    return found.take(slice(0, ENOUGH))


def _last(bench: Bench, field: Contenders) -> bool:
    """Whether the best of them wins: what it leaves does not matter."""
    log = simulate(bench.world, bench.turn.cue, attempt(field.shots[0]).shot()).log
    return bench.rules.verdict(log.contacts(), bench.turn).won


def _distinct(
    bench: Bench, running: Ahead, level: Level, most: int, rng: np.random.Generator
) -> list[int]:
    """The best of each path, but for those which mostly score by the path of another."""
    field = running.field
    rows = first_of_each(field.paths, np.argsort(-running.worth, kind="stable").tolist())[:most]
    kept = rows[:1]
    for row in rows[1:]:
        shots = missed(field.shots[row][None], level, WITNESSES, bench.radius, rng)
        common = Counter(bench.play(shots, paths=True).paths).most_common(1)
        if not common or common[0][0] not in {field.paths[other] for other in rows if other != row}:
            kept.append(row)
    return kept


def _measured(
    bench: Bench, running: Ahead, row: int, level: Level, copies: int, rng: np.random.Generator
) -> Solution:
    """What is known of a stroke, its share on fresh errors."""
    shot, after = running.field.shots[row], running.after[row] if running.count[row] else np.nan
    copied = bench.play(missed(shot[None], level, copies, bench.radius, rng))
    aim, cue, world = attempt(shot), bench.turn.cue, bench.world
    log = simulate(world, cue, aim.shot()).log
    decided = bench.rules.verdict(log.contacts(), bench.turn).facts.decided
    linear = tolerance(world, cue, aim, until(cue, decided or inf))
    return Solution(
        path=running.field.paths[row], aim=aim, share=float(copied.made.mean()), copies=copies,
        gain=float(copied.gain.mean()), after=None if np.isnan(after) else float(after),
        worth=float(running.worth[row]), thickness=thickness(world, cue, aim),
        tip=Tip.of(aim.right, aim.up, bench.radius),
        tolerance=linear and tried(bench, aim, linear),
    )  # fmt: skip
