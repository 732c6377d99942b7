"""Many shots from the command line: ranges of a shot's numbers in, a table of outcomes out."""

from __future__ import annotations

import argparse
import csv
import re
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager, nullcontext
from math import floor, isfinite, prod
from typing import TYPE_CHECKING, Any

from physics.shot import NUMBERS

from .many import MOST as CONTACTS
from .many import simulate_many

if TYPE_CHECKING:
    from physics.world import World

    from .outcomes import Outcomes

MEANING = {
    "speed": "m/s",
    "angle": "degrees, anticlockwise from +x",
    "follow": "m/s, + follow, - draw",
    "masse": "m/s, + curves right, - left",
    "side": "m/s, + right english (anticlockwise from above), - left",
    "climb": "m/s, + upward",
}
MOST = 10_000_000  # shots: the outcomes of four balls fill a gigabyte
PIECE = 200_000  # shots that are made ready at once: 50 MB
CROWD = 1024  # threads or processes: to start more would take longer than the work
REACHED = 10.0  # s: a scheduler that does not answer by then is not there
PATIENCE = 1.0  # s: what is done by then needs no bar


def add_options(one: argparse.ArgumentParser) -> None:
    """The options of `sweep` besides a scene, its laws and its engine."""
    one.add_argument("--ball", help="which ball is struck (the scene's first)")
    for name, default in zip(NUMBERS, (None, *"00000"), strict=True):
        one.add_argument(
            f"--{name}", metavar="RANGE", type=values, required=default is None, default=default,
            help=f"{MEANING[name]}: 1.5, or 1,2,3 or FROM:TO:STEP with both ends",
        )  # fmt: skip
    many = one.add_mutually_exclusive_group()
    many.add_argument("--threads", type=count, metavar="N", help="share the work")
    many.add_argument("--processes", type=count, metavar="N", help="share the work")
    many.add_argument("--dask", metavar="ADDRESS", help="a scheduler's: its cluster does the work")
    one.add_argument(
        "--contacts", type=kept, metavar="N", default=0,
        help="of each shot that --npz keeps: who hit what, and when",
    )  # fmt: skip
    one.add_argument("--csv", metavar="FILE", help="write a line a shot (- for the terminal)")
    one.add_argument("--npz", metavar="FILE", help="write NumPy arrays")


def values(text: str) -> list[float]:
    """The numbers of a range."""
    try:
        numbers = [float(number) for number in text.split(":" if ":" in text else ",")]
        if ":" not in text:
            return numbers
        low, high, step = numbers
        steps = (high - low) / step
        # products, not sums of steps: the last one is the end itself where the steps fit
        if isfinite(low) and 0.0 <= steps < MOST:
            return [low + k * step for k in range(floor(steps + 1e-9) + 1)]
    except (ValueError, ZeroDivisionError):
        pass
    raise argparse.ArgumentTypeError(f"{text!r:.60} is no number, list 1,2,3 or range FROM:TO:STEP")


def count(text: str, most: int = CROWD) -> int:
    """A number of workers."""
    if re.fullmatch(r"\d{1,9}", text) and int(text) > 0:
        if int(text) > most:
            raise argparse.ArgumentTypeError(f"{text!r} are too many: at most {most}")
        return int(text)
    raise argparse.ArgumentTypeError(f"{text!r:.60} is no whole number above zero")


def kept(text: str) -> int:
    """A number of contacts."""
    return count(text, CONTACTS)


def sweep(world: World, options: argparse.Namespace) -> str:
    """Play all shots and write what was asked for; returns a line about it."""
    import numpy as np

    from .outcomes import together

    ball = world.ball(options.ball) if options.ball else world.balls[0]
    ranges = [getattr(options, name) for name in NUMBERS]
    total = prod(map(len, ranges))
    if total > MOST:
        raise ValueError(f"{total} shots are too many: at most {MOST}")
    files = [file for file in (options.npz, options.csv) if file not in (None, "-")]
    for file in files:
        open(file, "ab").close()  # before all the work, not after it
    shots = np.stack(np.meshgrid(*ranges, indexing="ij"), axis=-1).reshape(-1, len(NUMBERS))
    with pool(options) as executor, bar(total) as progress:
        how: Any = {"contacts": options.contacts, "executor": executor, "progress": progress}
        parts = [
            simulate_many(world, ball, shots[k : k + PIECE], **how) for k in range(0, total, PIECE)
        ]
    outcomes = together(parts)
    if options.npz:
        with open(options.npz, "wb") as out:
            np.savez_compressed(out, shots=shots, **arrays(outcomes))
    if options.csv:
        write(options.csv, shots, outcomes)
    said = f"{total} shot{'s' * (total > 1)} at {ball.name}, {int(outcomes.events.sum())} events"
    return "; written to ".join([said, " and ".join(files)] if files else [said])


def pool(options: argparse.Namespace) -> Any:
    """What does the work: this thread alone, threads, processes or a cluster."""
    if options.threads:
        return ThreadPoolExecutor(options.threads)
    if options.processes:
        return ProcessPoolExecutor(options.processes)
    return cluster(options.dask) if options.dask else nullcontext()


@contextmanager
def cluster(address: str) -> Iterator[Executor]:
    """The workers of the Dask scheduler at that address; they need this package too."""
    try:
        from distributed import Client
    except ImportError:
        raise ImportError("--dask needs the extra `cluster`") from None
    with Client(address, timeout=REACHED) as client:
        yield client.get_executor()


@contextmanager
def bar(total: int) -> Iterator[Callable[[int], object] | None]:
    """A progress bar on the terminal for long runs, where tqdm is installed."""
    try:
        from tqdm import tqdm
    except ImportError:
        yield None
        return
    with tqdm(total=total, unit=" shots", unit_scale=True, delay=PATIENCE, disable=None) as shown:
        yield shown.update


def arrays(outcomes: Outcomes) -> dict[str, Any]:
    """What goes into a file of NumPy arrays, by name."""
    found: dict[str, Any] = {
        "balls": outcomes.balls, "positions": outcomes.positions, "times": outcomes.times,
        "events": outcomes.events,
    }  # fmt: skip
    if outcomes.contacts.shape[1]:
        found |= {"contacts": outcomes.contacts, "dropped": outcomes.dropped}
        found["walls"] = [name or "" for name in outcomes.walls]
    return found


def write(file: str, shots: Any, outcomes: Outcomes) -> None:
    """A line of names, then one for each shot: its six numbers, time, events, places at rest."""
    places = [f"{name} {axis}" for name in outcomes.balls for axis in "xy"]
    with nullcontext(sys.stdout) if file == "-" else open(file, "w", newline="") as out:
        rows = csv.writer(out)
        rows.writerow([*NUMBERS, "time", "events", *places])
        for shot, rest, time, events in zip(shots.tolist(), *outcomes[:3], strict=True):
            rows.writerow([*shot, float(time), int(events), *map(float, rest.flat)])
