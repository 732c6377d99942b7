"""Rounded boxes and discs of the interface, drawn once for each size and state and kept."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import pygame

from game.render.arrays import Bytes
from game.render.theme import ACCENT, LINE, PANEL, Colour

RADIUS = 6
"""Corner radius of everything, px at s = 1."""
RING = 3
"""Width of the focus ring, px at s = 1."""


def box(
    surface: pygame.Surface,
    rect: pygame.Rect,
    s: float,
    fill: Colour = PANEL,
    border: Colour = LINE,
    width: float = 1.0,
    ring: bool = False,
    radius: float = RADIUS,
) -> pygame.Rect:
    """Draw a rounded box; `width` (px at s = 1) lies inside `rect`, the focus ring outside it."""
    edge = max(1, round(width * s))
    halo = max(2, round(RING * s)) if ring else 0
    picture = _box(rect.size, round(radius * s, 2), fill, border, edge, halo)
    return surface.blit(picture, (rect.x - halo, rect.y - halo))


@lru_cache(maxsize=256)
def _box(
    size: tuple[int, int], radius: float, fill: Colour, border: Colour, edge: int, halo: int
) -> pygame.Surface:
    """Return the box with its transparent corners: only the corners are worked out per pixel."""
    outer = (size[0] + 2 * halo, size[1] + 2 * halo)
    picture = pygame.Surface(outer, pygame.SRCALPHA, 32)
    if halo:
        picture.fill((*ACCENT, 56))
    middle = picture.get_rect().inflate(-2 * halo, -2 * halo)
    picture.fill((*border, 255), middle)
    picture.fill((*fill, 255), middle.inflate(-2 * edge, -2 * edge))
    reach = min(int(np.ceil(radius + halo)) + 1, outer[0] // 2, outer[1] // 2)
    _corners(picture, _corner(reach, radius, halo, edge, fill, border))
    return picture


def _corner(
    reach: int, radius: float, halo: int, edge: int, fill: Colour, border: Colour
) -> tuple[Bytes, Bytes]:
    """Return colour and alpha (reach, reach) of the top left corner."""
    i = halo + radius - np.arange(reach) - 0.5
    away = np.hypot(i[:, None].clip(0, None), i[None].clip(0, None)) - radius
    away = np.maximum(away, np.maximum(i[:, None], i[None]) - radius)
    inside = (0.5 - away).clip(0, 1)
    core = (0.5 - edge - away).clip(0, 1)[..., None]
    colour = np.array(border) + (np.array(fill) - np.array(border)) * core
    alpha = inside.copy()
    if halo:
        around = (halo + 0.5 - away).clip(0, 1) * 0.22
        alpha = inside + around * (1 - inside)
        share = (inside / np.maximum(alpha, 1e-6))[..., None]
        colour = np.array(ACCENT) + (colour - np.array(ACCENT)) * share
    return np.round(colour).astype(np.uint8), np.round(alpha * 255).astype(np.uint8)


def _corners(picture: pygame.Surface, corner: tuple[Bytes, Bytes]) -> None:
    """Copy one corner to all four."""
    colour, alpha = corner
    reach = alpha.shape[0]
    pixels, cover = pygame.surfarray.pixels3d(picture), pygame.surfarray.pixels_alpha(picture)
    for a in (1, -1):
        for b in (1, -1):
            pixels[::a, ::b][:reach, :reach] = colour
            cover[::a, ::b][:reach, :reach] = alpha


@lru_cache(maxsize=256)
def _disc(radius: float, colour: Colour, edge: Colour, width: float) -> pygame.Surface:
    """Return a disc with a rim `width` px wide in the colour `edge`."""
    half = int(np.ceil(radius)) + 1
    axis = np.arange(2 * half + 1) - half
    away = np.hypot(axis[:, None], axis[None])
    core = (radius - width + 0.5 - away).clip(0, 1)[..., None]
    picture = pygame.Surface((2 * half + 1, 2 * half + 1), pygame.SRCALPHA, 32)
    pixels = np.array(edge) + (np.array(colour) - np.array(edge)) * core
    pygame.surfarray.pixels3d(picture)[:] = np.round(pixels)
    pygame.surfarray.pixels_alpha(picture)[:] = np.round((radius + 0.5 - away).clip(0, 1) * 255)
    return picture


def disc(
    surface: pygame.Surface,
    centre: tuple[float, float],
    radius: float,
    colour: Colour,
    edge: Colour | None = None,
    width: float = 0.0,
) -> pygame.Rect:
    """Draw a disc centred on the pixel at `centre`, for interface dots that never move smoothly."""
    picture = _disc(round(radius, 2), colour, edge or colour, width)
    half = picture.get_width() // 2
    return surface.blit(picture, (int(centre[0]) - half, int(centre[1]) - half))


def bar(surface: pygame.Surface, rect: pygame.Rect, colour: Colour) -> pygame.Rect:
    """Draw a bar with round ends."""
    radius = min(rect.w, rect.h) / 2
    return surface.blit(_box(rect.size, radius, colour, colour, 1, 0), rect)
