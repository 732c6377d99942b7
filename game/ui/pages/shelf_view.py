"""How the shelf looks and where its parts are: tabs, small tables, a box for a name or a line."""

from __future__ import annotations

import warnings
from functools import lru_cache
from typing import NamedTuple

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes, stars, text_line
from game.render.parts.text_line import TextLine
from game.render.table.finish import FINISHES
from game.render.theme import ACCENT, LINE, LINE_INPUT, PANEL_RAISED, mix
from game.table import presets
from game.table.lineup import UNMADE, Lineup
from game.text.text_field import TextField
from game.ui.panels import drill_words
from game.ui.sight import Sight
from game.ui.table.looks import kind_of, looks_of
from physics import Pocket, World

from . import page_parts

GROUPS = ("sagu", "three_cushion", "pool", "snooker", "pyramid", "scenes", "own")
BUTTONS = ("save", "copy", "shot", "paste", "delete")
COLUMNS, ROWS = 5, 2
TAB, BOX, GAP = 34, 38, 10
SIZE = 13
"""Of the text in the box."""
NAME = 26
"""Room for a card's name, px at s = 1."""
FINER = 3
"""Times the size at which a small table is drawn before it is averaged."""
WRONG = ("line.", "shelf.un", "shelf.broken", "shelf.kept")


class ShelfSpot(NamedTuple):
    """A part of the shelf: "tab" "card" "box" "button" "close" "outside" or "", and which."""

    kind: str
    place: int = 0


class Card(NamedTuple):
    """A set-up on show: what it is called, by a key of the texts or by the player.

    drill, stars  the name of the drill that it is, and how many stars it has been worth so far
    """

    name: str
    own: bool
    lineup: Lineup
    drill: str = ""
    stars: int = 0


class ShelfLook(NamedTuple):
    """What the picture of the shelf depends on.

    cards  the set-ups of the group on show
    group  its place in GROUPS
    focus  counts the cards, then comes the box, then the buttons
    over   the part under the mouse
    field  the text in the box while it has the focus, else None
    text   what is in the box
    said   key of the texts and a word in it: what came of the last action
    """

    cards: list[Card]
    group: int
    focus: int
    over: ShelfSpot
    field: TextField | None
    text: str
    said: tuple[str, str]


# -- where things are ----------------------------------------------------------------------------


def tab_rects(layout: Layout) -> list[pygame.Rect]:
    """Return the tabs of the groups."""
    area = page_parts.inside(layout)
    bar = pygame.Rect(area.x, area.y, area.w, layout.px(TAB))
    return page_parts.row_of(bar, (1,) * len(GROUPS), layout.px(8))


def first_shown(focus: int, count: int) -> int:
    """Return the first card on show, so that the one in focus is among them."""
    row = min(focus, max(count - 1, 0)) // COLUMNS
    return max(0, row - ROWS + 1) * COLUMNS


def card_rect(slot: int, layout: Layout) -> pygame.Rect:
    """Return where the card at a slot (0 is the first shown) is."""
    area, gap = page_parts.inside(layout), layout.px(GAP)
    top = area.y + layout.px(TAB + 12)
    height = (area.bottom - layout.px(2 * BOX + 2 * GAP) - top - gap * ROWS) // ROWS
    wide = (area.w - gap * (COLUMNS - 1)) // COLUMNS
    x, y = slot % COLUMNS, slot // COLUMNS
    return pygame.Rect(area.x + x * (wide + gap), top + y * (height + gap), wide, height)


def box_rect(layout: Layout) -> pygame.Rect:
    """Return the box for a name or a line."""
    area, height = page_parts.inside(layout), layout.px(BOX)
    return pygame.Rect(area.x, area.bottom - 2 * height - layout.px(GAP), area.w, height)


def text_window(sight: Sight) -> pygame.Rect:
    """Return the room for the text in the box."""
    return box_rect(sight.layout).inflate(-2 * round(12 * sight.layout.s), 0)


