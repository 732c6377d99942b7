"""How the page of labs looks: the labs at the left, the question, fields for answers, buttons."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes, text_line
from game.render.parts.text_line import TextLine
from game.render.theme import ACCENT, LINE, LINE_INPUT, PANEL_RAISED
from game.text.quoting import drawable
from game.ui.sight import Sight

from . import labs_text, page_parts

if TYPE_CHECKING:
    from danggu.labs import Worksheet

BUTTONS = ("open", "check", "fewer", "more", "print")
LIST, ROW, GAP = 250, 33, 12
SIZE = 14
"""Of an answer."""
CELL, BOX, MARK = 52, 28, 84
"""Height of a field with its label, of its box, and width of what is said beside it."""
COLUMNS = 2
WRONG = ("labs.un",)
WAYS = {0: "labs.right", 1: "labs.large", -1: "labs.small"}


class LabsSpot(NamedTuple):
    """A part of the page: a button, "lab" "field" "close" "outside" or "", and which."""

    kind: str
    place: int = 0


class LabsLook(NamedTuple):
    """What the picture depends on.

    place     of the lab in the list
    seed      0: the usual numbers
    focus     the field that is typed into; -1: the list
    lines     the answers
    ways      of each answer: 0 right, +1 too large, -1 too small; None: not checked
    over      the part under the mouse
    said      key of the texts and a word in it
    language  of the texts
    """

    place: int
    seed: int
    focus: int
    lines: tuple[TextLine, ...]
    ways: tuple[int | None, ...]
    over: LabsSpot
    said: tuple[str, str]
    language: str


def plain(text: str) -> TextLine:
    """A text that is not being edited."""
    return TextLine(text)


# -- where things are ----------------------------------------------------------------------------


def lab_rects(layout: Layout, count: int) -> list[pygame.Rect]:
    """Return the rows of the list."""
    area, step = page_parts.inside(layout), layout.px(ROW)
    wide, high = layout.px(LIST), step - layout.px(4)
    return [pygame.Rect(area.x, area.y + k * step, wide, high) for k in range(count)]


def _right(layout: Layout) -> pygame.Rect:
    area, aside = page_parts.inside(layout), layout.px(LIST + 28)
    return pygame.Rect(area.x + aside, area.y, area.w - aside, area.h)


def button_rects(layout: Layout) -> dict[str, pygame.Rect]:
    """Return the buttons by their names; "fewer" and "more" are beside the numbers."""
    area, height = _right(layout), layout.px(page_parts.BUTTON)
    bar = pygame.Rect(area.x, area.bottom - height, area.w, height)
    open_, check, fewer, _, more, print_ = page_parts.row_of(
        bar, (1.3, 1, 0.28, 1.1, 0.28, 1.2), layout.px(8)
    )
    return dict(zip(BUTTONS, (open_, check, fewer, more, print_), strict=True))


def _number_rect(layout: Layout) -> pygame.Rect:
    rects = button_rects(layout)
    left, right = rects["fewer"].right, rects["more"].x
    return pygame.Rect(left, rects["fewer"].y, right - left, rects["fewer"].h)


def field_rects(layout: Layout, count: int) -> list[pygame.Rect]:
    """Return the boxes for answers; each has its label above it."""
    area, cell = _right(layout), layout.px(CELL)
    rows = -(-count // COLUMNS)
    top = button_rects(layout)["open"].y - layout.px(GAP) - rows * cell
    wide = (area.w - layout.px(24)) // COLUMNS
    found = []
    for k in range(count):
        column, row = k % COLUMNS, k // COLUMNS
        x, y = area.x + column * (wide + layout.px(24)), top + row * cell
        box = layout.px(BOX)
        found.append(pygame.Rect(x, y + cell - box - layout.px(4), wide - layout.px(MARK), box))
    return found


def _reading(layout: Layout, boxes: list[pygame.Rect]) -> pygame.Rect:
    """The room above the fields."""
    area = _right(layout)
    area.h = boxes[0].y - layout.px(CELL - BOX) - area.y
    return area


def text_window(sight: Sight, place: int, count: int) -> pygame.Rect:
    """Return the room for the text of an answer."""
    return field_rects(sight.layout, count)[place].inflate(-2 * round(10 * sight.layout.s), 0)


def spot_at(at: tuple[int, int], sight: Sight, count: int, sheet: Worksheet) -> LabsSpot:
    """Return what is at a point of the window, with so many labs in the list."""
    layout = sight.layout
    if not page_parts.panel(layout).collidepoint(at):
        return LabsSpot("outside")
    if page_parts.close_rect(layout).collidepoint(at):
        return LabsSpot("close")
    for name, rect in button_rects(layout).items():
        if rect.collidepoint(at):
            return LabsSpot(name)
    for kind, rects in (
        ("lab", lab_rects(layout, count)),
        ("field", field_rects(layout, len(sheet.fields))),
    ):
        for place, rect in enumerate(rects):
            if rect.collidepoint(at):
                return LabsSpot(kind, place)
    return LabsSpot("")


# -- what it looks like --------------------------------------------------------------------------


def draw(
    surface: pygame.Surface, sight: Sight, look: LabsLook, names: Sequence[str], sheet: Worksheet
) -> pygame.Rect:
    """Draw the page and return its rectangle."""
    w, (key, word) = sight.words, look.said
    wrong = key.startswith(WRONG)
    foot = w[key].format(*word.split(), word=drawable(word)) if key else w["labs.hint"]
    title = f"{w['labs.title']}{' · ' + sheet.title(look.language)}"
    rect = page_parts.frame(surface, sight, title, foot, wrong, look.over.kind == "close")
    _list(surface, sight, look, names)
    boxes = field_rects(sight.layout, len(sheet.fields))
    labs_text.draw(surface, sight, sheet, _reading(sight.layout, boxes))
    for place, box in enumerate(boxes):
        _field(surface, sight, look, sheet, place, box)
    _buttons(surface, sight, look)
    return rect


def _list(surface: pygame.Surface, sight: Sight, look: LabsLook, names: Sequence[str]) -> None:
    from danggu.labs import text

    s, type_, say = sight.layout.s, sight.type, text.of(look.language)
    for place, rect in enumerate(lab_rects(sight.layout, len(names))):
        chosen, hot = place == look.place, look.over == ("lab", place)
        edge = ACCENT if chosen else LINE_INPUT if hot else LINE
        ring = chosen and look.focus < 0
        shapes.box(surface, rect, s, PANEL_RAISED, edge, 2.0 if ring else 1.0, ring=ring)
        name = type_.fitted(say[f"{names[place]}.title"], 13, rect.w - 20 * s)
        at = rect.x + 10 * s, rect.centery + type_.cap(13) / 2
        ink = theme.TEXT if chosen or hot else theme.TEXT_SOFT
        type_.draw(surface, name, at, 13, ink)


def _field(
    surface: pygame.Surface, sight: Sight, look: LabsLook, sheet: Worksheet, place: int,
    box: pygame.Rect,
) -> None:  # fmt: skip
    """A label, the box with its unit, and what has come of the answer."""
    s, type_, w, field = sight.layout.s, sight.type, sight.words, sheet.fields[place]
    focused, line, way = look.focus == place, look.lines[place], look.ways[place]
    unit = f" ({field.unit})" if field.unit else ""
    label = sheet.label(field.name, look.language) + unit
    label = type_.fitted(label, 13, box.w + MARK * s)
    type_.draw(surface, label, (box.x, box.y - 6 * s), 13, theme.TEXT_SOFT)
    hot = look.over == ("field", place)
    edge = ACCENT if focused else LINE_INPUT if hot else LINE
    shapes.box(surface, box, s, PANEL_RAISED, edge, 2.0 if focused else 1.0, ring=focused)
    window = box.inflate(-2 * round(10 * s), 0)
    base = box.centery + type_.cap(SIZE) / 2
    text_line.draw(surface, window, type_, line, SIZE, base, theme.TEXT)
    if way is not None:
        said = type_.fitted(w[WAYS[way]], 13, (MARK - 10) * s)
        ink = theme.ERROR if way else theme.GOOD
        type_.draw(surface, said, (box.right + 10 * s, base), 13, ink)


def _buttons(surface: pygame.Surface, sight: Sight, look: LabsLook) -> None:
    w, type_ = sight.words, sight.type
    labels = {"fewer": "−", "more": "+"}
    for name, rect in button_rects(sight.layout).items():
        hot, primary = look.over.kind == name, name == ("check" if look.focus >= 0 else "open")
        label = labels.get(name) or w[f"labs.{name}"]
        page_parts.button(surface, rect, type_, label, False, hot, primary=primary)
    rect = _number_rect(sight.layout)
    said = w["labs.seed"].format(seed=look.seed) if look.seed else w["labs.usual"]
    said = type_.fitted(said, 13, rect.w - 8 * sight.layout.s)
    at = rect.centerx, rect.centery + type_.cap(13) / 2
    type_.draw(surface, said, at, 13, theme.TEXT, "centre")
