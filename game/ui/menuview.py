"""How the game menu looks and where its parts are: the game at the left, players at the right."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, NamedTuple

import pygame

from game.fixture import FREE, SKILLS, Fixture
from game.render import shapes, theme
from game.render.layout import Layout
from game.render.theme import ACCENT, LINE_INPUT, PANEL_RAISED

from . import pages
from .parts import Sight

if TYPE_CHECKING:
    from .menu import Row

BUTTONS = ("start", "shelf", "rules", "help", "settings", "quit")
ROW, STRIDE = 38, 46
HEAD = 26
ARROW = 30
LABEL = 132
GROUP = 10
"""Room above a player's rows."""


class Spot(NamedTuple):
    """A part of the menu: place in the order of focus, or -1; step of an arrow, or what else."""

    place: int
    step: int = 0
    other: str = ""


NOTHING, OUTSIDE, CLOSE = Spot(-1), Spot(-1, 0, "outside"), Spot(-1, 0, "close")


# -- where things are ----------------------------------------------------------------------------


def row_rect(rows: Sequence[Row], place: int, layout: Layout) -> pygame.Rect:
    """Return where a row is."""
    area, gap = pages.inside(layout), layout.px(32)
    right = next((i for i, row in enumerate(rows) if row.name == "players"), len(rows))
    column = place >= right
    index = place - right if column else place
    wide = (area.w - gap) // 2
    groups = max(rows[place].seat, -1) + 1 if column else 0
    top = area.y + layout.px(HEAD) + layout.px(STRIDE * index + GROUP * groups)
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


def button_rects(layout: Layout) -> list[pygame.Rect]:
    """Return the buttons below the rows, the primary one first and wider."""
    area, height = pages.inside(layout), layout.px(pages.BUTTON)
    bar = pygame.Rect(area.x, area.bottom - height, area.w, height)
    return pages.row_of(bar, (1.7, 1, 1, 1, 1, 1), layout.px(10))


def spot_at(at: tuple[int, int], sight: Sight, rows: Sequence[Row]) -> Spot:
    """Return what is at a point of the window."""
    layout = sight.layout
    if not pages.panel(layout).collidepoint(at):
        return OUTSIDE
    if pages.close_rect(layout).collidepoint(at):
        return CLOSE
    for place, row in enumerate(rows):
        rect = row_rect(rows, place, layout)
        if rect.collidepoint(at):
            left, right = arrows(rect, layout)
            if row.kind == "text":
                return Spot(place)
            value = 1 if row.kind == "choice" and value_rect(rect, layout).collidepoint(at) else 0
            return Spot(
                place, -1 if left.collidepoint(at) else 1 if right.collidepoint(at) else value
            )
    for k, rect in enumerate(button_rects(layout)):
        if rect.collidepoint(at):
            return Spot(len(rows) + k)
    return NOTHING


# -- what it looks like --------------------------------------------------------------------------


def draw(
    surface: pygame.Surface,
    sight: Sight,
    fixture: Fixture,
    rows: Sequence[Row],
    focus: int,
    over: Spot,
    caret: bool,
) -> pygame.Rect:
    """Draw the menu and return its rectangle."""
    w, layout = sight.words, sight.layout
    foot = _foot(w, fixture, rows[focus] if focus < len(rows) else None)
    rect = pages.frame(surface, sight, w["menu.title"], foot, False, over == CLOSE)
    _heads(surface, sight, fixture)
    for place, row in enumerate(rows):
        spot = row_rect(rows, place, layout)
        hot = over.step if over.place == place else 0
        _row(surface, sight, spot, row, fixture, place == focus, hot, caret)
    for k, (name, spot) in enumerate(zip(BUTTONS, button_rects(layout), strict=True)):
        place = len(rows) + k
        pages.button(
            surface,
            spot,
            sight.type,
            w[f"menu.{name}"],
            place == focus,
            over.place == place,
            k == 0,
        )
    return rect


