"""Measured pictures of the aim panel: the tip point on the ball, the power bar, the thickness."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from math import cos, pi, sin

import numpy as np
import pygame

from game.aim.tip import LIMIT
from game.render import theme
from game.render.font import Type
from game.render.table import light, lines
from game.render.theme import Colour, mix

from . import shapes, signs
from .cards import card

RED = theme.rgb("#C4162E")
AMBER = theme.rgb("#C97400")
"""The theme's warning where it lies on a ball, which is light."""
EIGHTHS_SHOWN = tuple(range(-7, 8))
"""Where the cue ball can be sent past another, in eighths: + on its right; full in the middle."""


def tip_circle(rect: pygame.Rect, s: float) -> tuple[tuple[float, float], float]:
    """Return centre and radius (px) of the ball in the tip card: offsets in R map onto it."""
    head, foot = 36 * s, 17 * s
    radius = int(min((rect.h - head - foot) / 2, (rect.w - 112 * s) / 2))
    return (rect.x + round(16 * s) + radius, rect.y + (rect.h + head - foot) // 2), radius


@lru_cache(maxsize=4)
def _tip_ball(radius: int, body: Colour) -> pygame.Surface:
    """Return a plain lit ball with a grid in eighths of R."""
    side = 2 * radius + 4
    normal, cover = light.normals(side, radius, side / 2)
    shade = light.diffuse(normal, 0, 0) * (1 - 0.62 * light.rim(normal))
    kept = (shade * 0.97 / shade.max()).clip(0, 1) ** (1 / 2.0)
    axis = np.abs(np.arange(side) + 0.5 - side / 2) / radius
    weight = np.zeros(side)
    half = 0.55 / radius
    for line, strength in ((0.0, 0.30), (0.3, 0.09), (0.6, 0.09)):
        weight = np.maximum(weight, strength * (1.5 - np.abs(axis - line) / half).clip(0, 1))
    grid = 1 - np.maximum(weight[:, None], weight[None])
    picture = pygame.Surface((side, side), pygame.SRCALPHA, 32)
    colour = np.array(body)[None, None] * (kept * grid)[..., None]
    pygame.surfarray.pixels3d(picture)[:] = colour.clip(0, 255)
    pygame.surfarray.pixels_alpha(picture)[:] = np.round(cover * 255)
    return picture


def tip(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    title: str,
    point: tuple[float, float],
    values: Sequence[tuple[str, str]],
    safe: bool = True,
    body: Colour = theme.BALLS["white"].body,
    refused: bool = False,
) -> pygame.Rect:
    """Draw the tip picker: `point` is (right, up) in ball radii, `values` are (label, value).

    `safe` says whether the tip holds there; it decides the marker's colour.  `refused` lights the
    ring beyond which a point has been wished.
    """
    s = type_.s
    card(surface, rect, s)
    type_.draw(surface, title, (rect.x + 12 * s, rect.y + 24 * s), 13, theme.TEXT_SOFT)
    (x, y), radius = tip_circle(rect, s)
    ball = _tip_ball(int(radius), body)
    surface.blit(ball, ball.get_rect(center=(x, y)))
    _miscue_ring(surface, (x, y), LIMIT * radius, s, refused)
    _marker(surface, (x + point[0] * radius, y - point[1] * radius), radius, s, safe)
    right = rect.right - 12 * s
    for i, (label, value) in enumerate(values):
        base = rect.y + (50 + 38 * i) * s
        type_.draw(surface, label, (right, base), 13, theme.TEXT_SOFT, "right")
        type_.draw(surface, value, (right, base + 18 * s), 17, theme.TEXT, "right")
    return rect


def _miscue_ring(
    surface: pygame.Surface,
    centre: tuple[float, float],
    radius: float,
    s: float,
    refused: bool,
) -> None:
    """Draw the dashed circle beyond which the tip slips; whole and thick where it has to stop."""
    if refused:
        lines.ring(surface, centre, radius, AMBER, 3.5 * s, 1.0, 0.12)
        return
    count = 96
    circle = [
        (centre[0] + radius * cos(2 * pi * i / count), centre[1] + radius * sin(2 * pi * i / count))
        for i in range(count + 1)
    ]
    dash = 2 * pi * radius / 32
    lines.polyline(surface, circle, RED, 1.5 * s, 0.95, dashes=(0.62 * dash, 0.38 * dash))


def _marker(
    surface: pygame.Surface, centre: tuple[float, float], radius: float, s: float, safe: bool
) -> None:
    """Draw the tip's footprint, true to scale."""
    foot = max(radius * 0.006 / 0.03275 * 0.5, 8 * s)
    lines.dot(surface, (centre[0], centre[1] + 1.5 * s), foot + 1.5 * s, (0, 0, 0), 0.25)
    lines.ring(surface, centre, foot, theme.WHITE, 1.5 * s, 1.0)
    lines.dot(surface, centre, foot - 0.4 * s, theme.rgb("#1F6FB5") if safe else AMBER)
    lines.dot(surface, centre, 1.6 * s, theme.WHITE)


def power_track(rect: pygame.Rect, s: float) -> pygame.Rect:
    """Return the bar of the power card: its ends are no power and all of it."""
    height = round(10 * s)
    return pygame.Rect(
        rect.x + round(12 * s), rect.y + round(47 * s) - height // 2, rect.w - round(24 * s), height
    )


def power(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    title: str,
    value: str,
    unit: str,
    share: float,
    ticks: Sequence[tuple[float, str]],
) -> pygame.Rect:
    """Draw the power bar filled to `share`; `ticks` are (share, label), a label may be empty."""
    s = type_.s
    card(surface, rect, s)
    base = rect.y + 24 * s
    type_.draw(surface, title, (rect.x + 12 * s, base), 13, theme.TEXT_SOFT)
    type_.draw(surface, unit, (rect.right - 12 * s, base), 13, theme.TEXT_SOFT, "right")
    type_.draw(surface, value, (rect.right - 46 * s, base), 20, theme.TEXT, "right")
    track = power_track(rect, s)
    shapes.bar(surface, track, theme.LINE_TRACK)
    x = track.x + track.h / 2 + min(max(share, 0.0), 1.0) * (track.w - track.h)
    shapes.bar(
        surface,
        pygame.Rect(track.x, track.y, round(x) - track.x + track.h // 2, track.h),
        theme.ACCENT,
    )
    for where, label in ticks:
        at = round(track.x + track.h / 2 + where * (track.w - track.h))
        height = round((5 if label else 4) * s)
        surface.fill(theme.LINE_INPUT, (at, track.bottom + round(3 * s), max(1, round(s)), height))
        type_.draw(surface, label, (at + s / 2, rect.y + 72 * s), 11, theme.TEXT_SOFT, "centre")
    lines.dot(surface, (x, track.centery), 10 * s, theme.PANEL)
    lines.dot(surface, (x, track.centery), 7.5 * s, theme.TEXT)
    return rect


def thickness(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    title: str,
    items: Sequence[tuple[str, str]],
    overlap: float,
    colour: Colour,
) -> pygame.Rect:
    """Draw (large value, line below) pairs and the object ball half hidden by the cue ball.

    `overlap` is 0 to 1, negative where the cue ball passes on the other side; None of it is text.
    """
    s = type_.s
    card(surface, rect, s)
    type_.draw(surface, title, (rect.x + 12 * s, rect.y + 24 * s), 13, theme.TEXT_SOFT)
    step = min(92 * s, (rect.w - 24 * s - 112 * s) / max(len(items), 1))
    for i, (value, below) in enumerate(items):
        left = rect.x + round(12 * s + i * step)
        type_.draw(surface, value, (left, rect.y + 59 * s), 26, theme.TEXT)
        type_.draw(surface, below, (left, rect.y + 81 * s), 12, theme.TEXT_SOFT)
    radius = min(20 * s, (rect.h - 24 * s) / 2)
    apart = 2 * radius * (1 - min(abs(overlap), 1.0)) * (1 if overlap >= 0 else -1)
    centre = (rect.right - 66 * s, rect.centery - 9 * s)
    object_ball = (centre[0] - apart / 2, centre[1])
    cue_ball = (centre[0] + apart / 2, centre[1])
    lines.dot(surface, object_ball, radius, colour)
    lines.ring(surface, cue_ball, radius, mix(theme.PANEL, theme.WHITE, 0.96), 1.5 * s, 1.0, 0.25)
    return rect


def eighth_boxes(rect: pygame.Rect, s: float) -> list[pygame.Rect]:
    """Return where the exact eighths of `EIGHTHS_SHOWN` are chosen, in the thickness card."""
    count, width = len(EIGHTHS_SHOWN), 112 * s
    left = rect.right - 66 * s - width / 2
    top, height = rect.bottom - round(27 * s), round(22 * s)
    edges = [round(left + i * width / count) for i in range(count + 1)]
    return [pygame.Rect(a, top, b - a, height) for a, b in pairwise(edges)]


def eighths(
    surface: pygame.Surface, rect: pygame.Rect, type_: Type, overlap: float, colour: Colour
) -> pygame.Rect:
    """Draw a tick for each eighth and a sign below the present `overlap` (as in `thickness`)."""
    boxes, s = eighth_boxes(rect, type_.s), type_.s
    if not boxes:
        return rect
    for box, eighth in zip(boxes, EIGHTHS_SHOWN, strict=True):
        tall = round((9 if eighth == 0 else 7 if eighth % 4 == 0 else 4) * s)
        tick = pygame.Rect(0, 0, max(1, round(s)), tall)
        tick.midbottom = (box.centerx, box.y + round(11 * s))
        surface.fill(theme.TEXT_SOFT if eighth % 4 == 0 else theme.LINE_INPUT, tick)
    past = 8 * (1 - abs(overlap)) * (1 if overlap >= 0 else -1)
    step = (boxes[-1].centerx - boxes[0].centerx) / (len(boxes) - 1)
    x = min(max(boxes[len(boxes) // 2].centerx + past * step, boxes[0].x), boxes[-1].right)
    place = pygame.Rect(round(x), boxes[0].y + round(16 * s), 1, 1)
    signs.draw(surface, place, "here", s, colour)
    return rect
