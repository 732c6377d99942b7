"""How the game menu looks and where its parts are: the game at the left, players at the right."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes, text_line
from game.render.parts.text_line import TextLine
from game.render.theme import ACCENT, LINE_INPUT, PANEL_RAISED
from game.session.terms import FOUR_BALL, FREE, LONGEST_NAME, MOST_POINTS, SKILLS, Terms
from game.table.own_table import is_own
from game.text.text_field import TextField
from game.ui import halls
from game.ui.names import player_name
from game.ui.sight import Sight

from . import menu_tiles, page_parts
from .menu_rows import MenuRow

BUTTONS = ("start", "resume", "shelf", "rules", "help", "settings", "quit")
ROW, STRIDE = 38, 46
HEAD = 26
ROOM = 392
"""For the rows of a game, above the buttons."""
ARROW = 30
LABEL = 132
SIZE = 15
"""Of the text of a row."""
GROUP = 10
"""Room above a player's rows."""


class MenuSpot(NamedTuple):
    """A part of the menu: place in the order of focus, or -1; step of an arrow, or what else: a
    family of games by its name."""

    place: int
    step: int = 0
    other: str = ""


NOTHING, OUTSIDE, CLOSE = MenuSpot(-1), MenuSpot(-1, 0, "outside"), MenuSpot(-1, 0, "close")


class MenuLook(NamedTuple):
    """What the picture of the menu depends on.

    terms    what has been put together so far
    rows     that these terms have
    focus    counts the rows, then come the buttons, and last the tiles of the families
    over     the part under the mouse
    field    the text of the row in focus, if it is one that is typed into
    touched  has it been edited since?
    refused  why the last characters did not go into it: "digits" "full" or ""
    offered  the terms of the matches that can be gone on with, the newest first
    which    the one of them that is on offer
    """

    terms: Terms
    rows: list[MenuRow]
    focus: int
    over: MenuSpot
    field: TextField | None
    touched: bool
    refused: str
    offered: tuple[Terms, ...]
    which: int

    @property
    def row(self) -> MenuRow | None:
        """The row in focus, or None on a button."""
        return self.rows[self.focus] if self.focus < len(self.rows) else None


# -- where things are ----------------------------------------------------------------------------


def row_rect(rows: Sequence[MenuRow], place: int, layout: Layout) -> pygame.Rect:
    """Return where a row is."""
    area, gap = page_parts.inside(layout), layout.px(32)
    right = next((i for i, row in enumerate(rows) if row.name == "players"), len(rows))
    column = place >= right
    index = place - right if column else place
    wide = (area.w - gap) // 2
    groups = max(rows[place].seat, -1) + 1 if column else 0
    stride = min(STRIDE, ROOM / max(right, 1))
    top = area.y + layout.px(HEAD) + layout.px(stride * index + GROUP * groups)
    return pygame.Rect(area.x + column * (wide + gap), top, wide, layout.px(ROW))


def arrows(rect: pygame.Rect, layout: Layout) -> tuple[pygame.Rect, pygame.Rect]:
    """Return the two arrows of a row's box."""
    side = layout.px(ARROW)
    box = value_rect(rect, layout)
    return (
        pygame.Rect(box.x, box.y, side, box.h),
        pygame.Rect(box.right - side, box.y, side, box.h),
    )


def value_rect(rect: pygame.Rect, layout: Layout) -> pygame.Rect:
    """Return the box with a row's value."""
    left = layout.px(LABEL)
    return pygame.Rect(rect.x + left, rect.y, rect.w - left, rect.h)


