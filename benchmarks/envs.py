"""Environments: steps a second, and what plain players score: at random, and the best of some."""

import os
from collections.abc import Callable
from time import process_time
from typing import Any

import gymnasium
import numpy as np

import danggu.envs as envs
from danggu.envs import hall as halls
from danggu.players import LEVELS, Level, solutions
from danggu.players.levels import MISCUE

from . import report
from .report import Report, figure

TABLES = (256, 1024, 4096)
STROKES = (40, 400, 2000)  # of each player in each game without pockets; of the others a tenth
TRIED = (1, 16, 256)  # actions that are tried before the best is played; 1: at random
NOISES = (None, "expert", "club")
COACHED = (1_000, 40_000, 40_000)  # strokes tried by the coach
ADVISED = (2, 20, 40)  # strokes of the coach in each game without pockets
POCKETS = ("danggu/EightBall-v0", "danggu/NineBall-v0", "danggu/Snooker-v0")


class Watched:
    """`simulate_many` with a clock: CPU seconds spent in it."""

    def __init__(self) -> None:
        self.spent, self.real = 0.0, halls.simulate_many

    def __call__(self, *args: Any, **given: Any) -> Any:
        start = process_time()
        found = self.real(*args, **given)
        self.spent += process_time() - start
        return found


def rates(name: str, count: int, mode: str, rounds: int) -> tuple[float, float, float]:
    """(steps, strokes, both a CPU second, share of the time in the batch)."""
    env = gymnasium.make_vec(name, num_envs=count, noise="expert", autoreset_mode=mode)
    env.reset(seed=0)
    env.action_space.seed(0)
    actions = [env.action_space.sample() for _ in range(12)]
    env.step(actions[0])  # the kernel is loaded
    halls.simulate_many = watch = Watched()
    best = (np.inf, 0, 0.0)
    try:
        for _ in range(rounds):
            watch.spent, strokes, start = 0.0, 0, process_time()
            for action in actions:
                waits = env.unwrapped._over  # of those that are only laid again
                strokes += int((~waits).sum())
                env.step(action)
            best = min(best, (process_time() - start, strokes, watch.spent))
    finally:
        halls.simulate_many = watch.real
    spent, strokes, within = best
    return count * len(actions) / spent, strokes / spent, within / spent


def coached(name: str, noise: str | None, effort: int) -> tuple[float, float, int]:
    """The same of the coach, which knows how large the noise is."""
    env = gymnasium.make(name, noise=noise, limit=50, aim="absolute").unwrapped
    level = {each.key: each for each in LEVELS}[noise or "perfect"]
    return _played(env, ADVISED[effort], lambda k: _advised(env, level, k, COACHED[effort]))


def _played(env: Any, strokes: int, choose: Callable[[int], Any]) -> tuple[float, float, int]:
    """What a player scores who chooses the action of each stroke by its number, as `scored`."""
    made, rewards, total = 0, [], 0.0
    env.reset(seed=1)
    for k in range(strokes):
        _, reward, over, late, info = env.step(choose(k))
        made, total = made + (reward > 0 or info["reason"] == "potted"), total + reward
        if over or late:
            rewards.append(total)
            total = 0.0
            env.reset()
    return made / strokes, float(np.mean(rewards)) if rewards else total, len(rewards)


def _advised(env: Any, level: Level, seed: int, budget: int) -> Any:
    """(5,): the action that is the coach's stroke; one at random where it knows none."""
    hall, action = env.hall, np.random.default_rng(seed).uniform(-1.0, 1.0, 5)
    world = hall.world.copy()
    for k, place in zip(hall.order, hall.places[0].tolist(), strict=True):
        world.balls[k].position = tuple(place)
    given = {"seed": seed, "most": 1}
    ways = solutions(world, hall.rules, hall.turn_of(0), level, budget, **given)
    if ways:
        aim, (slow, fast) = ways[0].aim, np.log(env.setup.pace)
        power = 2.0 * (np.log(aim.speed) - slow) / (fast - slow) - 1.0
        way = np.radians(aim.angle)
        action = np.array([np.cos(way), np.sin(way), power, aim.right / MISCUE, aim.up / MISCUE])
    return action


