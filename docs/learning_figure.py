"""Draws docs/learning.png: how docs/learning.py learns three-cushion.

`python docs/learning_figure.py`; needs matplotlib (extra `plot`), gymnasium (`rl`), some minutes.
The lines of plain players are those of benchmarks/results/envs.csv.
"""

import csv
from pathlib import Path
from time import process_time

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from learning import TABLES, learned

DOCS = Path(__file__).parent
GAME, NOISE, UPDATES, MEAN = "danggu/ThreeCushion-v0", "expert", 1500, 25
NAMES = {"1": "random", "16": "best of 16 tried", "256": "best of 256 tried"}


def plain():
    """(name, share) of the players that do not learn."""
    with (DOCS.parent / "benchmarks" / "results" / "envs.csv").open() as file:
        for row in csv.DictReader(file):
            asked = (row["what"], row["game"], row["noise"]) == ("player", GAME, NOISE)
            if asked and row["how"] in NAMES:
                yield NAMES[row["how"]], float(row["first"])


def main():
    start = process_time()
    shares = np.array([*learned(UPDATES, GAME, NOISE)])
    spent = process_time() - start
    count = np.arange(1, UPDATES + 1)
    means = np.convolve(shares, np.ones(MEAN))[:UPDATES] / np.minimum(count, MEAN)
    strokes = TABLES * 1e-6 * count
    figure, axes = plt.subplots(figsize=(7.2, 3.6), layout="constrained")
    axes.plot(strokes, 100.0 * means, color="#1f5fa8", lw=1.5)
    for (name, share), dash in zip(plain(), (":", "-.", "--"), strict=True):
        axes.axhline(100.0 * share, color="#888888", lw=1.0, ls=dash)
        axes.annotate(name, (strokes[-1], 100.0 * share), (0, 3), textcoords="offset points",
                      ha="right", fontsize=9, color="#555555")  # fmt: skip
    axes.set(
        xlabel=f"million strokes ({spent:.0f} s of one core in all)",
        ylabel="strokes that score, %", xlim=(0.0, strokes[-1]), ylim=(0.0, 22.0),
        title="Three-cushion, noise of an expert: a small policy learns by REINFORCE",
    )  # fmt: skip
    figure.savefig(DOCS / "learning.png", dpi=110)
    print(f"{100 * means[0]:.1f} % to {100 * means[-1]:.1f} % in {spent:.0f} CPU s")


if __name__ == "__main__":
    main()
