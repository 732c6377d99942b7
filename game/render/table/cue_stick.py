"""The cue, true to scale, with the light of a round stick and a shadow on the cloth."""

from __future__ import annotations

from functools import lru_cache
from math import ceil, cos, radians, sin

import numpy as np
import pygame
from numpy.typing import NDArray

from game.render import raster, theme
from game.render.arrays import Floats, Indices
from game.render.layout import Layout

LENGTH = 1.40
ACROSS = 33
"""Shades across the stick."""
TIP, BUTT = 0.0060, 0.0145
"""Radius at the two ends, m."""
LEAST = 0.012
"""Gap between tip and ball when the cue is not drawn back, m."""
PARTS = (
    (0.0, theme.CUE_TIP),
    (0.010, theme.CUE_FERRULE),
    (0.030, theme.CUE_SHAFT),
    (0.690, theme.CUE_JOINT),
    (0.704, theme.CUE_BUTT),
    (0.930, theme.CUE_WRAP),
    (1.210, theme.CUE_BUTT),
    (1.372, theme.CUE_FERRULE),
    (1.380, theme.CUE_WRAP),
)
"""Where each part begins, metres from the tip."""
SIDEWAYS, DOWNWARDS = 0.12, 0.30
"""How far the butt's shadow is seen from it, in heights."""
FADE = 22
"""Over this many px (at s = 1) the cue fades at the edge of the table, so it crosses no field."""


def draw(
    surface: pygame.Surface,
    layout: Layout,
    ball_xy: tuple[float, float],
    angle_rad: float,
    pullback_m: float,
    alpha: float = 1.0,
    radius: float = 0.03275,
    elevation: float = 0.0,
) -> pygame.Rect:
    """Draw the cue behind a ball at `ball_xy` (m) that is to leave at `angle_rad` (y up).

    `pullback_m` is how far the tip is drawn back from the ball's surface. Raised by `elevation`,
    degrees, it looks shorter, and its shadow leaves it.
    """
    ends = _ends(layout, ball_xy, angle_rad, radius + LEAST + pullback_m, elevation)
    clip = surface.get_clip().clip(layout.table)
    dirty = _shadow(surface, layout, ends, clip, alpha, LENGTH * sin(radians(elevation)))
    near = raster.beside(ends[0], ends[1], BUTT * layout.scale + 1, clip)
    if elevation:  # what is seen of the stick, along the stick
        along = near.along / np.float32(cos(radians(elevation)))
        near = near._replace(along=along.clip(0, LENGTH * layout.scale))
    half = _half(layout, near)
    cover = (half + np.float32(0.5) - near.away).clip(0, 1) * np.float32(alpha)
    spot = near.along.astype(np.intp) * ACROSS + _shade(near, ends, half)
    colour = _texture(layout.scale).reshape(-1, 3).take(spot, axis=0)
    cover *= _inside(layout, near)
    return dirty.union(raster.blend(surface, near.x, near.y, cover, colour, once=True))


def _ends(
    layout: Layout, ball: tuple[float, float], angle: float, back: float, elevation: float
) -> list[tuple[float, float]]:
    """Where tip and butt are on the screen; `back`: from the ball's middle to the tip, m."""
    level = cos(radians(elevation))
    ahead = (cos(angle), sin(angle))
    reach = (back * level, (back + LENGTH) * level)
    return [layout.to_screen(ball[0] - d * ahead[0], ball[1] - d * ahead[1]) for d in reach]


def room(
    layout: Layout,
    ball_xy: tuple[float, float],
    angle_rad: float,
    pullback_m: float,
    radius: float,
    elevation: float = 0.0,
) -> pygame.Rect:
    """Return the rectangle around a cue and its shadow, inside the table."""
    ends = _ends(layout, ball_xy, angle_rad, radius + pullback_m, elevation)
    high = LENGTH * sin(radians(elevation)) * layout.scale
    pad = ceil(0.08 * layout.scale)
    xs = (ends[0][0], ends[1][0], ends[1][0] + SIDEWAYS * high)
    ys = (ends[0][1], ends[1][1], ends[1][1] + DOWNWARDS * high)
    left, top = int(min(xs)), int(min(ys))
    box = pygame.Rect(left, top, int(max(xs)) - left + 1, int(max(ys)) - top + 1)
    return box.inflate(2 * pad, 2 * pad).clip(layout.table)


