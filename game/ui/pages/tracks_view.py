"""How the page "my table" looks: files at the left, a box for a path, the report, four buttons."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes, text_line
from game.render.parts.text_line import TextLine
from game.render.theme import ACCENT, LINE, LINE_INPUT, PANEL_RAISED
from game.table.table_fit import FitReport
from game.text.quoting import drawable
from game.ui.sight import Sight

from . import page_parts

BUTTONS = ("base", "fit", "save", "play")
FILES = 8
"""Files of the folder that are shown at once."""
LIST, ROW, BOX, GAP = 250, 36, 38, 10
SIZE, LINE_STEP = 13, 23
COLUMNS = (0.0, 0.40, 0.58, 0.76)
"""Where the columns of the report begin, as shares of its width."""
WRONG = ("tracks.broken", "tracks.failed", "tracks.un", "tracks.none")


class TracksSpot(NamedTuple):
    """A part of the page: a button, "file" "box" "close" "outside" or "", and which."""

    kind: str
    place: int = 0


class TracksLook(NamedTuple):
    """What the picture depends on.

    files        names of those in the folder for tracks
    first        the first of them that is shown
    line         the path in the box
    base         the table to begin with
    primary      what RETURN does
    over         the part under the mouse
    report       what has been found, or None
    looking_for  while it is fitted: how many tracks, and what for
    seconds      for which it has been fitted
    running      is it being fitted?
    said         key of the texts: what was done last, or ""
    trouble      why nothing has come of it, or ""
    own          is there a table to play on?
    key          of a table that can be saved, or ""
    folder       for tracks, "" without a home
    language     of the texts
    """

    files: tuple[str, ...]
    first: int
    line: TextLine
    base: str
    primary: str
    over: TracksSpot
    report: FitReport | None
    looking_for: tuple[int, tuple[str, ...]] | None
    seconds: int
    running: bool
    said: str
    trouble: str
    own: bool
    key: str
    folder: str
    language: str


# -- where things are ----------------------------------------------------------------------------


def box_rect(layout: Layout) -> pygame.Rect:
    """Return the box for a path."""
    area = page_parts.inside(layout)
    return pygame.Rect(area.x, area.y, area.w, layout.px(BOX))


def text_window(sight: Sight) -> pygame.Rect:
    """Return the room for the text in the box."""
    return box_rect(sight.layout).inflate(-2 * round(12 * sight.layout.s), 0)


def file_rects(layout: Layout) -> list[pygame.Rect]:
    """Return the rows of files."""
    area, top = page_parts.inside(layout), box_rect(layout).bottom + layout.px(34)
    step = layout.px(ROW)
    return [
        pygame.Rect(area.x, top + k * step, layout.px(LIST), step - layout.px(4))
        for k in range(FILES)
    ]


def button_rects(layout: Layout) -> dict[str, pygame.Rect]:
    """Return the buttons by their names."""
    area, height = page_parts.inside(layout), layout.px(BOX)
    bar = pygame.Rect(area.x, area.bottom - height, area.w, height)
    rects = page_parts.row_of(bar, (1.4, 1, 1, 1), layout.px(8))
    return dict(zip(BUTTONS, rects, strict=True))


def report_rect(layout: Layout) -> pygame.Rect:
    """Return the room for the report."""
    area, aside = page_parts.inside(layout), layout.px(LIST + 28)
    top = box_rect(layout).bottom + layout.px(16)
    bottom = area.bottom - layout.px(BOX + GAP)
    return pygame.Rect(area.x + aside, top, area.w - aside, bottom - top)


def spot_at(at: tuple[int, int], sight: Sight) -> TracksSpot:
    """Return what is at a point of the window."""
    layout = sight.layout
    if not page_parts.panel(layout).collidepoint(at):
        return TracksSpot("outside")
    if page_parts.close_rect(layout).collidepoint(at):
        return TracksSpot("close")
    if box_rect(layout).collidepoint(at):
        return TracksSpot("box")
    for name, rect in button_rects(layout).items():
        if rect.collidepoint(at):
            return TracksSpot(name)
    for place, rect in enumerate(file_rects(layout)):
        if rect.collidepoint(at):
            return TracksSpot("file", place)
    return TracksSpot("")


# -- what it looks like --------------------------------------------------------------------------


def draw(surface: pygame.Surface, sight: Sight, look: TracksLook) -> pygame.Rect:
    """Draw the page and return its rectangle."""
    w, over = sight.words, look.over
    usual = "tracks.hint.running" if look.running else "tracks.hint"
    foot, wrong = w[look.said or usual], look.said.startswith(WRONG)
    title = w["tracks.title"]
    rect = page_parts.frame(surface, sight, title, foot, wrong, over.kind == "close")
    _box(surface, sight, look)
    _files(surface, sight, look)
    _buttons(surface, sight, look)
    area, s = report_rect(sight.layout), sight.layout.s
    base = area.y + 14 * s
    for text, size, ink in _lines(sight, look, area.w):
        for column, cell in zip(COLUMNS, text.split("\t"), strict=False):
            sight.type.draw(surface, cell, (area.x + column * area.w, base), size, ink)
        base += LINE_STEP * s
    return rect


def _box(surface: pygame.Surface, sight: Sight, look: TracksLook) -> None:
    s, type_, rect = sight.layout.s, sight.type, box_rect(sight.layout)
    shapes.box(surface, rect, s, PANEL_RAISED, ACCENT, 2.0, ring=True)
    line, tone, window = look.line, theme.TEXT, text_window(sight)
    if not line.whole.text:
        said = type_.fitted(sight.words["tracks.box"], SIZE, window.w)
        line, tone = line._replace(text=said), theme.TEXT_FAINT
    text_line.draw(surface, window, type_, line, SIZE, rect.centery + type_.cap(SIZE) / 2, tone)


def _files(surface: pygame.Surface, sight: Sight, look: TracksLook) -> None:
    s, type_, rects = sight.layout.s, sight.type, file_rects(sight.layout)
    head = sight.words["tracks.files" if look.files else "tracks.nofiles"]
    head = type_.fitted(head, SIZE, rects[0].w)
    type_.draw(surface, head, (rects[0].x, rects[0].y - 8 * s), SIZE, theme.TEXT_SOFT)
    shown = look.files[look.first : look.first + FILES]
    for place, (name, rect) in enumerate(zip(shown, rects, strict=False)):
        chosen = look.line.text.endswith(name)
        edge = ACCENT if chosen else LINE_INPUT if look.over == ("file", place) else LINE
        shapes.box(surface, rect, s, PANEL_RAISED, edge)
        text = type_.fitted(drawable(name), SIZE, rect.w - 20 * s)
        at = rect.x + 10 * s, rect.centery + type_.cap(SIZE) / 2
        type_.draw(surface, text, at, SIZE, theme.TEXT if chosen else theme.TEXT_SOFT)


def _buttons(surface: pygame.Surface, sight: Sight, look: TracksLook) -> None:
    w = sight.words
    labels = {name: w[f"tracks.{name}"] for name in BUTTONS[1:]}
    labels["base"] = w["tracks.base"].format(table=w[f"table.{look.base}"])
    if look.running:
        labels["fit"] = w["tracks.stop"]
    primary = "fit" if look.primary == "stop" else look.primary
    for name, rect in button_rects(sight.layout).items():
        hot = look.over.kind == name
        args = surface, rect, sight.type, labels[name]
        page_parts.button(*args, False, hot, primary=name == primary)


Line = tuple[str, float, theme.Colour]


def _lines(sight: Sight, look: TracksLook, room: int) -> Iterator[Line]:
    """The report, what is being done, or what is wrong: cells with tabs between, size and ink."""
    w = sight.words
    if look.trouble:
        said = drawable(" ".join(look.trouble.split()))
        yield from _wrapped(sight, said, room, theme.ERROR)
    elif look.running:
        yield w["tracks.running"].format(seconds=look.seconds), 15, theme.TEXT
        if look.looking_for is not None:
            count, names = look.looking_for
            called = ", ".join(w[f"tracks.{name}"] for name in names)
            said = w["tracks.looking"].format(count=count, names=called)
            yield from _wrapped(sight, said, room, theme.TEXT_SOFT)
    elif look.report is not None:
        yield from _reported(sight, look.report, room)
    else:
        yield from _wrapped(sight, w["tracks.about"], room, theme.TEXT_SOFT)
        yield from _wrapped(sight, w["tracks.about.2"], room, theme.TEXT_SOFT)
        yield from _wrapped(sight, w["tracks.folder"].format(folder=look.folder), room, theme.TEXT)
        yield w["tracks.own" if look.own else "tracks.noown"], SIZE, theme.TEXT


def _reported(sight: Sight, report: FitReport, room: int) -> Iterator[Line]:
    w = sight.words
    misfit = w["tracks.misfit"].format(count=report.tracks, misfit=f"{report.misfit:.2f}")
    yield misfit, 15, theme.TEXT
    yield "\t".join(("", w["tracks.before"], w["tracks.found"], "±")), SIZE, theme.TEXT_SOFT
    for row in report.rows:
        numbers = (f"{number:.5f}" for number in (row.before, row.found, row.error))
        yield "\t".join((w[f"tracks.{row.name}"], *numbers)), SIZE, theme.TEXT
    for name, why in report.unseen:
        yield w["tracks.unseen"].format(name=w[f"tracks.{name}"]), SIZE, theme.WARNING
        yield from _wrapped(sight, why, room, theme.TEXT_SOFT)


def _wrapped(sight: Sight, text: str, room: int, ink: theme.Colour) -> Iterator[Line]:
    for line in page_parts.wrapped(text, sight.type, SIZE, room):
        yield sight.type.fitted(line, SIZE, room), SIZE, ink
