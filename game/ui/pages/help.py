"""The page of keys, laid over the table until it is closed."""

from __future__ import annotations

from collections.abc import Mapping

import pygame

from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.theme import ACCENT, LINE_TRACK, PANEL, PANEL_RAISED, TEXT, TEXT_SOFT
from game.text import words
from game.text.keycap import cap_name

ROW = 23
KEY_COLUMN = 126
PAD = 26
Rows = tuple[tuple[str, str], ...]
"""Keys and what they do: a key is written as it is, by its name, or "@" and the action it has.

What is held with it is written before."""
Section = tuple[str, Rows]
COLUMNS: tuple[tuple[Section, ...], ...] = (
    (
        (
            "help.play",
            (
                ("@edit 0", "help.left"),
                ("@clear", "help.right"),
                ("name.digits", "help.digit"),
                ("name.enter", "help.return"),
                ("Ctrl+Enter", "help.ctrl"),
                ("@place", "help.down"),
                ("@stop", "help.space"),
                ("@retry", "help.retry"),
                ("@engine", "help.engine"),
                ("@law", "help.law"),
                ("@arrange", "key.arrange"),
            ),
        ),
        (
            "help.box",
            (
                ("name.enter", "help.next"),
                ("name.back", "help.back"),
                ("← → Home End", "help.caret"),
                ("Ctrl+A C X V", "help.paste"),
                ("Tab, Shift", "help.tab"),
                ("Esc", "help.esc"),
            ),
        ),
    ),
    (
        (
            "help.aim",
            (
                ("@turn 1 @turn -1", "help.turn"),
                ("Shift Ctrl+← →", "help.finer"),
                ("@push 0.5 @push -0.5", "help.push"),
                ("Alt+← → ↑ ↓", "help.tip"),
                ("Alt+PgUp PgDn", "help.tilt"),
                ("@centre", "help.centre"),
                ("@thicker 1", "help.thick"),
                ("@aids", "help.aids"),
                ("@fan", "help.fan"),
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
    ),
    (
        (
            "help.time",
            (
                ("@pause", "help.pause"),
                ("@faster -1 @faster 1", "help.rate"),
                ("@back @frame", "help.frame"),
                ("Shift+@back @frame", "help.event"),
                ("@home @skip", "help.skip"),
                ("@undo @redo", "help.undo"),
            ),
        ),
        (
            "help.always",
            (
                ("@help", "help.help"),
                ("@language", "help.language"),
                ("@settings", "key.settings"),
                ("@sheet shelf", "key.sheet shelf"),
                ("@sheet rules", "key.sheet rules"),
                ("@sheet menu", "key.sheet menu"),
                ("@mute", "key.mute"),
                ("@both", "key.both"),
            ),
        ),
    ),
)
MOUSE = ("help.mouse.aim", "help.mouse.cue", "help.mouse.time")


def panel(layout: Layout) -> pygame.Rect:
    """Return the rectangle of the page: nearly as wide as the window's contents, centred."""
    width = layout.shoot.right - layout.table.x - 2 * layout.px(12)
    rect = pygame.Rect(0, 0, width, layout.px(584))
    rect.center = ((layout.table.x + layout.shoot.right) // 2, layout.size[1] // 2)
    return rect


def column(layout: Layout) -> int:
    """Return the width of a column, px."""
    return round((panel(layout).w - 2 * PAD * layout.s) / len(COLUMNS))


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
    surface: pygame.Surface, layout: Layout, type_: Type, language: str, names: Mapping[str, str]
) -> pygame.Rect:
    """Draw the page over a darkened window; returns all of it.  `names`: the key of each action."""
    darken(surface)
    s, w, rect = layout.s, words(language, names), panel(layout)
    shapes.box(surface, rect, s, PANEL, LINE_TRACK)
    left, top = rect.x + round(PAD * s), rect.y + round(38 * s)
    type_.draw(surface, w["help.title"], (left, top), 20, TEXT)
    type_.draw(surface, w["help.close"], (rect.right - PAD * s, top), 13, TEXT_SOFT, "right")
    for place, sections in enumerate(COLUMNS):
        y = rect.y + 70 * s
        for title, rows in sections:
            shown = [(caption(key, w, names), w[said]) for key, said in rows]
            at = (left + place * column(layout), y)
            y = _section(surface, type_, at, w[title], shown)
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
