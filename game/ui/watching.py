"""Watching a record in the window: it goes on by itself, and can be held, left and be silent."""

from __future__ import annotations

import pygame

from game.replay.replay import Replay
from game.session.action import Action

from .layers import Answer, answer
from .view import View

HOLDS = (Action("pause"), Action("stop"))
LEFT = (Action("quit"), Action("mute"))
"""What a viewer can do to the game itself."""


class WatchingLayer:
    """The topmost layer while a record is played: nothing that is typed or clicked plays it."""

    def __init__(self, view: View, replay: Replay) -> None:
        self.view, self.replay = view, replay

    def answer(self, event: pygame.event.Event, texts: bool) -> Answer | None:
        """Hold the record or go on, leave, or be silent."""
        action = self._meant(event)
        if action in HOLDS and not self.replay.done:
            self.replay.paused = not self.replay.paused
            self.tell()
        moved = event.type == pygame.MOUSEMOTION and self.view.hover(event.pos)
        return answer(action if action in LEFT else None, redraw=moved)

    def _meant(self, event: pygame.event.Event) -> Action | None:
        if event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self.view.press(event.pos)
        if event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE:
            return Action("quit")
        if event.type == pygame.KEYDOWN:
            return self.view.preferences.keys.play.get(event.key)
        return None

    def tell(self) -> None:
        """Say in the window how the record stands, if that has changed."""
        session, state = self.view.session, f"replay.{self.replay.state}"
        if session.notice is None or session.notice.key != state:
            session.say(state, error=self.replay.differs is not None)
