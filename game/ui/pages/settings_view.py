"""How the settings page looks and where its parts are: choices at the left, keys at the right."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.render.layout import Layout
from game.render.parts import shapes
from game.render.theme import (
    ACCENT,
    ERROR,
    LINE,
    LINE_INPUT,
    LINE_TRACK,
    PANEL,
    PANEL_RAISED,
    TEXT,
    TEXT_SOFT,
    Colour,
)
from game.text.keycap import cap_name
from game.ui.sight import Sight

from . import page_parts
from .settings_rows import CHOSEN, KEYS, ROWS, SettingsRow, beside, current

HEIGHT = 574
PAD = 28
TOP = 66
"""Where the rows begin, below the title."""
FOOT = 44
ROW, GAP = 34, 8
SPLIT = 0.56
"""Share of the width at which the keys begin."""
KEY_ROW = 26
KEY_COLUMN = 118
Spot = tuple[int, str]
"""A part of the page: number of the row, or -1, and which of its choices, or what else."""
NOTHING, OUTSIDE, CLOSE = (-1, ""), (-1, "outside"), (-1, "close")


class SettingsLook(NamedTuple):
    """Focused row, whether its key is waited for, first key shown, part under the mouse."""

    focus: int
    waiting: bool
    first: int
    over: Spot


# -- where things are ----------------------------------------------------------------------------


def panel(layout: Layout) -> pygame.Rect:
    """Return the page's rectangle, in the middle of the window's contents."""
    return page_parts.panel(layout, HEIGHT)


def keys_shown(layout: Layout) -> int:
    """Return how many rows of keys there is room for."""
    return min((HEIGHT - TOP - FOOT) // KEY_ROW, len(KEYS))


def row_rect(index: int, layout: Layout, first: int) -> pygame.Rect | None:
    """Return where a row is, or None while it is scrolled away."""
    rect, s = panel(layout), layout.s
    middle = rect.x + round(SPLIT * rect.w)
    place = index - len(CHOSEN)
    if place < 0:
        gaps = sum(row.gap for row in CHOSEN[: index + 1])
        top = rect.y + round((TOP + index * ROW + gaps * GAP) * s)
        left = rect.x + round((PAD - 10) * s)
        return pygame.Rect(left, top, middle - round(14 * s) - left, round((ROW - 4) * s))
    if not first <= place < first + keys_shown(layout):
        return None
    top = rect.y + round((TOP + (place - first) * KEY_ROW) * s)
    return pygame.Rect(middle, top, rect.right - round(18 * s) - middle, round(KEY_ROW * s) - 1)


class Cell(NamedTuple):
    """A choice: where it is, which key of its row it chooses, and what is written there."""

    rect: pygame.Rect
    key: str
    word: str


def cells(index: int, sight: Sight) -> list[Cell]:
    """Return the choices of a row; where there is no room for all, the present one and arrows."""
    row, rect = ROWS[index], row_rect(index, sight.layout, 0)
    if rect is None or row.kind not in ("choice", "switch"):
        return []
    left = rect.x + label_room(sight)
    found = _side_by_side(
        [(key, choice_word(row, key, sight)) for key in row.keys], left, rect, sight
    )
    if found[-1].rect.right <= rect.right:
        return found
    now = current(row, sight.session, sight.settings)
    word = choice_word(row, now, sight) if now in row.keys else "–"
    steps = [(beside(row, now, -1), "←"), (now, word), (beside(row, now, 1), "→")]
    return _side_by_side(steps, left, rect, sight)


def _side_by_side(
    words: Sequence[tuple[str, str]], left: int, row: pygame.Rect, sight: Sight
) -> list[Cell]:
    s, found = sight.layout.s, []
    for key, word in words:
        wide = sight.type.width(word, 13) + round(20 * s)
        found.append(Cell(pygame.Rect(left, row.y + round(2 * s), wide, round(26 * s)), key, word))
        left += wide + round(3 * s)
    return found


def label_room(sight: Sight) -> int:
    """Return the px from a row's left edge to its choices: the longest label, and a gap."""
    names = (sight.words[f"set.{row.name}"] for row in CHOSEN)
    longest = max(sight.type.width(name, 13) for name in names)
    return int(longest + round(36 * sight.layout.s))


