"""Where a pocket's pixels lie: how far from cushions, wood and hole; measured once, mirrored."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

import numpy as np
import pygame

from game.render.arrays import Floats
from game.render.layout import CUSHION, Layout
from physics import tables

from . import bed, plan

FEATHER = 0.030
"""Width over which a patch turns into the picture around it, m."""
BENT = 0.7
"""Part of a round nose's radius by which a patch reaches farther."""


class Ground:
    """The pixels around a pocket as if it were in the north-east; arrays (width, height), metres.

    hole   the pocket
    east   beyond the line of the short nose
    north  beyond the line of the long nose
    long   from the long cushion, negative inside it
    short  from the short one; far away at a side pocket
    """

    def __init__(
        self, layout: Layout, table: tables.Table, hole: plan.Hole, box: pygame.Rect
    ) -> None:
        self.hole = hole
        across, down = bed.axes(layout, *box)
        self._x, self._y = np.meshgrid(across, down, indexing="ij")
        half = np.array((0.5 * table.length, 0.5 * table.width), np.float32)
        self.east, self.north = self._x - half[0], self._y - half[1]
        long, short = plan.north_east(table)
        # a side pocket lies between two long cushions, one the mirror image of the other
        self.long = plan.distance(long, self._x if hole.corner else np.abs(self._x), self._y)
        self.short = np.full(self._x.shape, 1e3, np.float32)
        if hole.corner:
            self.short = plan.distance(short, self._x, self._y)

    @cached_property
    def rubber(self) -> Floats:
        """From the edge of the nearest cushion, which goes on below the wood; negative inside."""
        return np.asarray(np.minimum(self.long, self.short))

    @cached_property
    def cushion(self) -> Floats:
        """From what is seen of the nearest cushion, negative inside it."""
        return np.maximum(self.rubber, -self.wood)

    @cached_property
    def wood(self) -> Floats:
        """From where the wood begins, positive inside of that."""
        out = np.maximum(self.east, self.north) if self.hole.corner else self.north
        return np.asarray(CUSHION - out, np.float32)

    @cached_property
    def rim(self) -> Floats:
        """From the leather's inner edge, negative inside of it."""
        return np.asarray(self._from(self.hole.rim) - self.hole.width, np.float32)

    @cached_property
    def drop(self) -> Floats:
        """From the edge of the hole, negative in it."""
        edge = self._from(self.hole.at) - np.float32(self.hole.radius)
        return np.asarray(np.maximum(edge, self.rim))

    @cached_property
    def behind(self) -> Floats:
        """Beyond the middle of the leather, away from the table."""
        rim = self.hole.rim
        x, y = self._x - np.float32(rim.real), self._y - np.float32(rim.imag)
        return np.asarray((x + y) * np.float32(0.7071) if self.hole.corner else y)

    @cached_property
    def way(self) -> tuple[Floats, Floats]:
        """The direction from the middle of the leather, of length 1."""
        rim = self.hole.rim
        away = np.maximum(self._from(rim), np.float32(1e-6))
        return (self._x - np.float32(rim.real)) / away, (self._y - np.float32(rim.imag)) / away

    def _from(self, at: complex) -> Floats:
        away = np.hypot(self._x - np.float32(at.real), self._y - np.float32(at.imag))
        return np.asarray(away, np.float32)


class Patch(NamedTuple):
    """One pocket where it is.

    hole: the pocket.
    box: its rectangle of the window.
    sx, sy: signs of its quarter, 0 for x at a side.
    ground: of its mirror image in the north-east.
    """

    hole: plan.Hole
    box: pygame.Rect
    sx: int
    sy: int
    ground: Ground

    def turned(self, values: Floats) -> Floats:
        """A picture of the box as it would lie in the north-east, or back."""
        return values[:: self.sx or 1, :: self.sy]


def patches(layout: Layout, table: tables.Table | None) -> tuple[Patch, ...]:
    """All pockets of a table; one corner and one side are measured."""
    return tuple(_patches(layout, table)) if table is not None and table.pockets else ()


def _patches(layout: Layout, table: tables.Table) -> Iterator[Patch]:
    known: dict[bool, tuple[pygame.Rect, Ground]] = {}
    for hole in sorted(plan.holes(table), key=lambda h: (-h.at.imag, -h.at.real)):
        if hole.corner not in known:
            box = _box(layout, hole.rim, _reach(table, hole))
            known[hole.corner] = box, Ground(layout, table, hole, box)
        box, ground = known[hole.corner]
        sx, sy = hole.quarter
        yield Patch(hole, _mirrored(layout.table, box, sx, sy), sx, sy, ground)


def _reach(table: tables.Table, hole: plan.Hole) -> float:
    """Half the side of a patch: as far as the noses of its pocket bend."""
    assert table.pockets is not None
    mouth = table.pockets.corner if hole.corner else table.pockets.side
    nose = 0.5 * mouth.width
    if hole.corner:
        nose = mouth.width * 0.7072 + hole.rim.real - 0.5 * table.length
    return max(nose + BENT * mouth.rounding + FEATHER, hole.width + plan.LINER + 0.015)


def _box(layout: Layout, centre: complex, reach: float) -> pygame.Rect:
    x, y = layout.to_screen(centre.real, centre.imag)
    far = reach * layout.scale
    table = layout.table
    left, top = int(x - far), max(table.top, int(y - far))
    right, bottom = min(table.right, int(x + far) + 1), int(y + far) + 1
    if not centre.real:  # as many columns on either side
        left = table.x + table.right - right
    return pygame.Rect(left, top, right - left, bottom - top)


def _mirrored(table: pygame.Rect, box: pygame.Rect, sx: int, sy: int) -> pygame.Rect:
    """Its mirror image: the table's middle is that of whole pixels or of halves."""
    x = table.x + table.right - box.right if sx < 0 else box.x
    y = table.y + table.bottom - box.bottom if sy < 0 else box.y
    return pygame.Rect(x, y, *box.size)
