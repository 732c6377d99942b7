"""The card of the cue: tip point on the ball, elevation from the side, how much help is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cos, radians, sin

import pygame

from game.aim.tip import STEEPEST
from game.render import theme
from game.render.font import Type
from game.render.table import lines
from game.render.theme import mix

from . import gauges, shapes

Place = tuple[float, float]
WIDE, HIGH = 92, 62
"""The side view, px at s = 1."""
ARM = 50
"""Length of the drawn cue, px at s = 1: its end is what one takes hold of."""
BALL = 8
CORNER = 108
"""Width of the corner below the ball, px at s = 1."""


def side_view(rect: pygame.Rect, s: float) -> pygame.Rect:
    """Return where the cue is seen from the side, in the card of the tip point."""
    box = pygame.Rect(0, 0, round(WIDE * s), round(HIGH * s))
    box.bottomright = (rect.right - round(8 * s), rect.bottom - round(8 * s))
    return box


def side_ball(rect: pygame.Rect, s: float) -> Place:
    """Return the middle of the ball in the side view."""
    box = side_view(rect, s)
    return box.x + 20 * s, box.bottom - 12 * s


def tip(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    title: str,
    point: Place,
    values: Sequence[tuple[str, str]],
    holds: bool,
    refused: bool,
    elevation: float | None,
) -> pygame.Rect:
    """Draw the card; `point` and `values` as in `gauges.tip`, no `elevation` if there is none."""
    gauges.tip(surface, rect, type_, title, point, values, holds, refused=refused)
    _side(surface, rect, type_.s, elevation)
    return rect


def _side(surface: pygame.Surface, rect: pygame.Rect, s: float, elevation: float | None) -> None:
    (x, y), faint = side_ball(rect, s), mix(theme.PANEL, theme.LINE_INPUT, 0.7)
    box = side_view(rect, s)
    ground = round(y + BALL * s)
    surface.fill(theme.LINE_TRACK, (box.x + round(6 * s), ground, box.w - round(8 * s), 1))
    turns = [radians(STEEPEST * i / 20) for i in range(21)]
    arc = [(x + ARM * s * cos(a), y - ARM * s * sin(a)) for a in turns]
    lines.polyline(surface, arc, faint, 1.2 * s, 0.9)
    steep = radians(elevation or 0.0)
    ahead = (cos(steep), -sin(steep))
    ends = [(x + d * s * ahead[0], y + d * s * ahead[1]) for d in (BALL + 2, ARM)]
    ink = theme.CUE_SHAFT if elevation is not None else faint
    lines.polyline(surface, ends, ink, 3.2 * s)
    lines.dot(surface, (x, y), BALL * s, theme.BALLS["white"].body)
    lines.dot(surface, ends[1], 5.5 * s, theme.TEXT if elevation is not None else faint)


def corner(rect: pygame.Rect, s: float) -> pygame.Rect:
    """Return the lower left corner of the card, below the ball."""
    box = pygame.Rect(0, 0, round(CORNER * s), round(20 * s))
    box.bottomleft = (rect.x + round(6 * s), rect.bottom - round(3 * s))
    return box


def switch(
    surface: pygame.Surface, box: pygame.Rect, type_: Type, said: str, *, on: bool
) -> None:
    """Draw something that a click switches: lit while it is on."""
    s, ink = type_.s, theme.ACCENT if on else theme.TEXT_FAINT
    at = box.x + 6 * s, box.centery + type_.cap(12) / 2
    type_.draw(surface, type_.fitted(said, 12, box.w - 8 * s), at, 12, ink)


def choice_boxes(rect: pygame.Rect, type_: Type, names: Sequence[str]) -> list[pygame.Rect]:
    """Return where the choices are: side by side at the right of the card's first line."""
    s = type_.s
    widths = [type_.width(name, 12) + round(14 * s) for name in names]
    edges = [rect.right - round(10 * s) - sum(widths)]
    for width in widths:
        edges.append(edges[-1] + width)
    top, height = rect.y + round(8 * s), round(22 * s)
    return [pygame.Rect(a, top, b - a, height) for a, b in pairwise(edges)]


def choices(
    surface: pygame.Surface,
    boxes: Sequence[pygame.Rect],
    type_: Type,
    names: Sequence[str],
    chosen: int,
) -> None:
    """Draw one of some choices, lit."""
    s = type_.s
    whole = boxes[0].unionall(list(boxes[1:]))
    shapes.box(surface, whole, s, theme.PANEL_RAISED, theme.LINE_INPUT)
    for index, (box, name) in enumerate(zip(boxes, names, strict=True)):
        if index == chosen:
            inside = box.inflate(-round(4 * s), -round(4 * s))
            lit = mix(theme.PANEL_RAISED, theme.ACCENT, 0.28)
            shapes.box(surface, inside, s, lit, lit, radius=4)
        ink = theme.TEXT if index == chosen else theme.TEXT_SOFT
        middle = (box.centerx, box.centery + type_.cap(12) / 2)
        type_.draw(surface, name, middle, 12, ink, "centre")
