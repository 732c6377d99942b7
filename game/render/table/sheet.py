"""Many balls at once: all that have turned are coloured in one go, each in its cell of a sheet.

A ball costs a third of what `Painter` takes for one, and what it shows is a little less smooth.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
import pygame
from numpy.typing import NDArray

from game.render.arrays import Floats
from game.render.theme import BallLook, Colour

from . import light, prints
from .painter import overlays
from .rotation import Quaternion, rows
from .shades import SHADES, shades


class Turn(NamedTuple):
    """One ball to be painted: its place in the sheet, how it has turned, the light's cell (m), and
    by how many half pixels its centre is off."""

    cell: int
    turn: Quaternion
    where: tuple[float, float]
    half: tuple[int, int]


class Sheet:
    """The pictures of balls that are `shown` with one radius, px.

    `disc`: how large their numbers' are, see `prints`; `finer`: how many times larger they are
    painted, to be averaged.
    """

    def __init__(
        self,
        shown: float,
        looks: Sequence[BallLook],
        cloth: Colour,
        disc: float | None = None,
        finer: int = 1,
    ) -> None:
        radius = shown * finer
        self.cloth = cloth
        self.side = 2 * int(np.ceil(radius + 1))
        halves = [(x, y) for x in (0, 1) for y in (0, 1)]
        discs = [light.normals(self.side, radius, self.side / 2, half) for half in halves]
        self._disc = discs[0]
        # pygame wants rows first: so are these
        flat = [d.transpose(0, 2, 1).reshape(3, -1) for d, _ in discs]
        self._flat = np.ascontiguousarray(np.stack(flat))
        covers = [np.round(255 * c.T).astype(np.uint32).ravel() << np.uint32(24) for _, c in discs]
        self._covers = np.ascontiguousarray(np.stack(covers))
        self._number = {half: k for k, half in enumerate(halves)}
        count, side = len(looks), self.side
        self._paint = np.zeros((count, side * side), np.uint32)
        self.whole = pygame.image.frombuffer(self._paint.data, (side, side * count), "BGRA")
        self.areas = [pygame.Rect(0, side * k, side, side) for k in range(count)]
        """Of the cells: blitting a part of the whole takes a sixth of what a subsurface takes."""
        self.cells = [self.whole.subsurface(area) for area in self.areas]
        self._lights: dict[object, tuple[pygame.Surface, pygame.Surface]] = {}
        self._look(looks, shown, prints.disc_of(shown) if disc is None else disc, finer)

    def _look(self, looks: Sequence[BallLook], shown: float, disc: float, finer: int) -> None:
        """Lay the colours of all looks one behind the other."""
        self._numbered = [bool(look.number) for look in looks]
        self._banded = np.array([look.banded for look in looks])
        tables = [
            prints.printed(look, shown, disc, finer)
            if look.number
            else shades(look, shown * finer)
            for look in looks
        ]
        self._first = np.cumsum([0, *map(len, tables)])[:-1].astype(np.int32)
        self._colours = np.concatenate(tables) & np.uint32(0xFFFFFF)

    def paint(self, turns: Sequence[Turn]) -> None:
        """Paint the cells of balls that have turned, moved or come under another light."""
        # numbered balls first: two slices of an array take a fifth of what two masks of it do
        turns = sorted(turns, key=self._plain)
        cells = np.array([t.cell for t in turns])
        halves = np.array([self._number[t.half] for t in turns])
        matrices = np.array([rows(t.turn) for t in turns], np.float32).reshape(-1, 3, 3)
        flat = self._flat.take(halves, 0)
        own = np.matmul(matrices.transpose(0, 2, 1), flat)
        count = len(turns) - sum(map(self._plain, turns))
        spots = np.empty((len(turns), flat.shape[2]), np.int32)
        if count:
            self._print_spots(own[:count], spots[:count])
        if count < len(turns):
            self._mark_spots(own[count:], cells[count:], spots[count:])
        spots += self._first[cells][:, None]
        self._paint[cells] = self._colours.take(spots) | self._covers.take(halves, 0)
        for turn in turns:
            times, added = self._light(turn.where)
            at = (0, turn.cell * self.side)
            self.whole.blit(times, at, special_flags=pygame.BLEND_RGBA_MULT)
            self.whole.blit(added, at, special_flags=pygame.BLEND_RGBA_ADD)

    def _plain(self, turn: Turn) -> bool:
        return not self._numbered[turn.cell]

    def _print_spots(self, own: Floats, spots: NDArray[np.int32]) -> None:
        """Which texel each pixel shows: a number can be read from either end of its axis."""
        half = np.float32(prints.SIZE / 2)
        across = np.copysign(half - np.float32(0.01), own[:, 0])
        across *= own[:, 1]
        across += half
        down = own[:, 2] * np.float32(0.01 - half)
        down += half
        spots[:] = across
        spots *= prints.SIZE
        spots += down.astype(np.int32)

    def _mark_spots(self, own: Floats, cells: NDArray[np.intp], spots: NDArray[np.int32]) -> None:
        """Which shade each pixel has: bands by their own axis, dots by the nearest of the three."""
        away = np.abs(own)
        step = away.max(axis=1)
        banded = self._banded[cells]
        if banded.any():
            step[banded] = away[banded, 2]
        spots[:] = np.minimum(step * np.float32(SHADES - 1), SHADES - 1)

    def _light(self, where: tuple[float, float]) -> tuple[pygame.Surface, pygame.Surface]:
        """The overlays under the light there; made when they are first asked for."""
        if where not in self._lights:
            normal, _ = self._disc
            whole = np.ones(normal.shape[1:], np.float32)
            self._lights[where] = overlays(normal, whole, where, self.cloth)
        return self._lights[where]


class Fine:
    """The same balls one at a time, painted at twice the size and averaged; made when needed."""

    def __init__(self, radius: float, looks: Sequence[BallLook], cloth: Colour) -> None:
        self._given = radius, looks, cloth
        self.side = 2 * int(np.ceil(2 * radius + 1))
        """In halves of a pixel."""

    @cached_property
    def _sheet(self) -> Sheet:
        radius, looks, cloth = self._given
        return Sheet(radius, looks, cloth, finer=2)

    @cached_property
    def _large(self) -> pygame.Surface:
        return pygame.Surface((self.side + 2, self.side + 2), pygame.SRCALPHA, 32)

    def sprite(self, turn: Turn) -> pygame.Surface:
        """Return a picture of one ball, which keeps what it shows."""
        self._sheet.paint([turn._replace(half=(0, 0))])
        self._large.fill(0)
        flags = pygame.BLEND_RGBA_MAX
        self._large.blit(self._sheet.cells[turn.cell], turn.half, special_flags=flags)
        extent = self._large.get_width() // 2
        return pygame.transform.smoothscale(self._large, (extent, extent))
