"""What lies under the balls: the aim and its preview, or the traces of the last shot."""

from __future__ import annotations

from cmath import rect
from collections.abc import Mapping, Sequence
from math import copysign, radians

import pygame

from game.aim.preview import path
from game.render.font import type_at
from game.render.layout import Layout
from game.render.parts import cards
from game.render.table import hand, lines, pocket_marks
from game.render.table.plan import Hole
from game.render.theme import ACCENT, LILAC, WHITE, BallLook
from game.session.notice import Notice
from game.session.session import Session

from . import furniture, preview_lines
from .racked import racked
from .trail import drawn_until

TAG = 16
"""How far left of and above a trace's beginning its letter stands, px at s = 1."""
Rects = list[pygame.Rect]


def aiming(session: Session) -> bool:
    """Is the next shot on show?"""
    return not session.shown_shot and not session.moving


def key(session: Session, aids: str) -> object:
    """What decides how the marks look: equal keys, equal marks."""
    if aiming(session):
        if session.arranging:
            return "arrange", session.held_ball, session.stamp, in_hand(session), _refused(session)
        theirs = computer(session), coached(session)
        return "aim", session.preview_key, aids, theirs, call_of(session), _refused(session)
    if session.shown_shot:
        at = None if session.timeline.runs else session.timeline.at
        return (
            "shot",
            session.stamp,
            session.began,
            drawn_until(session),
            session.moving,
            at,
            session.timeline.playing,
        )
    return None


def draw(
    surface: pygame.Surface,
    layout: Layout,
    session: Session,
    looks: Sequence[BallLook],
    aids: str,
    holes: Mapping[str, Hole] | None = None,
) -> list[pygame.Rect]:
    """Draw the marks, with `aids` "off" "short" or "full"; returns the rectangles around them.

    `holes` are the table's pockets by name.
    """
    if aiming(session):
        if session.arranging:
            return _taken(surface, layout, session)
        rects = _taken(surface, layout, session) if _refused(session) else []
        rects += _called(surface, layout, session, looks, holes or {})
        return rects + _aim(surface, layout, session, looks, aids, holes or {})
    return _traces(surface, layout, session, looks) if session.shown_shot else []


def _aim(
    surface: pygame.Surface,
    layout: Layout,
    session: Session,
    looks: Sequence[BallLook],
    aids: str,
    holes: Mapping[str, Hole],
) -> Rects:
    """Draw what the next shot will do, as far as `aids` show it."""
    aids = "full" if computer(session) or coached(session) else aids
    if aids == "off":
        return []
    preview = session.preview
    if preview is None or (aids == "short" and preview.contact is None):
        return _direction(surface, layout, session)
    ink = LILAC if computer(session) else WHITE
    seen = preview_lines.Seen(surface, layout, session, looks, ink, holes)
    return seen.first(preview) if aids == "short" else seen.whole(preview)


def call_of(session: Session) -> tuple[str, str]:
    """The ball and the pocket that are called for the next stroke, or ""."""
    if session.contest is None:
        return "", ""
    call = session.contest.match.call
    return call.ball, call.pocket


def _called(
    surface: pygame.Surface,
    layout: Layout,
    session: Session,
    looks: Sequence[BallLook],
    holes: Mapping[str, Hole],
) -> Rects:
    """Ring the ball and the pocket that are called."""
    name, pocket = call_of(session)
    rects, s = [], layout.s
    found = {ball.name: (ball, look) for ball, look in zip(session.world.balls, looks, strict=True)}
    if name in found and not found[name][0].gone:
        ball = found[name][0]
        radius = ball.radius * layout.scale + 2.6 * s
        at = layout.to_screen(*ball.position)
        rects.append(lines.ring(surface, at, radius, WHITE, 1.3 * s, 0.85))
    if pocket in holes:
        ink = found[name][1].ui if name in found else ACCENT
        rects.append(pocket_marks.called(surface, layout, holes[pocket], ink))
    return rects


def _taken(surface: pygame.Surface, layout: Layout, session: Session) -> Rects:
    """Draw the ball in hand, and the region that it may be put into."""
    ball, table = session.world.ball(session.held_ball), session.world.table
    centre, radius = layout.to_screen(*ball.position), ball.radius * layout.scale
    region = in_hand(session)
    if not region:
        return [lines.ring(surface, centre, 1.45 * radius, ACCENT, 2.0 * layout.s, 0.95)]
    rects = [hand.region(surface, layout, table, region)]
    rects.append(hand.held(surface, centre, radius, layout.s))
    return rects + _forbidden(surface, layout, session)


