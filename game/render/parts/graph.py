"""A small graph: curves over time in a frame, what it shows and its largest number, a moment."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import pygame

from game.render import theme
from game.render.font import Type
from game.render.table import lines
from game.render.theme import Colour

if TYPE_CHECKING:
    import numpy.typing as npt

HEAD = 18
"""Room for the name above a graph, px at s = 1."""


class Curve(NamedTuple):
    """Numbers at moments that are equally far apart.

    values  of the curve
    ink     its colour
    faint   is it in the second place?
    """

    values: npt.NDArray[Any]
    ink: Colour
    faint: bool = False


def plot(rect: pygame.Rect, s: float) -> pygame.Rect:
    """Return the part of a graph that the curves are in."""
    head = round(HEAD * s)
    return pygame.Rect(rect.x, rect.y + head, rect.w, rect.h - head)


def graph(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    name: str,
    curves: Sequence[Curve],
    share: float,
) -> None:
    """Draw curves from the left to the right, with a line where `share` of the time has passed."""
    s, room = type_.s, plot(rect, type_.s)
    low, high = bounds(curves)
    type_.draw(surface, name, (rect.x, rect.y + 12 * s), 12, theme.TEXT_SOFT)
    most = f"{high:.3g}" if high > 0.0 or low == 0.0 else f"{low:.3g}"
    most = most.replace("-", "\u2212")
    type_.draw(surface, most, (rect.right, rect.y + 12 * s), 12, theme.TEXT_SOFT, "right")
    zero = room.bottom - round(room.h * -low / (high - low))
    surface.fill(theme.LINE, (room.x, room.y, room.w, max(1, round(s))))
    surface.fill(theme.LINE_INPUT, (room.x, min(zero, room.bottom - 1), room.w, max(1, round(s))))
    for curve in curves:
        _curve(surface, room, s, curve, (low, high))
    at = room.x + round(share * (room.w - 1))
    surface.fill(theme.ACCENT, (at, room.y, max(1, round(s)), room.h))


def bounds(curves: Sequence[Curve]) -> tuple[float, float]:
    """Return the least and the largest number, nought among them; never the same."""
    values = [float(v) for curve in curves for v in (curve.values.min(), curve.values.max())]
    low, high = min([0.0, *values]), max([0.0, *values])
    return (low, high) if high > low else (0.0, 1.0)


def _curve(
    surface: pygame.Surface, room: pygame.Rect, s: float, curve: Curve, ends: tuple[float, float]
) -> None:
    low, high = ends
    step, scale = room.w / max(len(curve.values) - 1, 1), room.h / (high - low)
    points = [
        (room.x + k * step, room.bottom - (float(v) - low) * scale)
        for k, v in enumerate(curve.values)
    ]
    points = lines.decimated(points)
    alpha = 0.45 if curve.faint else 0.95
    lines.polyline(surface, points, curve.ink, 1.4 * s, alpha)
