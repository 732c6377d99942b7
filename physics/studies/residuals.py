"""A picture of what a fit leaves over: seen less expected, track by track."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .fit import Fit, StrokeFound
from .grounds import INK
from .plot import MISSING, PAPER, colours, save
from .tracks import Track

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MM = 1e3
MOST = 12  # tracks: more would be too small to read


def picture(found: Fit, tracks: Sequence[Track]) -> Figure:
    """Residuals in mm over time, a row for each of the first twelve tracks; x discs, y rings.

    The band is two standard deviations of the stated noise; a dashed line is where the model leaves
    a track. Without matplotlib an ImportError says what to install.
    """
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise ImportError(MISSING) from None
    shown = list(zip(found.strokes, tracks, strict=True))[:MOST]
    figure = Figure(figsize=(9.0, 1.0 + 1.6 * len(shown)), facecolor=PAPER, layout="constrained")
    for axes, (stroke, track) in zip(
        figure.subplots(len(shown), squeeze=False)[:, 0], shown, strict=True
    ):
        _row(axes, found, stroke, track)
    figure.supxlabel("seconds after the stroke", color=INK, size=10)
    figure.supylabel("seen less expected, mm", color=INK, size=10)
    return figure


def _row(axes: Any, found: Fit, stroke: StrokeFound, track: Track) -> None:
    times = track.times - stroke.start
    band = 2.0 * MM * track.noise
    axes.axhspan(-band, band, color=INK, alpha=0.08, lw=0)
    for k, ball in enumerate(found.world.balls):
        _, dark = colours(found.world, ball.name)
        x, y = MM * stroke.residuals[:, k].T
        axes.plot(times, x, ls="", marker="o", ms=2.0, color=dark, label=ball.name)
        axes.plot(times, y, ls="", marker="o", ms=2.4, mfc="none", mew=0.6, color=dark)
    if stroke.share < 1.0:
        axes.axvline(stroke.share * (times[-1]), color=INK, lw=0.8, ls="--")
    axes.set_title(f"{stroke.name}: {MM * stroke.misfit:.2f} mm", size=9, color=INK, loc="left")
    axes.legend(loc="upper right", fontsize=7, frameon=False, ncols=len(found.world.balls))


def draw(found: Fit, tracks: Sequence[Track], file: str | Path) -> None:
    """The same, as a PNG file."""
    save(picture(found, tracks), file)
