"""Cards of words and numbers: score plates, inning, engine, result, read-outs and the event log."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import pygame

from game.render import theme
from game.render.font import Type
from game.render.theme import Colour, mix

from . import shapes

ROW = 24
"""Height of a row of the log, px at s = 1."""
LOG_HEAD, LOG_FOOT = 36, 8
CURRENT = mix(theme.PANEL, theme.ACCENT, 0.20)


def card(surface: pygame.Surface, rect: pygame.Rect, s: float, raised: bool = False) -> pygame.Rect:
    """Draw an empty card on the window's background."""
    surface.fill(theme.BACKGROUND, rect)
    fill = theme.PANEL_RAISED if raised else theme.PANEL
    return shapes.box(surface, rect, s, fill, theme.LINE_TRACK if raised else theme.LINE)


def score(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    name: str,
    averages: str,
    points: str,
    goal: str,
    playing: bool,
    ball: pygame.Surface | None = None,
    share: float | None = None,
    tone: Colour | None = None,
    kept: int = 0,
) -> pygame.Rect:
    """Draw a player's plate: `goal` is written after a slash, or as it is in brackets; `share`
    fills the bar (None: no bar).

    `ball` is a sprite of the player's ball; `averages` may be empty, `tone` is its own colour;
    `kept` px at the end of `score_room` stay free.
    """
    s = type_.s
    card(surface, rect, s, playing)
    strong = theme.TEXT if playing else theme.TEXT_FAINT
    weak = theme.TEXT_SOFT if playing else theme.TEXT_FAINT
    if playing:
        _mark(surface, rect, s)
    if ball is not None:
        surface.blit(ball, ball.get_rect(center=(rect.x + round(28 * s), rect.centery)))
    left, end = score_room(rect, type_, points, goal, ball is not None)
    lift = 21 if averages else 29
    _points(surface, rect, type_, points, goal, (strong, weak))
    end -= kept + (round(70 * s) if share is not None else 0)
    name, averages = type_.fitted(name, 15, end - left), type_.fitted(averages, 12, end - left)
    type_.draw(surface, name, (left, rect.y + lift * s), 15, strong if playing else weak)
    type_.draw(surface, averages, (left, rect.y + 39 * s), 12, tone or weak)
    if share is not None:
        bar = pygame.Rect(end + round(8 * s), 0, round(62 * s), round(4 * s))
        bar.centery = rect.centery
        _progress(surface, bar, share, theme.ACCENT if playing else theme.TEXT_FAINT)
    return rect


