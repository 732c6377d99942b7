"""Shadows of balls: a sharp one where they touch the cloth, a soft one around, thrown away from
the lamps; a ball in the air leaves its own behind, and the higher it is the paler and wider."""

from __future__ import annotations

import numpy as np
import pygame

from game.render.arrays import Floats

CONTACT, SOFT = (0.80, 1.16, 0.55), (0.55, 1.75, 0.40)
"""Radii at which a disc begins to fade and has gone, and its alpha."""
THROWN = ((SOFT, 1.6), (CONTACT, 0.5))
"""How far each is thrown, beside the other."""
ASIDE, DOWN = 0.35, 0.70
"""How far the shadow of a ball in the air is seen from it, in heights, in the table's middle."""
LAMP = 0.95
"""Height of the lamps, m."""
WIDER, PALER = 6.0, 9.0
"""How a shadow grows and fades with each metre of height."""
Place = tuple[float, float]


def _alpha(away: Floats, inner: float, outer: float, strength: float) -> Floats:
    t = ((outer - away) / (outer - inner)).clip(0, 1)
    return np.asarray(strength * t * t * (3 - 2 * t), np.float32)


def soft_disc(radius: float, inner: float, outer: float, strength: float) -> pygame.Surface:
    """Return a black disc of alpha `strength` that fades out from `inner` to `outer` radii."""
    half = int(np.ceil(radius * outer)) + 1
    axis = np.arange(2 * half, dtype=np.float32) + 0.5 - half
    away = np.hypot(axis[:, None], axis[None]) / radius
    t = ((outer - away) / (outer - inner)).clip(0, 1)
    disc = pygame.Surface((2 * half, 2 * half), pygame.SRCALPHA, 32)
    pygame.surfarray.pixels_alpha(disc)[:] = np.round(255 * strength * t * t * (3 - 2 * t))
    return disc


class Shadows:
    """The shadows of balls of one radius, px; `scale` is px per metre."""

    def __init__(self, radius: float, scale: float) -> None:
        self.radius, self.scale = radius, scale
        self._discs = [(soft_disc(radius, *disc), throw) for disc, throw in THROWN]
        self._joined: dict[Place, tuple[pygame.Surface, int, int]] = {}

    def thrown(self, at: Place) -> list[tuple[pygame.Surface, float, float]]:
        """The two discs of a ball at `at` (m), and how far each is off its centre, px."""
        x, y = 0.12 * at[0] * self.radius, (0.12 - 0.19 * at[1]) * self.radius
        return [(disc, x * throw, y * throw) for disc, throw in self._discs]

    def draw(self, surface: pygame.Surface, centre: Place, at: Place) -> pygame.Rect:
        """Draw the shadow of a ball at `at` (m), whose centre is `centre` on the screen."""
        dirty = None
        for disc, dx, dy in self.thrown(at):
            half = disc.get_width() / 2
            rect = surface.blit(disc, (round(centre[0] + dx - half), round(centre[1] + dy - half)))
            dirty = rect if dirty is None else dirty.union(rect)
        assert dirty is not None
        return dirty

    def draw_joined(
        self, surface: pygame.Surface, middle: tuple[int, int], cell: Place
    ) -> pygame.Rect:
        """The same in one go, thrown as in the middle of its light's cell (m)."""
        if cell not in self._joined:
            self._joined[cell] = self._join(cell)
        disc, left, top = self._joined[cell]
        return surface.blit(disc, (middle[0] + left, middle[1] + top))

    def _join(self, cell: Place) -> tuple[pygame.Surface, int, int]:
        """Both discs as one: what the one lets through, the other one darkens; and where its corner
        is from the ball's middle, px."""
        half = int(np.ceil(self.radius * SOFT[1] * 1.4)) + 2
        axis = np.arange(2 * half, dtype=np.float32) + 0.5 - half
        left = np.ones((2 * half, 2 * half), np.float32)
        for (shape, _), (_, dx, dy) in zip(THROWN, self.thrown(cell), strict=True):
            away = np.hypot(axis[:, None] - dx, axis[None] - dy) / self.radius
            left *= 1 - _alpha(away, *shape)
        disc = pygame.Surface((2 * half, 2 * half), pygame.SRCALPHA, 32)
        pygame.surfarray.pixels_alpha(disc)[:] = np.round(255 * (1 - left))
        seen = disc.get_bounding_rect()
        return disc.subsurface(seen).copy(), seen.x - half, seen.y - half

    def draw_below(
        self, surface: pygame.Surface, centre: Place, at: Place, height: float
    ) -> pygame.Rect:
        """Draw the shadow of a ball that is `height` m above the cloth."""
        disc = soft_disc(
            self.radius * (1 + WIDER * height * 0.5), max(0.1, 0.75 - WIDER * height), 1.25,
            0.55 / (1 + PALER * height),
        )  # fmt: skip
        x, y = self.offset(at, height)
        half = disc.get_width() / 2
        return surface.blit(disc, (round(centre[0] + x - half), round(centre[1] + y - half)))

    def offset(self, at: Place, height: float) -> Place:
        """How far the shadow of a ball in the air is from it, px: away from the lamps."""
        far = height * self.scale
        return far * (ASIDE + 0.5 * at[0] / LAMP), far * (DOWN - 0.5 * at[1] / LAMP)
