"""Ball in hand: where it may be put, and the ball that is held."""

from __future__ import annotations

from math import cos, pi, sin
from typing import Any

import pygame

from game.render.arrays import Points
from game.render.layout import Layout
from game.render.theme import ACCENT, ERROR, WHITE
from physics import tables

from . import lines

DIM, TINT = (4, 10, 18, 96), (*WHITE, 20)
"""What is laid over the bed beside a region, and over the region."""
CUT = 0.02
"""How far beside a mouth the border turns, m: no ball can be put into one."""
BENDS = 48
"""Chords of a half circle."""
DASHES = (5, 4)
"""Of the border, px at s = 1."""


def region(surface: pygame.Surface, layout: Layout, table: tables.Table, name: str) -> pygame.Rect:
    """Show where the centre of a ball in hand may be: one of `table.regions`, by its name.

    If it is a part of the bed the rest is dimmed, and the line at which it ends is bright; the
    border is dashed. KeyError for a name that the table does not know. Returns the rectangle that
    has been drawn in.
    """
    found: Any = table.regions[name]
    s = layout.s
    open_ = [layout.to_screen(*p) for p in outline(table, name)]
    line, room = table.head_string, layout.bed.copy()
    if hasattr(found, "radius") or (line is not None and found.east <= line):
        _dim(surface, layout, _lit(layout, table, found, open_))
        if line is not None and not hasattr(found, "radius"):
            ends = [layout.to_screen(line, sign * 0.5 * table.width) for sign in (1, -1)]
            room.union_ip(lines.polyline(surface, ends, ACCENT, 1.6 * s, 0.95))
    dashes = [d * s for d in DASHES]
    border = lines.polyline(surface, [*open_, open_[0]], ACCENT, 1.2 * s, 0.75, dashes=dashes)
    return room.union(border)


def outline(table: tables.Table, name: str) -> Points:
    """The border of a region, m: corners at pockets are cut off."""
    found: Any = table.regions[name]
    if hasattr(found, "radius"):
        (x, y), turns = found.centre, [pi * k / BENDS for k in range(BENDS + 1)]
        return [(x - found.radius * sin(t), y + found.radius * cos(t)) for t in turns]
    cut = 0.0
    if table.pockets is not None:
        cut = 0.7072 * table.pockets.corner.width + CUT
    west, east, south, north = found.west, found.east, found.south, found.north
    far = east > 0.25 * table.length
    right = cut if far else 0.0
    corners = [
        (east - right, north), (west + cut, north), (west, north - cut), (west, south + cut),
        (west + cut, south), (east - right, south), (east, south + right), (east, north - right),
    ]  # fmt: skip
    return [p for k, p in enumerate(corners) if p != corners[k - 1]]


def _lit(
    layout: Layout, table: tables.Table, found: Any, border: Points
) -> Points:
    """What is not dimmed, as a polygon on the screen: up to the noses, or the D itself."""
    if hasattr(found, "radius"):
        return border
    east = table.head_string if table.head_string is not None else found.east
    half = 0.5 * table.width
    corners = [(-0.5 * table.length, half), (east, half), (east, -half)]
    return [layout.to_screen(*p) for p in (*corners, (-0.5 * table.length, -half))]


def _dim(surface: pygame.Surface, layout: Layout, lit: Points) -> None:
    """Darken the bed outside of a polygon and brighten it inside."""
    bed = layout.bed
    veil = pygame.Surface(bed.size, pygame.SRCALPHA, 32)
    veil.fill(DIM)
    corners = [(x - bed.x, y - bed.y) for x, y in lit]
    pygame.draw.polygon(veil, TINT, corners)
    surface.blit(veil, bed)


def held(
    surface: pygame.Surface, centre: tuple[float, float], radius: float, s: float
) -> pygame.Rect:
    """Draw a ring with four arrows around the ball in hand; `radius` is the ball's, px."""
    rect = lines.ring(surface, centre, radius + 3 * s, ACCENT, 1.5 * s, 0.95)
    x, y = centre
    tip, base, half = radius + 11 * s, radius + 6.5 * s, 3.6 * s
    for u, v in ((1, 0), (0, 1), (-1, 0), (0, -1)):
        foot = x + u * base, y + v * base
        wings = [(foot[0] - k * half * v, foot[1] + k * half * u) for k in (1, -1)]
        point = x + u * tip, y + v * tip
        rect = rect.union(lines.polygon(surface, [point, *wings], ACCENT, 0.95))
    return rect


def forbidden(
    surface: pygame.Surface, centre: tuple[float, float], radius: float, s: float
) -> pygame.Rect:
    """Draw a barred ring where a ball of `radius` px may not be put."""
    x, y = centre
    rect, reach = lines.ring(surface, centre, radius, ERROR, 2.0 * s, 0.95), 0.7071 * radius
    bar = [(x - reach, y - reach), (x + reach, y + reach)]
    return rect.union(lines.polyline(surface, bar, ERROR, 2.0 * s, 0.95))


def blocking(
    surface: pygame.Surface, centre: tuple[float, float], radius: float, s: float
) -> pygame.Rect:
    """Draw a ring around the ball that is in the way; `radius` is the ball's, px."""
    return lines.ring(surface, centre, radius + 3 * s, ERROR, 2.0 * s, 0.95)
