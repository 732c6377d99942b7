"""The pages of rules, one for each game."""

from __future__ import annotations

from collections.abc import Hashable
from itertools import pairwise

import pygame

from game.render import theme
from game.render.parts import shapes
from game.session.action import Action
from game.session.session import Session
from game.session.terms import GAMES
from game.text import LANGUAGES
from game.ui.sight import Sight

from . import page_parts

RULES = {game: sum(key.startswith(f"rule.{game}.") for key in LANGUAGES["en"]) for game in GAMES}
"""How many rules each game has: "rule.free.1" and so on in the texts."""
LINE, SPACE = 25, 9
LIST = 190
"""Width of the list of games, px at s = 1."""
STEPS = {
    pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_TAB: 1, pygame.K_UP: -1, pygame.K_DOWN: 1,
}  # fmt: skip


class RulesPage:
    """Which game's page is open."""

    typing = False

    def __init__(self) -> None:
        self.place = 0
        self.over = ""

    def open(self, session: Session) -> None:
        """Begin with the game that is played."""
        self.place = GAMES.index(session.contest.terms.game) if session.contest else 0

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        return self.place, self.over, sight.session.language

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._key(event.key, sight)
        if event.type == pygame.MOUSEMOTION:
            self.over = self._spot(event.pos, sight)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            spot = self._spot(event.pos, sight)
            if spot in ("close", "outside"):
                return Action("sheet", "")
            if spot in GAMES:
                self.place = GAMES.index(spot)
        return None

    def _key(self, key: int, sight: Sight) -> Action | None:
        always = sight.preferences.keys.always.get(key)
        if always is not None:
            return always
        if key in (pygame.K_ESCAPE, pygame.K_RETURN, pygame.K_KP_ENTER):
            return Action("sheet", "")
        step = STEPS.get(key, 0)
        self.place = (self.place + step) % len(GAMES)
        return None

    def _tabs(self, sight: Sight) -> list[pygame.Rect]:
        area, layout = page_parts.inside(sight.layout), sight.layout
        wide, step = layout.px(LIST), area.h / len(GAMES)
        tops = [area.y + round(k * step) for k in range(len(GAMES) + 1)]
        return [
            pygame.Rect(area.x, top, wide, end - top - layout.px(2)) for top, end in pairwise(tops)
        ]

    def _spot(self, at: tuple[int, int], sight: Sight) -> str:
        if not page_parts.panel(sight.layout).collidepoint(at):
            return "outside"
        if page_parts.close_rect(sight.layout).collidepoint(at):
            return "close"
        tabs = zip(GAMES, self._tabs(sight), strict=True)
        return next((name for name, rect in tabs if rect.collidepoint(at)), "")

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the page; returns its rectangle."""
        w, s, type_ = sight.words, sight.layout.s, sight.type
        closing = self.over == "close"
        rect = page_parts.frame(surface, sight, w["rules.title"], w["rules.hint"], False, closing)
        game = GAMES[self.place]
        for name, tab in zip(GAMES, self._tabs(sight), strict=True):
            page_parts.button(
                surface, tab, type_, w[f"game.{name}"], name == game, name == self.over
            )
        area = page_parts.inside(sight.layout)
        aside = sight.layout.px(LIST + 24)
        area.x, area.w = area.x + aside, area.w - aside
        base = area.y + 16 * s
        for n in range(1, RULES[game] + 1):
            shapes.disc(surface, (area.x + 5 * s, base - type_.cap(15) / 2), 3 * s, theme.ACCENT)
            for line in page_parts.wrapped(w[f"rule.{game}.{n}"], type_, 15, area.w - 24 * s):
                type_.draw(surface, line, (area.x + 22 * s, base), 15, theme.TEXT)
                base += LINE * s
            base += SPACE * s
        return rect
