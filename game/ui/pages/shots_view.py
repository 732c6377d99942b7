"""How the page of kept shots looks and where its parts are: a list, a small table, a name."""

from __future__ import annotations

from typing import NamedTuple

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes, text_line
from game.render.parts.text_line import TextLine
from game.render.theme import ACCENT, LINE, LINE_INPUT, PANEL_RAISED, mix
from game.settings.shot_folder import KeptShot
from game.table.own_table import is_own
from game.table.shared import SharedShot
from game.ui.sight import Sight

from . import page_parts
from .shelf_view import BOX, GAP, box_rect, text_window, thumbnail

BUTTONS = ("save", "aim", "open", "copy", "paste", "delete")
ROW = 30
SIZE = 13
LIST = 0.52
"""The part of the width that the list takes."""
WRONG = ("line.", "shots.un", "shots.broken", "shots.none", "shots.kept", "toast.")


class ShotsSpot(NamedTuple):
    """A part of the page: "row" "box" "button" "close" "outside" or "", and which."""

    kind: str
    place: int = 0


class ShotsLook(NamedTuple):
    """What the picture of the page depends on.

    shots     that are kept, the newest first
    chosen    which of them
    first     the first one on show
    line      the name that is typed
    typing    is it edited?
    over      the part under the mouse
    said      key of the texts and a word in it: what came of the last action
    kind      "replay" or "shot": what would be saved
    language  of the words
    """

    shots: tuple[KeptShot, ...]
    chosen: int
    first: int
    line: TextLine
    typing: bool
    over: ShotsSpot
    said: tuple[str, str]
    kind: str
    language: str


# -- where things are ----------------------------------------------------------------------------


def list_rect(layout: Layout) -> pygame.Rect:
    """Return the room for the list."""
    area = page_parts.inside(layout)
    below = layout.px(2 * BOX + 2 * GAP)
    return pygame.Rect(area.x, area.y, round(area.w * LIST), area.h - below)


