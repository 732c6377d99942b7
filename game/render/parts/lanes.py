"""The timeline: one thin lane a ball, bright where it is fast, marks where something happened."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import pygame

from game.render import theme
from game.render.font import Type
from game.render.theme import Colour, mix

from . import shapes, signs
from .cards import card

LANE, MARKED = 6, 9
"""From lane to lane, px at s = 1, where there is room; what marks need above and below all."""
FULL = 2.5
"""Speed (m/s) from which a lane has its full colour."""
PREVIEW = 0.62


@dataclass(frozen=True)
class Lane:
    """One ball's life in a shot; times are seconds.

    colour    of the ball
    legs      (from, to, mean speed in m/s), drawn one after the other
    cushions  times at which it meets one
    joins     (time, other lane) of each collision; one of the two lanes is enough
    rests     times at which it comes to rest
    drops     times at which it falls into a pocket
    """

    colour: Colour
    legs: tuple[tuple[float, float, float], ...] = ()
    cushions: tuple[float, ...] = ()
    joins: tuple[tuple[float, int], ...] = ()
    rests: tuple[float, ...] = field(default=())
    drops: tuple[float, ...] = field(default=())


class Buttons(NamedTuple):
    """How the buttons look: whether undo and redo have anything to do, whether it plays, speed."""

    undo: bool = False
    redo: bool = False
    playing: bool = False
    rate: str = "\u00d71"


IDLE = Buttons()
BUTTONS = 5


def buttons(rect: pygame.Rect, s: float) -> list[pygame.Rect]:
    """Return where the buttons are: undo, redo, to the beginning, play or pause, to the end."""
    side = round(26 * s)
    boxes = [pygame.Rect(0, 0, side, rect.h) for _ in range(BUTTONS)]
    for i, box in enumerate(boxes):
        box.center = (rect.x + round((19 + 27 * i + (8 if i > 1 else 0)) * s), rect.centery)
    return boxes


def track(rect: pygame.Rect, s: float) -> pygame.Rect:
    """Return the part of the strip whose left and right ends are the shot's beginning and end."""
    left, right = rect.x + round(226 * s), rect.right - round(124 * s)
    return pygame.Rect(left, rect.y, right - left, rect.h)


def speed(rect: pygame.Rect, s: float) -> pygame.Rect:
    """Return where the speed of time is written, with a sign for slower and faster beside it."""
    return pygame.Rect(rect.x + round(151 * s), rect.y, round(58 * s), rect.h)


def rate_halves(rect: pygame.Rect, s: float) -> tuple[pygame.Rect, pygame.Rect]:
    """Return the halves of the speed: slower and faster."""
    whole = speed(rect, s)
    half = whole.w // 2
    return (
        pygame.Rect(whole.x, whole.y, half, whole.h),
        pygame.Rect(whole.x + half, whole.y, whole.w - half, whole.h),
    )


def timeline(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    lanes: Sequence[Lane],
    duration: float,
    label: str,
    state: Buttons = IDLE,
    time: float | None = None,
) -> pygame.Rect:
    """Draw the strip; without `time` it is a preview: paler, without a handle.

    Returns the strip and the room of the handle, which stands out above it.
    """
    s = type_.s
    room = pygame.Rect(rect.x, rect.y - round(7 * s), rect.w, rect.h + round(7 * s))
    surface.fill(theme.BACKGROUND, room)
    card(surface, rect, s)
    preview = time is None
    _buttons(surface, rect, type_, theme.TEXT_FAINT if preview else theme.TEXT, state)
    middle = rect.centery + type_.cap(13) / 2
    tone = theme.TEXT_SOFT if preview else theme.TEXT
    type_.draw(surface, label, (rect.right - 12 * s, middle), 13, tone, "right")
    _lanes(surface, rect, s, lanes, max(duration, 1e-9), PREVIEW if preview else 1.0)
    if time is not None:
        _handle(surface, rect, s, min(max(time / max(duration, 1e-9), 0.0), 1.0))
    return room


