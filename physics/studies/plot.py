"""Pictures of what happened, for papers and pages: paths on the table, to scale.

Needs matplotlib, the `plot` extra; nothing else here imports it.
"""

from collections.abc import Iterable
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any
from weakref import WeakSet

from physics.engines.engine import Movable
from physics.log import Event

from .grounds import CLOTH, FILLED, INK, NOSE, PLANE, RAIL, box, layers, outline, railed
from .trace import trace

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

MISSING = "pictures need matplotlib: pip install 'danggu[plot]', or pip install matplotlib"
RATE = 240  # samples a second of a path
LONG = 84  # letters: a longer title is smaller
NAMED = 4  # balls: the legend names no more than these
PAPER = "#FFFFFF"
BODIES = {"white": "#FFFFFF", "yellow": "#F2B90C", "red": "#D6202F"}
DARK = {"white": "#4A5561", "yellow": "#9A6F00", "red": "#7E0E19"}
OTHERS = ("#2A7FB8", "#2E9E5B", "#8A5BC7", "#D9702B", "#159AA0", "#B8478B")
MARKS = {  # shape, size, word
    "cushion": ("s", 7, "cushion"),
    "ball": ("X", 9, "balls meet"),
    "roll": ("o", 5, "starts to roll"),
}


def picture(
    world: Movable, title: str, note: str, engine: str, other: Movable | None = None,
    dashes: str = "",
) -> "Figure":  # fmt: skip
    """The log of the world as solid paths, on its table; that of another world dashed, beside it.

    engine and dashes are the words for the two in the legend.
    Rings are where balls began, discs where they are now. Without matplotlib, an ImportError says
    what to install.
    """
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise ImportError(MISSING) from None
    bounds = extent(world)
    width, height = bounds[1] - bounds[0], bounds[3] - bounds[2]
    figure = Figure(figsize=(9.0, 9.0 * (height / width) + 1.25), facecolor=PAPER)
    axes = figure.add_axes(
        (0.0, 0.55 / figure.get_figheight(), 1.0, 1 - 1.25 / figure.get_figheight())
    )
    axes.set(xlim=bounds[:2], ylim=bounds[2:], aspect="equal")
    axes.axis("off")
    lay_table(axes, world)
    if other is not None:
        lay_paths(axes, other, dashed=True)
    lay_paths(axes, world, dashed=False)
    lay_marks(axes, world)
    figure.text(
        0.03, 1 - 0.34 / figure.get_figheight(), title, color=INK, weight="bold",
        size=12.0 * min(1.0, LONG / max(len(title), 1)),
    )
    figure.text(0.03, 1 - 0.60 / figure.get_figheight(), note, color=INK, size=10)
    legend(figure, world, engine, dashes)
    return figure


def onto(
    world: Movable, axes: "Axes | None", label: str | None, balls: Iterable[str] | None
) -> "Axes":
    """The paths of these balls on the axes, and the table under them if it is not there yet."""
    if axes is None:
        try:
            from matplotlib import pyplot
        except ImportError:
            raise ImportError(MISSING) from None
        axes = pyplot.subplots(layout="constrained")[1]
    if axes not in _laid:
        _laid.add(axes)
        bounds = extent(world)
        axes.set(xlim=bounds[:2], ylim=bounds[2:], aspect="equal")
        axes.axis("off")
        lay_table(axes, world)
    named = [ball.name for ball in world.balls] if balls is None else [*balls]
    if label is None:
        lay_paths(axes, world, dashed=False, balls=named)
    else:
        _lay_labelled(axes, world, label, named)
    return axes


_laid: "WeakSet[Any]" = WeakSet()
"""The axes that have a table."""


def _lay_labelled(axes: "Axes", world: Movable, label: str, balls: list[str]) -> None:
    """All paths in the next colour of the axes, with one line of its legend."""
    from matplotlib.patches import Circle

    _, paths = trace(world, RATE)
    colour = None
    for i, ball in enumerate(world.balls):
        x, y = paths[:, i, 0], paths[:, i, 1]
        if ball.name in balls and (x != x[0]).any():
            named = label if colour is None else None
            (line,) = axes.plot(x, y, lw=1.6, zorder=5, label=named, color=colour)
            colour = line.get_color()
            spot = x[-1], y[-1]
            axes.add_patch(Circle(spot, ball.radius, fc="none", ec=colour, lw=1.6, zorder=7))
    if colour is None:
        axes.plot([], [], label=label)
    axes.legend(loc="upper right")


def save(figure: "Figure", file: str | Path) -> None:
    """As PNG, 990 pixels wide."""
    figure.savefig(file, dpi=110, format="png")


# -- the table -------------------------------------------------------------------------------------


def extent(world: Movable) -> tuple[float, float, float, float]:
    """West, east, south, north of the picture: the table, or the paths if that has no end."""
    if railed(world):
        corners = outline(world, RAIL)
        west, east = min(p.real for p in corners), max(p.real for p in corners)
        south, north = min(p.imag for p in corners), max(p.imag for p in corners)
        if world.balls and max(east, -west, north, -south) == PLANE:
            west, east, south, north = _reached(world, 4.0)
    else:
        west, east, south, north = box(world.walls)
        if world.balls:  # may be out of there
            a, b, c, d = _reached(world, 1.0)
            west, east, south, north = min(a, west), max(b, east), min(c, south), max(d, north)
    return west - 0.02, east + 0.02, south - 0.02, north + 0.02


