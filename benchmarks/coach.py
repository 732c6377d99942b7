"""The coach: how often it finds a way, whether its shares hold, and what each level scores."""

from math import sqrt
from time import process_time
from typing import Any, NamedTuple

import numpy as np

from danggu.players import Solution, solutions
from danggu.players.errors import missed
from danggu.players.levels import CLUB, EXPERT, MASTER, NOVICE, PERFECT, Level
from danggu.rules import GAMES, Turn
from physics import Ball, World, simulate_many, tables

from . import report
from .report import Report, figure

POSITIONS = (3, 30, 200)  # of three-cushion, at random
INNINGS = 200  # of a player at most
# Players: the game, a level, how many plies it looks ahead, and strokes at most.
THREE = "three-cushion"
PLAYERS = (
    (THREE, EXPERT, 1, 800), (THREE, EXPERT, 2, 200), (THREE, MASTER, 1, 40),
    (THREE, MASTER, 2, 40), (THREE, NOVICE, 2, 40), (THREE, CLUB, 2, 40), (THREE, PERFECT, 2, 10),
)  # fmt: skip
HEADS = (
    "game", "level", "plies", "innings", "strokes", "points", "average", "high run", "share",
    "expected", "s",
)  # fmt: skip
PARTS = (0.02, 0.1, 1.0)  # of these strokes
BUDGETS = (1500, None, None)  # strokes tried for each
LONGEST = 50  # strokes of an inning
COPIES = 400  # of a stroke, to see whether its share holds
GAP = 1e-4  # m, between balls that are laid at random


class Baize:
    """A table of a game, on which balls are laid."""

    def __init__(self, game: str) -> None:
        self.rules = GAMES[game]()
        self.world = tables.medium_carom() if game == "four-ball" else tables.match_carom()
        self.names = self.rules.balls
        for k, name in enumerate(self.names):
            self.world.add(Ball(name, at=(0.2 * k, 0.0)))
        table = self.world.table
        self.half = 0.5 * np.array([table.length, table.width]) - table.radius
        self.reach = 2 * table.radius + GAP

    def random(self, rng: np.random.Generator) -> Any:
        """(balls, 2) m: all of them anywhere."""
        while True:
            found = rng.uniform(-self.half, self.half, (len(self.names), 2))
            apart = found[:, None] - found[None]
            near = np.hypot(apart[..., 0], apart[..., 1])[np.triu_indices(len(found), 1)]
            if near.min() > self.reach:
                return found

    def laid(self, places: Any) -> World:
        """The world with the balls there."""
        copy = self.world.copy()
        for ball, at in zip(copy.balls, places.tolist(), strict=True):
            ball.position = tuple(at)
        return copy

    def play(self, places: Any, shots: Any) -> tuple[Any, Any]:
        """Which of the shots score, and where the balls lie afterwards."""
        many = np.repeat(places[None], len(shots), axis=0)
        done = simulate_many(self.world, self.names[0], shots, positions=many, contacts=64)
        return self.rules.verdicts(done, Turn(self.names[0])).made, done.positions


def row(way: Solution) -> Any:
    """(1, 6): its shot as `simulate_many` takes it."""
    shot = way.shot
    return np.array([[shot.speed, shot.angle, shot.follow, 0.0, shot.side, 0.0]])


class Spell(NamedTuple):
    """What was played.

    innings, points, strokes: how many.
    best: the high run.
    share: mean of the shares that were expected.
    expected: points an inning, as the shares have it: less a matter of chance than the points.
    error: its standard deviation, of the strokes.
    seconds: of CPU time for each stroke.
    """

    innings: int
    points: int
    strokes: int
    best: int
    share: float
    expected: float
    error: float
    seconds: float


def sat(game: str, level: Level, innings: int, strokes: int, **search: Any) -> Spell:
    """Innings of one player, each from a position at random."""
    table, runs, shares = Baize(game), [], []
    radius, start = table.world.table.radius, process_time()
    while len(runs) < innings and len(shares) < strokes:
        rng = np.random.default_rng([1, len(runs)])
        places, run = table.random(rng), 0
        while run < LONGEST and len(shares) < strokes:
            ways = solutions(
                table.laid(places), table.rules, Turn(table.names[0]), level,
                seed=int(rng.integers(2**31)), most=1, **search,
            )  # fmt: skip
            shares.append(ways[0].share if ways else 0.0)
            if not ways:
                break
            made, after = table.play(places, missed(row(ways[0]), level, 1, radius, rng))
            places = after[0]
            if not made[0] or not np.isfinite(places).all():
                break
            run += 1
        runs.append(run)
    return summed(runs, shares, process_time() - start)


