"""Many balls at once: all that have turned are coloured in one go, each in its cell of a sheet.

A ball costs a third of what `Painter` takes for one, and what it shows is a little less smooth.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.render.arrays import Floats
from game.render.theme import BallLook, Colour

from . import light, prints
from .painter import overlays
from .shades import SHADES, shades


class Turn(NamedTuple):
    """One ball to be painted: its place in the sheet, its rotation (3, 3), the light's cell (m),
    and by how many half pixels its centre is off."""

    cell: int
    matrix: Floats
    where: tuple[float, float]
    half: tuple[int, int]


class Sheet:
    """The pictures of balls of one radius, px; `disc`: of their numbers, see `prints`."""

    def __init__(
        self, radius: float, looks: Sequence[BallLook], cloth: Colour, disc: float | None = None
    ) -> None:
        self.radius, self.cloth = radius, cloth
        self.side = 2 * (int(np.ceil(radius)) + 2)
        halves = [(x, y) for x in (0, 1) for y in (0, 1)]
        discs = [light.normals(self.side, radius, self.side / 2, half) for half in halves]
        self._discs = dict(zip(halves, discs, strict=True))
        # pygame wants rows first: so are these
        flat = [d.transpose(0, 2, 1).reshape(3, -1) for d, _ in discs]
        self._flat = np.ascontiguousarray(np.stack(flat))
        self._number = {half: k for k, half in enumerate(halves)}
        count, side = len(looks), self.side
        self._paint = np.zeros((count, side * side), np.uint32)
        self._whole = pygame.image.frombuffer(self._paint.data, (side, side * count), "BGRA")
        self.cells = [self._whole.subsurface((0, side * k, side, side)) for k in range(count)]
        self._lights: dict[object, tuple[pygame.Surface, pygame.Surface]] = {}
        self._look(looks, prints.disc_of(radius) if disc is None else disc)

    def _look(self, looks: Sequence[BallLook], disc: float) -> None:
        """Lay the colours of all looks one behind the other."""
        self._numbered = np.array([bool(look.number) for look in looks])
        self._banded = np.array([look.banded for look in looks])
        tables = [
            prints.printed(look, self.radius, disc) if look.number else shades(look, self.radius)
            for look in looks
        ]
        self._first = np.cumsum([0, *map(len, tables)])[:-1].astype(np.int32)
        self._colours = np.concatenate(tables)

    def paint(self, turns: Sequence[Turn]) -> None:
        """Paint the cells of balls that have turned, moved or come under another light."""
        cells = np.array([t.cell for t in turns])
        matrices = np.stack([t.matrix for t in turns]).transpose(0, 2, 1)
        flat = self._flat[[self._number[t.half] for t in turns]]
        own = np.matmul(matrices, flat)
        numbered = self._numbered[cells]
        if numbered.all():
            spots = self._print_spots(own)
        elif not numbered.any():
            spots = self._mark_spots(own, cells)
        else:
            spots = np.empty((len(turns), flat.shape[2]), np.int32)
            spots[numbered] = self._print_spots(own[numbered])
            spots[~numbered] = self._mark_spots(own[~numbered], cells[~numbered])
        spots += self._first[cells][:, None]
        self._paint[cells] = self._colours.take(spots)
        for turn in turns:
            times, added = self._light(turn)
            at = (0, turn.cell * self.side)
            self._whole.blit(times, at, special_flags=pygame.BLEND_RGBA_MULT)
            self._whole.blit(added, at, special_flags=pygame.BLEND_RGB_ADD)

    def _print_spots(self, own: Floats) -> NDArray[np.int32]:
        """Which texel each pixel shows: a number can be read from either end of its axis."""
        half = np.float32(prints.SIZE / 2)
        across = own[:, 1] * np.copysign(half - 0.01, own[:, 0]) + half
        down = half - own[:, 2] * np.float32(half - 0.01)
        spots = across.astype(np.int32) * prints.SIZE + down.astype(np.int32)
        return np.asarray(spots, np.int32)

    def _mark_spots(self, own: Floats, cells: NDArray[np.intp]) -> NDArray[np.int32]:
        """Which shade each pixel has: bands by their own axis, dots by the nearest of the three."""
        away = np.abs(own)
        step = away.max(axis=1)
        banded = self._banded[cells]
        if banded.any():
            step[banded] = away[banded, 2]
        shade = np.minimum(step * np.float32(SHADES - 1), SHADES - 1)
        return np.asarray(shade.astype(np.int32), np.int32)

    def _light(self, turn: Turn) -> tuple[pygame.Surface, pygame.Surface]:
        """The overlays under that light; made when they are first asked for."""
        key = turn.where, turn.half
        if key not in self._lights:
            normal, cover = self._discs[turn.half]
            self._lights[key] = overlays(normal, cover, turn.where, self.cloth)
        return self._lights[key]
