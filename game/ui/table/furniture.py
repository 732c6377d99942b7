"""The table of a world as a picture: what it is, and what stands on it beside."""

from __future__ import annotations

from typing import Any

import pygame

from game.render.layout import Layout
from game.render.table.background import background
from game.render.table.obstacles import Thing
from physics import World, tables

SIDES = ("west", "east", "south", "north")
"""The four rails of a world without a table, as they are named everywhere."""


def furnished(layout: Layout, world: World) -> pygame.Surface:
    """The window without cards and balls, for any world."""
    table = world.table if isinstance(world.table, tables.Table) else None
    half = 0.5 * layout.length, 0.5 * layout.width
    own = SIDES if table is None else {piece.name for piece in table.obstacles}
    beside = (wall for wall in world.walls if wall.name not in own)
    things = [thing for wall in beside if (thing := _thing(wall, half)) is not None]
    return background(layout, table=table, things=things)


def _thing(wall: Any, half: tuple[float, float]) -> Thing | None:
    """What of an obstacle is to be drawn; None if nothing is."""
    if wall.kind == "line":
        ends = across(wall.normal, wall.offset, half)
        return Thing("wall", ends) if len(ends) == 2 else None
    if wall.kind in ("post", "pocket"):
        return Thing(wall.kind, [wall.at], wall.radius)
    return Thing("wall", [(p.real, p.imag) for p in wall.curve()])


def across(
    normal: complex, offset: float, half: tuple[float, float]
) -> list[tuple[float, float]]:
    """Both ends of the part of an endless line that is on a bed of half that length and width, m;
    nothing if none is."""
    ends = []
    for sign in (-1.0, 1.0):
        if abs(normal.imag) > 1e-9:
            x = sign * half[0]
            ends.append((x, (offset - normal.real * x) / normal.imag))
        if abs(normal.real) > 1e-9:
            y = sign * half[1]
            ends.append(((offset - normal.imag * y) / normal.real, y))
    inside = sorted(p for p in ends if abs(p[0]) <= half[0] and abs(p[1]) <= half[1])
    return [inside[0], inside[-1]] if len(inside) > 1 else []
