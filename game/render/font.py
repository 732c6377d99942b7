"""Text in one font: sizes follow the window's scale, every string is rendered once and kept."""

from __future__ import annotations

from bisect import bisect_right
from functools import lru_cache
from io import BytesIO

import numpy as np
import pygame

import assets
from game.text.quoting import drawable

from .theme import Colour

SMALL = 18
"""Below this many px a string is drawn at double size and averaged: SDL_ttf snaps every advance to
whole pixels, which shows as gaps inside small words."""
GAMMA = 0.80
"""Power on the averaged coverage, without which light strokes on dark look thin."""
KEPT = 1500
PART = " · "
CAP_HEIGHT = 0.73
"""Height of a capital in em."""
_INK = np.round(255 * (np.arange(256) / 255) ** GAMMA).astype(np.uint8)
_DATA = b""


def _font(px: int) -> pygame.font.Font:
    global _DATA
    if not pygame.font.get_init():
        pygame.font.init()
    _DATA = _DATA or assets.stream(assets.FONT).getvalue()
    return pygame.font.Font(BytesIO(_DATA), px)


class Type:
    """The font at the scale `s` of a window; sizes are given in px at s = 1."""

    def __init__(self, s: float) -> None:
        self.s = s
        self._fonts: dict[int, pygame.font.Font] = {}
        self._strings: dict[tuple[str, int, Colour], pygame.Surface] = {}

    def px(self, size: float) -> int:
        """Return `size` in px of this window: never below 11, the least that can be read."""
        return max(11, round(size * self.s))

    def cap(self, size: float) -> float:
        """Return the height of a capital in px."""
        return CAP_HEIGHT * self.px(size)

    def width(self, string: str, size: float) -> int:
        """Return the width of `string` in px."""
        px, string = self.px(size), drawable(string)
        if px < SMALL:
            return (self._sized(2 * px).size(string)[0] + 1) // 2
        return self._sized(px).size(string)[0]

    def fitted(self, string: str, size: float, room: float) -> str:
        """Return as much of `string` as fits into `room` px: whole parts between dots, then "…"."""
        while self.width(string, size) > room and PART in string:
            string = string.rpartition(PART)[0].rstrip()
        if self.width(string, size) <= room:
            return string
        # names may be thousands of characters long
        starts = range(1, len(string))
        fits = bisect_right(starts, room, key=lambda n: self.width(string[:n] + "…", size))
        return string[:fits].rstrip() + "…" if fits else ""

    def ascent(self, size: float) -> int:
        """Return how far the baseline lies below the top of a rendered string, px."""
        px = self.px(size)
        return (self._sized(2 * px).get_ascent() + 1) // 2 if px < SMALL else self._ascent(px)

    def render(self, string: str, size: float, colour: Colour) -> pygame.Surface:
        """Return `string` on a transparent surface; the same surface for the same arguments."""
        key = (string, self.px(size), colour)
        surface = self._strings.get(key)
        if surface is None:
            if len(self._strings) >= KEPT:
                del self._strings[next(iter(self._strings))]
            surface = self._strings[key] = self._drawn(*key)
        return surface

    def draw(
        self,
        surface: pygame.Surface,
        string: str,
        pos: tuple[float, float],
        size: float,
        colour: Colour,
        align: str = "left",
    ) -> pygame.Rect:
        """Draw `string` with its baseline at `pos` (px) and return the rectangle it covers.

        `align` is "left", "right" or "centre": which part of the string lies at `pos`.
        """
        ink = self.render(string, size, colour)
        shift = {"left": 0.0, "centre": 0.5, "right": 1.0}[align] * ink.get_width()
        return surface.blit(ink, (round(pos[0] - shift), round(pos[1]) - self.ascent(size)))

    def _sized(self, px: int) -> pygame.font.Font:
        if px not in self._fonts:
            self._fonts[px] = _font(px)
        return self._fonts[px]

    def _ascent(self, px: int) -> int:
        return self._sized(px).get_ascent()

    def _drawn(self, string: str, px: int, colour: Colour) -> pygame.Surface:
        string = drawable(string)
        if px >= SMALL:
            return self._sized(px).render(string, True, colour)
        return _halved(
            self._sized(2 * px).render(string, True, colour), colour, self._ascent(2 * px)
        )


@lru_cache(maxsize=4)
def type_at(s: float) -> Type:
    """Return the font at a scale: the same one every time, which keeps what it has rendered."""
    return Type(s)


def _halved(large: pygame.Surface, colour: Colour, ascent: int) -> pygame.Surface:
    """Return `large` averaged 2 x 2, padded above so that its baseline falls between rows."""
    top = ascent % 2
    width, height = (large.get_width() + 1) // 2, (large.get_height() + top + 1) // 2
    ink = np.zeros((2 * width, 2 * height), np.uint16)
    ink[: large.get_width(), top : top + large.get_height()] = pygame.surfarray.array_alpha(large)
    mean = (ink[::2, ::2] + ink[1::2, ::2] + ink[::2, 1::2] + ink[1::2, 1::2] + 2) >> 2
    small = pygame.Surface((width, height), pygame.SRCALPHA)
    small.fill((*colour, 0))
    pygame.surfarray.pixels_alpha(small)[:] = _INK[mean]
    return small