def summed(runs: list[int], shares: list[float], spent: float) -> Spell:
    share, n = float(np.mean(shares)), len(shares)
    error = float(np.std(shares)) / sqrt(n)
    miss = max(1.0 - share, 1e-9)
    return Spell(
        len(runs), sum(runs), n, max(runs), share, share / miss, error / miss**2, spent / n
    )


class Held(NamedTuple):
    """A way that was found at a position, and what it came to when it was replayed.

    seconds: CPU time of the search.
    share, copies: as it says.
    made: how many of COPIES new strokes scored.
    """

    seconds: float
    share: float
    copies: int
    made: int

    @property
    def off(self) -> float:
        """By how many standard deviations the two shares differ, both being of finite numbers."""
        both = (self.share * self.copies + self.made) / (self.copies + COPIES)
        spread = both * (1.0 - both) * (1.0 / self.copies + 1.0 / COPIES)
        return (self.made / COPIES - self.share) / sqrt(spread) if spread else 0.0


def replayed(number: int, budget: int | None) -> Held | None:
    """The first way of an expert at three-cushion position `number`; None if none was found."""
    table, rng = Baize(THREE), np.random.default_rng([2, number])
    places, start = table.random(rng), process_time()
    world = table.laid(places)
    ways = solutions(world, table.rules, Turn(), EXPERT, budget, seed=number, most=1)
    spent = process_time() - start
    if not ways:
        return None
    shots = missed(row(ways[0]), EXPERT, COPIES, table.world.table.radius, rng)
    made = int(table.play(places, shots)[0].sum())
    return Held(spent, ways[0].share, ways[0].copies, made)


def positions(page: Report, effort: int) -> list[list[Any]]:
    """Whether there is a way, how long the search takes and whether its share holds."""
    replayed(0, BUDGETS[0])  # the kernel is loaded
    tried = [replayed(k, BUDGETS[effort]) for k in range(POSITIONS[effort])]
    found = [one for one in tried if one is not None]
    n, times = len(found), [one.seconds for one in found]
    middle, longest = float(np.median(times)), max(times)
    share = float(np.mean([one.share for one in found]))
    squares = sum(one.off**2 for one in found)
    pooled = sum(one.made / COPIES - one.share for one in found) / n
    spread = sqrt(sum(one.share * (1 - one.share) * (1 / one.copies + 1 / COPIES) for one in found))
    page.say(
        f"{len(tried)} three-cushion positions at random, an expert to play: a way was found in"
        f" {n} of them, in {figure(middle)} s of CPU time (the median; the longest"
        f" {figure(longest)} s). The first way of each was replayed {COPIES} times with new errors:"
        f" its share of {figure(share)} on average came out {figure(abs(pooled))}"
        f" {'higher' if pooled > 0.0 else 'lower'}, which is"
        f" {figure(abs(pooled) * n / spread)} standard deviations; the squares of the {n}"
        f" differences, in standard deviations, add up to {figure(squares)}, where {n} ±"
        f" {figure(sqrt(2 * n))} are to be expected."
    )
    numbers = len(tried), n, share, pooled, spread / n, squares, longest, middle
    return [["positions", EXPERT.key, 2, *numbers]]


def averages(page: Report, effort: int) -> list[list[Any]]:
    """What each level scores in three-cushion, and what the positions are worth that it leaves."""
    page.say(
        f"Each inning from a position at random, {INNINGS} innings or so many"
        f" strokes, no inning longer than {LONGEST}; both players look for a stroke among as many"
        " aims, and with two plies also at the positions that it leaves. *Expected* is what the"
        " shares of the strokes say, Σ share / Σ (1 − share): less a matter of chance than the"
        " points that were made."
    )
    lines, rows = [], []
    for game, level, plies, strokes in PLAYERS:
        most = max(2, int(PARTS[effort] * strokes))
        one = sat(game, level, INNINGS, most, plies=plies, budget=BUDGETS[effort])
        print(game, level.key, plies, one, flush=True)
        made = f"{figure(one.points / one.innings)}"
        expected = f"{figure(one.expected)} ± {figure(one.error, 2)}" if one.error else "–"
        lines.append(
            [game, level.key, plies, one.innings, one.strokes, one.points, made, one.best,
             one.share, expected, one.seconds]
        )  # fmt: skip
        rows.append([game, level.key, plies, *one])
    page.table(HEADS, lines)
    return rows


def main(arguments: list[str] | None = None) -> int:
    options = report.options("coach", __doc__, arguments)
    page = Report("coach", "Coach", options.out)
    rows = positions(page, options.effort)
    page.save()
    rows += averages(page, options.effort)
    page.data(["what", "level", "plies", *"abcdefgh"], rows)
    page.save()
    return 0
