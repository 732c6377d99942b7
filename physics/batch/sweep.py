"""Many shots from the command line: ranges of a shot's numbers in, a table of outcomes out."""

from __future__ import annotations

import argparse
import csv
import sys
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any

from physics.ranges import add_ranges, add_workers, bar, grid, kept, pool, writable
from physics.shot import NUMBERS

from .many import simulate_many

if TYPE_CHECKING:
    from physics.world import World

    from .outcomes import Outcomes

PIECE = 200_000  # shots that are made ready at once: 50 MB


def add_options(one: argparse.ArgumentParser) -> None:
    """The options of `sweep` besides a scene, its laws and its engine."""
    one.add_argument("--ball", help="which ball is struck (the scene's first)")
    add_ranges(one)
    add_workers(one)
    one.add_argument(
        "--contacts", type=kept, metavar="N", default=0,
        help="of each shot that --npz keeps: who hit what, and when",
    )  # fmt: skip
    one.add_argument("--csv", metavar="FILE", help="write a line a shot (- for the terminal)")
    one.add_argument("--npz", metavar="FILE", help="write NumPy arrays")


def sweep(world: World, options: argparse.Namespace) -> str:
    """Play all shots and write what was asked for; returns a line about it."""
    import numpy as np

    from .outcomes import together

    ball = world.ball(options.ball) if options.ball else world.balls[0]
    shots = grid(options)
    total, files = len(shots), writable(options.npz, options.csv)
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
