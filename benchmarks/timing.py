"""CPU time, measured so that a busy machine does the least harm: in turns, with a yardstick."""

import gc
from collections.abc import Callable
from statistics import median
from time import process_time
from typing import Any, NamedTuple


class Cost(NamedTuple):
    """Seconds of CPU for one run: the least seen, and the median."""

    least: float
    median: float

    def per(self, parts: float) -> "Cost":
        """The cost of one of that many equal parts."""
        return Cost(self.least / parts, self.median / parts)


def once(run: Callable[[], Any]) -> float:
    """CPU seconds of one run."""
    start = process_time()
    run()
    return process_time() - start


def in_turns(runs: dict[str, Callable[[], Any]], rounds: int) -> dict[str, Cost]:
    """The cost of each run, all once in every round: a busy machine slows them alike.

    Each round begins with a different one, since the first finds cold caches.
    """
    order = list(runs)
    seen: dict[str, list[float]] = {name: [] for name in runs}
    gc.collect()
    gc.disable()
    try:
        for k in range(rounds):
            for name in order[k % len(order) :] + order[: k % len(order)]:
                seen[name].append(once(runs[name]))
            gc.collect()
    finally:
        gc.enable()
    return {name: Cost(min(times), median(times)) for name, times in seen.items()}


def cost(run: Callable[[], Any], rounds: int) -> Cost:
    """The cost of one thing alone."""
    return in_turns({"it": run}, rounds)["it"]


def yardstick(passes: int = 100_000) -> complex:
    """A fixed loop of complex arithmetic in Python: costs in passes of it outlive the machine."""
    z, c = 0j, 0.3 + 0.4j
    for k in range(passes):
        z = 0.5 * (z + c) * c.conjugate() + k * 1e-9
        if z.real * z.real + z.imag * z.imag > 4.0:
            z = 0j
    return z


PASSES = 100_000  # of the yardstick