def _reached(world: Movable, radii: float) -> tuple[float, float, float, float]:
    """West, east, south, north of where balls have been, and so many radii more."""
    _, paths = trace(world, RATE)
    reach = radii * max(ball.radius for ball in world.balls)
    west, south = paths.min(axis=(0, 1)) - reach
    east, north = paths.max(axis=(0, 1)) + reach
    return west, east, south, north


def lay_table(axes: "Axes", world: Movable) -> None:
    """Rails, cloth and diamonds."""
    for colour, edge, corners in layers(world):
        axes.fill([p.real for p in corners], [p.imag for p in corners], fc=colour, ec=edge, lw=1.4)
    corners = outline(world)
    lay_obstacles(axes, world)
    if len(corners) != 4 or abs(corners[0]) >= PLANE or not world.scene.lines:
        return
    sides = [*pairwise([*corners, corners[0]])]
    longest = max(abs(q - p) for p, q in sides)
    for p, q in sides:
        parts = 8 if abs(q - p) > 0.75 * longest else 4
        for k in range(1, parts):
            spot = p + (q - p) * k / parts - 0.5j * RAIL * (q - p) / abs(q - p)
            axes.plot(spot.real, spot.imag, "D", ms=3, color=PAPER)


def lay_obstacles(axes: "Axes", world: Movable) -> None:
    """All that is no line: pockets, posts, segments and arcs."""
    for wall in world.walls:
        points = wall.curve()
        x, y = [p.real for p in points], [p.imag for p in points]
        if wall.kind in FILLED:
            axes.fill(x, y, fc=FILLED[wall.kind], ec=NOSE, lw=1.4)
        else:
            axes.plot(x, y, color=NOSE, lw=1.4)


# -- the balls -------------------------------------------------------------------------------------


def colours(world: Movable, name: str) -> tuple[str, str]:
    """Of the ball, and darker, of its edge."""
    for word, body in BODIES.items():
        if name.startswith(word):
            return body, DARK[word]
    number = [ball.name for ball in world.balls].index(name)
    return OTHERS[number % len(OTHERS)], INK


def lay_paths(
    axes: "Axes", world: Movable, dashed: bool, balls: Iterable[str] | None = None
) -> None:
    """The way of these balls, or of all; where each began and where it is."""
    from matplotlib.patches import Circle
    from matplotlib.patheffects import Normal, Stroke

    _, paths = trace(world, RATE)
    for i, ball in enumerate(world.balls):
        if balls is not None and ball.name not in balls:
            continue
        body, dark = colours(world, ball.name)
        x, y = paths[:, i, 0], paths[:, i, 1]
        if dashed:
            axes.plot(x, y, color=dark, lw=1.4, dashes=(4, 2.5), zorder=5)
        else:
            halo = [Stroke(linewidth=4.2, foreground=dark), Normal()]
            axes.plot(x, y, color=body, lw=2.6, zorder=4, path_effects=halo, solid_capstyle="round")
            axes.add_patch(Circle((x[0], y[0]), ball.radius, fc="none", ec=dark, lw=1.8, zorder=6))
        style: Any = {"fc": CLOTH, "ls": (0, (2.5, 1.5))} if dashed else {"fc": body}
        axes.add_patch(Circle((x[-1], y[-1]), ball.radius, ec=dark, lw=1.4, zorder=7, **style))


def lay_marks(axes: "Axes", world: Movable) -> None:
    """What happened where."""
    for event in world.log:
        if event.kind in MARKS:
            lay_mark(axes, event)


def lay_mark(axes: "Axes", event: Event) -> None:
    shape, size, _ = MARKS[event.kind]
    axes.plot(*event.point, shape, ms=size, mfc=INK, mec=PAPER, mew=0.9, zorder=8)


def legend(figure: "Figure", world: Movable, engine: str, dashes: str) -> None:
    """What the marks and lines mean, in one row below the picture."""
    from matplotlib.lines import Line2D

    rows: list[tuple[Line2D, str]] = []
    for ball in world.balls if len(world.balls) <= NAMED else ():
        body, dark = colours(world, ball.name)
        disc = Line2D([], [], marker="o", ls="", ms=9, mfc=body, mec=dark)
        rows.append((disc, ball.name))
    rows.append((Line2D([], [], color=INK, lw=2.6), engine))
    if dashes:
        rows.append((Line2D([], [], color=INK, lw=1.4, dashes=(4, 2.5)), dashes))
    happened = {event.kind for event in world.log}
    for kind, (shape, size, word) in MARKS.items():
        if kind in happened:
            mark = Line2D([], [], marker=shape, ls="", ms=size, mfc=INK, mec=PAPER)
            rows.append((mark, word))
    figure.legend(
        *zip(*rows, strict=True), loc="lower center", ncols=len(rows), frameon=False,
        fontsize=10, labelcolor=INK, handletextpad=0.5, columnspacing=1.3,
    )  # fmt: skip
