"""The newest part of a trace: it grows behind each ball until the next event draws it properly."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot

import pygame

from game.play import Game
from game.render import lines
from game.render.layout import Layout
from game.render.theme import BallLook

STEP = 0.015
"""Metres between two points: about half a ball, so that a fast frame draws one piece."""
Place = tuple[float, float]


class Trail:
    """Points behind each ball since the last event of the shot, metres."""

    def __init__(self) -> None:
        self._since: object = None
        self._points: dict[int, list[Place]] = {}
        self._drawn: dict[int, int] = {}

    def grow(self, game: Game) -> None:
        """Take in where the balls are now."""
        since = (game.shots, game.began, len(game.world.log))
        if since != self._since:
            self._since, self._drawn = since, {}
            self._points = {i: [at] for i, at in _last_places(game).items()}
        for i, points in self._points.items():
            ball = game.world.balls[i]
            at = ball.position
            if hypot(at[0] - points[-1][0], at[1] - points[-1][1]) >= STEP:
                points.append(at)

    def undrawn(self) -> None:
        """Forget what has been drawn: the surface is new."""
        self._drawn = {}

    def draw(
        self, surface: pygame.Surface, layout: Layout, looks: Sequence[BallLook]
    ) -> list[pygame.Rect]:
        """Draw what has grown since the last time; returns the rectangles that changed."""
        dirty = []
        for i, points in self._points.items():
            for k in range(self._drawn.get(i, 1), len(points)):
                ends = [layout.to_screen(*p) for p in points[k - 1 : k + 1]]
                dirty.append(lines.polyline(surface, ends, looks[i].ui, 1.6 * layout.s))
            self._drawn[i] = len(points)
        return dirty


def _last_places(game: Game) -> dict[int, Place]:
    """Where the balls that leave a trace were at the last event, or when the shot began."""
    if not (game.shown_shot and game.moving):
        return {}
    log = game.world.log
    states = log.at(log[-1].time if len(log) else game.began)
    names = enumerate(ball.name for ball in game.world.balls)
    return {i: states[name].position for i, name in names if name in game.traced}
