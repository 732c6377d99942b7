"""Numbers beside balls that are too small for them, or whose colours not everyone can tell apart.

Each stands where there is most room; in a cluster there is none, and a ball goes without.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cos, hypot, radians, sin
from typing import NamedTuple

import pygame

from game.render.arrays import Points
from game.render.font import Type
from game.render.layout import Layout
from game.render.theme import TEXT, Colour

WAYS = (-45, -135, -90, 0, 180, 45, 135, 90)
"""Directions in which a tag is tried, degrees clockwise from the right: the better ones first."""
SIZE, GAP = 11, 7.5
"""Of the digits, and how far their middle is from the ball's edge; px at s = 1."""
ROOM, ENOUGH, DISLIKE = 3.0, 15.0, 0.3
"""Px that a tag needs around it; more than enough is no better; what each later way costs."""
OUTLINE = (4, 14, 24)
AROUND = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if x or y]
Place = tuple[float, float]


class Tag(NamedTuple):
    """A ball on the table: its place on the screen and radius, px, and its text; "" for none."""

    at: Place
    radius: float
    text: str


def draw(
    surface: pygame.Surface,
    layout: Layout,
    type_: Type,
    balls: Sequence[Tag],
    paths: Sequence[Points] = (),
    ink: Colour = TEXT,
) -> list[pygame.Rect]:
    """Write beside all balls what they are; `paths` (px) are kept clear, and so is every ball."""
    rects = []
    for ball in balls:
        centre = place(layout, ball, balls, paths) if ball.text else None
        if centre is not None:
            rects.append(_written(surface, type_, ball.text, centre, ink))
    return rects


def place(
    layout: Layout, ball: Tag, balls: Sequence[Tag], paths: Sequence[Points] = ()
) -> Place | None:
    """Where a tag has its middle, px; None if there is no room for it."""
    far = ball.radius + GAP * max(layout.s, 0.85)
    inside = layout.bed.inflate(-14, -14)
    best: tuple[float, Place | None] = (ROOM, None)
    for k, way in enumerate(WAYS):
        at = ball.at[0] + far * cos(radians(way)), ball.at[1] + far * sin(radians(way))
        if inside.collidepoint(at):
            room = min(_room(at, ball, balls, paths), ENOUGH) - k * DISLIKE
            if room > best[0]:
                best = room, at
    return best[1]


def _room(at: Place, own: Tag, balls: Sequence[Tag], paths: Sequence[Points]) -> float:
    """How far the nearest other thing is, px."""
    others = (_gap(at, ball.at) - ball.radius for ball in balls if ball is not own)
    ways = (_from_line(at, p, q) for path in paths for p, q in pairwise(path))
    return min((*others, *ways), default=ENOUGH)


def _gap(p: Place, q: Place) -> float:
    return hypot(p[0] - q[0], p[1] - q[1])


def _from_line(at: Place, p: Place, q: Place) -> float:
    """The distance from a straight piece of a path."""
    dx, dy = q[0] - p[0], q[1] - p[1]
    square = dx * dx + dy * dy
    share = ((at[0] - p[0]) * dx + (at[1] - p[1]) * dy) / square if square else 0.0
    share = min(1.0, max(0.0, share))
    return hypot(at[0] - p[0] - share * dx, at[1] - p[1] - share * dy)


def _written(
    surface: pygame.Surface, type_: Type, text: str, centre: Place, ink: Colour
) -> pygame.Rect:
    """Write a tag with a dark outline, so that it reads on any cloth."""
    bright, dark = (type_.render(text, SIZE, colour) for colour in (ink, OUTLINE))
    x = round(centre[0] - bright.get_width() / 2)
    y = round(centre[1] + type_.cap(SIZE) / 2) - type_.ascent(SIZE)
    for dx, dy in AROUND:
        surface.blit(dark, (x + dx, y + dy))
    return surface.blit(bright, (x, y)).inflate(2, 2)
