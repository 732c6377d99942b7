"""The fan: where the cue ball may go when aim is a little off, as a soft density of paths.

Samples are drawn at half the size into a board of floats, so many thin paths become a mist and not
a bundle of hairs.  They can be added a few a frame.
"""

from __future__ import annotations

import numpy as np
import pygame

from game.render import raster
from game.render.arrays import Floats, Points
from game.render.layout import Layout
from game.render.theme import WHITE, Colour

MOST = 0.32
"""Alpha where very many paths meet."""
HALF = 2
"""The board has one cell for this many px each way."""


class Fan:
    """A density of paths over the bed of one layout."""

    def __init__(self, layout: Layout, colour: Colour = WHITE) -> None:
        self._bed, self._s, self._colour = layout.bed, layout.s, colour
        cells = (self._bed.w // HALF + 1, self._bed.h // HALF + 1)
        self._density = np.zeros(cells, np.float32)
        self._picture: pygame.Surface | None = None
        self.count = 0

    def clear(self) -> None:
        """Forget every sample."""
        self._density[:] = 0
        self._picture, self.count = None, 0

    def add(self, points: Points) -> None:
        """Add one sample path, screen points (decimated ones are faster)."""
        self._picture, self.count = None, self.count + 1
        if len(points) < 2:
            return
        own = [((x - self._bed.x) / HALF, (y - self._bed.y) / HALF) for x, y in points]
        width, height = self._density.shape
        width_px = max(1.0, 0.9 * self._s)
        near = raster.touched(own, width_px, pygame.Rect(0, 0, width, height))
        cover = (1 - near.away / width_px).clip(0, 1)
        spot = near.x * height + near.y
        highest = raster.peak(spot, cover, width * height)
        self._density.reshape(-1)[spot] += highest

    def draw(self, surface: pygame.Surface, alpha: float = 1.0) -> pygame.Rect:
        """Lay the mist over the bed; `alpha` fades it in."""
        if not self.count or alpha <= 0:
            return pygame.Rect(0, 0, 0, 0)
        if self._picture is None:
            self._picture = self._painted()
        self._picture.set_alpha(round(255 * alpha))
        clip = surface.get_clip()
        surface.set_clip(clip.clip(self._bed))
        dirty = surface.blit(self._picture, self._bed)
        surface.set_clip(clip)
        return dirty

    def _painted(self) -> pygame.Surface:
        """Return the density as a picture: alpha rises with the share of paths and levels off."""
        share = _blurred(_blurred(self._density)) * np.float32(9.0 / self.count)
        small = pygame.Surface(self._density.shape, pygame.SRCALPHA, 32)
        small.fill((*self._colour, 0))
        alpha = np.round(255 * MOST * (1 - np.exp(-share)))
        pygame.surfarray.pixels_alpha(small)[:] = alpha
        size = (self._density.shape[0] * HALF, self._density.shape[1] * HALF)
        return pygame.transform.smoothscale(small, size)


def _blurred(board: Floats) -> Floats:
    """Return the board averaged with its neighbours."""
    for axis in (0, 1):
        board = 0.5 * board + 0.25 * (np.roll(board, 1, axis) + np.roll(board, -1, axis))
    return np.asarray(board, np.float32)