def text_window(rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Return the room for the text of a row, between the arrows that it may have."""
    return value_rect(rect, sight.layout).inflate(-2 * sight.layout.px(ARROW + 4), 0)


def button_rects(layout: Layout) -> list[pygame.Rect]:
    """Return the buttons below the rows, the primary one first and wider."""
    area, height = page_parts.inside(layout), layout.px(page_parts.BUTTON)
    bar = pygame.Rect(area.x, area.bottom - height, area.w, height)
    return page_parts.row_of(bar, (1.5, 1.3, 1, 1, 1, 1, 1), layout.px(10))


def spot_at(
    at: tuple[int, int], sight: Sight, rows: Sequence[MenuRow], offered: int = 0
) -> MenuSpot:
    """Return what is at a point of the window; `offered` matches can be gone on with."""
    layout = sight.layout
    if not page_parts.panel(layout).collidepoint(at):
        return OUTSIDE
    if page_parts.close_rect(layout).collidepoint(at):
        return CLOSE
    for place, row in enumerate(rows):
        rect = row_rect(rows, place, layout)
        if rect.collidepoint(at):
            left, right = arrows(rect, layout)
            if row.kind == "text":
                return MenuSpot(place)
            value = 1 if row.kind == "choice" and value_rect(rect, layout).collidepoint(at) else 0
            return MenuSpot(
                place, -1 if left.collidepoint(at) else 1 if right.collidepoint(at) else value
            )
    for k, rect in enumerate(button_rects(layout)):
        if rect.collidepoint(at):
            several = BUTTONS[k] == "resume" and offered > 1
            return MenuSpot(len(rows) + k, _end_at(rect, at[0], layout) if several else 0)
    family = menu_tiles.at(at, layout)
    return MenuSpot(len(rows) + len(BUTTONS), 0, family) if family else NOTHING


def _end_at(rect: pygame.Rect, x: int, layout: Layout) -> int:
    """The end of a button that is at a column: -1 the left one, 1 the right one, 0 neither."""
    side = layout.px(ARROW)
    return (x >= rect.right - side) - (x < rect.x + side)


# -- what it looks like --------------------------------------------------------------------------


def draw(surface: pygame.Surface, sight: Sight, menu: MenuLook) -> pygame.Rect:
    """Draw the menu and return its rectangle."""
    w, layout, rows, over = sight.words, sight.layout, menu.rows, menu.over
    rect = page_parts.frame(
        surface, sight, w["menu.title"], _foot(w, menu), bool(menu.refused), over == CLOSE
    )
    _heads(surface, sight, menu.terms)
    tiles = menu.focus == len(rows) + len(BUTTONS)
    menu_tiles.draw(surface, sight, menu.terms, focused=tiles, over=over.other)
    for place, row in enumerate(rows):
        _row(surface, sight, row_rect(rows, place, layout), menu, place, row)
    for k, (name, spot) in enumerate(zip(BUTTONS, button_rects(layout), strict=True)):
        focused, hot = menu.focus == len(rows) + k, over.place == len(rows) + k
        label = w["menu.again" if name == "start" and _over(sight) else f"menu.{name}"]
        page_parts.button(surface, spot, sight.type, label, focused, hot, k == 0)
        if name == "resume" and len(menu.offered) > 1:
            _ends(surface, spot, layout, over.step if hot else 0, focused)
    return rect


def _ends(
    surface: pygame.Surface, rect: pygame.Rect, layout: Layout, over: int, focused: bool
) -> None:
    """Draw the arrows at the ends of a button that has several things to choose from."""
    side = layout.px(ARROW)
    for way, left in ((-1, rect.x), (1, rect.right - side)):
        end = pygame.Rect(left, rect.y, side, rect.h)
        _arrow(surface, end, layout.s, way, focused or over == way)


def _over(sight: Sight) -> bool:
    """Is there a match that is over, so that the same again is a rematch?"""
    return sight.session.contest is not None and sight.session.contest.over


def _heads(surface: pygame.Surface, sight: Sight, terms: Terms) -> None:
    area, s, w = page_parts.inside(sight.layout), sight.layout.s, sight.words
    base = area.y + 12 * s
    sight.type.draw(surface, w["menu.game.head"], (area.x, base), 13, ACCENT)
    middle = area.x + (area.w - sight.layout.px(32)) // 2 + sight.layout.px(32)
    if terms.game != FREE:
        sight.type.draw(surface, w["menu.players.head"], (middle, base), 13, ACCENT)
        return
    size, room = 13, area.right - middle
    for i, line in enumerate(page_parts.wrapped(w["rule.free.1"], sight.type, size, room)):
        at = (middle, base + (28 + 22 * i) * s)
        sight.type.draw(surface, line, at, size, theme.TEXT_SOFT)


def _foot(w: dict[str, str], menu: MenuLook) -> str:
    row, terms = menu.row, menu.terms
    if row is None:
        return _foot_of_button(w, menu)
    if menu.refused:
        return w[f"menu.refused.{row.name}"].format(most=MOST_POINTS, length=LONGEST_NAME)
    if row.name == "level":
        skill = SKILLS.get(terms.seats[row.seat].level)
        if skill is not None:
            numbers = {"angle": f"{skill.angle:g}", "speed": f"{100 * skill.speed:g}"}
            return w["level.error"].format(**numbers, tip=f"{skill.tip:g}")
    if row.name == "target" and terms.game == FOUR_BALL:
        return halls.hint(terms, row.seat, w)
    if row.kind == "number" and menu.touched:
        return w["menu.hint.digits"]
    return w["menu.hint." + row.kind]


def _foot_of_button(w: dict[str, str], menu: MenuLook) -> str:
    """The line at the foot with a button in focus, or the tiles."""
    name = (*BUTTONS, "tiles")[menu.focus - len(menu.rows)]
    if name == "resume":
        return _offer(w, menu)
    return w["menu.hint.tiles" if name == "tiles" else "menu.hint.button"]


def _offer(w: dict[str, str], menu: MenuLook) -> str:
    """Which match would be gone on with."""
    if not menu.offered:
        return w["menu.nothing"]
    offered, several = menu.offered[menu.which], len(menu.offered) > 1
    names = " – ".join(player_name(offered, i, w) for i in range(len(offered.seats)))
    said = w["menu.offered"].format(game=w[f"game.{offered.game}"], names=names)
    place = w["menu.others"].format(n=menu.which + 1, count=len(menu.offered))
    return f"{said} · {place}" if several else said


def value_word(row: MenuRow, terms: Terms, w: dict[str, str]) -> str:
    """Return what a row says."""
    if row.name == "players":
        return w[f"players.{len(terms.seats)}"]
    if row.seat >= 0:
        seat = terms.seats[row.seat]
        if row.name == "name":
            return seat.name
        return w[f"level.{seat.level}"] if row.name == "level" else halls.goal(terms, row.seat, w)
    value = getattr(terms, row.name)
    if isinstance(value, bool):
        return w["yes" if value else "no"]
    if isinstance(value, int):
        return str(value)
    return w[f"{row.name}.own" if row.name == "table" and is_own(value) else f"{row.name}.{value}"]


def _row(
    surface: pygame.Surface,
    sight: Sight,
    rect: pygame.Rect,
    menu: MenuLook,
    place: int,
    row: MenuRow,
) -> None:
    s, type_, w = sight.layout.s, sight.type, sight.words
    focused, box = menu.focus == place, value_rect(rect, sight.layout)
    edge, width = (ACCENT, 2.0) if focused else (LINE_INPUT, 1.0)
    shapes.box(surface, box, s, PANEL_RAISED, edge, width)
    base = rect.centery + type_.cap(13) / 2
    label = type_.fitted(w[f"row.{row.name}"], 13, LABEL * s - 8)
    ink = theme.TEXT if focused else theme.TEXT_SOFT
    type_.draw(surface, label, (rect.x, base), 13, ink)
    _value(surface, sight, rect, menu, row, focused)
    if row.kind != "text":
        hot = menu.over.step if menu.over.place == place else 0
        for way, arrow in zip((-1, 1), arrows(rect, sight.layout), strict=True):
            _arrow(surface, arrow, s, way, focused or hot == way)


def _value(
    surface: pygame.Surface,
    sight: Sight,
    rect: pygame.Rect,
    menu: MenuLook,
    row: MenuRow,
    focused: bool,
) -> None:
    """Draw what a row says: with its caret where it is typed into."""
    type_, w, window = sight.type, sight.words, text_window(rect, sight)
    base = rect.centery + type_.cap(SIZE) / 2
    line, tone = TextLine(type_.fitted(value_word(row, menu.terms, w), SIZE, window.w)), theme.TEXT
    if focused and menu.field is not None:
        line = sight.line(menu.field)
    if row.name == "name" and not line.whole.text:
        usual = player_name(menu.terms, row.seat, w)
        line, tone = line._replace(text=type_.fitted(usual, SIZE, window.w)), theme.TEXT_FAINT
    text_line.draw(surface, window, type_, line, SIZE, base, tone, "centre")


def _arrow(surface: pygame.Surface, rect: pygame.Rect, s: float, way: int, hot: bool) -> None:
    ink = theme.TEXT if hot else theme.TEXT_FAINT
    (x, y), arm = rect.center, 4.5 * s
    for off in (-0.4, 0.4):
        for up in (-1, 1):
            tip = (x + way * arm / 2 + off, y)
            pygame.draw.aaline(surface, ink, tip, (x - way * arm / 2 + off, y + up * arm))
