"""Drawing the path of the cue ball with the mouse, and looking for the shot that takes it."""

from __future__ import annotations

from math import dist

import pygame

from game.aim import drawn_path
from game.computer.worker import News, Worker
from game.render.layout import Layout
from game.render.table import lines
from game.render.theme import ACCENT
from game.session.action import Action
from game.session.session import Session
from game.table.presets import size
from game.ui.sight import Sight

WIDTH = 3.0
"""Of the drawn line, px at s = 1: the path that is found lies beside it, thinner."""


class Sketch:
    """The path that has been drawn, m, and the search for its shot."""

    def __init__(self) -> None:
        self.points: list[drawn_path.Place] = []
        self.drawing = False
        """Is the button held?"""
        self._worker: Worker | None = None
        self._about: tuple[object, ...] = ()

    @property
    def searching(self) -> bool:
        """Is the search going on?"""
        return self._worker is not None

    def key(self, session: Session) -> object:
        """What its picture depends on."""
        return (len(self.points), self.points[-1:]) if session.sketching else None

    def mouse(self, event: pygame.event.Event, sight: Sight) -> bool:
        """Draw with the left button; returns whether the event was for this."""
        session, at = sight.session, sight.layout.to_table(*event.pos)
        if event.type == pygame.MOUSEBUTTONDOWN:
            if event.button != 1 or sight.pointer.over != "table":
                return False
            self._begin(at, session)
            return True
        if not self.drawing:
            return False
        if event.type == pygame.MOUSEMOTION and event.buttons[0]:
            self._on(at, session)
        elif event.type == pygame.MOUSEMOTION or event.button == 1:
            self._end(session)  # the button may have been let go where nobody saw it
        return True

    def _begin(self, at: drawn_path.Place, session: Session) -> None:
        self.clear()
        if not drawn_path.nearby(session.world, session.cue, at):
            session.say("sketch.start", error=True)
            return
        self.drawing, self._about = True, _about(session)
        self.points = [session.world.ball(session.cue).position]

    def _on(self, at: drawn_path.Place, session: Session) -> None:
        at = drawn_path.on_cloth(session.world, session.cue, at, size(session.world))
        if dist(at, self.points[-1]) >= drawn_path.APART:
            self.points.append(at)

    def _end(self, session: Session) -> None:
        self.drawing = False
        if drawn_path.length(self.points) < drawn_path.SHORTEST:
            self.clear()
            session.say("sketch.short", error=True)
            return
        world = session.world.copy()
        self._worker = Worker(drawn_path.recovered, world, session.cue, self.points)
        session.say("sketch.searching")

    def look(self, session: Session) -> Action | None:
        """What has been found since the last frame, as an action; says what has not.

        Balls that have been put elsewhere, another table and another cue ball end it all.
        """
        if (self.points or self.drawing) and self._about != _about(session):
            self.clear()
        news = self._worker.look() if self._worker is not None else None
        if news is None or news.kind == "told":
            return None
        self._worker = None
        return self._told(news, session)

    def _told(self, news: News, session: Session) -> Action | None:
        if news.kind == "done" and news.value.value:
            return Action("recover", news.value.value)
        failed = news.kind == "failed"
        session.say("sketch.failed" if failed else "sketch.none", error=True,
                    about="" if failed else news.value.off)  # fmt: skip
        return None

    def cancel(self, session: Session) -> bool:
        """Break off drawing or the search; returns whether there was anything to break off."""
        if not (self.drawing or self.searching):
            return False
        self.clear()
        session.say("sketch.cancelled")
        return True

    def clear(self) -> None:
        """Forget the path, and end the search."""
        if self._worker is not None:
            self._worker.cancel()
        self._worker, self.drawing, self.points = None, False, []

    def draw(self, surface: pygame.Surface, layout: Layout, session: Session) -> list[pygame.Rect]:
        """Draw the path; returns the rectangle around it."""
        if not session.sketching or len(self.points) < 2:
            return []
        shown = lines.decimated([layout.to_screen(*at) for at in self.points])
        return [lines.polyline(surface, shown, ACCENT, WIDTH * layout.s, 0.75)]


def _about(session: Session) -> tuple[object, ...]:
    """What a path is drawn for: others end it."""
    lies = tuple(session.world.layout())
    return id(session.world), session.cue, lies, session.sketching
