"""Balls with dots that roll: a sprite is coloured by direction, lit by overlays, then halved.

Everything is drawn at twice the size and averaged, so edges, dots and half-pixel steps are smooth.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import pygame
from numpy.typing import NDArray

from game.render.arrays import Floats
from game.render.layout import Layout
from game.render.theme import CLOTHS, BallLook, Colour

from . import light
from .rotation import RACKED, Quaternion, matrix, rotated, unit

SHADES = 2048
"""Steps from the middle of a mark's axis to its side: enough for a smooth edge at 4K."""
CELLS = (17, 9)
"""Light changes in steps of this many cells along and across the table."""
RADIUS = 0.03275


def _shades(look: BallLook, radius: float) -> NDArray[np.uint32]:
    """Return the colour (BGRA packed) for each step of the coordinate that `look.marks` cuts."""
    t = np.arange(SHADES, dtype=np.float64) / (SHADES - 1)
    painted = np.zeros(SHADES)
    for low, high in look.marks:
        ends = [
            (np.sqrt(max(0.0, 1 - e * e)) if not look.banded else 1.0) / radius for e in (low, high)
        ]
        rise = ((t - low) / max(ends[0], 1e-6) + 0.5).clip(0, 1)
        fall = ((high - t) / max(ends[1], 1e-6) + 0.5).clip(0, 1)
        painted = np.maximum(painted, np.minimum(rise, fall))
    body, mark = np.array(look.body), np.array(look.mark)
    r, g, b = np.round(body + (mark - body) * painted[:, None]).astype(np.uint32).T
    return np.asarray(np.uint32(255) << 24 | r << 16 | g << 8 | b, np.uint32)


class _Painter:
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
            times, added = light.overlays(self.normal, self.cover, x, y, self.cloth)
            pair = [pygame.Surface((self.side, self.side), pygame.SRCALPHA, 32) for _ in range(2)]
            pair[1].fill((0, 0, 0, 0))
            pygame.surfarray.pixels3d(pair[0])[:] = times[..., :3]
            pygame.surfarray.pixels_alpha(pair[0])[:] = times[..., 3]
            pygame.surfarray.pixels3d(pair[1])[:] = added
            self._lights[x, y] = (pair[0], pair[1])
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
        self._canvas.blit(added, (0, 0), special_flags=pygame.BLEND_RGB_ADD)
        self._large.fill(0)
        self._large.blit(self._canvas, half, special_flags=pygame.BLEND_RGBA_MAX)
        extent = self._large.get_width() // 2
        return pygame.transform.smoothscale(self._large, (extent, extent))


def _soft_disc(radius: float, inner: float, outer: float, strength: float) -> pygame.Surface:
    """Return a black disc of alpha `strength` that fades out from `inner` to `outer` radii."""
    half = int(np.ceil(radius * outer)) + 1
    axis = np.arange(2 * half, dtype=np.float32) + 0.5 - half
    away = np.hypot(axis[:, None], axis[None]) / radius
    t = ((outer - away) / (outer - inner)).clip(0, 1)
    disc = pygame.Surface((2 * half, 2 * half), pygame.SRCALPHA, 32)
    pygame.surfarray.pixels_alpha(disc)[:] = np.round(255 * strength * t * t * (3 - 2 * t))
    return disc