def shown(layout: Layout) -> int:
    """Return how many shots there is room for."""
    return max(1, list_rect(layout).h // layout.px(ROW))


def row_rect(layout: Layout, slot: int) -> pygame.Rect:
    """Return a row of the list, 0 is the first on show."""
    area, high = list_rect(layout), layout.px(ROW)
    return pygame.Rect(area.x, area.y + slot * high, area.w, high - layout.px(3))


def button_rects(layout: Layout) -> list[pygame.Rect]:
    """Return the buttons below the box."""
    area, high = page_parts.inside(layout), layout.px(BOX)
    bar = pygame.Rect(area.x, area.bottom - high, area.w, high)
    return page_parts.row_of(bar, (1.3, 1.3, 1, 1, 1, 1), layout.px(8))


def spot_at(at: tuple[int, int], sight: Sight) -> ShotsSpot:
    """Return what is at a point of the window."""
    layout = sight.layout
    if not page_parts.panel(layout).collidepoint(at):
        return ShotsSpot("outside")
    if page_parts.close_rect(layout).collidepoint(at):
        return ShotsSpot("close")
    rows = [row_rect(layout, slot) for slot in range(shown(layout))]
    found = (("row", rows), ("box", [box_rect(layout)]), ("button", button_rects(layout)))
    for kind, rects in found:
        for place, rect in enumerate(rects):
            if rect.collidepoint(at):
                return ShotsSpot(kind, place)
    return ShotsSpot("")


# -- what it looks like --------------------------------------------------------------------------


def draw(surface: pygame.Surface, sight: Sight, look: ShotsLook) -> pygame.Rect:
    """Draw the page and return its rectangle."""
    w, layout, type_ = sight.words, sight.layout, sight.type
    key, word = look.said
    foot = w[key].format(word=word) if key else w["shots.hint"]
    closing = look.over.kind == "close"
    wrong = key.startswith(WRONG)
    rect = page_parts.frame(surface, sight, w["shots.title"], foot, wrong, closing)
    _list(surface, sight, look)
    _chosen(surface, sight, look)
    _box(surface, sight, look)
    for place, (name, spot) in enumerate(zip(BUTTONS, button_rects(layout), strict=True)):
        label = w[f"shots.save.{look.kind}"] if name == "save" else w[f"shots.{name}"]
        hot = look.over == ShotsSpot("button", place)
        primary = name == ("save" if look.typing else "open")
        page_parts.button(surface, spot, type_, label, False, hot, primary=primary)
    return rect


def _list(surface: pygame.Surface, sight: Sight, look: ShotsLook) -> None:
    s, type_, w, layout = sight.layout.s, sight.type, sight.words, sight.layout
    if not look.shots:
        area = list_rect(layout)
        lines = page_parts.wrapped(w["shots.empty"], type_, 15, area.w - 20 * s)
        for place, line in enumerate(lines):
            at = (area.x, area.y + (24 + 26 * place) * s)
            type_.draw(surface, line, at, 15, theme.TEXT_SOFT)
    for slot, kept in enumerate(look.shots[look.first : look.first + shown(layout)]):
        rect, chosen = row_rect(layout, slot), look.first + slot == look.chosen
        if chosen or look.over == ShotsSpot("row", slot):
            fill = mix(PANEL_RAISED, ACCENT, 0.2 if chosen else 0.0)
            edge = ACCENT if chosen and not look.typing else LINE
            shapes.box(surface, rect, s, fill, edge, radius=5)
        base = rect.centery + type_.cap(15) / 2
        kind = _kind(kept.shot, w)
        end = rect.right - 10 * s
        left = type_.draw(surface, kind, (end, base), 12, theme.TEXT_SOFT, "right").x
        name = type_.fitted(kept.name, 15, left - rect.x - 20 * s)
        ink = theme.TEXT if kept.shot is not None else theme.ERROR
        type_.draw(surface, name, (rect.x + 10 * s, base), 15, ink)


def _kind(shot: SharedShot | None, w: dict[str, str]) -> str:
    if shot is None:
        return w["shots.kind.broken"]
    table = shot.lineup.table
    name = w.get(f"table.{'own' if is_own(table) else table}") or w.get(f"position.{table}", table)
    return f"{w['shots.kind.replay' if shot.replay else 'shots.kind.shot']} · {name}"


def _chosen(surface: pygame.Surface, sight: Sight, look: ShotsLook) -> None:
    """Draw the table of the chosen shot, with its five numbers below."""
    if not look.shots or look.shots[look.chosen].shot is None:
        return
    shot, layout, s = look.shots[look.chosen].shot, sight.layout, sight.layout.s
    assert shot is not None
    area, left = list_rect(layout), list_rect(layout).right + layout.px(24)
    room = pygame.Rect(left, area.y, page_parts.inside(layout).right - left, area.h - round(56 * s))
    picture = thumbnail(shot.lineup, room.size, sight.settings.colours)
    place = surface.blit(picture, picture.get_rect(midtop=room.midtop))
    words = sight.words
    numbers = " · ".join(shot.lineup.texts[:5])
    lines = [words["shots.numbers"].format(numbers=numbers)] if numbers else []
    lines.append(
        " · ".join(words.get(f"set.{name}.{key}", key) for name, key in shot.kit if key != "table")
    )
    for row, line in enumerate(lines):
        at = (room.centerx, place.bottom + (22 + 22 * row) * s)
        line = sight.type.fitted(line, SIZE, room.w)
        sight.type.draw(surface, line, at, SIZE, theme.TEXT_SOFT, "centre")


def _box(surface: pygame.Surface, sight: Sight, look: ShotsLook) -> None:
    s, type_, window = sight.layout.s, sight.type, text_window(sight)
    rect = box_rect(sight.layout)
    edge = ACCENT if look.typing else LINE_INPUT
    width = 2.0 if look.typing else 1.0
    shapes.box(surface, rect, s, PANEL_RAISED, edge, width, ring=look.typing)
    line, tone = (look.line if look.typing else TextLine(look.line.text)), theme.TEXT
    if not line.whole.text:
        said = type_.fitted(sight.words["shots.box"], SIZE, window.w)
        line, tone = line._replace(text=said), theme.TEXT_FAINT
    base = rect.centery + type_.cap(SIZE) / 2
    text_line.draw(surface, window, type_, line, SIZE, base, tone)
