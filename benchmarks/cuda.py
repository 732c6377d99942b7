"""The graphics card: is every bit the CPU's, and how many shots does it play a second?

Without a card it only compiles, for compute capability 9.0, and says what the code needs. Needs the
extra `cuda`. With a card it takes about three minutes.
"""

import subprocess
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from importlib.metadata import files
from pathlib import Path
from time import perf_counter, process_time
from typing import Any
from unittest.mock import patch

import numpy as np

from physics import Ball, Outcomes, World, laws, scenes, simulate_many, tables

from . import report
from .report import Report, duration

CAPABILITY = (9, 0)
SHOTS = (2, 10_000, 100_000)
TIMED = (2, 100_000, 1_000_000)


def mathavan() -> World:
    world = scenes.carom()
    world.cushion_law = laws.MathavanCushion()
    return world


def break_shot() -> World:
    """Fifteen balls that touch, and pockets."""
    world = tables.pool_9ft()
    for ball in world.table.rack("8-ball"):
        world.add(ball)
    world.add(Ball("cue", at=(-0.7, 0.01)))
    return world


def crowd() -> World:
    """As many balls as have cells."""
    world = tables.snooker_12ft()
    for k in range(36):
        world.add(Ball(f"{k}", at=(-1.5 + 0.26 * (k % 12), -0.5 + 0.45 * (k // 12))))
    return world


SCENES: dict[str, tuple[Callable[[], World], str, float]] = {
    "carom": (scenes.carom, "white", 1.0),
    "Mathavan's cushion": (mathavan, "white", 0.2),
    "8-ball break, pockets": (break_shot, "cue", 0.05),
    "36 balls, cells": (crowd, "0", 0.02),
}
"""World, ball, and which part of the shots is played."""


def shots(count: int) -> Any:
    """(count, 6): directions, speeds and spins at random, one in eight a jump."""
    chance = np.random.default_rng(12)
    low, high = (0.5, -180.0, -3.0, -1.0, -3.0, -7.0), (7.0, 180.0, 3.0, 1.0, 3.0, 1.0)
    table = chance.uniform(low, high, (count, 6))
    table[:, 5] = np.maximum(table[:, 5], 0.0)
    return table


def differing(ours: Outcomes, theirs: Outcomes) -> int:
    """Of how many shots any bit differs."""
    wrong = np.zeros(len(ours.times), bool)
    for a, b in zip(ours.part, theirs.part, strict=True):
        if a.size:
            a, b = (np.ascontiguousarray(x).view(np.uint8).reshape(len(a), -1) for x in (a, b))
            wrong |= (a != b).any(axis=1)
    return int(wrong.sum())


@contextmanager
def pretended() -> Iterator[None]:
    """numba takes it that there is a card, so that it compiles."""
    from numba.cuda import dispatcher

    class Card:
        compute_capability = CAPABILITY

    with patch.object(dispatcher, "get_current_device", Card):
        yield


def ptx() -> str:
    """The kernel in the card's language; no card is needed."""
    import numba
    from numba import cuda

    from physics.batch import card
    from physics.batch.outcomes import Part

    world = scenes.carom()
    world.plan()
    n = len(world.balls)
    part = Part.room(1, n, 1)
    given = np.empty((1, 6)), np.empty((1, n, 2)), np.empty((n, 9)), 0, 0, 0, 0
    own, shared = card.lanes(world.scene)
    arguments = [*given, *part, *(row[None] for row in own), *shared]
    signature = numba.void(*map(numba.typeof, arguments))
    with pretended(), card.unfused():
        play = card.kernel().py_func
        text, _ = cuda.compile(play, signature, device=False, abi="numba", cc=CAPABILITY)
    return str(text)


def assembled(text: str, folder: Path) -> list[str]:
    """What the assembler says that the kernel needs: registers, stack and spills; nothing without
    an assembler."""
    found = [f for f in files("nvidia-cuda-nvcc-cu12") or [] if f.name in ("ptxas", "ptxas.exe")]
    source = folder / "kernel.ptx"
    source.write_text(text)
    if not found:
        return []
    arch = f"-arch=sm_{CAPABILITY[0]}{CAPABILITY[1]}"
    words = [str(found[0].locate()), "-v", arch, "-o", str(folder / "kernel.cubin"), str(source)]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    lines = done.stderr.splitlines()
    entry = next(k for k, line in enumerate(lines) if "Compiling entry function" in line)
    return [line.removeprefix("ptxas info    : ").strip() for line in lines[entry + 2 : entry + 4]]


def main(arguments: list[str] | None = None) -> int:
    options = report.options("cuda", __doc__, arguments)
    from numba import cuda

    page = Report("cuda", "A graphics card beside the CPU", options.out)
    if not cuda.is_available():
        page.say("No CUDA device here: nothing was run.")
        compiled(page)
        return 0
    card = getattr(cuda.get_current_device(), "name", "numba's simulator")
    page.say(f"{card.decode() if isinstance(card, bytes) else card}.")
    wrong = check(page, SHOTS[options.effort])
    race(page, TIMED[options.effort])
    page.save()
    return 1 if wrong else 0


def compiled(page: Report) -> None:
    from tempfile import TemporaryDirectory

    start = process_time()
    text = ptx()
    spent = process_time() - start
    with TemporaryDirectory() as folder:
        needs = "; ".join(assembled(text, Path(folder)))
    fused = text.count("fma.rn.f64")
    page.say(f"It compiles in {duration(spent)}, with {fused} fused products. {needs}")


def check(page: Report, count: int) -> int:
    """How many shots are not the CPU's in every bit."""
    rows, wrong = [], 0
    for name, (make, ball, part) in SCENES.items():
        world, table = make(), shots(max(1, int(part * count)))
        start = perf_counter()
        theirs = simulate_many(world, ball, table, contacts=64, device="cuda")
        spent = perf_counter() - start
        ours = simulate_many(world, ball, table, contacts=64, compiled=True)
        differ = differing(ours, theirs)
        wrong += differ
        rows.append([name, len(table), int(ours.events.sum()), differ, duration(spent)])
    page.table(["scene", "shots", "events", "shots that differ", "time, with compiling"], rows)
    return wrong


def race(page: Report, count: int) -> None:
    """Shots a second, the best of three rounds each."""
    rows, data = [], []
    for name, (make, ball, part) in SCENES.items():
        world, table = make(), shots(max(1, int(part * count)))
        best = {}
        for device in ("cpu", "cuda") * 3:
            how: dict[str, Any] = {"compiled": True} if device == "cpu" else {"device": device}
            start = perf_counter()
            simulate_many(world, ball, table, **how)
            best[device] = max(best.get(device, 0.0), len(table) / (perf_counter() - start))
        rates = best["cpu"], best["cuda"]
        rows.append([name, len(table), *(f"{rate:,.0f}" for rate in rates), rates[1] / rates[0]])
        data.append([name, len(table), *rates])
    page.table(["scene", "shots", "CPU, one thread, shots/s", "card, shots/s", "ratio"], rows)
    page.data(["scene", "shots", "CPU shots per s", "card shots per s"], data)
