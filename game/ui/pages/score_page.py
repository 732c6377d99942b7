"""The sheet of the match: visit by visit at the left, what each player has done at the right."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from itertools import accumulate

import pygame

from game.render import theme
from game.render.parts import shapes
from game.session import scorecard
from game.session.action import Action
from game.session.running_match import Contest
from game.session.session import Session
from game.session.terms import HUMAN
from game.settings.statistics import Figures, kept_name
from game.ui.names import player_name
from game.ui.panels import rack_words
from game.ui.sight import Sight

from . import page_parts

ROW = 26
SIZE = 13
STEPS = {
    pygame.K_UP: -1, pygame.K_DOWN: 1, pygame.K_PAGEUP: -10, pygame.K_PAGEDOWN: 10,
    pygame.K_HOME: -9999, pygame.K_END: 9999,
}  # fmt: skip
CLOSING = (pygame.K_ESCAPE, pygame.K_RETURN, pygame.K_KP_ENTER)
LINES = ("visits", "average", "best", "strokes", "made", "share", "fouls")


class ScorePage:
    """The sheet; `top` is the first visit on show."""

    typing = False

    def __init__(self) -> None:
        self.top = 0
        self.closing = False
        self.career: Callable[[str, str], Figures] = lambda player, game: Figures()
        """What a player has done in a game so far."""

    def open(self, session: Session) -> None:
        """Begin with the last visits."""
        self.top = 9999

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        contest = sight.session.contest
        card = contest.card if contest is not None else None
        return self.top, self.closing, card, sight.session.language

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            always = sight.preferences.keys.always.get(event.key)
            if always is not None:
                return always
            if event.key in CLOSING:
                return Action("sheet", "")
            self._scroll(STEPS.get(event.key, 0), sight)
        elif event.type == pygame.MOUSEWHEEL:
            self._scroll(-event.y, sight)
        elif event.type == pygame.MOUSEMOTION:
            self.closing = page_parts.close_rect(sight.layout).collidepoint(event.pos)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            outside = not page_parts.panel(sight.layout).collidepoint(event.pos)
            if outside or page_parts.close_rect(sight.layout).collidepoint(event.pos):
                return Action("sheet", "")
        return None

    def _scroll(self, step: int, sight: Sight) -> None:
        contest = sight.session.contest
        count = len(contest.card) if contest is not None else 0
        last = max(0, count - _room(sight))
        self.top = min(max(min(self.top, last) + step, 0), last)

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the page; returns its rectangle."""
        w, contest = sight.words, sight.session.contest
        rect = page_parts.frame(
            surface, sight, w["sheet.title"], w["sheet.hint"], False, self.closing
        )
        area = page_parts.inside(sight.layout)
        if contest is None:
            at = (area.x, area.y + 20 * sight.layout.s)
            sight.type.draw(surface, w["sheet.none"], at, 15, theme.TEXT_SOFT)
            return rect
        self._scroll(0, sight)
        half = round(0.5 * area.w)
        left = pygame.Rect(area.x, area.y, half, area.h)
        right = pygame.Rect(area.x + half, area.y, area.w - half, area.h)
        _visits(surface, left, sight, contest, self.top)
        _players(surface, right, sight, contest, self.career)
        return rect


def _room(sight: Sight) -> int:
    """How many visits there is room for."""
    return int(page_parts.inside(sight.layout).h / (ROW * sight.layout.s)) - 1