def button_rects(layout: Layout) -> list[pygame.Rect]:
    """Return the buttons below the box."""
    area, height = page_parts.inside(layout), layout.px(BOX)
    bar = pygame.Rect(area.x, area.bottom - height, area.w, height)
    return page_parts.row_of(bar, (1, 1, 1.2, 1, 1), layout.px(8))


def spot_at(at: tuple[int, int], sight: Sight, count: int) -> ShelfSpot:
    """Return what is at a point of the window."""
    layout = sight.layout
    if not page_parts.panel(layout).collidepoint(at):
        return ShelfSpot("outside")
    if page_parts.close_rect(layout).collidepoint(at):
        return ShelfSpot("close")
    for kind, rects in (
        ("tab", tab_rects(layout)),
        ("button", button_rects(layout)),
        ("box", [box_rect(layout)]),
    ):
        for place, rect in enumerate(rects):
            if rect.collidepoint(at):
                return ShelfSpot(kind, place)
    for slot in range(min(count, COLUMNS * ROWS)):
        if card_rect(slot, layout).collidepoint(at):
            return ShelfSpot("card", slot)
    return ShelfSpot("")


# -- what it looks like --------------------------------------------------------------------------


def draw(surface: pygame.Surface, sight: Sight, shelf: ShelfLook) -> pygame.Rect:
    """Draw the shelf and return its rectangle."""
    w, layout, type_ = sight.words, sight.layout, sight.type
    key, word = shelf.said
    foot = w[key].format(word=word) if key else _hint(shelf, w)
    wrong = key.startswith(WRONG)
    closing = shelf.over.kind == "close"
    rect = page_parts.frame(surface, sight, w["shelf.title"], foot, wrong, closing)
    for place, tab in enumerate(tab_rects(layout)):
        hot = shelf.over == ShelfSpot("tab", place)
        label = w[f"shelf.{GROUPS[place]}"]
        page_parts.button(surface, tab, type_, label, False, hot, primary=place == shelf.group)
    _cards(surface, sight, shelf)
    _box(surface, sight, shelf)
    for place, (name, spot) in enumerate(zip(BUTTONS, button_rects(layout), strict=True)):
        focused = shelf.focus == len(shelf.cards) + 1 + place
        hot = shelf.over == ShelfSpot("button", place)
        page_parts.button(surface, spot, type_, w[f"shelf.{name}"], focused, hot)
    return rect


def _hint(shelf: ShelfLook, w: dict[str, str]) -> str:
    """What the drill in focus asks for, or what keys do."""
    drill = shelf.cards[shelf.focus].drill if shelf.focus < len(shelf.cards) else ""
    return drill_words.goal(drill, w) if drill else w["shelf.hint"]


def _cards(surface: pygame.Surface, sight: Sight, shelf: ShelfLook) -> None:
    s, type_, w, cards = sight.layout.s, sight.type, sight.words, shelf.cards
    first = first_shown(shelf.focus, len(cards))
    if not cards:
        at = (card_rect(0, sight.layout).x, card_rect(0, sight.layout).y + 30 * s)
        type_.draw(surface, w["shelf.empty"], at, 15, theme.TEXT_SOFT)
    for slot, card in enumerate(cards[first : first + COLUMNS * ROWS]):
        rect, place = card_rect(slot, sight.layout), first + slot
        focused, hot = shelf.focus == place, shelf.over == ShelfSpot("card", slot)
        edge = ACCENT if focused else LINE_INPUT if hot else LINE
        shapes.box(surface, rect, s, PANEL_RAISED, edge, 2.0 if focused else 1.0, ring=focused)
        room = rect.inflate(-round(14 * s), 0)
        room.h -= round((NAME + 10) * s)
        room.y += round(8 * s)
        picture = thumbnail(card.lineup, room.size, sight.settings.colours)
        surface.blit(picture, picture.get_rect(center=room.center))
        name = card.name if card.own else w.get(card.name, card.name.partition(".")[2])
        name = type_.fitted(name, 13, rect.w - 12 * s)
        ink = theme.TEXT if focused or hot else theme.TEXT_SOFT
        type_.draw(surface, name, (rect.centerx, rect.bottom - 10 * s), 13, ink, "centre")
        if card.drill:
            side = 12 * s
            corner = rect.right - (3 * 1.25 + 0.6) * side, rect.y + 0.9 * side
            stars.draw(surface, corner, side, card.stars)


