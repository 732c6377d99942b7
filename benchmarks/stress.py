"""Scenes made to break the engine, by families; failures are printed with how to repeat them."""

import argparse
import re
from collections.abc import Callable, Iterator
from random import Random
from time import process_time

from physics import commandline

from . import stepping_breaks
from .families import FAMILIES
from .report import place, provenance
from .trials import Trial, outcome

HEAD = "| family | trials | events | failed | CPU s |\n|---|---|---|---|---|"


def trial(family: str, k: int, seed: int) -> Trial:
    """The k-th trial of a family, the same for the same seed."""
    return FAMILIES[family][0](k, Random(f"{family} {k} {seed}"))


def failures(family: str, ks: range, seed: int) -> Iterator[tuple[int, list[str], int]]:
    """(k, faults, events) of each trial."""
    for k in ks:
        found, events = outcome(trial(family, k, seed))
        yield k, found, events


def report(family: str, ks: range, seed: int) -> tuple[str, int]:
    """Run a family and print its first faults: (its line of the table, how many trials failed)."""
    start, events, bad = process_time(), 0, 0
    for k, found, happened in failures(family, ks, seed):
        events += happened
        if found:
            bad += 1
            if bad <= 5:
                print(f"  --family {family} --seed {seed} --only {k}: {'; '.join(found)[:300]}")
    line = f"| {family} | {len(ks)} | {events} | {bad} | {process_time() - start:.1f} |"
    print(line, flush=True)
    return line, bad


def options(arguments: list[str] | None) -> argparse.Namespace:
    parser = commandline.Parser(prog="python -m benchmarks stress", description=__doc__)
    trials = parser.add_mutually_exclusive_group()
    trials.add_argument("--short", action="store_true", help="the part that runs with the tests")
    trials.add_argument("--count", type=_from(1), help="so many trials of each family")
    trials.add_argument("--only", type=_from(0), metavar="K", help="only trial K")
    parser.add_argument("--family", choices=FAMILIES, help="only this one")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--write", type=place, metavar="FILE", help="keep the tables there")
    chosen = parser.parse_args(arguments)
    if chosen.write and not chosen.write.parent.is_dir():
        parser.error(f"--write {chosen.write}: there is no folder {chosen.write.parent}")
    return chosen


def _from(least: int) -> Callable[[str], int]:
    def number(text: str) -> int:
        if not re.fullmatch(r"\d{1,9}", text) or int(text) < least:
            raise argparse.ArgumentTypeError(f"{text!r} is no whole number from {least} on")
        return int(text)

    return number


def main(arguments: list[str] | None = None) -> int:
    chosen = options(arguments)
    print(HEAD)
    lines, failed = [HEAD], 0
    for name in [chosen.family] if chosen.family else FAMILIES:
        _, long, short = FAMILIES[name]
        count = chosen.count or (short if chosen.short else long)
        first = chosen.only or 0
        line, bad = report(
            name, range(first, first + (count if chosen.only is None else 1)), chosen.seed
        )
        lines.append(line)
        failed += bad
    if not chosen.family:
        lines += ["", stepping_breaks.table(2 if chosen.short else 40)]
        print(lines[-1])
    if chosen.write:
        text = "\n".join(["# Stress", "", *lines, "", provenance()])
        chosen.write.write_text(text + "\n", encoding="utf-8")
    return 1 if failed else 0
