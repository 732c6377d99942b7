"""What the pages laid over the table share: their frame, buttons and wrapped text."""

from __future__ import annotations

from collections.abc import Hashable, Iterator, Sequence
from typing import Protocol

import pygame

from game.render import theme
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.theme import ACCENT, LINE, LINE_INPUT, LINE_TRACK, PANEL, PANEL_RAISED, mix
from game.session.action import Action
from game.session.session import Session
from game.ui.sight import Sight

WIDTH, HEIGHT = 1128, 568
PAD = 28
TOP = 62
"""Where the contents begin, below the title; px at s = 1, as all sizes here."""
FOOT = 44
BUTTON = 38
SIZE = 13


class Page(Protocol):
    """Something laid over the table that takes all keys and the mouse until it is closed."""

    @property
    def typing(self) -> bool:
        """Are characters typed into it?"""
        ...

    def open(self, session: Session) -> None:
        """It has been laid over the table."""
        ...

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        ...

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw it; returns its rectangle."""
        ...

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        ...


def panel(layout: Layout, height: int = HEIGHT) -> pygame.Rect:
    """Return the page's rectangle, in the middle of the window's contents."""
    inside = layout.shoot.right - layout.table.x
    rect = pygame.Rect(0, 0, min(layout.px(WIDTH), inside), layout.px(height))
    rect.center = ((layout.table.x + layout.shoot.right) // 2, layout.size[1] // 2)
    return rect


def inside(layout: Layout) -> pygame.Rect:
    """Return the room for the contents between title and foot."""
    rect, pad = panel(layout), layout.px(PAD)
    top, bottom = rect.y + layout.px(TOP), rect.bottom - layout.px(FOOT)
    return pygame.Rect(rect.x + pad, top, rect.w - 2 * pad, bottom - top)


def close_rect(layout: Layout, height: int = HEIGHT) -> pygame.Rect:
    """Return the button that closes the page."""
    rect, side = panel(layout, height), layout.px(30)
    return pygame.Rect(rect.right - layout.px(18) - side, rect.y + layout.px(16), side, side)


def frame(
    surface: pygame.Surface, sight: Sight, title: str, foot: str, wrong: bool, closing: bool
) -> pygame.Rect:
    """Draw the empty page with its title, the line at its foot and the cross that closes it."""
    layout, type_, s = sight.layout, sight.type, sight.layout.s
    rect = panel(layout)
    shapes.box(surface, rect, s, PANEL, LINE_TRACK)
    type_.draw(surface, title, (rect.x + PAD * s, rect.y + 40 * s), 20, theme.TEXT)
    cross(surface, close_rect(layout), s, closing)
    colour = theme.ERROR if wrong else theme.TEXT_SOFT
    said = type_.fitted(foot, SIZE, rect.w - 2 * PAD * s)
    type_.draw(surface, said, (rect.x + PAD * s, rect.bottom - 16 * s), SIZE, colour)
    return rect


def cross(surface: pygame.Surface, rect: pygame.Rect, s: float, hot: bool) -> None:
    """Draw the button that closes the page."""
    shapes.box(surface, rect, s, PANEL_RAISED, LINE_INPUT if hot else LINE)
    arm = 5 * s
    (x, y), ink = rect.center, theme.TEXT if hot else theme.TEXT_SOFT
    for way in (1, -1):
        for off in (-0.4, 0.4):
            ends = (x - arm + off, y - way * arm), (x + arm + off, y + way * arm)
            pygame.draw.aaline(surface, ink, *ends)


def button(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    label: str,
    focused: bool,
    hot: bool = False,
    primary: bool = False,
) -> None:
    """Draw a button; the primary one is the one that the page is for."""
    s = type_.s
    fill = theme.PRIMARY if primary else mix(PANEL_RAISED, theme.WHITE, 0.06 if hot else 0.0)
    edge = ACCENT if focused else theme.PRIMARY_EDGE if primary else LINE_INPUT
    shapes.box(surface, rect, s, fill, edge, 2.0 if focused else 1.0, ring=focused)
    ink = theme.WHITE if primary or hot or focused else theme.TEXT_SOFT
    base = rect.centery + type_.cap(15) / 2
    room = rect.w - 8 * s
    type_.draw(surface, type_.fitted(label, 15, room), (rect.centerx, base), 15, ink, "centre")


def row_of(rect: pygame.Rect, shares: Sequence[float], gap: int) -> list[pygame.Rect]:
    """Return `rect` cut into pieces beside each other, as wide as their shares say."""
    room, left, found = rect.w - gap * (len(shares) - 1), rect.x, []
    for share in shares:
        wide = round(room * share / sum(shares))
        found.append(pygame.Rect(left, rect.y, wide, rect.h))
        left += wide + gap
    return found


def wrapped(string: str, type_: Type, size: float, room: float) -> Iterator[str]:
    """Cut a text at its spaces into lines that are at most `room` px wide."""
    line = ""
    for word in string.split():
        longer = f"{line} {word}".lstrip()
        if line and type_.width(longer, size) > room:
            yield line
            longer = word
        line = longer
    if line:
        yield line
