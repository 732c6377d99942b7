"""The newest part of a trace: it grows behind each ball until the next event draws it properly."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import pygame

from game.render.layout import Layout
from game.render.theme import BallLook, Colour
from game.session.session import Session

STEP = 0.015
"""Metres between two points: about half a ball, so that a fast frame draws one piece."""
Place = tuple[float, float]


class Trail:
    """Points behind each ball since the last event of the shot, metres."""

    def __init__(self) -> None:
        self._since: object = None
        self._points: dict[int, list[Place]] = {}
        self._drawn: dict[int, int] = {}

    def grow(self, session: Session) -> None:
        """Take in where the balls are now."""
        self._follow(session)
        live, balls = session.timeline.at is None, session.world.balls
        for i, points in self._points.items():
            ball = balls[i]
            at = ball.position if live else session.seen[ball.name].position
            if hypot(at[0] - points[-1][0], at[1] - points[-1][1]) >= STEP:
                points.append(at)

    def _follow(self, session: Session) -> None:
        """Begin again after an event, a shot or a stop."""
        since = session.stamp, session.began, drawn_until(session), session.timeline.runs
        if since != self._since:
            self._since, self._drawn = since, {}
            self._points = {i: [at] for i, at in _last_places(session).items()}

    def undrawn(self) -> None:
        """Forget what has been drawn: the surface is new."""
        self._drawn = {}

    def draw(
        self, surface: pygame.Surface, layout: Layout, session: Session, looks: Sequence[BallLook]
    ) -> list[pygame.Rect]:
        """Draw what has grown since the last time; returns the rectangles that changed."""
        self._follow(session)
        dirty = []
        for i, points in self._points.items():
            for k in range(self._drawn.get(i, 1), len(points)):
                ends = [layout.to_screen(*p) for p in points[k - 1 : k + 1]]
                dirty.append(_stroke(surface, ends[0], ends[1], looks[i].ui, layout.s))
            self._drawn[i] = len(points)
        return dirty


def drawn_until(session: Session) -> float:
    """World time up to which traces are drawn properly, s: while the balls run, that of the last
    event of a ball that leaves one. In a break the others have fifty for each of these."""
    timeline = session.timeline
    if not timeline.runs:
        return timeline.moment
    events, traced = timeline.events, {*session.traced}
    for k in range(timeline.passed - 1, -1, -1):
        if not traced.isdisjoint(events[k].balls):
            return events[k].time
    return session.began


def _stroke(
    surface: pygame.Surface, start: Place, end: Place, colour: Colour, s: float
) -> pygame.Rect:
    """Draw a line about 1.8 px wide as two thin ones: cheap enough for every frame."""
    x, y = end[0] - start[0], end[1] - start[1]
    off = 0.4 * s / max(hypot(x, y), 1e-9)
    dirty = pygame.Rect(0, 0, 0, 0)
    for k in (off, -off):
        # aaline has pixel centres at whole numbers, our points at halves
        a, b = ((p[0] - 0.5 - k * y, p[1] - 0.5 + k * x) for p in (start, end))
        rect = pygame.draw.aaline(surface, colour, a, b).inflate(2, 2)
        dirty = dirty.union(rect) if dirty.w else rect
    return dirty.clip(surface.get_rect())


def _last_places(session: Session) -> dict[int, Place]:
    """Where the balls that leave a trace were at the last event, or when the shot began."""
    if not session.timeline.runs:
        return {}
    states = session.world.log.at(drawn_until(session))
    names, traced = enumerate(ball.name for ball in session.world.balls), session.traced
    return {i: states[name].position for i, name in names if name in traced}