def _heads(surface: pygame.Surface, sight: Sight, fixture: Fixture) -> None:
    area, s, w = pages.inside(sight.layout), sight.layout.s, sight.words
    base = area.y + 12 * s
    sight.type.draw(surface, w["menu.game.head"], (area.x, base), 13, ACCENT)
    middle = area.x + (area.w - sight.layout.px(32)) // 2 + sight.layout.px(32)
    if fixture.game != FREE:
        sight.type.draw(surface, w["menu.players.head"], (middle, base), 13, ACCENT)
        return
    size, room = 13, area.right - middle
    for i, line in enumerate(pages.wrapped(w["rule.free.1"], sight.type, size, room)):
        at = (middle, base + (28 + 22 * i) * s)
        sight.type.draw(surface, line, at, size, theme.TEXT_SOFT)


def _foot(w: dict[str, str], fixture: Fixture, row: Row | None) -> str:
    if row is None:
        return w["menu.hint.button"]
    if row.name == "level":
        skill = SKILLS.get(fixture.seats[row.seat].level)
        if skill is not None:
            numbers = {"angle": f"{skill.angle:g}", "speed": f"{100 * skill.speed:g}"}
            return w["level.error"].format(**numbers, tip=f"{skill.tip:g}")
    return w["menu.hint." + row.kind]


def value_word(row: Row, fixture: Fixture, w: dict[str, str]) -> str:
    """Return what a row says."""
    if row.name == "players":
        return w[f"players.{len(fixture.seats)}"]
    if row.seat >= 0:
        seat = fixture.seats[row.seat]
        if row.name == "name":
            return seat.name
        return w[f"level.{seat.level}"] if row.name == "level" else str(seat.target)
    value = getattr(fixture, row.name)
    if isinstance(value, bool):
        return w["yes" if value else "no"]
    return str(value) if isinstance(value, int) else w[f"{row.name}.{value}"]


def _row(
    surface: pygame.Surface,
    sight: Sight,
    rect: pygame.Rect,
    row: Row,
    fixture: Fixture,
    focused: bool,
    hot: int,
    caret: bool,
) -> None:
    s, type_, w = sight.layout.s, sight.type, sight.words
    box = value_rect(rect, sight.layout)
    shapes.box(
        surface, box, s, PANEL_RAISED, ACCENT if focused else LINE_INPUT, 2.0 if focused else 1.0
    )
    base = rect.centery + type_.cap(13) / 2
    label = w[f"row.{row.name}"]
    ink = theme.TEXT if focused else theme.TEXT_SOFT
    type_.draw(surface, type_.fitted(label, 13, LABEL * s - 8), (rect.x, base), 13, ink)
    said, tone = value_word(row, fixture, w), theme.TEXT
    if row.name == "name" and not said and not (focused and caret):
        said, tone = player_name(fixture, row.seat, w), theme.TEXT_FAINT
    room = box.w - (2 * ARROW + 8) * s
    base = rect.centery + type_.cap(15) / 2
    shown = type_.draw(
        surface, type_.fitted(said, 15, room), (box.centerx, base), 15, tone, "centre"
    )
    if focused and row.kind != "choice" and caret:
        bar = pygame.Rect(shown.right + 1, 0, max(1, round(1.5 * s)), round(20 * s))
        bar.centery = rect.centery
        surface.fill(ACCENT, bar)
    if row.kind != "text":
        for way, arrow in zip((-1, 1), arrows(rect, sight.layout), strict=True):
            _arrow(surface, arrow, s, way, focused or hot == way)


def player_name(fixture: Fixture, index: int, w: dict[str, str]) -> str:
    """Return how a player is called: the name that was given, or the usual one."""
    seat = fixture.seats[index]
    if seat.name:
        return seat.name
    if seat.level in SKILLS:
        return w["player.computer"].format(level=w[f"level.{seat.level}"])
    return w["player.human"].format(n=index + 1)


def _arrow(surface: pygame.Surface, rect: pygame.Rect, s: float, way: int, hot: bool) -> None:
    ink = theme.TEXT if hot else theme.TEXT_FAINT
    (x, y), arm = rect.center, 4.5 * s
    for off in (-0.4, 0.4):
        for up in (-1, 1):
            tip = (x + way * arm / 2 + off, y)
            pygame.draw.aaline(surface, ink, tip, (x - way * arm / 2 + off, y + up * arm))
