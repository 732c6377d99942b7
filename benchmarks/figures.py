"""The plots: one style, colours that the colour-blind can tell apart, a marker a method."""

import csv
from pathlib import Path
from typing import Any

# Okabe and Ito's palette
BLUE, SKY, GREEN = "#0072B2", "#56B4E9", "#009E73"
ORANGE, RED, PURPLE = "#E69F00", "#D55E00", "#CC79A7"
GREY, INK = "#8A8A8A", "#222222"
METHODS = {
    "thesis stepping": (RED, "o"),
    "thesis program": (GREY, "X"),
    "Euler": (ORANGE, "s"),
    "RK4": (GREEN, "^"),
    "RK4, contacts located": (PURPLE, "D"),
}
EXACT = {"interpreted": (BLUE, "*"), "compiled": (SKY, "P")}
STYLE = {
    "font.size": 9.5, "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": GREY,
    "axes.titlesize": 10.5, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "axes.grid": True, "grid.color": "#E6E6E6", "grid.linewidth": 0.6, "axes.axisbelow": True,
    "legend.frameon": False, "figure.dpi": 110, "savefig.dpi": 110, "text.color": INK,
    "axes.labelcolor": INK, "xtick.color": INK, "ytick.color": INK,
}  # fmt: skip


def pyplot() -> Any:
    """matplotlib without a window, in this style."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    plt.rcParams.update(STYLE)
    return plt


def save(figure: Any, out: Path, name: str) -> None:
    """Write a PNG of few colours: flat areas need no more, and it stays small."""
    from PIL import Image

    out.mkdir(parents=True, exist_ok=True)
    path = out / f"{name}.png"
    figure.savefig(path)
    pyplot().close(figure)
    with Image.open(path) as picture:
        small = picture.convert("RGB").quantize(128, dither=Image.Dither.NONE)
    small.save(path, optimize=True)


Row = dict[str, str]


def _cloud(axes: Any, rows: list[Row], method: str) -> None:
    """Median error over the least time, with the middle half of the step sizes as a band."""
    mine = [row for row in rows if row["method"] == method]
    colour, marker = METHODS[method]
    low, middle, high, times = (
        [float(row[name]) for row in mine]
        for name in ("its lower quartile", "error at rest m", "its upper quartile", "cpu s")
    )
    axes.fill_between(times, low, high, color=colour, alpha=0.18, lw=0)
    axes.plot(times, middle, color=colour, marker=marker, ms=4.5, lw=1.3, label=method)


def _panel(axes: Any, scene: str, rows: list[Row]) -> None:
    for method in METHODS:
        _cloud(axes, rows, method)
    for way, (colour, marker) in EXACT.items():
        mine = next(row for row in rows if row["method"] == f"exact, {way}")
        axes.plot(
            [float(mine["cpu s"])], [float(mine["error at rest m"])], color=colour, marker=marker,
            ms=11, lw=0, mec="white", mew=0.6, label=f"exact, {way}",
        )  # fmt: skip
    axes.set(xscale="log", yscale="log", title=scene, ylim=(1e-16, 10), xlim=(1.5e-7, 100))
    axes.set_xticks([1e-6, 1e-4, 1e-2, 1], ["1 µs", "100 µs", "10 ms", "1 s"])
    lengths = ["1 fm", "1 pm", "1 nm", "1 µm", "1 mm", "1 m"]
    axes.set_yticks([1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1], lengths)
    axes.minorticks_off()


def work_precision(out: Path) -> None:
    """From work-precision.csv: all scenes in one picture, and the two of the README in another."""
    with (out / "work-precision.csv").open() as file:
        rows = list(csv.DictReader(file))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    _work_precision("work-precision", scenes, rows, 4, out)
    readme = [scene for scene in scenes if scene in ("single ball", "carom shot")]
    if readme:
        _work_precision("fast-accurate", readme, rows, 2, out)


def _work_precision(name: str, scenes: list[str], rows: list[Row], columns: int, out: Path) -> None:
    columns = min(columns, len(scenes) + (len(scenes) > columns))
    lines = -(-len(scenes) // columns)
    figure, grid = pyplot().subplots(
        lines, columns, figsize=(3.2 * columns + 2.0 * (lines == 1), 2.9 * lines + 0.3),
        sharex=True, sharey=True, squeeze=False, layout="constrained",
    )  # fmt: skip
    panels = list(grid.flat)
    for axes, scene in zip(panels, scenes, strict=False):
        _panel(axes, scene, [row for row in rows if row["scene"] == scene])
    for axes in panels[len(scenes) :]:
        axes.set_axis_off()
    handles, labels = panels[0].get_legend_handles_labels()
    if len(panels) > len(scenes):
        panels[-1].legend(handles, labels, loc="center left")
        panels[-1 - columns].tick_params(labelbottom=True)
    else:
        figure.legend(handles, labels, loc="outside right center")
    figure.supxlabel("CPU time for the shot", fontsize=9.5)
    figure.supylabel("error at rest, worst ball", fontsize=9.5)
    save(figure, out, name)