def scored(name: str, tried: int, noise: str | None, strokes: int) -> tuple[float, float, int]:
    """(share of the strokes that score, reward of an episode, episodes) of a player."""
    env = gymnasium.make(name, noise=noise, limit=50).unwrapped
    rng = np.random.default_rng(0)

    def choose(k: int) -> Any:
        actions = rng.uniform(-1.0, 1.0, (tried, 5))
        found = env.hall.tried(0, actions) if tried > 1 else None
        value = 0 if found is None else int(np.argmax(found.points + found.made - found.foul))
        return actions[value]

    return _played(env, strokes, choose)


def main(arguments: list[str] | None = None) -> int:
    options = report.options("envs", __doc__, arguments)
    page = Report("envs", "Environments", options.out)
    rows = speeds(page, options.effort)
    rows += players(page, options.effort)
    page.data(["what", "game", "how", "noise", "first", "second", "third"], rows)
    page.save()
    return 0


def speeds(page: Report, effort: int) -> list[list[Any]]:
    """The table of rates; returns its numbers."""
    page.say(
        f"Steps of `make_vec` with random actions and expert noise, CPU time of one core of"
        f" {os.cpu_count()}. Under `NextStep` a step after the end of an episode only lays the"
        " balls; under `SameStep` every step is a stroke."
    )
    lines, rows = [], []
    for name in ("danggu/ThreeCushion-v0", "danggu/FourBall-v0", "danggu/NineBall-v0"):
        count = TABLES[effort] if name not in POCKETS else TABLES[effort] // 16
        for mode in ("NextStep", "SameStep"):
            steps, strokes, share = rates(name, count, mode, 1 + effort)
            lines.append(
                [name.partition("/")[2], count, mode, f"{steps:,.0f}", f"{strokes:,.0f}",
                 f"{100 * share:.0f} %"]
            )  # fmt: skip
            rows.append(["rate", name, mode, "expert", steps, strokes, share])
    page.table(["game", "tables", "mode", "steps/s", "strokes/s", "in simulate_many"], lines)
    return rows


def players(page: Report, effort: int) -> list[list[Any]]:
    """The table of what players score; returns its numbers."""
    page.say(
        "Share of the strokes that score, and in brackets the reward of an episode: an inning, or"
        " with pockets a rack played alone, cut off after 50 strokes. *Random*: actions drawn"
        " evenly. *Best of n*: n of them are tried without noise, and the one that scores most is"
        f" played. *Coach*: the best stroke of {COACHED[effort]:,} that `danggu.players.solutions`"
        f" tries, knowing the noise; {ADVISED[effort]} strokes of it."
    )
    lines, rows = [], []
    for name in envs.IDS:
        for tried in TRIED[: 2 + (effort > 0)]:
            line = [name.partition("/")[2], "random" if tried == 1 else f"best of {tried}"]
            for noise in NOISES:
                strokes = STROKES[effort] // (10 if name in POCKETS else 1)
                share, reward, episodes = scored(name, tried, noise, strokes)
                line.append(f"{figure(100 * share)} % ({figure(reward)})")
                rows.append(["player", name, tried, str(noise), share, reward, episodes])
            lines.append(line)
        if name not in POCKETS:
            lines.append(_coach_row(name, effort, rows))
    page.table(["game", "player", "no noise", *NOISES[1:]], lines)
    return rows


def _coach_row(name: str, effort: int, rows: list[list[Any]]) -> list[str]:
    """The coach's line of the table; its numbers go into the rows."""
    line = [name.partition("/")[2], "coach"]
    for noise in NOISES:
        share, reward, episodes = coached(name, noise, effort)
        line.append(f"{figure(100 * share)} % ({figure(reward)})")
        rows.append(["player", name, "coach", str(noise), share, reward, episodes])
    return line