def track(index: int, sight: Sight) -> pygame.Rect:
    """Return the slider's track."""
    rect, s = row_rect(index, sight.layout, 0), sight.layout.s
    assert rect is not None, "sliders are not scrolled"
    bar = pygame.Rect(0, 0, round(210 * s), max(4, round(6 * s)))
    bar.midleft = (rect.x + label_room(sight) + round(10 * s), rect.centery)
    return bar


def close_rect(layout: Layout) -> pygame.Rect:
    """Return the button that closes the page."""
    return page_parts.close_rect(layout, HEIGHT)


def slid(at: tuple[int, int], sight: Sight, index: int) -> str:
    """Return which of a slider's keys is at a point."""
    bar, keys = track(index, sight), ROWS[index].keys
    share = (at[0] - bar.x) / bar.w
    return keys[min(max(round(share * (len(keys) - 1)), 0), len(keys) - 1)]


def part_at(at: tuple[int, int], sight: Sight, first: int) -> Spot:
    """Return what is at a point of the window."""
    if not panel(sight.layout).collidepoint(at):
        return OUTSIDE
    if close_rect(sight.layout).collidepoint(at):
        return CLOSE
    for index in range(len(ROWS)):
        rect = row_rect(index, sight.layout, first)
        if rect is not None and rect.collidepoint(at):
            keys = (cell.key for cell in cells(index, sight) if cell.rect.collidepoint(at))
            return index, next(keys, "")
    return NOTHING


def choice_word(row: SettingsRow, key: str, sight: Sight) -> str:
    """Return how a choice is called."""
    w = sight.words
    return w[f"set.{key}"] if row.kind == "switch" else w[f"set.{row.name}.{key}"]


# -- what it looks like --------------------------------------------------------------------------


def draw(surface: pygame.Surface, sight: Sight, state: SettingsLook) -> pygame.Rect:
    """Draw the page and return its rectangle."""
    layout, type_, w, s = sight.layout, sight.type, sight.words, sight.layout.s
    rect = panel(layout)
    shapes.box(surface, rect, s, PANEL, LINE_TRACK)
    base = rect.y + 40 * s
    type_.draw(surface, w["set.title"], (rect.x + PAD * s, base), 20, TEXT)
    keys = rect.x + round(SPLIT * rect.w) + 10 * s
    type_.draw(surface, w["set.keys"], (keys, base), 13, TEXT_SOFT)
    page_parts.cross(surface, close_rect(layout), s, state.over == CLOSE)
    for index, row in enumerate(ROWS):
        spot = row_rect(index, layout, state.first)
        if spot is not None:
            _row(surface, sight, state, index, row, spot)
    _scroll_bar(surface, layout, state.first)
    said, colour = _foot(sight, state)
    room = rect.w - 2 * PAD * s
    foot = (rect.x + PAD * s, rect.bottom - 16 * s)
    type_.draw(surface, type_.fitted(said, 13, room), foot, 13, colour)
    return rect


def _scroll_bar(surface: pygame.Surface, layout: Layout, first: int) -> None:
    """Show which of the keys are on show, if not all of them are."""
    shown, s, rect = keys_shown(layout), layout.s, panel(layout)
    if shown == len(KEYS):
        return
    reach = shown * KEY_ROW * s
    bar = pygame.Rect(0, 0, max(2, round(4 * s)), round(reach))
    bar.topright = rect.right - round(8 * s), rect.y + round(TOP * s)
    shapes.bar(surface, bar, LINE)
    part = bar.move(0, round(reach * first / len(KEYS)))
    part.h = round(reach * shown / len(KEYS))
    shapes.bar(surface, part, LINE_INPUT)


