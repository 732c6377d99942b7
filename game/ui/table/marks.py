"""What lies under the balls: the aim and its preview, or the traces of the last shot."""

from __future__ import annotations

from cmath import rect
from collections.abc import Sequence
from functools import lru_cache
from math import copysign, radians

import pygame

from game.aim.preview import path
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts import cards
from game.render.table import lines
from game.render.theme import ACCENT, LILAC, WHITE, BallLook
from game.session.session import Game
from game.session.timeline import events, known, passed, runs

from . import preview_lines

TAG = 16
"""How far left of and above a trace's beginning its letter stands, px at s = 1."""
Rects = list[pygame.Rect]


def aiming(game: Game) -> bool:
    """Is the next shot on show?"""
    return not game.shown_shot and not game.moving


def key(game: Game, aids: str) -> object:
    """What decides how the marks look: equal keys, equal marks."""
    if aiming(game):
        if game.arranging:
            return "arrange", game.held_ball, game.stamp
        return "aim", game.preview_key, aids, computer(game)
    if game.shown_shot:
        at = None if runs(game) else game.head.at
        return "shot", game.stamp, game.began, passed(game), game.moving, at, game.head.playing
    return None


def draw(
    surface: pygame.Surface, layout: Layout, game: Game, looks: Sequence[BallLook], aids: str
) -> list[pygame.Rect]:
    """Draw the marks, with `aids` "off" "short" or "full"; returns the rectangles around them."""
    if aiming(game):
        if game.arranging:
            return [_taken(surface, layout, game)]
        aids = "full" if computer(game) else aids
        if aids == "off":
            return []
        preview = game.preview
        if preview is None or (aids == "short" and preview.contact is None):
            return _direction(surface, layout, game)
        seen = preview_lines.Seen(surface, layout, game, looks, LILAC if computer(game) else WHITE)
        return seen.first(preview) if aids == "short" else seen.whole(preview)
    return _traces(surface, layout, game, looks) if game.shown_shot else []


def _taken(surface: pygame.Surface, layout: Layout, game: Game) -> pygame.Rect:
    """Draw a ring around the ball in hand."""
    ball = game.world.ball(game.held_ball)
    centre, radius = layout.to_screen(*ball.position), 1.45 * ball.radius * layout.scale
    return lines.ring(surface, centre, radius, ACCENT, 2.0 * layout.s, 0.95)


def computer(game: Game) -> bool:
    """Does the computer show what it intends?"""
    return game.contest is not None and game.contest.level is not None


def _direction(surface: pygame.Surface, layout: Layout, game: Game) -> Rects:
    """Draw where the cue ball would leave to, as far as the cushion, while the rest is unknown."""
    if game.aim.angle is None:
        return []
    ball = game.world.ball(game.cue)
    x, y = ball.position
    ahead = rect(1.0, radians(game.aim.angle))
    half = (layout.length / 2 - ball.radius, layout.width / 2 - ball.radius)
    steps = zip((x, y), (ahead.real, ahead.imag), half, strict=True)
    reach = min((side - at * copysign(1, step)) / abs(step) for at, step, side in steps if step)
    ends = [(x, y), (x + reach * ahead.real, y + reach * ahead.imag)]
    s = layout.s
    shown = [layout.to_screen(*p) for p in ends]
    return [lines.polyline(surface, shown, WHITE, 1.4 * s, 0.6, dashes=(6 * s, 6 * s))]


def _traces(
    surface: pygame.Surface, layout: Layout, game: Game, looks: Sequence[BallLook]
) -> Rects:
    """Draw where the balls have run up to the last event, or to the moment on show."""
    log, s = game.world.log, layout.s
    now = known(game)
    rects: Rects = []
    lettered = any(look.dashes for look in looks)
    for name in game.traced:
        look = looks[preview_lines.index(game, name)]
        points = path(log, name, game.began, now)
        shown = preview_lines.on_screen(layout, points)
        if shown:
            rects.append(lines.trace(surface, shown, look.ui, s, dashes=look.dashes))
            radius = game.world.ball(name).radius * layout.scale
            rects.append(lines.ring(surface, shown[0], radius, look.ui, 1.3 * s, 0.8))
            if lettered:
                at = shown[0][0] - TAG * s, shown[0][1] - TAG * s
                rects.append(cards.tag(surface, at, _type(s), look.ui, look.letter))
        if game.head.at is not None:
            ahead = preview_lines.on_screen(layout, path(log, name, now, game.world.time))
            rects.append(lines.polyline(surface, ahead, look.ui, 1.3 * s, 0.26))
    return rects + _hits(surface, layout, game, looks, now)


@lru_cache(maxsize=4)
def _type(s: float) -> Type:
    return Type(s)


def _hits(
    surface: pygame.Surface, layout: Layout, game: Game, looks: Sequence[BallLook], now: float
) -> Rects:
    walls = {wall.name: wall for wall in game.world.walls}
    s, rects = layout.s, []
    for event in events(game):
        if event.time > now:
            break
        if event.balls[0] not in game.traced:
            continue
        if event.kind == "cushion":
            look = looks[preview_lines.index(game, event.balls[0])]
            out = -walls[event.wall].facing(event.after[0].position)
            centre = layout.to_screen(*event.after[0].position)
            radius = game.world.ball(event.balls[0]).radius * layout.scale
            aside = (out.real, -out.imag)
            rects.append(lines.bounce(surface, centre, aside, radius, look.ui, s, 0.9))
        elif event.kind == "ball":
            rects.append(lines.collision(surface, layout.to_screen(*event.point), s))
    return rects
