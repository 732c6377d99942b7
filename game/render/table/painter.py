"""One ball at a time, as smooth as it gets: coloured by direction, lit by overlays, then halved.

Everything is drawn at twice the size and averaged, so edges, dots and half-pixel steps are smooth.
"""

from __future__ import annotations

import numpy as np
import pygame
from numpy.typing import NDArray

from game.render.arrays import Floats
from game.render.theme import Colour

from . import light
from .shades import SHADES


def overlays(
    normal: Floats, cover: Floats, where: tuple[float, float], cloth: Colour
) -> tuple[pygame.Surface, pygame.Surface]:
    """Return what a ball at `where` (m) is multiplied by, and what is added to it then.

    Nothing is added to alpha, so that RGBA_ADD, an eighth of the time, does what RGB_ADD does.
    """
    times, added = light.overlays(normal, cover, *where, cloth)
    pair = [pygame.Surface(cover.shape, pygame.SRCALPHA, 32) for _ in range(2)]
    pair[1].fill((0, 0, 0, 0))
    pygame.surfarray.pixels3d(pair[0])[:] = times[..., :3]
    pygame.surfarray.pixels_alpha(pair[0])[:] = times[..., 3]
    pygame.surfarray.pixels3d(pair[1])[:] = added
    return pair[0], pair[1]


class Painter:
    """Draws any ball of one radius in any orientation; keeps what depends on the radius only."""

    def __init__(self, radius: float, cloth: Colour) -> None:
        self.radius, self.cloth = radius, cloth
        self.side = 2 * (int(np.ceil(2 * radius)) + 3)
        self.normal, self.cover = light.normals(self.side, 2 * radius, self.side / 2)
        # pygame wants rows first, surfarray columns first: paint in rows
        flat = np.ascontiguousarray(self.normal.transpose(0, 2, 1)).reshape(3, -1)
        self._flat = flat * np.float32((SHADES - 1) / 1.0)
        self._paint = np.zeros(self.side * self.side, np.uint32)
        size = (self.side, self.side)
        self._canvas = pygame.image.frombuffer(self._paint.data, size, "BGRA")
        self._large = pygame.Surface((self.side + 2, self.side + 2), pygame.SRCALPHA, 32)
        self._lights: dict[tuple[float, float], tuple[pygame.Surface, pygame.Surface]] = {}

    def lights(self, x: float, y: float) -> tuple[pygame.Surface, pygame.Surface]:
        """Return the overlays for a ball at (x, y) metres."""
        if (x, y) not in self._lights:
            self._lights[x, y] = overlays(self.normal, self.cover, (x, y), self.cloth)
        return self._lights[x, y]

    def sprite(
        self,
        shades: NDArray[np.uint32],
        banded: bool,
        turn: Floats,
        where: tuple[float, float],
        half: tuple[int, int],
    ) -> pygame.Surface:
        """Return the ball turned by `turn`, lit as at `where` (m), moved by `half` half-pixels."""
        own = (turn.T[2:3] if banded else turn.T) @ self._flat
        np.abs(own, out=own)
        step = own[0] if banded else np.maximum(np.maximum(own[0], own[1]), own[2])
        np.take(shades, step.astype(np.int32), out=self._paint, mode="clip")
        times, added = self.lights(*where)
        self._canvas.blit(times, (0, 0), special_flags=pygame.BLEND_RGBA_MULT)
        self._canvas.blit(added, (0, 0), special_flags=pygame.BLEND_RGBA_ADD)
        self._large.fill(0)
        self._large.blit(self._canvas, half, special_flags=pygame.BLEND_RGBA_MAX)
        extent = self._large.get_width() // 2
        return pygame.transform.smoothscale(self._large, (extent, extent))
