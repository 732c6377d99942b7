"""What lies under the balls: the aim and its preview, or the traces of the last shot."""

from __future__ import annotations

from cmath import rect
from collections.abc import Sequence
from functools import lru_cache
from math import atan2, copysign, hypot, radians

import pygame

from game.play import Game
from game.playhead import events, known, passed, runs
from game.preview import Contact, Place, Preview, path
from game.render import cards, lines
from game.render.layout import Layout
from game.render.text import Type
from game.render.theme import ACCENT, LILAC, WHITE, BallLook, Colour

FADE = 0.75
"""Metres over which the object ball's path fades away."""
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
        if aids == "short" and preview is not None and preview.contact is not None:
            return _first(surface, layout, game, preview, preview.contact, looks)
        if preview is None or aids == "short":
            return _direction(surface, layout, game)
        return _preview(surface, layout, game, preview, looks)
    return _traces(surface, layout, game, looks) if game.shown_shot else []


def _taken(surface: pygame.Surface, layout: Layout, game: Game) -> pygame.Rect:
    """Draw a ring around the ball in hand."""
    ball = game.world.ball(game.held_ball)
    centre, radius = layout.to_screen(*ball.position), 1.45 * ball.radius * layout.scale
    return lines.ring(surface, centre, radius, ACCENT, 2.0 * layout.s, 0.95)


def _screen(layout: Layout, points: Sequence[Place]) -> list[tuple[float, float]]:
    return lines.decimated([layout.to_screen(*p) for p in points]) if len(points) > 1 else []


def _first(
    surface: pygame.Surface,
    layout: Layout,
    game: Game,
    seen: Preview,
    contact: Contact,
    looks: Sequence[BallLook],
) -> Rects:
    """Draw the way to the first ball, and where both leave to."""
    radius = game.world.ball(game.cue).radius * layout.scale
    way = _clear(_screen(layout, seen.way), radius)
    line = lines.polyline(surface, way, WHITE, 1.6 * layout.s, 0.95)
    return [line, *_meeting(surface, layout, game, contact, looks)]


def _preview(
    surface: pygame.Surface, layout: Layout, game: Game, seen: Preview, looks: Sequence[BallLook]
) -> Rects:
    s, contact, ink = layout.s, seen.contact, _ink(game)
    radius = game.world.ball(game.cue).radius * layout.scale
    rects = []
    way = _screen(layout, seen.way)
    if contact is None:
        rects.append(lines.polyline(surface, way, ink, 1.7 * s, 0.92, fade=(1.0, 0.33)))
    else:
        rects.append(lines.polyline(surface, _clear(way, radius), ink, 1.6 * s, 0.95))
        beyond = _screen(layout, seen.beyond)
        rects.append(lines.polyline(surface, beyond, ink, 1.7 * s, 0.85, fade=(1.0, 0.35)))
        rects += _object(surface, layout, game, seen, looks)
    for at, out in seen.bounces:
        centre = layout.to_screen(*at)
        rects.append(lines.bounce(surface, centre, (out[0], -out[1]), radius, ink, s, 0.75))
    last = (seen.beyond or seen.way)[-1:]
    if last:
        end = layout.to_screen(*last[0])
        rects.append(lines.ring(surface, end, radius, ink, 1.4 * s, 0.55))
    if contact is not None:
        rects += _meeting(surface, layout, game, contact, looks)
    return rects


def _ink(game: Game) -> Colour:
    """White for what a person aims at, lilac for what the computer intends."""
    return LILAC if computer(game) else WHITE


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


def _clear(points: list[tuple[float, float]], gap: float) -> list[tuple[float, float]]:
    """A path without its last `gap` px, so that the ghost stays empty."""
    kept = points[:]
    while len(kept) > 1:
        (x0, y0), (x1, y1) = kept[-2:]
        size = hypot(x1 - x0, y1 - y0)
        if size > gap:
            share = 1 - gap / size
            kept[-1] = (x0 + share * (x1 - x0), y0 + share * (y1 - y0))
            break
        gap -= size
        kept.pop()
    return kept


