"""What is drawn on the cloth of a table with pockets: spots, the baulk line, the D."""

from __future__ import annotations

from math import cos, pi, sin

import pygame

from game.render.layout import Layout
from game.render.theme import WHITE, Colour, mix
from physics import tables

from . import lines
from .finish import FINISHES

BENDS = 60
"""Chords of the D."""
CLEAR = 0.004
"""How far from the noses a line ends, m."""


def draw(surface: pygame.Surface, layout: Layout, table: tables.Table, cloth: Colour) -> None:
    """Draw what is marked on a table, by its kind."""
    finish, s = FINISHES[table.kind], layout.s
    ink = mix(cloth, WHITE, 0.72)
    for path in _lines(table) if finish.line else ():
        shown = [layout.to_screen(*p) for p in path]
        lines.polyline(surface, shown, ink, 1.3 * s, 0.50)
    spots = table.spots
    for name in finish.spots:
        if name not in spots:
            continue
        at = layout.to_screen(*spots[name])
        radius = max(1.1, 0.0045 * layout.scale)
        lines.dot(surface, at, radius, mix(cloth, (0, 0, 0), 0.6), 0.7)


def _lines(table: tables.Table) -> list[list[tuple[float, float]]]:
    """The line across the table, and the D on it if there is one; m."""
    x, y = table.head_string, 0.5 * table.width - CLEAR
    found = [[(x, y), (x, -y)]] if x is not None else []
    bow = table.regions.get("D")
    radius = getattr(bow, "radius", None)
    if x is not None and radius is not None:
        turns = (pi * k / BENDS for k in range(BENDS + 1))
        found.append([(x - radius * sin(t), radius * cos(t)) for t in turns])
    return found
