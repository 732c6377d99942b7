"""The table of a world as a picture: what it is, and what stands on it beside."""

from __future__ import annotations

from typing import Any

import pygame

from game.render.layout import Layout
from game.render.table import ground, plan
from game.render.table.background import background
from game.render.table.obstacles import Thing
from game.render.table.wells import Wells
from physics import World, tables

from .dropped import Hole

SIDES = ("west", "east", "south", "north")
"""The four rails of a world without a table, as they are named everywhere."""


def furnished(layout: Layout, world: World) -> tuple[pygame.Surface, Wells]:
    """The window without cards and balls, for any world, and the openings of its holes."""
    table, things = table_of(world), beside(layout, world)
    patches = ground.patches(layout, table)
    picture = background(layout, table=table, things=things, patches=patches)
    return picture, Wells(layout, patches, things)


def table_of(world: World) -> tables.Table | None:
    """The table that a world is of, if it is of one."""
    return world.table if isinstance(world.table, tables.Table) else None


def beside(layout: Layout, world: World) -> list[Thing]:
    """What a world has beside the pieces of its table, or beside its four rails."""
    table = table_of(world)
    half = 0.5 * layout.length, 0.5 * layout.width
    own = SIDES if table is None else {piece.name for piece in table.obstacles}
    others = (wall for wall in world.walls if wall.name not in own)
    return [thing for wall in others if (thing := _thing(wall, half)) is not None]


def holes(world: World) -> dict[str, plan.Hole]:
    """The pockets of a world by name, also those that belong to no table."""
    table = table_of(world)
    found = {}
    for wall in _pockets(world):
        at = complex(*wall.at)
        found[wall.name] = plan.Hole(wall.name, at, wall.radius, at, wall.radius, False)
    if table is not None and table.pockets is not None:
        found |= {hole.name: hole for hole in plan.holes(table)}
    return found


def falls_into(world: World) -> dict[str, Hole]:
    """Where balls fall, by the names of the pockets."""
    return {name: Hole(hole.rim, hole.width) for name, hole in holes(world).items()}


def _pockets(world: World) -> list[Any]:
    return [wall for wall in world.walls if wall.kind == "pocket"]


def _thing(wall: Any, half: tuple[float, float]) -> Thing | None:
    """What of an obstacle is to be drawn; None if nothing is."""
    if wall.kind == "line":
        normal, offset = wall.lines(0.0, 0.0)[0]
        ends = across(normal, offset, half)
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
