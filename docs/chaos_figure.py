"""Draws docs/chaos.png: two chaotic billiards, and how a difference of 1e-10 m grows in them.

`python docs/chaos_figure.py`; needs matplotlib (extra `plot`).
"""

from math import log
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from physics import scenes, trace
from physics.studies.plot import lay_obstacles

START, ENDS = 1e-10, 0.05  # m: the difference at first, and where it is as large as the table
SHOWN, LONG = 12.0, 60.0  # s: of the path, and of the growth
PATH, OTHER = "#27577a", "#c0392b"


def beside(make):
    """The scene, with its ball moved by START across its way."""
    world = make()
    (ball,) = world.balls
    (x, y), (u, v) = ball.position, ball.velocity
    speed = (u * u + v * v) ** 0.5
    ball.position = (x - START * v / speed, y + START * u / speed)
    return world


def growth(make):
    """Times, and how far the two balls are apart, m."""
    paths = []
    for world in (make(), beside(make)):
        world.run(LONG)
        times, path = trace(world, 200.0)
        paths.append(path[:, 0, 0] + 1j * path[:, 0, 1])
    return times, np.abs(paths[0] - paths[1])


def exponent(times, apart):
    """How fast it grows, 1/s, until the balls are far apart."""
    near = (apart > 3.0 * START) & (np.cumsum(apart > ENDS) == 0)
    return np.polyfit(times[near], np.log(apart[near]), 1)[0]


def table(axes, make):
    world = make()
    world.run(SHOWN)
    lay_obstacles(axes, world)
    _, path = trace(world, 400.0)
    axes.plot(path[:, 0, 0], path[:, 0, 1], color=PATH, lw=0.7)
    x, y = path[0, 0]
    axes.add_patch(plt.Circle((x, y), world.balls[0].radius, fc="none", ec=OTHER))
    axes.set_aspect("equal")
    axes.axis("off")


def main():
    """Draw it."""
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), layout="constrained")
    for k, make in enumerate((scenes.sinai, scenes.stadium)):
        table(axes[k], make)
        times, apart = growth(make)
        rate = exponent(times, apart)
        name = make.__name__
        axes[k].set_title(f"{name}, {SHOWN:g} s", size=9, loc="left")
        label = f"{name}: {rate:.2f}/s, tenfold in {log(10.0) / rate:.2f} s"
        apart, colour = np.maximum(apart, 1e-12), (PATH, OTHER)[k]
        axes[2].semilogy(times, apart, lw=0.9, color=colour, label=label)
        print(label)
    axes[2].set(xlim=(0.0, 30.0), ylim=(1e-11, 3.0))
    axes[2].set_xlabel("s", size=8)
    axes[2].set_title("m between two balls, 1e-10 m at first", size=9, loc="left")
    axes[2].legend(fontsize=7)
    axes[2].tick_params(labelsize=7)
    figure.savefig(Path(__file__).with_name("chaos.png"), dpi=110)


if __name__ == "__main__":
    main()