def _mark(surface: pygame.Surface, rect: pygame.Rect, s: float) -> None:
    """Mark the plate of the player at the table."""
    mark = pygame.Rect(rect.x + round(s), 0, round(3 * s), rect.h // 2)
    mark.centery = rect.centery
    surface.fill(theme.ACCENT, mark)


def score_room(
    rect: pygame.Rect, type_: Type, points: str, goal: str, ball: bool
) -> tuple[int, int]:
    """Where the words of a plate begin, after the player's `ball` if it has one, and where what
    stands before its points has to end, px."""
    s = type_.s
    tail = rect.right - round(14 * s) - type_.width(_goal(goal), 15)
    shown = tail - round(6 * s) - type_.width(points, 30)
    # two digits have room, so that what is before them does not move
    return rect.x + round((50 if ball else 14) * s), min(shown, tail - round(42 * s)) - round(8 * s)


def _goal(goal: str) -> str:
    return goal if goal.startswith("(") else f"/ {goal}"


def _points(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    points: str,
    goal: str,
    inks: tuple[Colour, Colour],
) -> None:
    """Write the points and their goal at the right."""
    s = type_.s
    right = rect.right - round(14 * s)
    tail = type_.draw(surface, _goal(goal), (right, rect.y + 31 * s), 15, inks[1], "right")
    type_.draw(surface, points, (tail.x - round(6 * s), rect.y + 36 * s), 30, inks[0], "right")


def _progress(surface: pygame.Surface, bar: pygame.Rect, share: float, ink: Colour) -> None:
    shapes.bar(surface, bar, theme.LINE_TRACK)
    done = pygame.Rect(bar.x, bar.y, round(bar.w * min(max(share, 0.0), 1.0)), bar.h)
    if done.w >= bar.h:
        shapes.bar(surface, done, ink)


def inning(
    surface: pygame.Surface, rect: pygame.Rect, type_: Type, label: str, number: str
) -> pygame.Rect:
    """Draw the inning's number under its name."""
    s = type_.s
    card(surface, rect, s)
    type_.draw(surface, label, (rect.centerx, rect.y + 20 * s), 13, theme.TEXT_SOFT, "centre")
    sizes = (20, 17, 15, 13)
    room = rect.w - 8 * s
    size = next((size for size in sizes if type_.width(number, size) <= room), sizes[-1])
    type_.draw(surface, number, (rect.centerx, rect.y + 41 * s), size, theme.TEXT, "centre")
    return rect


def engine(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    first: str,
    second: str,
    corner: str = "",
    kept: int = 0,
) -> pygame.Rect:
    """Draw the card that names the engine (first line) and the table (second).

    `kept` px at s = 1 stay free at the right of the first line.
    """
    s = type_.s
    card(surface, rect, s)
    shapes.disc(surface, (rect.x + 18 * s, rect.y + 17 * s), 4 * s, theme.GOOD)
    left, right = rect.x + 30 * s, rect.right - 12 * s
    first = type_.fitted(first, 13, right - left - kept * s)
    type_.draw(surface, first, (left, rect.y + 21 * s), 13, theme.TEXT)
    end = type_.draw(surface, corner, (right, rect.y + 39 * s), 12, theme.TEXT_SOFT, "right").x
    second = type_.fitted(second, 12, end - 8 * s - left)
    type_.draw(surface, second, (left, rect.y + 39 * s), 12, theme.TEXT_SOFT)
    return rect


def result(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    badge: str,
    first: str,
    second: str,
    tone: Colour = theme.GOOD,
) -> pygame.Rect:
    """Draw what a shot counted: a large badge such as +1 and two lines."""
    s = type_.s
    card(surface, rect, s, raised=True)
    type_.draw(surface, badge, (rect.x + 12 * s, rect.y + 42 * s), 28, tone)
    left = rect.x + max(round(58 * s), round(26 * s) + type_.width(badge, 28))
    room = rect.right - 12 * s - left
    type_.draw(surface, type_.fitted(first, 15, room), (left, rect.y + 27 * s), 15, theme.TEXT)
    second = type_.fitted(second, 13, room)
    type_.draw(surface, second, (left, rect.y + 47 * s), 13, theme.TEXT_SOFT)
    return rect


def readouts(
    surface: pygame.Surface, rect: pygame.Rect, type_: Type, items: Sequence[tuple[str, str, str]]
) -> pygame.Rect:
    """Draw some (label, value, unit) side by side with thin dividers."""
    s = type_.s
    card(surface, rect, s)
    step = (rect.w - round(24 * s)) / len(items)
    for i, (label, value, unit) in enumerate(items):
        left = rect.x + round(12 * s + i * step)
        if i:
            x = left - round(8 * s)
            pad = round(13 * s)
            surface.fill(theme.LINE, (x, rect.y + pad, max(1, round(s)), rect.h - 2 * pad))
        type_.draw(surface, label, (left, rect.centery - 11 * s), 13, theme.TEXT_SOFT)
        end = type_.draw(surface, value, (left, rect.centery + 21 * s), 20, theme.TEXT).right
        type_.draw(surface, unit, (end + 4 * s, rect.centery + 21 * s), 12, theme.TEXT_SOFT)
    return rect


@dataclass(frozen=True)
class LogRow:
    """An event as a row of the log.

    time    when it was, as it is written
    balls   whose it is: colours and, in the colour-blind set, letters
    first   what happened
    second  the same in another language, or any note, at the right; may be empty
    """

    time: str
    balls: tuple[tuple[Colour, str], ...]
    first: str
    second: str = ""


def log_rows(rect: pygame.Rect, s: float) -> int:
    """Return how many rows fit into the card of the log."""
    return max(1, int((rect.h - (LOG_HEAD + LOG_FOOT) * s) / (ROW * s)))


def log_scroll(count: int, current: int, shown: int) -> int:
    """Return the first row to show: the current one stays third from the bottom where it can."""
    return max(0, min(current - (shown - 3), count - shown))


def log_row(rect: pygame.Rect, s: float, place: int) -> pygame.Rect:
    """Return the rectangle of the row at `place` (0 is the top one shown)."""
    inset = round(6 * s)
    top = rect.y + round((LOG_HEAD + place * ROW) * s)
    return pygame.Rect(rect.x + inset, top, rect.w - 2 * inset, round(ROW * s))


def log(
    surface: pygame.Surface,
    rect: pygame.Rect,
    type_: Type,
    title: str,
    rows: Sequence[LogRow],
    current: int,
    letters: bool = False,
    first: int | None = None,
) -> pygame.Rect:
    """Draw the list of events; those after `current` are still to come.

    `first` is the top row shown; without it the current row is kept third from the bottom.
    """
    s = type_.s
    card(surface, rect, s)
    type_.draw(surface, title, (rect.x + 12 * s, rect.y + 23 * s), 13, theme.TEXT_SOFT)
    shown = log_rows(rect, s)
    top = log_scroll(len(rows), current, shown) if first is None else first
    for place, row in enumerate(rows[top : top + shown]):
        line = log_row(rect, s, place)
        _log_row(
            surface, line, type_, row, (top + place > current) - (top + place == current), letters
        )
    return rect


def _log_row(
    surface: pygame.Surface, line: pygame.Rect, type_: Type, row: LogRow, when: int, letters: bool
) -> None:
    """Draw a row that is past (`when` -1 is the current one), or still to come (1)."""
    s = type_.s
    if when < 0:
        shapes.box(surface, line, s, CURRENT, CURRENT, radius=4)
        surface.fill(
            theme.ACCENT, (line.x, line.y + round(2 * s), round(2 * s), line.h - 2 * round(2 * s))
        )
    ink, soft = (theme.TEXT_FAINT,) * 2 if when > 0 else (theme.TEXT, theme.TEXT_SOFT)
    baseline = line.centery + type_.cap(13) / 2
    type_.draw(surface, row.time, (line.x + 41 * s, baseline), 13, soft, "right")
    step = 15 if letters else 11
    for i, (colour, letter) in enumerate(row.balls):
        faded = mix(theme.PANEL, colour, 0.5) if when > 0 else colour
        centre = (line.x + round((56 + i * step + (2 if letters else 0)) * s), line.centery)
        tag(surface, centre, type_, faded, letter if letters else "")
    left, right = line.x + (92 if letters else 82) * s, line.right - 8 * s
    first = type_.fitted(row.first, 13, right - left)
    end = type_.draw(surface, first, (left, baseline), 13, ink).right
    second = type_.fitted(row.second, 13, right - 8 * s - end)
    type_.draw(surface, second, (right, baseline), 13, soft, "right")


def tag(
    surface: pygame.Surface, centre: tuple[float, float], type_: Type, colour: Colour, letter: str
) -> pygame.Rect:
    """Draw a ball's dot, with its letter where colours alone may not tell."""
    if not letter:
        return shapes.disc(surface, centre, 4 * type_.s, colour)
    rect = shapes.disc(surface, centre, max(7 * type_.s, 6.5), colour)
    middle = (int(centre[0]) + 0.5, int(centre[1]) + type_.cap(11) / 2)
    type_.draw(surface, letter, middle, 11, theme.BACKGROUND, "centre")
    return rect
