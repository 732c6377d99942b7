"""Scenes made to break the engine, by families; what fails is printed with how to see it again."""

import argparse
from collections.abc import Iterator
from random import Random
from time import process_time

from .families import FAMILIES
from .trials import Trial, outcome


def trial(family: str, k: int, seed: int) -> Trial:
    """The k-th trial of a family, the same for the same seed."""
    return FAMILIES[family][0](k, Random(f"{family} {k} {seed}"))


def failures(family: str, ks: range, seed: int) -> Iterator[tuple[int, list[str], int]]:
    """(k, faults, events) of each trial."""
    for k in ks:
        found, events = outcome(trial(family, k, seed))
        yield k, found, events


def report(family: str, ks: range, seed: int) -> int:
    """Run a family, print its line of the table and its first faults; how many trials failed."""
    start, events, bad = process_time(), 0, 0
    for k, found, happened in failures(family, ks, seed):
        events += happened
        if found:
            bad += 1
            if bad <= 5:
                print(f"  --family {family} --seed {seed} --only {k}: {'; '.join(found)[:300]}")
    seconds = process_time() - start
    print(f"| {family} | {len(ks)} | {events} | {bad} | {seconds:.1f} |", flush=True)
    return bad


def main(arguments: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="python -m benchmarks stress", description=__doc__)
    parser.add_argument("--short", action="store_true", help="the part that runs with the tests")
    parser.add_argument("--family", choices=FAMILIES, help="only this one")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--count", type=int, help="so many trials of each family")
    parser.add_argument("--only", type=int, metavar="K", help="only trial K")
    options = parser.parse_args(arguments)
    print("| family | trials | events | failed | CPU s |\n|---|---|---|---|---|")
    bad = 0
    for name in [options.family] if options.family else FAMILIES:
        count = options.count or FAMILIES[name][2 if options.short else 1]
        ks = range(count) if options.only is None else range(options.only, options.only + 1)
        bad += report(name, ks, options.seed)
    return 1 if bad else 0
