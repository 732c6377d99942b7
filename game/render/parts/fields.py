"""Input boxes, the primary button and the hint line in every state they can be in."""

from __future__ import annotations

import pygame

from game.render import theme
from game.render.font import Type
from game.render.theme import Colour, mix

from . import shapes, text_line
from .text_line import TextLine

STATES = ("idle", "hover", "focused", "invalid", "disabled")
UNIT_COLUMN = 28

PATH = "/"
"""What stands between folders."""


def field(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    label: str,
    value: str,
    unit: str,
    state: str = "idle",
    caret: int | None = None,
    selected: bool = False,
    flash: bool = False,
    line: TextLine | None = None,
) -> pygame.Rect:
    """Draw an input box and return its rectangle with the focus ring's room.

    `state` is one of `STATES`; an invalid box that is being edited has a `caret` too.  `caret` is
    its place in `value`; `selected` marks the whole value; `flash` lights the label for a moment.
    A `line` says all of that about the value itself.
    """
    s = type_.s
    room = rect.inflate(2 * round(4 * s), 2 * round(4 * s))
    surface.fill(theme.BACKGROUND, room)
    border, tone, width = _edge(state)
    shapes.box(surface, rect, s, theme.PANEL_RAISED, border, width, ring=state == "focused")
    name = theme.ACCENT if flash or state == "focused" else tone
    type_.draw(surface, label, (rect.x + 12 * s, rect.y + 18 * s), 12, name)
    baseline = rect.y + 39 * s
    right = rect.right - round(12 * s)
    type_.draw(surface, unit, (right, baseline), 13, theme.TEXT_SOFT, "right")
    ink = {"invalid": theme.ERROR, "disabled": theme.TEXT_SOFT}.get(state, theme.TEXT)
    line = line or TextLine(value, caret, (0, len(value) * selected))
    text_line.draw(surface, _window(rect, type_, unit), type_, line, 20, baseline, ink, "right")
    return room


def _window(rect: pygame.Rect, type_: Type, unit: str) -> pygame.Rect:
    """Return the room for the value, at the left of the unit."""
    s, left = type_.s, rect.x + round(12 * type_.s)
    right = rect.right - round(12 * s) - _unit_room(type_, unit)
    return pygame.Rect(left, rect.y + round(20 * s), right - left, round(28 * s))


def _edge(state: str) -> tuple[Colour, Colour, float]:
    """Return the border, the label's colour and the border's width (px at s = 1) of a state."""
    if state == "focused":
        return theme.ACCENT, theme.ACCENT, 2.0
    if state == "invalid":
        return theme.ERROR, theme.ERROR, 2.0
    if state == "hover":
        return theme.TEXT_SOFT, theme.TEXT_SOFT, 1.0
    if state == "disabled":
        return theme.LINE_TRACK, theme.TEXT_FAINT, 1.0
    return theme.LINE_INPUT, theme.TEXT_SOFT, 1.0


def _unit_room(type_: Type, unit: str) -> int:
    """Return the width of the column at the right that holds the unit."""
    column = round((UNIT_COLUMN + 8) * type_.s)
    return max(column, type_.width(unit, 13) + round(5 * type_.s))


def caret_at(
    rect: pygame.Rect, type_: Type, value: str, x: float, unit: str = "", caret: int | None = None
) -> int:
    """Return the place in `value` nearest to the screen's `x`, for a click into a box.

    `caret` is where it stands now, None without one: it decides how far a long value is scrolled.
    """
    line = TextLine(value, caret)
    return text_line.place_at(_window(rect, type_, unit), type_, line, 20, x, "right")


def button(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    label: str,
    key: str = "",
    state: str = "idle",
) -> pygame.Rect:
    """Draw the primary button; `state` is "idle", "hover", "pressed" or "disabled"."""
    s = type_.s
    fill, border, ink = _button_colours(state)
    surface.fill(theme.BACKGROUND, rect)
    shapes.box(surface, rect, s, fill, border)
    gap = round(12 * s) if key else 0
    cap = type_.width(key, 12) + round(12 * s) if key else 0
    left = rect.centerx - (type_.width(label, 18) + gap + cap) // 2
    baseline = rect.centery + type_.cap(18) / 2
    text = type_.draw(surface, label, (left, baseline), 18, ink)
    if key:
        outline = pygame.Rect(text.right + gap, 0, cap, round(21 * s))
        outline.centery = rect.centery
        shapes.box(surface, outline, s, fill, mix(fill, ink, 0.75), radius=4)
        middle = (outline.centerx, outline.centery + type_.cap(12) / 2)
        type_.draw(surface, key, middle, 12, ink, "centre")
    return rect


def _button_colours(state: str) -> tuple[Colour, Colour, Colour]:
    """Return fill, border and ink."""
    if state == "disabled":
        return theme.PANEL_RAISED, theme.LINE, theme.TEXT_FAINT
    if state == "hover":
        return mix(theme.PRIMARY, theme.WHITE, 0.08), theme.ACCENT, theme.WHITE
    if state == "pressed":
        return mix(theme.PRIMARY, theme.BACKGROUND, 0.25), theme.PRIMARY_EDGE, theme.WHITE
    return theme.PRIMARY, theme.PRIMARY_EDGE, theme.WHITE


def hint(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    string: str,
    error: bool = False,
    warning: bool = False,
) -> pygame.Rect:
    """Draw the line of help, or of an error or a warning with its sign."""
    s = type_.s
    sign = theme.ERROR if error else theme.WARNING if warning else None
    surface.fill(theme.BACKGROUND, rect)
    shapes.box(surface, rect, s, border=sign or theme.LINE)
    left = rect.x + round(12 * s)
    if sign is not None:
        centre = (left + round(5 * s), rect.centery)
        shapes.disc(surface, centre, 6.5 * s, sign)
        baseline = rect.centery + type_.cap(11) / 2
        mark = "!" if error else "i"
        type_.draw(surface, mark, (centre[0] + 0.5, baseline), 11, theme.PANEL, "centre")
        left += round(18 * s)
    ink, room = sign or theme.TEXT_SOFT, rect.right - round(6 * s) - left
    middle = rect.centery + type_.cap(13) / 2
    if type_.width(string, 13) > room:
        for k, line in enumerate(_halves(string, type_, room)):
            base = rect.centery + type_.cap(11) / 2 + (k - 0.5) * 15 * s
            type_.draw(surface, line, (left, base), 11, ink)
        return rect
    type_.draw(surface, type_.fitted(string, 13, room), (left, middle), 13, ink)
    return rect


def _halves(string: str, type_: Type, room: float) -> tuple[str, str]:
    """A text as two lines, cut where a word or a folder of a path ends."""
    ends = [k for k, c in enumerate(string, 1) if c in f" {PATH}"]
    cut = max((k for k in ends if type_.width(string[:k], 11) <= room), default=len(string))
    return type_.fitted(string[:cut], 11, room), type_.fitted(string[cut:], 11, room)
