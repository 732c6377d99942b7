"""The targets: what a shot, a break, an import and a compilation cost, and what they may cost."""

import os
import subprocess
import sys
from collections.abc import Callable
from functools import partial
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from tempfile import TemporaryDirectory
from typing import Any

from physics import World, scenes
from physics.shot import NUMBERS

from . import report
from .report import ROOT, Report, duration, figure
from .timing import PASSES, Cost, in_turns, once, yardstick
from .workload import (
    BREAK,
    SINGLE,
    Batch,
    at_rest,
    break_shot,
    exact,
    fan,
    play_fan,
    play_shot,
)

Row = tuple[str, str, Cost, float]  # what, how, cost, target in seconds


def children(arguments: list[str], bytecode: Path) -> float:
    """CPU seconds of Python run with these arguments, its bytecode kept in that folder."""
    env = {**os.environ, "PYTHONPYCACHEPREFIX": str(bytecode), "PYTHONDONTWRITEBYTECODE": ""}
    before = getrusage(RUSAGE_CHILDREN)
    subprocess.run([sys.executable, *arguments], cwd=ROOT, env=env, check=True)
    after = getrusage(RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def compiled_fan(shots: int) -> Callable[[], Any]:
    """The fan of directions through the compiled kernel, many rounds of it."""
    batch = Batch(scenes.carom(), shots, struck=0)
    rows = [[getattr(shot, name) for name in NUMBERS] for shot in fan(720)]
    batch.table[:] = [rows[k % len(rows)] for k in range(shots)]
    return batch


def shots_table(effort: int) -> tuple[list[Row], Cost]:
    """The scenes of the targets, interpreted and compiled, and the yardstick, all in turns."""
    directions, repeats = (12, 72, 720)[effort], (20, 200, 2000)[effort]
    world, plays = scenes.carom(), (1, 3, 10)[effort]
    runs = {
        "yardstick": yardstick,
        "fan": partial(play_fan, world, fan(directions)),
        "break": partial(play_shot, at_rest(break_shot), "cue", BREAK, plays),
        "single": partial(play_shot, at_rest(scenes.single), "white", SINGLE, 10 * plays),
        "compiled fan": compiled_fan(10 * repeats),
        "compiled break": Batch(exact(break_shot), repeats),
        "compiled single": Batch(exact(scenes.single), 10 * repeats),
    }
    for name in runs:
        if name.startswith("compiled"):
            runs[name]()  # so that loading and compiling are not timed
    cost = in_turns(runs, (2, 5, 15)[effort])
    fan_events = play_fan(world, fan(directions)) / directions
    carom = f"carom shot, 4 balls, mean of {directions} directions ({fan_events:.1f} events)"
    rack, single = (f"{n} ({_events(m)} events)" for n, m in
                    (("break, 16 balls", break_shot), ("single ball", scenes.single)))  # fmt: skip
    rows: list[Row] = [
        (carom, "interpreted", cost["fan"].per(directions), 0.20e-3),
        (carom, "compiled", cost["compiled fan"].per(10 * repeats), 3.3e-6),
        (rack, "interpreted", cost["break"].per(plays), 6e-3),
        (rack, "compiled",
         cost["compiled break"].per(repeats), 80e-6),
        (single, "interpreted",
         cost["single"].per(10 * plays), 0.08e-3),
        (single, "compiled",
         cost["compiled single"].per(10 * repeats), 1e-6),
    ]  # fmt: skip
    return rows, cost["yardstick"]


def _events(make: Callable[[], World]) -> int:
    world = make()
    world.run()
    return len(world.log)


def worst_frame(effort: int) -> Cost:
    """The most expensive 60-Hz frame of the break: the least of several runs, frame by frame."""
    frames, runs = 60, []
    for _ in range((2, 5, 20)[effort]):
        world = break_shot()
        world.plan()
        runs.append([once(partial(world.step, 1 / 60)) for _ in range(frames)])
    least = max(min(times) for times in zip(*runs, strict=True))
    return Cost(least, sorted(max(times) for times in runs)[len(runs) // 2])


def import_cost(effort: int) -> Cost:
    """`import physics` beyond Python itself, CPU seconds, in turns."""
    bare, full = [], []
    with TemporaryDirectory() as folder:
        children(["-c", "import physics"], Path(folder))  # so that the bytecode is there
        for _ in range((2, 5, 15)[effort]):
            bare.append(children(["-c", "pass"], Path(folder)))
            full.append(children(["-c", "import physics"], Path(folder)))
    extra = sorted(b - a for a, b in zip(bare, full, strict=True))
    return Cost(min(full) - min(bare), extra[len(extra) // 2])


# in a process of its own: numba's import apart, then the kernel and its first batch
COMPILE = """
import json, logging, sys, time
logging.disable(logging.WARNING)
import numba
from benchmarks.workload import Batch, exact, scenes
start = time.process_time()
Batch(exact(scenes.carom), 1)()
print(time.process_time() - start)
"""


def compile_cost(effort: int) -> list[Cost]:
    """[cold compilation, load from the cache], CPU seconds, without the import of numba."""
    cold, warm = [], []
    for _ in range((1, 1, 3)[effort]):
        with TemporaryDirectory() as folder:
            cold.append(_compile(Path(folder)))
            warm += [_compile(Path(folder)) for _ in range((1, 2, 3)[effort])]
    return [Cost(min(s), sorted(s)[len(s) // 2]) for s in (cold, warm)]


def _compile(folder: Path) -> float:
    done = subprocess.run(
        [sys.executable, "-c", COMPILE], cwd=ROOT,
        env={**os.environ, "XDG_CACHE_HOME": str(folder)}, check=True, capture_output=True,
        text=True,
    )  # fmt: skip
    return float(done.stdout)


def main(arguments: list[str] | None = None) -> int:
    options = report.options("speed", __doc__, arguments)
    page = Report("speed", "What it costs", options.out)
    rows, stick = shots_table(options.effort)
    frame, load = worst_frame(options.effort), import_cost(options.effort)
    rows.append(("worst 60-Hz frame of the break", "interpreted", frame, 2.5e-3))
    rows.append(("`import physics` beyond Python", "interpreted", load, 30e-3))
    if options.effort:
        cold, warm = compile_cost(options.effort)
        rows.append(("first batch: compilation", "compiled", cold, 10.0))
        rows.append(("first batch: from the cache", "compiled", warm, 0.6))
    single = stick.least / PASSES
    page.say(
        "CPU time: the least and the median of runs taken in turns. A pass is one round of a fixed"
        f" loop of complex arithmetic in plain Python, {duration(single)} here: costs in passes can"
        " be compared between machines. The targets are for a quiet machine of this kind."
    )
    page.table(
        ["what", "how", "least", "median", "passes", "target", "met"],
        [
            [what, how, duration(cost.least), duration(cost.median), figure(cost.least / single),
             duration(target), "yes" if cost.least <= target else "no"]
            for what, how, cost, target in rows
        ],
    )  # fmt: skip
    page.data(
        ["what", "how", "least s", "median s", "passes", "target s"],
        [[what, how, *cost, cost.least / single, target] for what, how, cost, target in rows],
    )
    page.save()
    return 0
