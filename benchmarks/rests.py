"""Where many shots leave their balls: what is wrong there, and a million of them to look at.

`python -m benchmarks.rests [SHOTS]` plays them, 1 000 000 or so many, in compiled batches.
"""

import sys
from random import Random
from time import process_time
from typing import Any

import numpy as np

from physics import Ball, EventBudgetError, World, simulate_many

from .any_tables import TABLES, place, table, within

OVERLAP = 1e-12  # m
BEHIND = 0.16  # m: the backs of pockets
BATCH = 10_000
BALLS = (1, 2, 4, 7, 11, 16)
LOW, HIGH = (0.2, 0.0, -8.0, -3.0, -4.0, 0.0), (10.0, 360.0, 8.0, 3.0, 4.0, 2.0)
HEAD = "| table | shots | events | pocketed | jumped | faults |\n|---|---|---|---|---|---|"


def shots(count: int, seed: int, jumps: bool) -> Any:
    """Of all strengths, with follow, draw, swerve and side, or jumps with all of these."""
    drawn = np.random.default_rng(seed).uniform(LOW, HIGH, (count, 6))
    return drawn if jumps else drawn[:, :5]


def faults(world: World, positions: Any, flew: bool) -> list[str]:
    """Balls that lie in each other, or outside the table or in a wall.

    positions: (shots, balls, 2), as of `simulate_many`.
    """
    places = positions[:, :, 0] + 1j * positions[:, :, 1]
    found = []
    for i, ball in enumerate(world.balls):
        for j, other in enumerate(world.balls[: 0 if flew else i]):  # one that is off may lie there
            gap = np.abs(places[:, i] - places[:, j]) - ball.touching_distance(other)
            found += [f"shot {k}: {ball.name} and {other.name} overlap by {-gap[k]:.1e} m"
                      for k in np.nonzero(gap < -OVERLAP)[0]]  # fmt: skip
    assert world.table is not None
    x, y = 0.5 * world.table.length, 0.5 * world.table.width
    near = np.minimum(x - np.abs(places.real), y - np.abs(places.imag)) < 0.1
    for k, i in zip(*np.nonzero(near), strict=True):
        at, ball = positions[k, i].tolist(), world.balls[i]
        if flew:  # over a rail, it is where it left
            outside = abs(at[0]) > x + BEHIND or abs(at[1]) > y + BEHIND
        else:
            outside = not within(world.table.outline, complex(*at)) or in_something(world, ball, at)
        if outside:
            found.append(f"shot {k}: {ball.name} is outside, at {at}")
    return found


def in_something(world: World, ball: Ball, at: tuple[float, float]) -> bool:
    return any(
        wall.distance(at) < (ball.radius if wall.pushes else 0.0) - OVERLAP for wall in world.walls
    )


def played(count: int, batch: int = BATCH, seed: int = 0) -> list[list[Any]]:
    """So many shots on each table, a fifth of them jumps: rows for HEAD, faults printed."""
    rows = []
    for kind, stands in enumerate(TABLES):
        events, down, jumped, bad = 0, 0, 0, 0
        for k in range(count // batch):
            dice = Random(f"{kind} {k} {seed}")
            world = table(dice, kind)
            place(world, BALLS[k % len(BALLS)], dice)
            jumps = k % 5 == 4
            try:
                outcomes = simulate_many(world, "0", shots(batch, k, jumps), compiled=True)
            except EventBudgetError as error:
                print(f"{stands.name}, batch {k}, seed {seed}: {error}")
                bad += 1
                continue
            found = faults(world, outcomes.positions, jumps)
            for fault in found[:3]:
                print(f"{stands.name}, batch {k}, seed {seed}: {fault}")
            events += int(outcomes.events.sum())
            down += int(np.isnan(outcomes.positions[:, :, 0]).sum())
            jumped, bad = jumped + jumps * batch, bad + len(found)
        rows.append([stands.name, count // batch * batch, events, down, jumped, bad])
    return rows


def main() -> int:
    start = process_time()
    rows = played(int(sys.argv[1]) // len(TABLES) if len(sys.argv) > 1 else 200_000)
    print(HEAD)
    for row in rows:
        print("|", " | ".join(map(str, row)), "|")
    print(f"{process_time() - start:.0f} s of CPU")
    return 1 if any(row[-1] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