def _lanes(
    surface: pygame.Surface,
    rect: pygame.Rect,
    s: float,
    lanes: Sequence[Lane],
    duration: float,
    strength: float,
) -> None:
    """Draw every lane, then the joins above them."""
    strip = track(rect, s)
    thick = max(1, round(1.5 * s))
    apart = min(LANE * s, (rect.h - MARKED * s) / max(len(lanes) - 1, 1))
    rows = [round(rect.centery + (i - (len(lanes) - 1) / 2) * apart) for i in range(len(lanes))]

    def x(time: float) -> int:
        return strip.x + round(time / duration * strip.w)

    for lane, y in zip(lanes, rows, strict=True):
        top = y - thick // 2
        surface.fill(mix(theme.PANEL, theme.LINE_TRACK, 0.7), (strip.x, top, strip.w, thick))
        bright = mix(theme.PANEL, lane.colour, strength)
        shapes.disc(surface, (strip.x - round(8 * s), y), 2 * s, bright)
        for begin, end, pace in lane.legs:
            tone = mix(theme.PANEL, bright, 0.30 + 0.70 * min(pace / FULL, 1.0))
            surface.fill(tone, (x(begin), top, max(1, x(end) - x(begin)), thick))
        for time in lane.cushions:
            half = round(3 * s)
            surface.fill(bright, (x(time) - thick // 2, y - half, thick, 2 * half + 1))
        for time in lane.rests:
            half = max(1, round(2 * s))
            surface.fill(bright, (x(time) - half, y - half, 2 * half + 1, 2 * half + 1))
        for time in lane.drops:
            shapes.disc(surface, (x(time), y), 3 * s, theme.PANEL, bright, max(1.0, 1.5 * s))
    _joins(surface, s, lanes, rows, x, strength)


def _joins(
    surface: pygame.Surface,
    s: float,
    lanes: Sequence[Lane],
    rows: Sequence[int],
    x: Callable[[float], int],
    strength: float,
) -> None:
    """Draw each collision as a line between two lanes with a dot on both."""
    for i, lane in enumerate(lanes):
        for time, other in lane.joins:
            top, bottom = sorted((rows[i], rows[other]))
            line = (x(time) - max(1, round(s)) // 2, top, max(1, round(s)), bottom - top)
            surface.fill(mix(theme.PANEL, theme.TEXT_SOFT, strength * 0.8), line)
            for row, colour in ((rows[i], lane.colour), (rows[other], lanes[other].colour)):
                tone = mix(theme.PANEL, colour, strength)
                shapes.disc(surface, (x(time), row), 2.6 * s, tone)


def _buttons(
    surface: pygame.Surface, rect: pygame.Rect, type_: Type, ink: Colour, state: Buttons
) -> None:
    """Draw undo, redo, |\u25c0, \u25b6 or two bars, \u25b6|, and the speed between its signs."""
    s, off = type_.s, theme.LINE_TRACK
    names = ("undo", "redo", "first", "pause" if state.playing else "play", "last")
    inks = (theme.TEXT if state.undo else off, theme.TEXT if state.redo else off, ink, ink, ink)
    for box, name, tone in zip(buttons(rect, s), names, inks, strict=True):
        signs.draw(surface, box, name, s, tone)
    where = speed(rect, s)
    usual = state.rate == IDLE.rate
    tone = theme.TEXT_FAINT if usual else theme.ACCENT
    place = (where.centerx, rect.centery + type_.cap(13) / 2)
    type_.draw(surface, state.rate, place, 13, tone, "centre")
    side = round(12 * s)
    for name, x in (("slower", where.x), ("faster", where.right - side)):
        box = pygame.Rect(x, rect.y, side, rect.h)
        signs.draw(surface, box, name, s, theme.TEXT_FAINT)


def _handle(surface: pygame.Surface, rect: pygame.Rect, s: float, share: float) -> None:
    """Draw the scrub handle: a tab above the strip and a line through all lanes."""
    strip = track(rect, s)
    x = strip.x + round(share * strip.w)
    width = max(1, round(1.5 * s))
    surface.fill(theme.ACCENT, (x - width // 2, rect.y, width, rect.h - round(4 * s)))
    tab = pygame.Rect(0, rect.y - round(6 * s), round(10 * s), round(12 * s))
    tab.centerx = x
    shapes.box(surface, tab, s, theme.ACCENT, theme.ACCENT, radius=3)
