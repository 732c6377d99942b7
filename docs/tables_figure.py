"""Draws docs/tables.png: the plans of the tables, with spots, lines and racks, and their pockets.

`python docs/tables_figure.py`; needs matplotlib (extra `plot`).
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Arc, Circle, Polygon

from physics import tables
from physics.tables.pocket_tables import PYRAMID_12FT, SNOOKER_12FT, pool

POOL = pool(9)
PLANS = (tables.THESIS, tables.MEDIUM_CAROM, tables.MATCH_CAROM, POOL, SNOOKER_12FT, PYRAMID_12FT)
POCKETED = PLANS[3:]
CLOTH, EDGE, MARK, BALL = "#dfeaf3", "#27577a", "#5d7f99", "#c0392b"
COLOURS = {"yellow": "#e0b400", "green": "#1c7c54", "brown": "#7b4420", "blue": "#1e55c4",
           "pink": "#f08cab", "black": "#222222"}  # fmt: skip


def cushions(axes, table, width):
    """The bed, and holes behind it; what belongs to a hole shows through it."""
    corners = [(p.real, p.imag) for p in table.outline]
    axes.add_patch(Polygon(corners, closed=True, fc=CLOTH, ec="none"))
    for thing in table.obstacles:
        if thing.kind == "pocket":
            (at,) = thing.points
            axes.add_patch(Circle((at.real, at.imag), thing.radius, fc="#333333", ec="none"))
        elif thing.kind == "segment":
            p, q = thing.points
            axes.plot([p.real, q.real], [p.imag, q.imag], color=EDGE, lw=width)
        elif thing.kind == "line":
            axes.add_patch(Polygon(corners, closed=True, fc="none", ec=EDGE, lw=width))
    for thing in table.obstacles:
        if thing.kind == "post":
            round_nose(axes, table, thing, width)


def round_nose(axes, table, thing, width):
    """As much of its circle as is nose: the outline's points that lie on it."""
    (centre,) = thing.points
    nose = [p for p in table.outline if abs(abs(p - centre) - thing.radius) < 1e-9]
    axes.plot([p.real for p in nose], [p.imag for p in nose], color=EDGE, lw=width)


def plan(axes, table):
    """From above, with what is marked on it, and the first of its racks."""
    cushions(axes, table, 1.2)
    y = 0.5 * table.width
    axes.plot([table.head_string] * 2, [-y, y], color=MARK, lw=0.7, zorder=1)
    if "D" in table.regions:
        (x, _), size = table.regions["D"].centre, 2.0 * table.regions["D"].radius
        axes.add_patch(Arc((x, 0.0), size, size, theta1=90, theta2=270, ec=MARK, lw=0.7))
    for x, y in table.spots.values():
        axes.plot(x, y, "+", color=MARK, ms=4, mew=0.8)
    balls = table.rack(table.racks[0]) if table.racks else []
    for ball in balls:
        colour = COLOURS.get(ball.name, BALL)
        axes.add_patch(Circle(ball.position, ball.radius, fc=colour, ec="white", lw=0.3, zorder=3))
    size = f"{table.length:g} × {table.width:g} m, balls {2000 * table.radius:.2f} mm"
    racked = f", {table.racks[0]}" if table.racks else ""
    axes.set_title(f"{table.name}{racked}\n{size}", size=8, loc="left")
    axes.set(xlim=(-1.95, 1.95), ylim=(-1.06, 1.06), aspect="equal")
    axes.axis("off")


def pocket(axes, table, corner):
    """Near by, with a ball in the mouth; the thin line is the mouth, between the vertices."""
    cushions(axes, table, 1.8)
    x, y, mouths = 0.5 * table.length, 0.5 * table.width, table.pockets
    mouth = mouths.corner if corner else mouths.side
    if corner:
        across = mouth.width * 0.5**0.5
        line, middle = ([x - across, x], [y, y - across]), (x - across / 2, y - across / 2)
        axes.set(xlim=(x - 0.16, x + 0.12), ylim=(y - 0.16, y + 0.12))
    else:
        line, middle = ([-mouth.width / 2, mouth.width / 2], [y, y]), (0.0, y)
        axes.set(xlim=(-0.14, 0.14), ylim=(y - 0.11, y + 0.17))
    axes.plot(*line, color=BALL, lw=0.8)
    axes.add_patch(Circle(middle, table.radius, fc="none", ec=BALL, lw=0.8))
    kind = "corner" if corner else "side"
    axes.set_title(f"{table.name}, {kind}: {1000 * mouth.width:.1f} mm", size=8, loc="left")
    axes.set_aspect("equal")
    axes.axis("off")


def main():
    """Draw it."""
    figure = plt.figure(figsize=(11, 6.6), layout="constrained")
    plans, pockets = figure.subfigures(2, 1, height_ratios=(2.0, 1.05))
    for axes, table in zip(plans.subplots(2, 3).flat, PLANS, strict=True):
        plan(axes, table)
    near = iter(pockets.subplots(1, 6).flat)
    for table in POCKETED:
        for corner in (True, False):
            pocket(next(near), table, corner)
    figure.savefig(Path(__file__).with_name("tables.png"), dpi=110)


if __name__ == "__main__":
    main()
