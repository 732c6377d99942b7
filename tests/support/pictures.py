"""What tests of the picture share: windows of many shapes, and pixels as numbers."""

from __future__ import annotations

import os

os.environ.setdefault("SDL_VIDEODRIVER", "dummy")

import numpy as np
import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.table.balls import BallSprites

SIZES = [
    (960, 540),
    (1024, 768),
    (1280, 720),
    (1280, 1024),
    (1366, 768),
    (1920, 1080),
    (2560, 1080),
    (1200, 1920),
    (3440, 1440),
    (3840, 2160),
]
TABLES = {"thesis": (2.448, 1.270, 0.03275), "match": (2.844, 1.4224, 0.03075)}


def layouts() -> list[Layout]:
    return [Layout(size, *shape[:2]) for size in SIZES for shape in TABLES.values()]


def pixels(surface: pygame.Surface) -> np.ndarray:
    return pygame.surfarray.array3d(surface)


def sprites(size: tuple[int, int] = (1280, 720)) -> BallSprites:
    return BallSprites(Layout(size, 2.448, 1.270), list(theme.BALLS.values()))


def same(layout: Layout) -> str:
    return f"{layout.size[0]}x{layout.size[1]}-{layout.length}"


def black(layout: Layout) -> pygame.Surface:
    return pygame.Surface(layout.size, 0, 32)


def changed(before: np.ndarray, surface: pygame.Surface) -> pygame.Rect:
    i, j = np.nonzero((pixels(surface) != before).any(axis=-1))
    if not len(i):
        return pygame.Rect(0, 0, 0, 0)
    return pygame.Rect(i.min(), j.min(), i.max() - i.min() + 1, j.max() - j.min() + 1)
