"""The cue, true to scale, with the light of a round stick and a shadow on the cloth."""

from __future__ import annotations

from functools import lru_cache
from math import cos, sin

import numpy as np
import pygame
from numpy.typing import NDArray

from . import raster, theme
from .arrays import Floats
from .layout import Layout

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
) -> pygame.Rect:
    """Draw the cue behind a ball at `ball_xy` (m) that is to leave at `angle_rad` (y up).

    `pullback_m` is how far the tip is drawn back from the ball's surface.
    """
    back = radius + LEAST + pullback_m
    ahead = (cos(angle_rad), sin(angle_rad))
    ends = [
        layout.to_screen(ball_xy[0] - d * ahead[0], ball_xy[1] - d * ahead[1])
        for d in (back, back + LENGTH)
    ]
    clip = surface.get_clip().clip(layout.table)
    dirty = _shadow(surface, layout, ends, clip, alpha)
    near = raster.touched(ends, BUTT * layout.scale + 1, clip)
    metres = near.along / layout.scale
    half = (TIP + (BUTT - TIP) * metres / LENGTH) * layout.scale
    cover = (half + 0.5 - near.away).clip(0, 1) * alpha * _inside(layout, near)
    some = cover > 0
    across = (near.away * _side(near, ends) / half).clip(-1, 1)[some]
    row = near.along[some].astype(np.intp)
    column = ((across + 1) * ((ACROSS - 1) / 2) + 0.5).astype(np.intp)
    colour = _texture(layout.scale)[row, column]
    return dirty.union(raster.blend(surface, near.x[some], near.y[some], cover[some], colour))


def _shadow(
    surface: pygame.Surface,
    layout: Layout,
    ends: list[tuple[float, float]],
    clip: pygame.Rect,
    alpha: float,
) -> pygame.Rect:
    """Draw a soft shadow that leaves the cue towards the butt, which is held higher."""
    scale = layout.scale
    drop = [(ends[0][0] + 0.006 * scale, ends[0][1] + 0.010 * scale)]
    drop.append((ends[1][0] + 0.020 * scale, ends[1][1] + 0.045 * scale))
    soft = 0.012 * scale
    near = raster.touched(drop, BUTT * scale + soft, clip)
    metres = near.along / scale
    half = (TIP + (BUTT - TIP) * metres / LENGTH) * scale
    edge = soft * (0.35 + 0.65 * metres / LENGTH)
    t = ((half + edge - near.away) / (2 * edge)).clip(0, 1)
    cover = 0.45 * t * t * (3 - 2 * t) * alpha * _inside(layout, near)
    return raster.blend(surface, near.x, near.y, cover.astype(np.float32), (2, 6, 10))


def _inside(layout: Layout, near: raster.Touched) -> Floats:
    """Return 1 on the table, falling to 0 at its outer edge."""
    box = layout.table
    x, y = near.x + 0.5, near.y + 0.5
    edge = np.minimum(np.minimum(x - box.x, box.right - x), np.minimum(y - box.y, box.bottom - y))
    t = (edge / (FADE * layout.s)).clip(0, 1).astype(np.float32)
    return np.asarray(t * t * (3 - 2 * t), np.float32)


def _side(near: raster.Touched, ends: list[tuple[float, float]]) -> Floats:
    """Return +1 on the side of the stick that faces up on screen and -1 on the other."""
    dx, dy = ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]
    cross = dx * (near.y + 0.5 - ends[0][1]) - dy * (near.x + 0.5 - ends[0][0])
    facing = 1.0 if dx > 0 or (dx == 0 and dy > 0) else -1.0
    return np.asarray(np.where(cross * facing < 0, 1, -1), np.float32)


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
