"""The page of keys, laid over the table until it is closed."""

from __future__ import annotations

from collections.abc import Mapping

import pygame

from game.aim.entry import BOXES
from game.input.captions import words
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.theme import ACCENT, LINE_TRACK, PANEL, PANEL_RAISED, TEXT, TEXT_SOFT
from game.session import commands
from game.session.command import HelpRow
from game.text.keycap import cap_name

ROW = 23
KEY_COLUMN = 126
PAD = 26
COLUMNS = (("play", "box"), ("aim", "numbers"), ("time", "always"), ("shots",), ("practice",))
"""The sections of each column: what is in them comes from the table of commands."""
BESIDE = 3
"""Columns of a sheet: there is a second one."""
MOUSE = ("help.mouse.aim", "help.mouse.cue", "help.mouse.time")


def panel(layout: Layout) -> pygame.Rect:
    """Return the rectangle of the page: nearly as wide as the window's contents, centred."""
    width = layout.shoot.right - layout.table.x - 2 * layout.px(12)
    rect = pygame.Rect(0, 0, width, layout.px(584))
    rect.center = ((layout.table.x + layout.shoot.right) // 2, layout.size[1] // 2)
    return rect


def column(layout: Layout) -> int:
    """Return the width of a column, px."""
    return round((panel(layout).w - 2 * PAD * layout.s) / BESIDE)


def sheets() -> int:
    """Return how many sheets there are."""
    return -(-len(COLUMNS) // BESIDE)


def rows(section: str) -> list[HelpRow]:
    """Return the rows of a section."""
    if section == "numbers":
        return [HelpRow(section, n, f"box.{box}", f"help.{box}") for n, box in enumerate(BOXES)]
    return commands.rows()[section]


def caption(key: str, w: Mapping[str, str], names: Mapping[str, str]) -> str:
    """Return what is written on the key, or the keys, of a row."""
    held, *idents = key.split("@")
    if not idents:
        return w.get(key, key)
    return held + " ".join(cap_name(names[ident.strip()], dict(w)) for ident in idents)


def darken(surface: pygame.Surface) -> None:
    """Put everything into the background."""
    shade = pygame.Surface(surface.get_size(), pygame.SRCALPHA)
    shade.fill((6, 9, 12, 150))
    surface.blit(shade, (0, 0))


def draw(
    surface: pygame.Surface,
    layout: Layout,
    type_: Type,
    language: str,
    names: Mapping[str, str],
    sheet: int = 0,
) -> pygame.Rect:
    """Draw a sheet of the page over a darkened window; returns all of it.

    `names`: the key of each action.
    """
    darken(surface)
    s, w, rect = layout.s, words(language, names), panel(layout)
    shapes.box(surface, rect, s, PANEL, LINE_TRACK)
    left, top = rect.x + round(PAD * s), rect.y + round(38 * s)
    type_.draw(surface, w["help.title"], (left, top), 20, TEXT)
    more = w["help.sheet"].format(sheet=sheet + 1, all=sheets()) + " · " + w["help.close"]
    type_.draw(surface, more, (rect.right - PAD * s, top), 13, TEXT_SOFT, "right")
    for place, sections in enumerate(COLUMNS[sheet * BESIDE :][:BESIDE]):
        y = rect.y + 70 * s
        for section in sections:
            shown = [(caption(row.keys, w, names), w[row.text]) for row in rows(section)]
            at = (left + place * column(layout), y)
            y = _section(surface, type_, at, w[f"help.{section}"], shown)
    foot = rect.bottom - (16 + 20 * (len(MOUSE) - 1)) * s
    for line, key in enumerate(MOUSE):
        type_.draw(surface, w[key], (left, foot + 20 * line * s), 13, TEXT_SOFT)
    return surface.get_rect()


def _section(
    surface: pygame.Surface,
    type_: Type,
    at: tuple[float, float],
    title: str,
    rows: list[tuple[str, str]],
) -> float:
    """Draw a title and its rows; returns where the next section begins."""
    s, (x, y) = type_.s, at
    type_.draw(surface, title, (x, y), 13, ACCENT)
    y += 8 * s
    for whole, said in rows:
        name = type_.fitted(whole, 12, (KEY_COLUMN - 12) * s)
        cap = pygame.Rect(x, round(y), type_.width(name, 12) + round(12 * s), round(19 * s))
        shapes.box(surface, cap, s, PANEL_RAISED, LINE_TRACK, radius=4)
        base = cap.centery + type_.cap(12) / 2
        type_.draw(surface, name, (cap.centerx, base), 12, TEXT, "centre")
        type_.draw(surface, said, (x + KEY_COLUMN * s, base), 13, TEXT_SOFT)
        y += ROW * s
    return y + 24 * s
