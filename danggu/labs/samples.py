"""What happens in a scene as comma-separated values: every ball, and all of them together."""

from __future__ import annotations

import csv
from collections.abc import Iterator
from io import StringIO
from math import ceil

from physics import World

RATE = 60.0  # samples a second
OF_A_BALL = ("x", "y", "vx", "vy", "speed", "wx", "wy", "wz")
TOGETHER = ("px", "py", "energy")


def samples(world: World, rate: float = RATE, begin: float | None = None) -> str:
    """The text of a CSV file: `rate` rows a second, from `begin`, s, or the log's start, to now.

    time in s from there on; of each ball x and y in m, vx, vy and speed in m/s, wx, wy and wz in
    rad/s; of all together momentum px and py in kg m/s, and energy, that of turning included, in J.
    """
    out = StringIO()
    rows = csv.writer(out, lineterminator="\n")
    names = [ball.name for ball in world.balls]
    rows.writerow(["time", *(f"{name} {what}" for name in names for what in OF_A_BALL), *TOGETHER])
    rows.writerows(_rows(world, rate, world.log.start if begin is None else begin))
    return out.getvalue()


def _rows(world: World, rate: float, start: float) -> Iterator[list[float]]:
    count = ceil((world.time - start) * rate - 1e-9)
    for k in range(count + 1):
        time = min(start + k / rate, world.time)
        yield [time - start, *_at(world, time)]


def _at(world: World, time: float) -> list[float]:
    """All numbers of a moment."""
    row: list[float] = []
    px = py = energy = 0.0
    for ball, state in zip(world.balls, world.log.at(time).values(), strict=True):
        (vx, vy), spin, mass = state.velocity, state.spin, ball.mass
        row += [*state.position, vx, vy, state.speed, *spin]
        px, py = px + mass * vx, py + mass * vy
        turning = 0.4 * ball.radius**2 * (spin[0] ** 2 + spin[1] ** 2 + spin[2] ** 2)
        lift = 0.5 * state.climb**2 + world.cloth.gravity * state.height
        energy += mass * (0.5 * (state.speed**2 + turning) + lift)
    return [*row, px, py, energy]
