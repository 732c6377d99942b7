"""What the page of labs has to read: the question, and what was measured beside or beneath it."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from game.render import theme
from game.ui.sight import Sight

from . import page_parts

if TYPE_CHECKING:
    from danggu.labs import Rows, Worksheet

SIZE, FINE = 13, 12
LINE_STEP, PARAGRAPH, ROW = 18, 7, 17
ASIDE = 0.43
"""Share of the width for a table at the right."""
FLAT = 5
"""Rows of a table that is put beneath the question."""

Lines = list[tuple[str, float]]
"""Lines of text, and how far below the first each is, px."""


def draw(surface: pygame.Surface, sight: Sight, sheet: Worksheet, area: pygame.Rect) -> None:
    """Draw the question, and the table if there is room for both."""
    rows = sheet.table()
    flat = len(rows.rows) <= FLAT
    beside = area.copy()
    beside.w = area.w if flat else round((1.0 - ASIDE) * area.w) - sight.layout.px(20)
    lines, end = question(sight, sheet, beside.w)
    tall = height(sight, rows)
    fits = end + tall <= area.h if flat else max(end, tall) <= area.h
    if not fits:
        lines, _ = question(sight, sheet, area.w)
    for line, down in lines:
        at = area.x, area.y + SIZE * sight.layout.s + down
        sight.type.draw(surface, line, at, SIZE, theme.TEXT)
    if fits and flat:
        room = pygame.Rect(area.x, area.y + round(end), area.w, round(tall))
        table(surface, sight, rows, room)
    elif fits:
        wide = round(ASIDE * area.w)
        table(surface, sight, rows, pygame.Rect(area.right - wide, area.y, wide, round(tall)))


def question(sight: Sight, sheet: Worksheet, room: int) -> tuple[Lines, float]:
    """The lines of the question in so many px of width, and how high they are together."""
    s, down, lines = sight.layout.s, 0.0, []
    for part in sheet.question(sight.session.language).split("\n\n"):
        for line in page_parts.wrapped(part, sight.type, SIZE, room):
            lines.append((line, down))
            down += LINE_STEP * s
        down += PARAGRAPH * s
    return lines, down


def height(sight: Sight, rows: Rows) -> float:
    """Of the table, px."""
    return (len(rows.rows) + 1) * ROW * sight.layout.s


def table(surface: pygame.Surface, sight: Sight, rows: Rows, room: pygame.Rect) -> None:
    """Draw what was measured, columns set to the right."""
    from danggu.labs import text

    s, type_, language = sight.layout.s, sight.type, sight.session.language
    step = room.w / len(rows.heads)
    heads = [text.word(head, language) for head in rows.heads]
    cells = [[text.figure(cell, language) for cell in row] for row in rows.rows]
    for down, line in enumerate([heads, *cells]):
        base = room.y + (down * ROW + FINE) * s
        for k, cell in enumerate(line):
            shown = type_.fitted(cell, FINE, step - 4 * s)
            ink = theme.TEXT if down else theme.TEXT_SOFT
            at = room.x + (k + 1) * step, base
            type_.draw(surface, shown, at, FINE, ink, "right")
