"""The lines of balkline and the barred corners of straight rail, drawn on the cloth."""

from __future__ import annotations

from itertools import chain

import pygame

from danggu.players.observer import areas_of
from danggu.rules.balkline import Balkline
from game.render.layout import Layout
from game.render.table import lines
from game.render.table.finish import FINISHES
from game.render.theme import CLOTHS, WHITE, mix
from game.session.session import Session

NEAR = 1e-6
"""Metres within which an edge lies along a cushion, where nothing is drawn."""
Place = tuple[float, float]
Edge = tuple[Place, Place]


def edges(session: Session) -> list[Edge]:
    """The edges of zones and anchors in a game that has any, each once, m."""
    contest, table = session.contest, session.world.table
    rules = contest.match.rules if contest is not None else None
    if not isinstance(rules, Balkline):
        return []
    length, width = table.length, table.width
    found = set()
    for area in chain(*areas_of(rules.name, length, width)):
        for p, q in zip(area.corners, (*area.corners[1:], area.corners[0]), strict=True):
            if not _along_a_cushion(p, q, length, width):
                found.add((min(p, q), max(p, q)))
    return sorted(found)


def _along_a_cushion(p: Place, q: Place, length: float, width: float) -> bool:
    halves = ((0, length / 2), (1, width / 2))
    return any(abs(abs(p[k] + q[k]) - 2 * half) < NEAR for k, half in halves)


def draw(surface: pygame.Surface, layout: Layout, session: Session) -> None:
    """Draw them, as thin as a player draws them with chalk."""
    ink = mix(CLOTHS[FINISHES["carom"].cloth], WHITE, 0.72)
    surface.set_clip(layout.bed)
    for edge in edges(session):
        ends = [layout.to_screen(*p) for p in edge]
        lines.polyline(surface, ends, ink, 1.3 * layout.s, 0.5)
    surface.set_clip(None)