def _visits(
    surface: pygame.Surface, area: pygame.Rect, sight: Sight, contest: Contest, top: int
) -> None:
    s, t, w, card = sight.layout.s, sight.type, sight.words, contest.card
    columns = [0, 44, 100, 256, 330, 412]
    frames, scores = _frames(contest), contest.terms.discipline.points or rack_words.scores(contest)
    rack = w["score.frame"] if frames else w["sheet.rack"]
    points = w["sheet.points"] if scores else ""
    heads = ["#", rack, w["sheet.player"], w["sheet.made"], points, ""]
    for x, head in zip(columns, heads, strict=True):
        t.draw(surface, head, (area.x + x * s, area.y + 14 * s), 12, theme.TEXT_SOFT)
    sums = [list(accumulate(v.points * (v.player == p) for v in card)) for p in (0, 1)]
    for place, visit in enumerate(card[top : top + _room(sight)]):
        base, number = area.y + (ROW * (place + 1) + 14) * s, top + place
        name = t.fitted(player_name(contest.terms, visit.player, w), SIZE, 150 * s)
        counted = f"{visit.points} · {sums[visit.player][number]}" if scores else ""
        words = [str(number + 1), str(visit.rack), name, f"{visit.made}/{visit.strokes}", counted]
        words.append(t.fitted(_end(visit, contest, w), SIZE, area.w - (columns[-1] + 8) * s))
        for x, word in zip(columns, words, strict=True):
            last = theme.GOOD if visit.won else theme.ERROR
            ink = last if x == columns[-1] else theme.TEXT
            t.draw(surface, word, (area.x + x * s, base), SIZE, ink)


def _frames(contest: Contest) -> bool:
    return contest.match.rules.key == rack_words.FRAMES


def _end(visit: scorecard.Visit, contest: Contest, w: dict[str, str]) -> str:
    """What a visit ended with, if that is to be said: the rack or frame, or a foul."""
    frame = "frame" if _frames(contest) else "rack"
    if (visit.won or visit.lost) and not contest.terms.discipline.points:
        return w[f"score.{frame}.won" if visit.won else f"sheet.{frame}.lost"]
    return w["sheet.foul"] if visit.foul else ""


def _players(
    surface: pygame.Surface,
    area: pygame.Rect,
    sight: Sight,
    contest: Contest,
    career: Callable[[str, str], Figures],
) -> None:
    s, t, w = sight.layout.s, sight.type, sight.words
    step = area.w / 3
    for index in range(len(contest.terms.seats)):
        x, base = area.x + (index + 1) * step, area.y + 14 * s
        name = t.fitted(player_name(contest.terms, index, w), 15, step - 10 * s)
        t.draw(surface, name, (x, base), 15, theme.ACCENT)
        own = scorecard.totals(contest.card, index)
        ever = _ever(contest, index, career)
        for place, line in enumerate(_figures(own)):
            t.draw(surface, line, (x, base + ROW * (place + 1) * s), SIZE, theme.TEXT)
        below = base + ROW * (len(LINES) + 2) * s
        for place, line in enumerate(_career(ever) if ever.matches else ()):
            t.draw(surface, line, (x, below + ROW * place * s), SIZE, theme.TEXT)
    for place, line in enumerate(LINES):
        at = (area.x, area.y + (14 + ROW * (place + 1)) * s)
        label = "break" if line == "best" and _frames(contest) else line
        t.draw(surface, w[f"sheet.{label}"], at, SIZE, theme.TEXT_SOFT)
    if not any(_ever(contest, k, career).matches for k in range(len(contest.terms.seats))):
        return
    for place, line in enumerate(("career", "won", "average", "best", "share")):
        at = (area.x, area.y + (14 + ROW * (len(LINES) + 2 + place)) * s)
        t.draw(surface, w[f"sheet.{line}"], at, SIZE, theme.TEXT_SOFT)
    top = area.y + (14 + ROW * (len(LINES) + 1)) * s
    shapes.bar(surface, pygame.Rect(area.x, round(top), area.w, max(1, round(s))), theme.LINE)


def _ever(contest: Contest, index: int, career: Callable[[str, str], Figures]) -> Figures:
    """What a person has done in the game so far; nothing for the computer."""
    seat = contest.terms.seats[index]
    if seat.level != HUMAN:
        return Figures()
    return career(kept_name(seat.name, index), contest.terms.game)


def _figures(own: scorecard.Totals) -> list[str]:
    """The figures of a match, in the order of LINES."""
    share = f"{round(100 * own.share)} %"
    counts = str(own.strokes), str(own.made)
    return [str(own.visits), f"{own.average:.2f}", str(own.best), *counts, share, str(own.fouls)]


def _career(ever: Figures) -> list[str]:
    share = f"{round(100 * ever.share)} %"
    return [str(ever.matches), str(ever.won), f"{ever.average:.2f}", str(ever.best), share]
