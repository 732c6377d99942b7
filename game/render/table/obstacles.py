"""What stands on a table beside its rails: walls, posts and holes of any world, as cushions."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.render.arrays import Points
from game.render.layout import Layout
from game.render.theme import Colour, mix

from . import leather, lines

WIDTH, FALLS = 0.016, 0.010
"""Width of a strip of cushion, and how far below it its shadow lies, m."""
LIGHTS = ((1.0, 0.55), (0.72, 1.12), (0.25, 1.30))
"""Shares of the width, and their light."""
RIM = 0.006
"""Width of the lip around a hole, m."""


class Thing(NamedTuple):
    """One of them.

    kind: "wall", "post" or "pocket".
    points: along a wall; the middle of what is round; m.
    radius: of what is round, m.
    """

    kind: str
    points: Points
    radius: float = 0.0


def _strip(surface: pygame.Surface, layout: Layout, wall: Points, colour: Colour) -> None:
    """Draw a wall inside the bed: its shadow, its cloth and its lit nose."""
    points = [layout.to_screen(*p) for p in wall]
    width = WIDTH * layout.scale
    below = [(x, y + FALLS * layout.scale) for x, y in points]
    lines.polyline(surface, below, (0, 0, 0), width, 0.40, soft=0.012 * layout.scale)
    for share, light in LIGHTS:
        tone = mix((0, 0, 0), colour, light)
        lines.polyline(surface, points, tone, width * share, soft=max(0.5, width * 0.04))


def draw(surface: pygame.Surface, layout: Layout, thing: Thing, colour: Colour) -> None:
    """Draw anything that stands or gapes inside the table."""
    clip = surface.get_clip()
    surface.set_clip(layout.table.clip(clip))
    if thing.kind == "pocket":
        _hole(surface, layout, thing)
    elif thing.kind == "post":
        _post(surface, layout, thing, colour)
    else:
        _strip(surface, layout, thing.points, colour)
    surface.set_clip(clip)


def _post(surface: pygame.Surface, layout: Layout, post: Thing, colour: Colour) -> None:
    """Draw a post from above: a shadow, a dark edge, a top that the lamps light."""
    (x, y), scale = layout.to_screen(*post.points[0]), layout.scale
    radius = max(post.radius * scale, 2.0)
    lines.ring(surface, (x, y + FALLS * scale), radius, (0, 0, 0), 2.0, 0.25, 0.40)
    for share, light in ((1.0, 0.55), (0.88, 1.12), (0.55, 1.30)):
        lines.dot(surface, (x, y), radius * share, mix((0, 0, 0), colour, light))


def _hole(surface: pygame.Surface, layout: Layout, hole: Thing) -> None:
    """Draw a hole in the bed, with a lip of leather."""
    centre, radius = layout.to_screen(*hole.points[0]), hole.radius * layout.scale
    lip = max(1.5, RIM * layout.scale)
    lines.dot(surface, centre, radius, leather.FLOOR)
    lines.ring(surface, centre, radius, mix(leather.WALL, leather.FLOOR, 0.3), lip, 0.9)
