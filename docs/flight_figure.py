"""Draws docs/flight.png: a jump over a ball, seen from the side, and one over the cushion.

`python docs/flight_figure.py`; needs matplotlib (extra `plot`).
"""

from math import radians, sin
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import Circle, Rectangle

from physics import Ball, CueStroke, simulate, tables

LOOKS = {"cue": "#8a8a8a", "red": "#c0392b", "yellow": "#d9a400"}
SPOTS = {"cue": 0.0, "red": 0.38, "yellow": 0.95}
TABLE = tables.MATCH_CAROM


def scene():
    """A ball in the way of the cue ball, and one behind it."""
    world = TABLE.world()
    for name, x in SPOTS.items():
        world.add(Ball(name, (x, 0.0), radius=TABLE.radius, mass=TABLE.mass))
    return world


def side_view(axes, after, until, start):
    """Where the balls' centres go, from the side; each ball at the start and once a beat."""
    times = np.linspace(0.0, until, 800)
    states = [after.log.at(time) for time in times]
    gone = {event.balls[0]: event.time for event in after.log if event.kind == "off"}
    for name, colour in LOOKS.items():
        seen = [s[name] for t, s in zip(times, states, strict=True) if t < gone.get(name, until)]
        x, z = ([s.position[0] for s in seen], [s.height + TABLE.radius for s in seen])
        axes.plot(x, z, color=colour, lw=1.2)
        for k in range(0, len(seen), 50):
            moves = k > 0 and x[k] != x[0]
            if k == 0 or moves:
                axes.add_patch(Circle((x[k], z[k]), TABLE.radius, fc=colour if k == 0 else "none",
                                      ec=colour, lw=0.6, alpha=1.0 if k == 0 else 0.6))  # fmt: skip
    for event in after.log:
        if event.kind == "land" and event.balls == ("cue",) and event.time < until:
            axes.plot(event.point[0], 0.0, "|", color="#333", ms=7)
    edge, nose = TABLE.length / 2, TABLE.cushion_law.nose * TABLE.radius
    axes.add_patch(Rectangle((edge, 0.0), 0.06, nose, fc="#27577a"))
    axes.axhline(0.0, color="#27577a", lw=2)
    axes.set(xlim=(start, edge + 0.06), ylim=(-0.01, 0.36), aspect="equal", ylabel="z (m)")


def main():
    """Draw it."""
    figure, panels = plt.subplots(2, 1, figsize=(11, 5.6), layout="constrained", sharex=True)
    for axes, speed, elevation in zip(panels, (4.0, 6.0), (40.0, 30.0), strict=True):
        world = scene()
        through_centre = sin(radians(elevation))
        stroke = CueStroke(speed, height=through_centre, elevation=elevation)
        after = simulate(world, "cue", stroke.jump(world.ball("cue")))
        side_view(axes, after, 0.62, -0.08)
        how = f"cue at {speed} m/s, butt raised by {elevation:.0f}°, through the ball's centre"
        axes.set_title(how, loc="left", size=10)
    panels[1].set_xlabel("x (m)")
    figure.savefig(Path(__file__).with_name("flight.png"), dpi=110)


if __name__ == "__main__":
    main()
