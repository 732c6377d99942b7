"""The families of games beside the menu's title: a tile each, of which one is that of the game."""

from __future__ import annotations

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.theme import ACCENT, LINE_INPUT, PANEL_RAISED, PRIMARY, WHITE, mix
from game.session.terms import DISCIPLINES, FREE, Terms
from game.ui.sight import Sight

from . import page_parts
from .menu_rows import on_its_table

TITLE = 176
"""Room for the title at the left of the tiles, px at s = 1, as all sizes here."""
HEIGHT, GAP = 38, 8
FAMILIES: dict[str, tuple[str, ...]] = {
    "free": (FREE,),
    "carom": tuple(name for name, one in DISCIPLINES.items() if one.position),
    "pool": ("8-ball", "9-ball", "10-ball", "14.1"),
    "snooker": ("snooker",),
    "pyramid": tuple(name for name in DISCIPLINES if name.endswith("pyramid")),
}
"""The games of each, the one first that its tile chooses."""


def family_of(game: str) -> str:
    """The family that a game belongs to."""
    return next(family for family, games in FAMILIES.items() if game in games)


def chosen(terms: Terms, family: str) -> Terms:
    """The terms with the first game of a family, or as they are if the game belongs to it."""
    return terms if family == family_of(terms.game) else on_its_table(terms, FAMILIES[family][0])


def stepped(terms: Terms, way: int) -> Terms:
    """The terms with the next family, or the one before (-1)."""
    names = (*FAMILIES,)
    return chosen(terms, names[(names.index(family_of(terms.game)) + way) % len(names)])


def rects(layout: Layout) -> dict[str, pygame.Rect]:
    """Where the tiles are."""
    area, close = page_parts.inside(layout), page_parts.close_rect(layout)
    left, height = area.x + layout.px(TITLE), layout.px(HEIGHT)
    bar = pygame.Rect(left, 0, close.x - layout.px(24) - left, height)
    bar.centery = close.centery
    pieces = page_parts.row_of(bar, (1,) * len(FAMILIES), layout.px(GAP))
    return dict(zip(FAMILIES, pieces, strict=True))


def at(point: tuple[int, int], layout: Layout) -> str:
    """The family whose tile is at a point of the window, or ""."""
    return next((name for name, rect in rects(layout).items() if rect.collidepoint(point)), "")


def draw(
    surface: pygame.Surface, sight: Sight, terms: Terms, *, focused: bool, over: str
) -> None:
    """Draw the tiles; with `focused` arrows go from one to the next."""
    s, t, mine = sight.layout.s, sight.type, family_of(terms.game)
    for name, rect in rects(sight.layout).items():
        own, hot = name == mine, name == over
        fill = PRIMARY if own else mix(PANEL_RAISED, WHITE, 0.06 if hot else 0.0)
        ring = own and focused
        edge = ACCENT if ring else LINE_INPUT
        shapes.box(surface, rect, s, fill, edge, 2.0 if ring else 1.0, ring=ring)
        ink = WHITE if own or hot else theme.TEXT_SOFT
        said = t.fitted(sight.words[f"family.{name}"], 15, rect.w - 8 * s)
        t.draw(surface, said, (rect.centerx, rect.centery + t.cap(15) / 2), 15, ink, "centre")
