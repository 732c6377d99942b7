"""Draws docs/acceptance.png: which offset, at which angle and speed, goes into a pocket of pool.

`python docs/acceptance_figure.py`; needs matplotlib and numba (extras `plot` and `fast`).
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from physics import Ball, laws, simulate_many, tables

INCH = 0.0254
SPEEDS = (1.0, 2.0, 4.0)  # m/s, rolling, RUN from the mouth
RUN = 0.5  # m
ANGLES = {"corner": np.arange(-44.0, 44.1, 1.0), "side": np.arange(-70.0, 70.1, 1.0)}
OFFSETS = np.arange(-3.0, 3.001, 0.02)  # inches
SHADES = ("#cfe3f1", "#7fb2d6", "#27577a")
MIRROR = laws.RigidCushion(1.0, 0.0, nose=1.0)


def mouth(kind):
    """The middle of the mouth, and the direction into the pocket."""
    table = tables.pool_9ft().table
    x, y = 0.5 * table.length, 0.5 * table.width
    if kind == "side":
        return complex(0.0, y), 1j
    axis = complex(1.0, 1.0) / 2.0**0.5
    return complex(x, y) - 0.5 * table.pockets.corner.width * axis, axis


def taken(kind, speed, law=None):
    """(angles, offsets): does a rolling ball go in?

    A positive angle is turned clockwise from the axis, a positive offset is to the right of it.
    """
    middle, axis = mouth(kind)
    way = (axis * np.exp(-1j * np.radians(ANGLES[kind])))[:, None]
    start = middle - RUN * way - 1j * way * INCH * OFFSETS
    world = tables.pool_9ft()
    if law is not None:
        world.cushion_law = law
    world.add(Ball("a", at=(0.0, 0.0)))
    here = clear(kind, start)
    at, angle = start[here], np.broadcast_to(np.degrees(np.angle(way)), start.shape)[here]
    rolling = {"speed": speed, "angle": angle, "follow": speed}
    done = simulate_many(world, "a", positions=np.stack([at.real, at.imag], -1)[:, None], **rolling)
    found = np.zeros(start.shape, bool)
    in_time = done.times < 2.0 * RUN / speed  # later: in another pocket
    found[here] = np.isnan(done.positions[:, 0, 0]) & in_time
    return found


def clear(kind, start):
    """Is the ball on the bed where it begins?"""
    table = tables.pool_9ft().table
    x, y, r = 0.5 * table.length, 0.5 * table.width, table.radius
    return (abs(start.real) < x - r) & (abs(start.imag) < y - r)


def panel(axes, kind):
    """Darker where it goes in at a higher speed too; the line is a mirror's edge."""
    angles, takes = ANGLES[kind], [taken(kind, speed) for speed in SPEEDS]
    count = sum(take.astype(int) for take in takes)
    mirror = taken(kind, 2.0, MIRROR)
    shades = matplotlib.colors.ListedColormap(["white", *SHADES])
    axes.pcolormesh(angles, OFFSETS, count.T, cmap=shades, vmin=-0.5, vmax=3.5, rasterized=True)
    axes.contour(angles, OFFSETS, mirror.T.astype(float), [0.5], colors="#c0392b", linewidths=0.6)
    axes.set_title(f"pool 9 ft, {kind} pocket", size=9, loc="left")
    axes.set_xlabel("angle to the pocket's axis, degrees", size=8)
    axes.tick_params(labelsize=7)
    for speed, take in zip(SPEEDS, takes, strict=True):
        share = take[np.abs(angles) < 0.1].mean() * 6.0
        print(f"{kind}, {speed:g} m/s: {share:.2f} in of offsets straight on")


def main():
    """Draw it."""
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained", sharey=True)
    for each, kind in zip(axes, ANGLES, strict=True):
        panel(each, kind)
    axes[0].set_ylabel("offset from the middle of the mouth, inches", size=8)
    keys = [plt.Rectangle((0, 0), 1, 1, fc=shade) for shade in SHADES]
    keys.append(plt.Line2D([], [], color="#c0392b", lw=0.8))
    words = [f"in at {n} of {' '.join(f'{v:g}' for v in SPEEDS)} m/s" for n in (1, 2, 3)]
    axes[1].legend(keys, [*words, "mirror cushions, 2 m/s"], fontsize=7, loc="lower right")
    figure.savefig(Path(__file__).with_name("acceptance.png"), dpi=110)


if __name__ == "__main__":
    main()