def _shadow(
    surface: pygame.Surface,
    layout: Layout,
    ends: list[tuple[float, float]],
    clip: pygame.Rect,
    alpha: float,
    high: float,
) -> pygame.Rect:
    """Draw a soft shadow that leaves the cue towards the butt, which is held higher, by `high`
    metres if the cue is raised."""
    scale = layout.scale
    aside, down = 0.020 + SIDEWAYS * high, 0.045 + DOWNWARDS * high
    start = (ends[0][0] + 0.006 * scale, ends[0][1] + 0.010 * scale)
    end = (ends[1][0] + aside * scale, ends[1][1] + down * scale)
    soft = 0.012 * scale
    near = raster.beside(start, end, BUTT * scale + soft, clip)
    edge = np.float32(0.35 * soft) + near.along * np.float32(0.65 * 0.012 / LENGTH)
    t = ((_half(layout, near) + edge - near.away) / (edge + edge)).clip(0, 1)
    cover = t * t * (3 - 2 * t) * np.float32(0.45 * alpha) * _inside(layout, near)
    return raster.blend(surface, near.x, near.y, cover, (2, 6, 10), once=True)


def _half(layout: Layout, near: raster.Beside) -> Floats:
    """Return half the thickness of the stick at each pixel, px."""
    return near.along * np.float32((BUTT - TIP) / LENGTH) + np.float32(TIP * layout.scale)


def _shade(near: raster.Beside, ends: list[tuple[float, float]], half: Floats) -> Indices:
    """Return which shade across the stick each pixel has: the last is that of the upper side."""
    dx, dy = ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]
    up = -1.0 if dx > 0 or (dx == 0 and dy > 0) else 1.0
    turned = (near.across / half).clip(-1, 1) * np.float32(up * (ACROSS - 1) / 2)
    return (turned + np.float32(ACROSS / 2)).astype(np.intp)


def _inside(layout: Layout, near: raster.Beside) -> Floats:
    """Return 1 on the table, falling to 0 at its outer edge."""
    across, down = _ramps(layout)
    return np.minimum(across.take(near.x - layout.table.x), down.take(near.y - layout.table.y))


@lru_cache(maxsize=2)
def _ramps(layout: Layout) -> tuple[Floats, Floats]:
    """Return how much of the cue is to be seen in each column and in each row of the table."""
    ramps = []
    for size in layout.table.size:
        at = np.arange(size, dtype=np.float32) + np.float32(0.5)
        t = (np.minimum(at, size - at) / (FADE * layout.s)).clip(0, 1)
        ramps.append(np.asarray(t * t * (3 - 2 * t), np.float32))
    return ramps[0], ramps[1]


@lru_cache(maxsize=2)
def _texture(scale: float) -> Floats:
    """Return the colours (length, ACROSS, 3) of the whole stick, lit, at `scale` px per metre."""
    metres = np.arange(int(LENGTH * scale) + 2, dtype=np.float32) / np.float32(scale)
    across = np.linspace(-1, 1, ACROSS, dtype=np.float32)
    starts = np.array([start for start, _ in PARTS], np.float32)
    colours = np.array([colour for _, colour in PARTS], np.float32)
    base = colours[np.searchsorted(starts, metres, side="right") - 1][:, None]
    base = np.where(_inlaid(metres[:, None], across)[..., None], np.array(theme.CUE_POINTS), base)
    turned = np.sqrt((1 - (across - 0.25) ** 2 * 0.62).clip(0, 1))
    shine = np.exp(-(((across - 0.38) / 0.20) ** 2))[:, None]
    lit = base * (0.34 + 0.70 * turned[:, None] ** 2)
    return np.asarray((lit + shine * (14 + 0.13 * base)).clip(0, 255), np.float32)


def _inlaid(metres: Floats, across: Floats) -> NDArray[np.bool_]:
    """Say where the long light points of the butt are."""
    inside = (metres > 0.716) & (np.abs(across) < (0.90 - metres) / 0.18)
    return np.asarray(inside & (metres < 0.90 - 0.16 * np.abs(across)))
