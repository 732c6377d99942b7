"""A question over a page or the table: what ends or changes a running match is asked for first."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes
from game.session.action import Action
from game.session.commands import COMMANDS
from game.session.session import Session
from game.ui.sight import Sight

from . import page_parts

WIDTH, HEIGHT = 480, 150
ANSWERS = ("keep", "end")
STEPS = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_UP: -1, pygame.K_DOWN: 1, pygame.K_TAB: 1}
GIVEN = (pygame.K_RETURN, pygame.K_KP_ENTER, pygame.K_SPACE)


def due(action: Action, session: Session) -> bool:
    """Would the action end or change a match that is being played?"""
    if session.contest is None or session.contest.match.finished:
        return False
    match COMMANDS[action.name].ends_match:
        case "begun":  # to leave it is no loss before its first stroke
            return session.moving or not session.contest.match.opening
        case "terms":
            return bool(action.value != getattr(session, action.name))
        case why:
            return bool(why)


class QuestionPage:
    """The page of a question that is asked over the table: nothing but the question is on it."""

    typing = False

    def open(self, session: Session) -> None:
        """There is nothing to begin with."""

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on: nothing."""
        return None

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw nothing; returns where the question will be."""
        return box(sight.layout)

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Without its question, it goes away."""
        return Action("sheet", "") if event.type == pygame.KEYDOWN else None


class Question:
    """Whether an action is to be done though it ends or changes the match; at first it is not."""

    def __init__(self, action: Action) -> None:
        self.action = action
        self.focus, self.over = 0, -1
        self.words = "ask"
        """How the keys of its texts begin."""
        if action.name == "quit" or COMMANDS[action.name].ends_match == "terms":
            self.words = "ask.quit" if action.name == "quit" else "ask.terms"

    def look(self) -> Hashable:
        """Return what its picture depends on."""
        return self.focus, self.over

    def answer(self, event: pygame.event.Event, sight: Sight) -> bool | None:
        """Return what an event answers; None while there is no answer."""
        if event.type == pygame.KEYDOWN:
            if event.key in STEPS:
                self.focus = (self.focus + STEPS[event.key]) % len(ANSWERS)
            elif event.key in GIVEN:
                return self.focus == ANSWERS.index("end")
            return False if event.key == pygame.K_ESCAPE else None
        if event.type == pygame.MOUSEMOTION:
            self.over = _answer_at(event.pos, sight.layout)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            if not box(sight.layout).collidepoint(event.pos):
                return False
            at = _answer_at(event.pos, sight.layout)
            return None if at < 0 else ANSWERS[at] == "end"
        return None

    def draw(self, surface: pygame.Surface, page: pygame.Rect, sight: Sight) -> None:
        """Draw it over the page at `page`, which fades behind it."""
        layout, type_, w, s = sight.layout, sight.type, sight.words, sight.layout.s
        rect = box(layout)
        shade = pygame.Surface(page.size, pygame.SRCALPHA)
        shapes.box(shade, shade.get_rect(), s, theme.BACKGROUND, theme.BACKGROUND)
        shade.set_alpha(150)
        surface.blit(shade, page)
        shapes.box(surface, rect, s, theme.PANEL_RAISED, theme.LINE_INPUT)
        said, hint = (rect.centerx, rect.y + 36 * s), (rect.centerx, rect.y + 62 * s)
        type_.draw(surface, w[f"{self.words}.match"], said, 15, theme.TEXT, "centre")
        type_.draw(surface, w[f"{self.words}.hint"], hint, 13, theme.TEXT_SOFT, "centre")
        for k, (name, spot) in enumerate(zip(ANSWERS, answers(layout), strict=True)):
            hot, label = k == self.over, w[f"{self.words}.{name}"]
            page_parts.button(surface, spot, type_, label, k == self.focus, hot, k == 0)


def box(layout: Layout) -> pygame.Rect:
    """Return where the question is."""
    rect = pygame.Rect(0, 0, layout.px(WIDTH), layout.px(HEIGHT))
    rect.center = page_parts.panel(layout).center
    return rect


def answers(layout: Layout) -> list[pygame.Rect]:
    """Return where the two answers are: to keep the match, and to end it."""
    rect, pad, height = box(layout), layout.px(24), layout.px(page_parts.BUTTON)
    bar = pygame.Rect(rect.x + pad, rect.bottom - pad - height, rect.w - 2 * pad, height)
    return page_parts.row_of(bar, (1, 1), layout.px(10))


def _answer_at(at: tuple[int, int], layout: Layout) -> int:
    return next((k for k, rect in enumerate(answers(layout)) if rect.collidepoint(at)), -1)
