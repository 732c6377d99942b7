"""The page of keys, laid over the table until it is closed."""

from __future__ import annotations

import pygame

from game.render import shapes
from game.render.layout import Layout
from game.render.text import Type
from game.render.theme import ACCENT, LINE_TRACK, PANEL, PANEL_RAISED, TEXT, TEXT_SOFT
from game.text import words

ROW = 25
KEY_COLUMN = 118
Rows = tuple[tuple[str, str], ...]
Section = tuple[str, Rows]
LEFT_COLUMN: tuple[Section, ...] = (
    (
        "help.play",
        (
            ("←", "help.left"),
            ("→", "help.right"),
            ("name.digits", "help.digit"),
            ("name.enter", "help.return"),
            ("Ctrl+Enter", "help.ctrl"),
            ("↓", "help.down"),
            ("name.space", "help.space"),
            ("R", "help.retry"),
            ("P", "help.pause"),
            (".", "help.frame"),
            ("End", "help.skip"),
            ("E", "help.engine"),
            ("L", "help.law"),
        ),
    ),
)
RIGHT_COLUMN: tuple[Section, ...] = (
    (
        "help.box",
        (
            ("name.enter", "help.next"),
            ("name.back", "help.back"),
            ("Tab, Shift+Tab", "help.tab"),
            ("Esc", "help.esc"),
        ),
    ),
    (
        "help.numbers",
        (
            ("box.speed", "help.speed"),
            ("box.follow", "help.follow"),
            ("box.masse", "help.masse"),
            ("box.side", "help.side"),
            ("box.angle", "help.angle"),
        ),
    ),
    ("help.always", (("F1", "help.help"), ("F2", "help.language"))),
)


def panel(layout: Layout) -> pygame.Rect:
    """Return the rectangle of the page: as wide as the window's contents, centred."""
    width = layout.shoot.right - layout.table.x - 2 * layout.px(60)
    rect = pygame.Rect(0, 0, width, layout.px(460))
    rect.center = ((layout.table.x + layout.shoot.right) // 2, layout.size[1] // 2)
    return rect


def darken(surface: pygame.Surface) -> None:
    """Put everything into the background."""
    shade = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
    shade.fill((6, 9, 12, 150))
    surface.blit(shade, (0, 0))


def draw(surface: pygame.Surface, layout: Layout, type_: Type, language: str) -> pygame.Rect:
    """Draw the page over a darkened window; returns all of it."""
    darken(surface)
    s, w, rect = layout.s, words(language), panel(layout)
    shapes.box(surface, rect, s, PANEL, LINE_TRACK)
    left, top = rect.x + round(28 * s), rect.y + round(42 * s)
    type_.draw(surface, w["help.title"], (left, top), 20, TEXT)
    type_.draw(surface, w["help.close"], (rect.right - 28 * s, top), 13, TEXT_SOFT, "right")
    middle = rect.x + round(rect.w * 0.515)
    for x, sections in ((left, LEFT_COLUMN), (middle, RIGHT_COLUMN)):
        y = rect.y + 76 * s
        for title, rows in sections:
            y = _section(surface, type_, w, (x, y), title, rows)
    foot = rect.bottom - 22 * s
    type_.draw(surface, w["help.click"], (left, foot), 13, TEXT_SOFT)
    return surface.get_rect()


def _section(
    surface: pygame.Surface,
    type_: Type,
    w: dict[str, str],
    at: tuple[float, float],
    title: str,
    rows: Rows,
) -> float:
    """Draw a title and its rows; returns where the next section begins."""
    s, (x, y) = type_.s, at
    type_.draw(surface, w[title], (x, y), 13, ACCENT)
    y += 8 * s
    for key, said in rows:
        name = w.get(key, key)
        cap = pygame.Rect(x, round(y), type_.width(name, 12) + round(14 * s), round(20 * s))
        shapes.box(surface, cap, s, PANEL_RAISED, LINE_TRACK, radius=4)
        base = cap.centery + type_.cap(12) / 2
        type_.draw(surface, name, (cap.centerx, base), 12, TEXT, "centre")
        type_.draw(surface, w[said], (x + KEY_COLUMN * s, base), 13, TEXT_SOFT)
        y += ROW * s
    return y + 20 * s