def _box(surface: pygame.Surface, sight: Sight, shelf: ShelfLook) -> None:
    s, type_, window = sight.layout.s, sight.type, text_window(sight)
    rect, focused = box_rect(sight.layout), shelf.field is not None
    edge = ACCENT if focused else LINE_INPUT
    shapes.box(surface, rect, s, PANEL_RAISED, edge, 2.0 if focused else 1.0, ring=focused)
    line, tone = sight.line(shelf.field) if shelf.field else TextLine(shelf.text), theme.TEXT
    if not line.whole.text:
        said = type_.fitted(sight.words["shelf.box"], SIZE, window.w)
        line, tone = line._replace(text=said), theme.TEXT_FAINT
    text_line.draw(surface, window, type_, line, SIZE, rect.centery + type_.cap(SIZE) / 2, tone)


@lru_cache(maxsize=128)
def thumbnail(lineup: Lineup, room: tuple[int, int], colours: str) -> pygame.Surface:
    """Return a small table with its balls, as large as fits into `room` px.

    Empty if its world cannot be made: one set-up must not take the shelf away.
    """
    try:
        return _miniature(lineup, room, colours)
    except UNMADE as error:
        said = f"no picture of set-up {lineup.table!r}: {error!r}"
        warnings.warn(said, RuntimeWarning, stacklevel=2)
        return pygame.Surface((1, 1), pygame.SRCALPHA)


def _miniature(lineup: Lineup, room: tuple[int, int], colours: str) -> pygame.Surface:
    world = presets.scene_world(lineup.table) if lineup.table in presets.SCENES else lineup.world()
    length, width = presets.size(world)
    border = 0.07
    scale = min(room[0] / (length + 2 * border), room[1] / (width + 2 * border))
    px = round((length + 2 * border) * scale), round((width + 2 * border) * scale)
    fine = scale * FINER
    large = pygame.Surface((px[0] * FINER, px[1] * FINER), pygame.SRCALPHA)
    large.fill((*theme.WOOD, 0))
    pygame.draw.rect(large, theme.WOOD, large.get_rect(), border_radius=round(0.05 * fine))
    bed = large.get_rect().inflate(-2 * round(border * fine), -2 * round(border * fine))
    pygame.draw.rect(large, mix(_cloth(world), theme.BACKGROUND, 0.15), bed)
    _holes(large, world, fine)
    radii = {ball.name: ball.radius for ball in world.balls}
    names = [ball.name for ball in world.balls]
    looks = dict(zip(names, looks_of(world, colours), strict=True))
    for name, (x, y) in lineup.balls:
        centre = large.get_width() / 2 + x * fine, large.get_height() / 2 - y * fine
        # larger than life, so that it can be seen
        radius = max(1.25 * radii[name] * fine, 2.6 * FINER)
        pygame.draw.circle(large, theme.BACKGROUND, centre, radius + FINER)
        pygame.draw.circle(large, looks[name].body, centre, radius)
    return pygame.transform.smoothscale(large, px)


def _cloth(world: World) -> theme.Colour:
    return theme.CLOTHS[FINISHES[kind_of(world)].cloth]


def _holes(large: pygame.Surface, world: World, fine: float) -> None:
    """Draw the pockets, if there are any."""
    for wall in world.walls:
        if isinstance(wall, Pocket):
            x, y = wall.at
            centre = large.get_width() / 2 + x * fine, large.get_height() / 2 - y * fine
            pygame.draw.circle(large, theme.BACKGROUND, centre, wall.radius * fine)