class BallSprites:
    """The pictures of some balls on one table, each with its own orientation.

    `looks` is one look a ball, drawn by its place in that order; `radius` is theirs in metres.
    """

    def __init__(
        self,
        layout: Layout,
        looks: Sequence[BallLook],
        radius: float = RADIUS,
        cloth: str = "blue",
    ) -> None:
        self.layout, self.looks, self.radius = layout, tuple(looks), radius
        self.px = radius * layout.scale
        self._painter = _Painter(self.px, CLOTHS[cloth])
        self._shades = [_shades(look, 2 * self.px) for look in self.looks]
        self._orientations = [_racked(i) for i in range(len(self.looks))]
        self._matrices = [matrix(q) for q in self._orientations]
        self._sprites: list[tuple[tuple[object, ...], pygame.Surface] | None]
        self._sprites = [None] * len(self.looks)
        self._contact = _soft_disc(self.px, 0.80, 1.16, 0.55)
        self._soft = _soft_disc(self.px, 0.55, 1.75, 0.40)

    def rotate(self, index: int, spin: tuple[float, float, float], dt: float) -> None:
        """Turn a ball with `spin` (wx, wy, wz in rad/s, z to the viewer) for `dt` seconds."""
        self.orient(index, rotated(self._orientations[index], spin, dt))

    def advance(self, index: int, rotation: tuple[float, float, float]) -> None:
        """Turn a ball by a rotation vector in radians."""
        self.rotate(index, rotation, 1.0)

    def orientation(self, index: int) -> Quaternion:
        """Return how a ball has turned since it was made of glass and light, scalar part first."""
        return self._orientations[index]

    def orient(self, index: int, turn: Quaternion) -> None:
        """Set how a ball has turned, as `orientation` gave it (for scrubbing and undo)."""
        if turn != self._orientations[index]:
            self._orientations[index] = turn
            self._matrices[index] = matrix(turn)

    def rack(self) -> None:
        """Turn every ball back to how it lay at the beginning."""
        for index in range(len(self.looks)):
            self.orient(index, _racked(index))

    def sprite(self, index: int, at: tuple[float, float]) -> tuple[pygame.Surface, tuple[int, int]]:
        """Return the picture of a ball at `at` (m) and where its top left corner goes.

        The same surface comes back while the ball neither turns nor moves half a pixel.
        """
        x, y = self.layout.to_screen(*at)
        left, top = (round(2 * p) - self._painter.side // 2 for p in (x, y))
        half = (left % 2, top % 2)
        key = (self._orientations[index], half, self._cell(at))
        kept = self._sprites[index]
        if kept is None or kept[0] != key:
            look = self.looks[index]
            picture = self._painter.sprite(
                self._shades[index], look.banded, self._matrices[index], self._cell(at), half
            )
            kept = self._sprites[index] = (key, picture)
        return kept[1], ((left - half[0]) // 2, (top - half[1]) // 2)

    def portrait(self, index: int) -> pygame.Surface:
        """Return a ball as it is racked in the middle of the table, for plates and lists."""
        look, turn = self.looks[index], matrix(_racked(index))
        return self._painter.sprite(self._shades[index], look.banded, turn, (0.0, 0.0), (0, 0))

    def shadow(self, surface: pygame.Surface, at: tuple[float, float]) -> pygame.Rect:
        """Draw the shadow of a ball at `at` (m), thrown away from the lamps."""
        x, y = self.layout.to_screen(*at)
        dirty = None
        for disc, throw in ((self._soft, 1.6), (self._contact, 0.5)):
            half = disc.get_width() / 2
            dx, dy = 0.12 * at[0] * self.px * throw, (0.12 - 0.19 * at[1]) * self.px * throw
            rect = surface.blit(disc, (round(x + dx - half), round(y + dy - half)))
            dirty = rect if dirty is None else dirty.union(rect)
        assert dirty is not None
        return dirty

    def draw(self, surface: pygame.Surface, index: int, at: tuple[float, float]) -> pygame.Rect:
        """Draw one ball and its shadow, centred at `at` (m)."""
        shadow = self.shadow(surface, at)
        return shadow.union(surface.blit(*self.sprite(index, at)))

    def draw_all(
        self, surface: pygame.Surface, places: Iterable[tuple[int, tuple[float, float]]]
    ) -> list[pygame.Rect]:
        """Draw balls given as (index, (x, y) m), all shadows below all balls."""
        placed = list(places)
        shadows = [self.shadow(surface, at) for _, at in placed]
        return [
            shadow.union(surface.blit(*self.sprite(index, at)))
            for shadow, (index, at) in zip(shadows, placed, strict=True)
        ]

    def _cell(self, at: tuple[float, float]) -> tuple[float, float]:
        """Return the middle of the light cell that holds `at`, metres."""
        sides = (self.layout.length, self.layout.width)
        x, y = (
            (min(max(round(p / side * n), -(n // 2)), n // 2)) * side / n
            for p, side, n in zip(at, sides, CELLS, strict=True)
        )
        return x, y


def _racked(index: int) -> Quaternion:
    """Return the first orientation of a ball: seen from above, each is turned another way."""
    return rotated(unit(RACKED), (0.0, 0.0, 1.0), 0.5 - 0.9 * (index % 3))