def _foot(sight: Sight, state: SettingsLook) -> tuple[str, Colour]:
    """The line at the bottom: what can be done, or why a key was refused."""
    w, refused = sight.words, sight.preferences.refused
    if state.waiting:
        return w["set.press"], ACCENT
    if refused is not None:
        why, _, key = refused
        owner = sight.preferences.keys.owner(key)
        taken = w[f"key.{owner}"] if owner else ""
        return w[f"set.refused.{why}"].format(key=cap_name(key, w), action=taken), ERROR
    if ROWS[state.focus].kind == "key":
        return w["set.hint.key"], TEXT_SOFT
    return w["set.hint"], TEXT_SOFT


def _row(
    surface: pygame.Surface,
    sight: Sight,
    state: SettingsLook,
    index: int,
    row: SettingsRow,
    rect: pygame.Rect,
) -> None:
    s, focused = sight.layout.s, index == state.focus
    if focused:
        shapes.box(surface, rect, s, PANEL_RAISED, ACCENT)
    elif state.over[0] == index:
        shapes.box(surface, rect, s, PANEL_RAISED, PANEL_RAISED)
    if row.kind == "key":
        _key(surface, sight, state, row, rect, focused)
        return
    base = rect.centery + sight.type.cap(13) / 2
    ink = TEXT if focused else TEXT_SOFT
    sight.type.draw(surface, sight.words[f"set.{row.name}"], (rect.x + 10 * s, base), 13, ink)
    now = current(row, sight.session, sight.settings)
    if row.kind == "slider":
        _slider(surface, sight, index, now, focused)
    for cell, key, word in cells(index, sight):
        hot = state.over == (index, key)
        if key == now:
            shapes.box(surface, cell, s, LINE_TRACK, LINE_INPUT, radius=4)
        elif hot:
            shapes.box(surface, cell, s, PANEL, LINE_INPUT, radius=4)
        ink = TEXT if key == now or hot else TEXT_SOFT
        sight.type.draw(surface, word, (cell.centerx, base), 13, ink, "centre")


def _slider(surface: pygame.Surface, sight: Sight, index: int, now: str, focused: bool) -> None:
    bar, s, keys = track(index, sight), sight.layout.s, ROWS[index].keys
    share = keys.index(now) / (len(keys) - 1)
    shapes.bar(surface, bar, LINE_TRACK)
    done = pygame.Rect(bar.x, bar.y, max(bar.h, round(bar.w * share)), bar.h)
    if share:
        shapes.bar(surface, done, ACCENT if focused else TEXT_SOFT)
    shapes.disc(surface, (bar.x + round(bar.w * share), bar.centery), 7 * s, TEXT, PANEL, 1.5 * s)
    base = bar.centery + sight.type.cap(13) / 2
    sight.type.draw(surface, now, (bar.right + 34 * s, base), 13, TEXT, "right")


def _key(
    surface: pygame.Surface,
    sight: Sight,
    state: SettingsLook,
    row: SettingsRow,
    rect: pygame.Rect,
    focused: bool,
) -> None:
    """Draw an action's key, with a border of its own where the player has changed it."""
    s, keys, w = sight.layout.s, sight.preferences.keys, sight.words
    waits = focused and state.waiting
    name = "…" if waits else cap_name(keys.names[row.name], w)
    wide = sight.type.width(name, 12) + round(14 * s)
    cap = pygame.Rect(rect.x + round(10 * s), 0, max(wide, round(24 * s)), round(20 * s))
    cap.centery = rect.centery
    edge = ACCENT if waits else TEXT_SOFT if row.name in keys.changed else LINE_TRACK
    shapes.box(surface, cap, s, PANEL_RAISED, edge, radius=4)
    base = cap.centery + sight.type.cap(12) / 2
    sight.type.draw(surface, name, (cap.centerx, base), 12, TEXT, "centre")
    room = rect.right - rect.x - KEY_COLUMN * s - 8 * s
    said = sight.type.fitted(w[f"key.{row.name}"], 13, room)
    ink = TEXT if focused else TEXT_SOFT
    sight.type.draw(surface, said, (rect.x + KEY_COLUMN * s, base), 13, ink)
