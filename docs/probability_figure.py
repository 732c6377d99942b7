"""Draws docs/probability.png: how probably a three-cushion shot scores, by angle and speed.

`python docs/probability_figure.py`; needs matplotlib and numba (extras `plot` and `fast`).
"""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import perf_counter, process_time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import PowerNorm

from danggu.__main__ import world_of
from danggu.players.levels import EXPERT
from danggu.rules import GAMES
from danggu.scores import scores

GAME = "three-cushion"
ANGLES = np.arange(-9.875, 115.0, 0.25)
SPEEDS = np.linspace(1.04, 4.96, 50)  # m/s
COPIES, AGAIN = 40, 10_000
RIGHT, UP = 0.35, 0.2  # radii: where the tip meets the ball


def shots(speeds, angles):
    """(speeds * angles, 6), each with the same tip."""
    speed, angle = (each.ravel() for each in np.meshgrid(speeds, angles, indexing="ij"))
    table = np.zeros((speed.size, 6))
    table[:, 0], table[:, 1] = speed, angle
    table[:, 2], table[:, 4] = 2.5 * UP * speed, 2.5 * RIGHT * speed
    return table


def shares(speeds, angles, copies, seed):
    """(speeds, angles): the share that scores with the errors of an expert."""
    with ThreadPoolExecutor(2) as threads:
        found = scores(
            world_of("opening", GAME), "white", shots(speeds, angles), GAMES[GAME](), level=EXPERT,
            copies=copies, seed=seed, executor=threads,
        )  # fmt: skip
    return found.made.reshape(len(speeds), len(angles))


def main():
    """Draw it."""
    shares(SPEEDS, ANGLES, 1, 0)  # the kernel is loaded
    wall, cpu = perf_counter(), process_time()
    made = shares(SPEEDS, ANGLES, COPIES, 1)
    wall, cpu = perf_counter() - wall, process_time() - cpu
    figure, axes = plt.subplots(figsize=(11, 4.2), layout="constrained")
    mesh = axes.pcolormesh(ANGLES, SPEEDS, 100.0 * made, cmap="Blues", norm=PowerNorm(0.6))
    figure.colorbar(mesh, label="strokes that score, %", pad=0.01)
    best = np.unravel_index(made.argmax(), made.shape)
    where = ANGLES[best[1]], SPEEDS[best[0]]
    fresh = shares(where[1:], where[:1], AGAIN, 2)[0, 0]  # the best of many was also lucky
    axes.plot(*where, "o", ms=9, mfc="none", mec="#c0392b", clip_on=False)
    axes.annotate(
        f"{100 * fresh:.0f} %", where, (10, -14), textcoords="offset points", color="#c0392b"
    )
    axes.set(
        xlabel="angle of the stroke, degrees", ylabel="speed, m/s",
        title=f"{made.size * COPIES:,} strokes from the opening position, errors of an expert",
        xticks=range(0, 116, 15),
    )  # fmt: skip
    figure.savefig(Path(__file__).with_name("probability.png"), dpi=110)
    print(
        f"{100 * made.mean():.2f} % score, the best {100 * made[best]:.1f} and {100 * fresh:.1f} %"
    )
    print(f"{cpu:.1f} CPU s, {wall:.1f} s with two threads")


if __name__ == "__main__":
    main()
