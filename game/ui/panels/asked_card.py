"""The question of a match: why it is asked, and a row for each answer with its key."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from danggu.rules.state import Option
from danggu.rules.verdict import Verdict
from game.render import theme
from game.render.layout import Layout
from game.render.parts import cards, shapes
from game.session.action import Action
from game.session.session import Session
from game.ui.names import player_name
from game.ui.sight import Place, Sight
from game.ui.table.looks import ball_words

from . import score_plates
from .parts import Panel

ROW, GAP, HEAD = 50, 8, 86
"""Height of a row, between two, and above the first one, px at s = 1."""
DIGITS = {getattr(pygame, f"K_{n}"): n - 1 for n in range(1, 10)} | {
    getattr(pygame, f"K_KP{n}"): n - 1 for n in range(1, 10)
}
STEPS = {pygame.K_UP: -1, pygame.K_DOWN: 1, pygame.K_TAB: 1}
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)


def options(session: Session) -> tuple[Option, ...]:
    """The answers to the question that is open now, () if there is none."""
    contest = session.contest
    if contest is None or session.moving or contest.match.asked is None:
        return ()
    return contest.match.asked.options


def key(event: pygame.event.Event, sight: Sight) -> tuple[bool, Action | None]:
    """Whether a key belongs to the question, and the answer that it gives, if any."""
    given = options(sight.session)
    if not given or getattr(event, "mod", 0) & (pygame.KMOD_CTRL | pygame.KMOD_ALT):
        return False, None
    first = _first(sight, len(given))
    if event.key in DIGITS:
        return True, _answer(sight, given, first + DIGITS[event.key])
    if event.key in STEPS:
        way = STEPS[event.key]
        sight.choice = (max(sight.choice, -(way > 0)) + way) % len(given)
        return True, None
    if event.key in ENTER:
        return True, _answer(sight, given, sight.choice)
    return False, None


def _answer(sight: Sight, given: tuple[Option, ...], place: int) -> Action | None:
    """The answer at a place, None if there is none; another question begins without a choice."""
    if not 0 <= place < len(given):
        return None
    sight.choice = -1
    return Action("answer", given[place].key)


def _shown(sight: Sight) -> int:
    """How many rows there is room for."""
    s, rect = sight.layout.s, _rect(sight.layout)
    return max(1, int((rect.h - HEAD * s) / ((ROW + GAP) * s)))


def _first(sight: Sight, count: int) -> int:
    """The first row on show, so that the one in focus is among them."""
    shown = _shown(sight)
    return min(max(0, sight.choice - shown + 1), max(0, count - shown))


def _rect(layout: Layout) -> pygame.Rect:
    return layout.tip.union(layout.thickness)


def row_rect(layout: Layout, place: int) -> pygame.Rect:
    """Where the row at a place is; 0 is the first one shown."""
    rect, s = _rect(layout), layout.s
    top = rect.y + round((HEAD + place * (ROW + GAP)) * s)
    return pygame.Rect(rect.x + round(12 * s), top, rect.w - round(24 * s), round(ROW * s))


def words_of(option: Option, sight: Sight) -> tuple[str, str]:
    """What an answer is called, and what follows from it."""
    w, contest = sight.words, sight.session.contest
    if f"option.{option.key}" not in w:  # a ball that is taken away
        ball = ball_words(option.key, w)
        return w["option.ball"].format(ball=ball), w["option.ball.hint"]
    hint = w[f"option.{option.key}.hint"]
    if option.key == "play_on" and option.state.free and contest is not None:
        on = ball_words(option.state.on, w) if option.state.on != "red" else w["on.red"]
        hint = w["option.play_on.free"].format(on=on)
    return w[f"option.{option.key}"], hint


def _key(sight: Sight) -> Hashable:
    contest = sight.session.contest
    asked = contest.match.asked if contest is not None else None
    return asked, sight.choice, sight.pointer.over, contest and contest.verdict


def _draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    s, t, w, contest = sight.layout.s, sight.type, sight.words, sight.session.contest
    cards.card(surface, rect, s, raised=True)
    given = options(sight.session)
    if contest is None or not given:
        return rect
    mark = pygame.Rect(rect.x + round(s), rect.y + round(14 * s), round(3 * s), round(44 * s))
    surface.fill(theme.ACCENT, mark)
    left, room = rect.x + 14 * s, rect.w - 28 * s
    name = player_name(contest.terms, contest.match.at, w)
    title = t.fitted(w["asked.title"].format(name=name), 15, room)
    t.draw(surface, title, (left, rect.y + 28 * s), 15, theme.TEXT)
    said = t.fitted(_why(contest.verdict, sight), 13, room)
    t.draw(surface, said, (left, rect.y + 50 * s), 13, theme.TEXT_SOFT)
    first = _first(sight, len(given))
    for place, option in enumerate(given[first : first + _shown(sight)]):
        _row(surface, sight, place, option, first + place == sight.choice)
    return rect


def _why(verdict: Verdict | None, sight: Sight) -> str:
    if verdict is None:
        return ""
    parts = [score_plates.reason(verdict, sight.words)]
    if verdict.gift:
        parts.append(sight.words["fact.gift"].format(n=verdict.gift))
    return " · ".join(parts)


def _row(surface: pygame.Surface, sight: Sight, place: int, option: Option, focused: bool) -> None:
    s, t = sight.layout.s, sight.type
    rect = row_rect(sight.layout, place)
    fill = theme.PRIMARY if focused else theme.PANEL_RAISED
    edge = theme.ACCENT if focused else theme.LINE_INPUT
    shapes.box(surface, rect, s, fill, edge, 2.0 if focused else 1.0, ring=focused)
    cap = pygame.Rect(rect.x + round(12 * s), 0, round(22 * s), round(24 * s))
    cap.centery = rect.centery
    shapes.box(surface, cap, s, theme.PANEL, theme.LINE_INPUT, radius=4)
    base = cap.centery + t.cap(13) / 2
    t.draw(surface, str(place + 1), (cap.centerx, base), 13, theme.TEXT, "centre")
    title, hint = words_of(option, sight)
    left = cap.right + 12 * s
    room = rect.right - 10 * s - left
    t.draw(surface, t.fitted(title, 15, room), (left, rect.y + 21 * s), 15, theme.TEXT)
    t.draw(surface, t.fitted(hint, 12, room), (left, rect.y + 40 * s), 12, theme.TEXT_SOFT)


def _touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    given = options(sight.session)
    first = _first(sight, len(given))
    for place in range(len(given[first : first + _shown(sight)])):
        if row_rect(sight.layout, place).collidepoint(at):
            return _answer(sight, given, first + place)
    return None


def _wheel(steps: int, sight: Sight) -> Action | None:
    given = options(sight.session)
    sight.choice = min(max(max(sight.choice, 0) - steps, 0), max(len(given) - 1, 0))
    return None


def part(layout: Layout) -> Panel:
    """The card in the window."""
    return Panel("asked", _rect(layout), _key, _draw, _touch, mode="asked", spill=4, wheel=_wheel)
