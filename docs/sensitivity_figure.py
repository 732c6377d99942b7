"""Draws docs/sensitivity.png: a carom shot, what errors make of it, and what each hit multiplies.

`python docs/sensitivity_figure.py`; needs matplotlib (extra `plot`).
"""

from dataclasses import astuple
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Ellipse, Rectangle

from physics import Shot, scenes, sensitivity, simulate, tables, trace
from physics.studies.sensitivity import NUMBERS

SHOT = Shot(3.0, 39.5, follow=1.0, side=0.5)
ERRORS = (0.002, 0.006, 0.006, 0.001, 0.006)  # the linear law nearly holds for these
LOOKS = {"white": "#8a8a8a", "yellow": "#d9a400", "red": "#c0392b", "red 2": "#e67e22"}
SHOTS = 150


def scattered(world, struck, shots, chance):
    """The same shot with errors, over and over: finished worlds."""
    for _ in range(shots):
        numbers = chance.normal(astuple(SHOT)[:5], ERRORS)
        yield simulate(world, struck, Shot(*numbers))


def ellipse(axes, centre, covariance, colour):
    """Where two of three outcomes are, were the linear law exact for all errors: 1.5 sigma."""
    sizes, axis = np.linalg.eigh(covariance)
    angle = np.degrees(np.arctan2(axis[1, 1], axis[0, 1]))
    width, height = 3.0 * np.sqrt(np.maximum(sizes[::-1], 0.0))
    axes.add_patch(Ellipse(centre, width, height, angle=angle, fill=False, ec=colour, lw=1.5))


def table(axes, seen, world):
    """The paths, those of shots that err, where balls come to rest, and the factors."""
    length, width = tables.MEDIUM_CAROM.length, tables.MEDIUM_CAROM.width
    axes.add_patch(Rectangle((-length / 2, -width / 2), length, width, fc="#e8f0f7", ec="#446"))
    for after in scattered(world, "white", SHOTS, np.random.default_rng(1)):
        _, paths = trace(after, 120)
        for k, ball in enumerate(after.balls):
            axes.plot(*paths[:, k].T, color=LOOKS[ball.name], lw=0.4, alpha=0.12)
            axes.plot(*ball.position, ".", color=LOOKS[ball.name], ms=2.5, alpha=0.6)
    _, paths = trace(seen.world, 240)
    for k, ball in enumerate(seen.world.balls):
        colour = LOOKS[ball.name]
        axes.plot(*paths[:, k].T, color=colour, lw=1.4)
        axes.add_patch(Circle(paths[0, k], ball.radius, fc="white", ec=colour))
        if seen.rest[k].any():
            ellipse(axes, ball.position, seen.covariance(ERRORS)[k], colour)
    hits = [slopes.event for slopes in seen.events if slopes.event.kind == "ball"]
    for hit, factor in zip(hits, seen.amplification(), strict=True):
        axes.annotate(
            f"×{factor:.0f}", hit.point, (12, 14), textcoords="offset points", fontsize=12,
            arrowprops={"arrowstyle": "-", "lw": 0.6},
        )  # fmt: skip
    axes.set(xlim=(-length / 2, length / 2), ylim=(-width / 2, width / 2), aspect="equal")
    axes.set_xlabel("x (m)")
    axes.set_ylabel("y (m)")


def growth(axes, seen):
    """How an error of aim grows: heading of each moving ball, per error of the aim, over time."""
    angle = NUMBERS.index("angle")
    for name, colour in LOOKS.items():
        times, turns = ([0.0], [1.0]) if name == "white" else ([], [])
        for slopes in seen.events:
            if name in slopes.event.balls:
                k = slopes.event.balls.index(name)
                for after in (False, True):
                    turn = abs(np.degrees(slopes.headings(after)[k, angle]))
                    times.append(slopes.event.time)
                    turns.append(turn if turn > 0.0 else np.nan)
        if times:
            axes.plot(times, turns, "o-", color=colour, lw=1.5, ms=3, label=name)
    axes.set(yscale="log", xlabel="time (s)", ylabel="error of heading / error of aim")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False)


def main():
    """Draw it."""
    world = scenes.carom()
    seen = sensitivity(world, "white", SHOT)
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(13, 4.6), width_ratios=(2.1, 1), layout="constrained"
    )
    table(left, seen, world)
    growth(right, seen)
    figure.savefig(Path(__file__).with_name("sensitivity.png"), dpi=110)


if __name__ == "__main__":
    main()