def _refused(session: Session) -> Notice | None:
    """What is said of a place that the ball in hand may not be put to."""
    notice = session.notice
    return notice if notice is not None and notice.at is not None else None


def _forbidden(surface: pygame.Surface, layout: Layout, session: Session) -> Rects:
    """Show that place, and the ball that is in the way there."""
    notice, world, rects = _refused(session), session.world, []
    if notice is None or notice.at is None:
        return []
    for ball in world.balls:
        radius = ball.radius * layout.scale
        if ball.name == notice.about:
            rects.append(hand.blocking(surface, layout.to_screen(*ball.position), radius, layout.s))
    radius = world.ball(session.held_ball).radius * layout.scale
    return [*rects, hand.forbidden(surface, layout.to_screen(*notice.at), radius, layout.s)]


def in_hand(session: Session) -> str:
    """The region of the table that the cue ball of a match may be put into, or ""."""
    region: str = getattr(session.contest, "in_hand", "")
    table = furniture.table_of(session.world)
    return region if table is not None and region in table.regions else ""


def computer(session: Session) -> bool:
    """Does the computer show what it intends?"""
    return session.contest is not None and session.contest.level is not None


def coached(session: Session) -> bool:
    """Is it the coach's stroke that is on show?  It is shown whole, whatever the aids."""
    return session.notice is not None and session.notice.key == "coach.found"


def _direction(surface: pygame.Surface, layout: Layout, session: Session) -> Rects:
    """Draw where the cue ball would leave to, as far as the cushion, while the rest is unknown."""
    if session.aim.angle is None:
        return []
    ball = session.world.ball(session.cue)
    x, y = ball.position
    ahead = rect(1.0, radians(session.aim.angle))
    half = (layout.length / 2 - ball.radius, layout.width / 2 - ball.radius)
    steps = zip((x, y), (ahead.real, ahead.imag), half, strict=True)
    reach = min((side - at * copysign(1, step)) / abs(step) for at, step, side in steps if step)
    ends = [(x, y), (x + reach * ahead.real, y + reach * ahead.imag)]
    s = layout.s
    shown = [layout.to_screen(*p) for p in ends]
    return [lines.polyline(surface, shown, WHITE, 1.4 * s, 0.6, dashes=(6 * s, 6 * s))]


def _traces(
    surface: pygame.Surface, layout: Layout, session: Session, looks: Sequence[BallLook]
) -> Rects:
    """Draw where the balls have run up to the last event, or to the moment on show."""
    log, s = session.world.log, layout.s
    now = drawn_until(session)
    rects: Rects = []
    lettered, heap = any(look.dashes for look in looks), racked(session)
    for name in session.traced:
        look = looks[preview_lines.index(session, name)]
        points = path(log, name, session.began, now)
        shown = preview_lines.on_screen(layout, points)
        if shown:
            rects.append(lines.trace(surface, shown, look.ui, s, dashes=look.dashes))
            radius = session.world.ball(name).radius * layout.scale
            if name not in heap:
                rects.append(lines.ring(surface, shown[0], radius, look.ui, 1.3 * s, 0.8))
            if lettered and look.letter and name not in heap:
                at = shown[0][0] - TAG * s, shown[0][1] - TAG * s
                rects.append(cards.tag(surface, at, type_at(s), look.ui, look.letter))
        if session.timeline.at is not None:
            ahead = preview_lines.on_screen(layout, path(log, name, now, session.world.time))
            rects.append(lines.polyline(surface, ahead, look.ui, 1.3 * s, 0.26))
    return rects + _hits(surface, layout, session, looks, now)


def _hits(
    surface: pygame.Surface, layout: Layout, session: Session, looks: Sequence[BallLook], now: float
) -> Rects:
    walls = {wall.name: wall for wall in session.world.walls}
    s, rects, traced, heap = layout.s, [], session.traced, racked(session)
    for event in session.timeline.events:
        if event.time > now:
            break
        if event.balls[0] not in traced:
            continue
        if event.kind == "cushion":
            look = looks[preview_lines.index(session, event.balls[0])]
            out = -walls[event.wall].facing(event.after[0].position)
            centre = layout.to_screen(*event.after[0].position)
            radius = session.world.ball(event.balls[0]).radius * layout.scale
            aside = (out.real, -out.imag)
            rects.append(lines.bounce(surface, centre, aside, radius, look.ui, s, 0.9))
        elif event.kind == "ball" and not heap.issuperset(event.balls):
            rects.append(lines.collision(surface, layout.to_screen(*event.point), s))
    return rects
