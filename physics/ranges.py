"""Shots from the command line: ranges of their numbers, what does the work, and how far it is."""

from __future__ import annotations

import argparse
import re
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from contextlib import contextmanager, nullcontext
from math import floor, isfinite, prod
from typing import Any

from .batch.many import MOST as CONTACTS
from .shot import NUMBERS

MEANING = {
    "speed": "m/s",
    "angle": "degrees, anticlockwise from +x",
    "follow": "m/s, + follow, - draw",
    "masse": "m/s, + curves right, - left",
    "side": "m/s, + right english (anticlockwise from above), - left",
    "climb": "m/s, + upward",
}
MOST = 10_000_000  # shots: the outcomes of four balls fill a gigabyte
CROWD = 1024  # threads or processes: to start more would take longer than the work
REACHED = 10.0  # s: a scheduler that does not answer by then is not there
PATIENCE = 1.0  # s: what is done by then needs no bar


def add_ranges(one: argparse.ArgumentParser) -> None:
    """An option for each number of a shot; `grid` makes the shots of them."""
    for name, default in zip(NUMBERS, (None, *"00000"), strict=True):
        one.add_argument(
            f"--{name}", metavar="RANGE", type=values, required=default is None, default=default,
            help=f"{MEANING[name]}: 1.5, or 1,2,3 or FROM:TO:STEP with both ends",
        )  # fmt: skip


def add_workers(one: argparse.ArgumentParser) -> None:
    """Options for what does the work; `pool` makes it of them."""
    many = one.add_mutually_exclusive_group()
    many.add_argument("--threads", type=count, metavar="N", help="share the work")
    many.add_argument("--processes", type=count, metavar="N", help="share the work")
    many.add_argument("--dask", metavar="ADDRESS", help="a scheduler's: its cluster does the work")


def grid(options: argparse.Namespace) -> Any:
    """(shots, 6): all combinations of the ranges; ValueError for too many."""
    import numpy as np

    ranges = [getattr(options, name) for name in NUMBERS]
    total = prod(map(len, ranges))
    if total > MOST:
        raise ValueError(f"{total} shots are too many: at most {MOST}")
    return np.stack(np.meshgrid(*ranges, indexing="ij"), axis=-1).reshape(-1, len(NUMBERS))


def writable(*names: str | None) -> list[str]:
    """The files among them; OSError if one cannot be written: before all the work, not after it."""
    files = [file for file in names if file not in (None, "-")]
    for file in files:
        open(file, "ab").close()
    return files


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


def joined(words: list[str]) -> list[str]:
    """`--angle -10:10:1` as `--angle=-10:10:1`, which argparse does not mistake for an option."""
    whole: list[str] = []
    for word in words:
        if whole and whole[-1][2:] in NUMBERS and re.match(r"-[\d.]", word):
            whole[-1] += f"={word}"
        else:
            whole.append(word)
    return whole


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


def pool(options: argparse.Namespace) -> Any:
    """What does the work: this thread alone, threads, processes or a cluster."""
    from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

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
