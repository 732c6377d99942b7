"""Small pictures of the interface, drawn large once and averaged: bars, gear, loudspeaker."""

from __future__ import annotations

from functools import lru_cache
from math import cos, pi, sin

import pygame

from game.render.theme import TEXT_SOFT, Colour

FINER = 4
"""Times the size at which they are drawn before averaging."""
Points = list[tuple[float, float]]


def draw(
    surface: pygame.Surface, rect: pygame.Rect, name: str, s: float, colour: Colour = TEXT_SOFT
) -> pygame.Rect:
    """Draw "coach" "sketch" "menu" "settings" "sound" or "silent" in the middle of `rect`."""
    picture = _icon(name, max(12, round(15 * s)), colour)
    return surface.blit(picture, picture.get_rect(center=rect.center))


@lru_cache(maxsize=32)
def _icon(name: str, px: int, colour: Colour) -> pygame.Surface:
    large = pygame.Surface((px * FINER, px * FINER), pygame.SRCALPHA)
    large.fill((*colour, 0))
    if name == "settings":
        _gear(large, colour)
    elif name == "menu":
        _bars(large, colour)
    elif name == "sketch":
        _pencil(large, colour)
    elif name == "coach":
        _lamp(large, colour)
    else:
        _speaker(large, colour, silent=name == "silent")
    return pygame.transform.smoothscale(large, (px, px))


def _bars(large: pygame.Surface, colour: Colour) -> None:
    size = large.get_width()
    for y in (0.18, 0.45, 0.72):
        bar = pygame.Rect(0, round(y * size), round(0.84 * size), round(0.11 * size))
        bar.centerx = size // 2
        pygame.draw.rect(large, (*colour, 255), bar, border_radius=round(0.05 * size))


def _pencil(large: pygame.Surface, colour: Colour) -> None:
    """A pencil from the top right to the point at the bottom left, with a gap before its end."""
    size, ink = large.get_width(), (*colour, 255)
    parts = (
        ((0.06, 0.94), (0.12, 0.70), (0.30, 0.88)),
        ((0.16, 0.66), (0.62, 0.20), (0.80, 0.38), (0.34, 0.84)),
        ((0.67, 0.15), (0.78, 0.04), (0.96, 0.22), (0.85, 0.33)),
    )
    for part in parts:
        pygame.draw.polygon(large, ink, [(x * size, y * size) for x, y in part])


def _lamp(large: pygame.Surface, colour: Colour) -> None:
    """A light bulb: glass, and two rings of its socket."""
    size, ink = large.get_width(), (*colour, 255)
    pygame.draw.circle(large, ink, (0.5 * size, 0.36 * size), 0.33 * size)
    glass = ((0.22, 0.52), (0.78, 0.52), (0.66, 0.72), (0.34, 0.72))
    pygame.draw.polygon(large, ink, [(x * size, y * size) for x, y in glass])
    for y, wide in ((0.77, 0.34), (0.89, 0.22)):
        ring = pygame.Rect(0, round(y * size), round(wide * size), round(0.08 * size))
        ring.centerx = size // 2
        pygame.draw.rect(large, ink, ring, border_radius=round(0.04 * size))


def _gear(large: pygame.Surface, colour: Colour) -> None:
    size = large.get_width()
    centre = size / 2, size / 2
    teeth: Points = []
    for k in range(8):
        for step, r in ((-0.30, 0.36), (-0.20, 0.48), (0.20, 0.48), (0.30, 0.36)):
            angle = (k + step) * pi / 4
            teeth.append((centre[0] + r * size * cos(angle), centre[1] + r * size * sin(angle)))
    pygame.draw.polygon(large, (*colour, 255), teeth)
    pygame.draw.circle(large, (*colour, 0), centre, 0.17 * size)


def _speaker(large: pygame.Surface, colour: Colour, *, silent: bool) -> None:
    size, ink = large.get_width(), (*colour, 255)
    shape = ((0.04, 0.36), (0.20, 0.36), (0.46, 0.12), (0.46, 0.88), (0.20, 0.64), (0.04, 0.64))
    pygame.draw.polygon(large, ink, [(x * size, y * size) for x, y in shape])
    wide = round(0.09 * size)
    if silent:
        for way in (1, -1):
            tip = 0.17 * way * size
            start, end = (0.62 * size, size / 2 - tip), (0.94 * size, size / 2 + tip)
            pygame.draw.line(large, ink, start, end, round(1.2 * wide))
        return
    for radius in (0.24, 0.44):
        box = pygame.Rect(0, 0, round(2 * radius * size), round(2 * radius * size))
        box.center = (round(0.50 * size), size // 2)
        pygame.draw.arc(large, ink, box, -pi / 3.6, pi / 3.6, wide)
