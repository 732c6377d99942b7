"""The plan of a table with pockets: its cushions as polygons, its holes as circles, metres."""

from __future__ import annotations

from itertools import pairwise
from math import hypot
from typing import NamedTuple

import numpy as np

from game.render.arrays import Floats
from game.render.layout import BORDER, CUSHION
from physics import tables

LINER = 0.015
"""Width of the leather around a hole, m."""
EDGE = 0.010
"""Least width of wood that is left outside the leather, m."""
BEYOND = 0.06
"""How far facings are drawn on behind what the physics needs of them, m."""
MIDDLE = 0.3
"""An outline that comes so near a hole's middle, in radii, crosses the back of the pocket there."""
Polygon = tuple[complex, ...]


class Hole(NamedTuple):
    """One pocket.

    name: that the world knows it by.
    at, radius: of the circle within which a ball's centre drops, m.
    rim, width: centre and radius of the leather's inner edge, the same circle where that has room
        in the wood: a pool table's side holes reach farther back than a rail is wide.
    corner: is it one of the four?
    """

    name: str
    at: complex
    radius: float
    rim: complex
    width: float
    corner: bool

    @property
    def quarter(self) -> tuple[int, int]:
        """Signs of x and y; 0 for x at the middle of a long side."""
        return (self.corner and (1 if self.at.real > 0 else -1)), 1 if self.at.imag > 0 else -1


def holes(table: tables.Table) -> tuple[Hole, ...]:
    """All pockets of a table, in its own order."""
    found = (p for p in table.obstacles if p.kind == "pocket")
    return tuple(_hole(table, p.name, p.points[0], p.radius) for p in found)


def _hole(table: tables.Table, name: str, at: complex, radius: float) -> Hole:
    corner = abs(at.real) > 0.25 * table.length
    rim, width = at, radius
    back = abs(at.imag) + radius - 0.5 * table.width
    room = BORDER - LINER - EDGE
    if not corner and back > room:
        deep = room - CUSHION
        half = 1.02 * _gap(table)
        width = (deep * deep + half * half) / (2.0 * deep)
        rim = complex(at.real, (0.5 * table.width + room - width) * (1 if at.imag > 0 else -1))
    return Hole(name, at, radius, rim, width, corner)


def _gap(table: tables.Table) -> float:
    """Half of the gap between the cushions of a side pocket where the wood begins, m."""
    y = 0.5 * table.width + CUSHION
    for p, q in pairwise(north_east(table)[0]):
        if (p.imag - y) * (q.imag - y) < 0.0 and p.real < 0.25 * table.length:
            return abs(p.real + (y - p.imag) / (q.imag - p.imag) * (q.real - p.real))
    return 0.05


def cushions(table: tables.Table) -> list[Polygon]:
    """The cushions, each from one pocket to the next.

    Their facings go on behind the wood, and a straight line closes them there.
    """
    edge = table.outline
    middles = [(p.points[0], MIDDLE * p.radius) for p in table.obstacles if p.kind == "pocket"]
    pairs = [*pairwise(edge), (edge[-1], edge[0])]
    cuts = [
        k for k, (p, q) in enumerate(pairs) if any(_away(p, q, at) < far for at, far in middles)
    ]
    chains = []
    for first, last in pairwise([*cuts, cuts[0] + len(edge)]):
        chain = [edge[k % len(edge)] for k in range(first + 1, last + 1)]
        chains.append(_closed(chain))
    return chains


def north_east(table: tables.Table) -> tuple[Polygon, Polygon]:
    """The long cushion of that quarter, and the short one in the east."""
    middles = [(sum(chain) / len(chain), chain) for chain in cushions(table)]
    long = max(middles, key=lambda pair: min(pair[0].real, pair[0].imag))[1]
    return long, max(middles, key=lambda pair: pair[0].real - abs(pair[0].imag))[1]


def _closed(chain: list[complex]) -> Polygon:
    """Both facings drawn on."""
    (a, b), (y, z) = chain[:2], chain[-2:]
    return (a + BEYOND * (a - b) / abs(a - b), *chain, z + BEYOND * (z - y) / abs(z - y))


def _away(p: complex, q: complex, at: complex) -> float:
    """The distance of a point from the line between two others."""
    way = q - p
    share = min(1.0, max(0.0, (way.conjugate() * (at - p)).real / abs(way) ** 2)) if way else 0.0
    return abs(p + share * way - at)


def distance(polygon: Polygon, x: Floats, y: Floats) -> Floats:
    """How far points are from a polygon's edge, m: negative inside; x and y of equal shape."""
    near = np.full(x.shape, 1e9, np.float32)
    inside = np.zeros(x.shape, bool)
    for p, q in pairwise((*polygon, polygon[0])):
        ex, ey = q.real - p.real, q.imag - p.imag
        size = hypot(ex, ey)
        if size < 1e-7:
            continue
        px, py = x - np.float32(p.real), y - np.float32(p.imag)
        share = (px * np.float32(ex) + py * np.float32(ey)) * np.float32(1 / size**2)
        share = share.clip(0, 1)
        gap = (px - share * np.float32(ex)) ** 2 + (py - share * np.float32(ey)) ** 2
        near = np.minimum(near, gap)
        if ey:
            crosses = (y < p.imag) != (y < q.imag)
            inside ^= crosses & (px < np.float32(ex / ey) * py)
    near = np.sqrt(near)
    return np.where(inside, -near, near)