def _object(
    surface: pygame.Surface, layout: Layout, game: Game, seen: Preview, looks: Sequence[BallLook]
) -> Rects:
    """Draw the beginning of the object ball's path, dashed and fading."""
    assert seen.contact is not None
    points = _begin(seen.path, FADE)
    colour = looks[_index(game, seen.contact.ball)].ui
    s = layout.s
    shown = _screen(layout, points)
    return [lines.polyline(surface, shown, colour, 1.5 * s, 0.8, (1.0, 0.0), (9 * s, 6 * s))]


def _begin(points: Sequence[Place], reach: float) -> list[Place]:
    """The first `reach` metres of a path."""
    kept = list(points[:1])
    for p in points[1:]:
        step = hypot(p[0] - kept[-1][0], p[1] - kept[-1][1])
        if step > reach:
            share = reach / step
            kept.append(tuple(a + share * (b - a) for a, b in zip(kept[-1], p, strict=True)))  # type: ignore[arg-type]
            break
        reach -= step
        kept.append(p)
    return kept


def _meeting(
    surface: pygame.Surface, layout: Layout, game: Game, contact: Contact, looks: Sequence[BallLook]
) -> Rects:
    """Draw the ghost and where both balls leave to."""
    s = layout.s
    radius = game.world.ball(game.cue).radius * layout.scale
    ghost = layout.to_screen(*contact.ghost)
    rects = [lines.ghost(surface, ghost, radius, s)]
    places = (contact.ghost, contact.other)
    colours = (_ink(game), looks[_index(game, contact.ball)].ui)
    for at, velocity, colour in zip(places, contact.leaves, colours, strict=True):
        if hypot(*velocity) > 1e-3:
            angle = atan2(-velocity[1], velocity[0])
            centre = layout.to_screen(*at)
            rects.append(lines.departure(surface, centre, angle, radius, colour, s))
    return rects


def _traces(
    surface: pygame.Surface, layout: Layout, game: Game, looks: Sequence[BallLook]
) -> Rects:
    """Draw where the balls have run up to the last event, or to the moment on show."""
    log, s = game.world.log, layout.s
    now = known(game)
    rects: Rects = []
    lettered = any(look.dashes for look in looks)
    for name in game.traced:
        look = looks[_index(game, name)]
        points = path(log, name, game.began, now)
        shown = _screen(layout, points)
        if shown:
            rects.append(lines.trace(surface, shown, look.ui, s, dashes=look.dashes))
            radius = game.world.ball(name).radius * layout.scale
            rects.append(lines.ring(surface, shown[0], radius, look.ui, 1.3 * s, 0.8))
            if lettered:
                at = shown[0][0] - TAG * s, shown[0][1] - TAG * s
                rects.append(cards.tag(surface, at, _type(s), look.ui, look.letter))
        if game.head.at is not None:
            ahead = _screen(layout, path(log, name, now, game.world.time))
            rects.append(lines.polyline(surface, ahead, look.ui, 1.3 * s, 0.26))
    return rects + _hits(surface, layout, game, looks, now)


@lru_cache(maxsize=4)
def _type(s: float) -> Type:
    return Type(s)


def _hits(
    surface: pygame.Surface, layout: Layout, game: Game, looks: Sequence[BallLook], now: float
) -> Rects:
    normals = {wall.name: wall.normal for wall in game.world.walls}
    s, rects = layout.s, []
    for event in events(game):
        if event.time > now:
            break
        if event.balls[0] not in game.traced:
            continue
        if event.kind == "cushion":
            look, out = looks[_index(game, event.balls[0])], -normals[event.wall]
            centre = layout.to_screen(*event.after[0].position)
            radius = game.world.ball(event.balls[0]).radius * layout.scale
            aside = (out.real, -out.imag)
            rects.append(lines.bounce(surface, centre, aside, radius, look.ui, s, 0.9))
        elif event.kind == "ball":
            rects.append(lines.collision(surface, layout.to_screen(*event.point), s))
    return rects


def _index(game: Game, name: str) -> int:
    return [ball.name for ball in game.world.balls].index(name)
