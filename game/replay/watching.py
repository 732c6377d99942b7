"""Watching a record in the window: it goes on by itself, and can be held, left and be silent."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pygame

from game.session.action import Action
from game.session.session import Notice

if TYPE_CHECKING:
    from game.app import App

    from .replay import Replay

HOLDS = (Action("pause"), Action("stop"))


def take(app: App, replay: Replay, event: pygame.event.Event) -> None:
    """Take an event of a person while a record is played."""
    action = _meant(app, event)
    if action in HOLDS and not replay.done:
        replay.paused = not replay.paused
        _tell(app, replay)
    elif action in (Action("quit"), Action("mute")):
        app.perform(action)


def _meant(app: App, event: pygame.event.Event) -> Action | None:
    if event.type == pygame.MOUSEMOTION:
        app.redraw(app.view.hover(event.pos))
    elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
        return app.view.press(event.pos)
    elif event.type == pygame.KEYDOWN and event.key == pygame.K_ESCAPE:
        return Action("quit")
    elif event.type == pygame.KEYDOWN:
        return app.preferences.keys.play.get(event.key)
    return None


def advance(app: App, replay: Replay, end: int) -> int:
    """Play the record on to a tick, or to its end; returns the tick reached."""
    if replay.paused or replay.done:
        return app.game.tick
    end = min(end, replay.end)
    for tick, action in replay.due(end):
        app.update(tick - app.game.tick)
        app.perform(action, human=False)
    app.update(end - app.game.tick)
    _tell(app, replay)
    app.game.over = app.game.over or (replay.done and app.options.virtual)
    return end


def _tell(app: App, replay: Replay) -> None:
    """Say in the window how the replay stands."""
    notice = Notice(f"replay.{replay.state}", error=replay.differs is not None)
    if notice != app.game.notice:
        app.game.notice = notice
        app.game.news += 1
        app.game.version += 1
