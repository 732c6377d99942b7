"""Shots a second of one scene in batches: interpreted, compiled, by threads and by executor.

And how long it takes to play and judge three-cushion shots by the million.
"""

import os
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from statistics import median
from time import perf_counter, process_time
from typing import Any

import numpy as np

from danggu.__main__ import world_of
from danggu.rules import GAMES
from danggu.scores import scores
from physics import Outcomes, World, scenes, simulate_many

from . import report
from .report import Report, figure

SHOTS = (8192, 65_536, 524_288)
INTERPRETED = (64, 720, 4096)
SCORED = (2000, 100_000, 1_000_000)


def table(shots: int) -> Any:
    """(shots, 5): the fan of directions at 3 m/s, with follow and side."""
    rows = np.empty((shots, 5))
    rows[:] = 3.0, 0.0, 0.5, 0.0, 1.5
    rows[:, 1] = 360.0 / 720 * (np.arange(shots) % 720)
    return rows


@contextmanager
def cluster() -> Iterator[Executor]:
    """Dask's local cluster of two processes."""
    from distributed import Client, LocalCluster

    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
        ) as local,
        Client(local) as client,
    ):
        yield client.get_executor()


def executors(effort: int) -> dict[str, Callable[[], Any]]:
    """The executors that may do the work."""
    ways: dict[str, Callable[[], Any]] = {
        "1 thread": lambda: ThreadPoolExecutor(1),
        "2 threads": lambda: ThreadPoolExecutor(2),
    }
    if effort:
        ways["2 processes"] = lambda: ProcessPoolExecutor(2)
        ways["Dask, 2 processes"] = cluster
    return ways


def once(
    world: World, shots: Any, executor: Executor | None, compiled: bool
) -> tuple[float, float, Outcomes]:
    """(seconds on the wall, CPU seconds of this process, outcomes) of one batch."""
    wall, cpu = perf_counter(), process_time()
    outcomes = simulate_many(world, "white", shots, executor=executor, compiled=compiled)
    return perf_counter() - wall, process_time() - cpu, outcomes


def main(arguments: list[str] | None = None) -> int:
    options = report.options("batch", __doc__, arguments)
    effort = options.effort
    page = Report("batch", "Shots a second", options.out)
    world, rounds = scenes.carom(), (1, 3, 7)[effort]
    many, few = table(SHOTS[effort]), table(INTERPRETED[effort])
    seen: dict[str, list[tuple[float, float]]] = {}
    same = True
    with ExitStack() as stack:
        ways: dict[str, tuple[Any, Any, bool]] = {
            "interpreted": (few, None, False),
            "compiled": (many, None, True),
        }
        for name, executor in executors(effort).items():
            ways[f"compiled, {name}"] = (many, stack.enter_context(executor()), True)
        for shots, executor, compiled in ways.values():
            once(world, shots[: 4 * 4096], executor, compiled)  # every worker has loaded the kernel
        truth = once(world, many, None, True)[2]
        for _ in range(rounds):
            for name, (shots, executor, compiled) in ways.items():
                wall, cpu, outcomes = once(world, shots, executor, compiled)
                seen.setdefault(name, []).append((len(shots) / wall, cpu / len(shots)))
                same &= np.array_equal(outcomes.positions, truth.positions[: len(shots)])
    report_ways(page, seen, same)
    report_scored(page, SCORED[effort])
    page.save()
    return 0 if same else 1


def report_ways(page: Report, seen: dict[str, list[tuple[float, float]]], same: bool) -> None:
    """The table: wall time, since that is what several workers save."""
    base = median(rate for rate, _ in seen["compiled"])
    page.say(
        "The carom shot in 720 directions over and over, by `simulate_many`, packing and collecting"
        f" included; wall time, in turns, on {os.cpu_count()} cores. Every digit of every outcome"
        f" {'agrees' if same else 'DOES NOT AGREE'} with the compiled batch of one thread."
    )
    rows = []
    for name, rates in seen.items():
        fast = [rate for rate, _ in rates]
        cpu = min(each for _, each in rates)
        here = "–" if "processes" in name else f"{1e6 * cpu:.3g} µs"
        rows.append(
            [name, f"{max(fast):,.0f}", f"{median(fast):,.0f}", figure(median(fast) / base), here]
        )
    page.table(["how", "most, shots/s", "median", "against compiled", "CPU a shot"], rows)
    page.data(
        ["how", "shots per s", "cpu s per shot"], [[n, *r] for n, rs in seen.items() for r in rs]
    )


def report_scored(page: Report, count: int) -> None:
    """Random three-cushion shots, with their contacts and verdicts, by two threads."""
    chance, game = np.random.default_rng(1), "three-cushion"
    low, high = (1.0, -180.0, -2.0, 0.0, -4.0, 0.0), (6.0, 180.0, 4.0, 0.0, 4.0, 0.0)
    shots = chance.uniform(low, high, (count, 6))
    with ThreadPoolExecutor(2) as threads:
        wall, cpu = perf_counter(), process_time()
        found = scores(world_of("opening", game), "white", shots, GAMES[game](), executor=threads)
        wall, cpu = perf_counter() - wall, process_time() - cpu
    page.say(
        f"{count:,} random three-cushion shots from the opening position, contacts and verdicts"
        f" included, by two threads: {wall:.2f} s, {cpu:.2f} s of CPU;"
        f" {100.0 * found.made.mean():.2f} % score."
    )
