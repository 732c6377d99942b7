"""What the shot in the boxes will do, drawn on the cloth: the engine's own paths and contacts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import atan2, hypot
from typing import NamedTuple

import pygame

from game.aim.preview import FirstContact, Meeting, Place, Preview
from game.render.layout import Layout
from game.render.table import lines, pocket_marks
from game.render.table.plan import Hole
from game.render.theme import ERROR, WHITE, BallLook, Colour
from game.session.session import Session

Rects = list[pygame.Rect]
Points = list[tuple[float, float]]
FADE = 0.75
"""Metres over which the beginning of the first ball's path fades."""
FAINT = 0.4
"""Alpha of the paths of the other balls: less than the least of the cue ball's."""
FEW = 16
"""Points of a path that are drawn sooner than it takes to find out which of them matter."""
POTTED = (9, 6)
"""Dashes of the way into a pocket, px at s = 1."""
ROUNDING = 1e-4
"""Metres by which the end of a path may miss the edge of a hole."""
BOUNCES = 6
"""Cushions whose marks fade one after the other."""


class Seen(NamedTuple):
    """Where and how a preview is drawn.

    ink: the colour of the cue ball's path.
    holes: pockets by name.
    """

    surface: pygame.Surface
    layout: Layout
    session: Session
    looks: Sequence[BallLook]
    ink: Colour
    holes: Mapping[str, Hole]

    @property
    def radius(self) -> float:
        """Of the cue ball, px."""
        return self.session.world.ball(self.session.cue).radius * self.layout.scale

    def first(self, seen: Preview) -> Rects:
        """Draw the way to the first ball, and where both leave to."""
        assert seen.contact is not None
        way = _clear(on_screen(self.layout, seen.way), self.radius)
        line = lines.polyline(self.surface, way, WHITE, 1.6 * self.layout.s, 0.95)
        return [line, *self._contact(seen.contact)]

    def whole(self, seen: Preview) -> Rects:
        """Draw the stroke as far as it counts: every ball's path, and what meets what."""
        s, surface = self.layout.s, self.surface
        drops = dropped(seen, self.session.cue, self.holes)
        rects = [self._lit(name, hole) for name, hole in drops.items()]
        rects += self._others(seen, drops)
        way = on_screen(self.layout, seen.way)
        if seen.contact is None:
            rects.append(lines.polyline(surface, way, self.ink, 1.7 * s, 0.92, fade=(1.0, 0.33)))
        else:
            clear = _clear(way, self.radius)
            rects.append(lines.polyline(surface, clear, self.ink, 1.6 * s, 0.95))
            beyond = on_screen(self.layout, seen.beyond)
            rects.append(lines.polyline(surface, beyond, self.ink, 1.7 * s, 0.85, fade=(1.0, 0.42)))
        rects += self._bounces(seen)
        last = (seen.beyond or seen.way)[-1:]
        if last and self.session.cue not in drops:
            end = self.layout.to_screen(*last[0])
            rects.append(lines.ring(surface, end, self.radius, self.ink, 1.4 * s, 0.55))
        for k, meeting in enumerate(seen.meetings):
            rects += self._meeting(meeting, foul=k == seen.foul)
        if seen.contact is not None:
            rects += self._contact(seen.contact, foul=seen.foul == -1)
        return rects

    def _bounces(self, seen: Preview) -> Rects:
        rects = []
        for k, (at, out) in enumerate(seen.bounces):
            centre, alpha = self.layout.to_screen(*at), 0.75 - 0.4 * min(k / BOUNCES, 1.0)
            aside = (out[0], -out[1])
            args = centre, aside, self.radius, self.ink, self.layout.s, alpha
            rects.append(lines.bounce(self.surface, *args))
        return rects

    def _lit(self, name: str, hole: Hole) -> pygame.Rect:
        """Light the pocket that a ball falls into, red for the cue ball."""
        ink = ERROR if name == self.session.cue else self._ink(name)
        return pocket_marks.lit(self.surface, self.layout, hole, ink)

    def _potted(self, name: str, way: Sequence[Place]) -> pygame.Rect:
        """Draw the whole way of a ball into its pocket."""
        points = on_screen(self.layout, way)
        s = self.layout.s
        return lines.trace(self.surface, points, self._ink(name), s, 0.9, dashes=POTTED)

    def _others(self, seen: Preview, drops: Mapping[str, Hole]) -> Rects:
        """Draw the other balls' paths: the beginning of the first ball's dashed, the rest thin;
        into a pocket dashed to the end."""
        s, rects, first = self.layout.s, [], seen.contact.ball if seen.contact else ""
        touched = (m.balls for m in seen.meetings if self.session.cue in m.balls)
        shown = {*self.session.traced, first}.union(drops, *touched)
        for name, way in seen.others.items():
            if name not in shown:
                continue
            if name in drops:
                rects.append(self._potted(name, way))
                continue
            ink, rest = self._ink(name), list(way)
            if name == first:
                begun, rest = _split(way, FADE)
                points, fade = on_screen(self.layout, begun), (1.0, FAINT / 0.8)
                args = self.surface, points, ink, 1.5 * s, 0.8, fade, (9 * s, 6 * s)
                rects.append(lines.polyline(*args))
            thin = on_screen(self.layout, rest)
            rects.append(lines.polyline(self.surface, thin, ink, max(1.2 * s, 1.0), FAINT))
            if seen.whole:
                end = self.layout.to_screen(*way[-1])
                radius = self.session.world.ball(name).radius * self.layout.scale
                rects.append(lines.ring(self.surface, end, radius, ink, 1.2 * s, FAINT))
        return rects

    def _meeting(self, meeting: Meeting, *, foul: bool) -> Rects:
        """Mark balls that meet after the first contact; where the cue ball is one, its ghost."""
        s, cue, balls = self.layout.s, self.session.cue, meeting.balls
        at = [self.layout.to_screen(*place) for place in meeting.places]
        middle = ((at[0][0] + at[1][0]) / 2, (at[0][1] + at[1][1]) / 2)
        if cue not in balls:
            known = {*balls} <= {*self.session.traced}
            return [lines.collision(self.surface, middle, 0.8 * s, 0.5)] if known else []
        own = balls.index(cue)
        ring = lines.ring(self.surface, at[own], self.radius, self.ink, 1.4 * s, 0.55)
        rects = [ring, lines.collision(self.surface, middle, s, 0.9)]
        return rects + ([self._blame(meeting.places[1 - own])] if foul else [])

    def _contact(self, contact: FirstContact, *, foul: bool = False) -> Rects:
        """Draw the ghost and where both balls leave to."""
        s, surface, to_screen = self.layout.s, self.surface, self.layout.to_screen
        rects = [lines.ghost(surface, to_screen(*contact.ghost), self.radius, s)]
        inks = self.ink, self._ink(contact.ball)
        places = (contact.ghost, contact.other)
        for at, velocity, colour in zip(places, contact.leaves, inks, strict=True):
            if hypot(*velocity) > 1e-3:
                args = to_screen(*at), atan2(-velocity[1], velocity[0]), self.radius, colour, s
                rects.append(lines.departure(surface, *args))
        return rects + ([self._blame(contact.other)] if foul else [])

    def _blame(self, place: Place) -> pygame.Rect:
        """Ring a ball that must not be hit."""
        at, s = self.layout.to_screen(*place), self.layout.s
        return lines.ring(self.surface, at, 1.3 * self.radius, ERROR, 2.0 * s, 0.95)

    def _ink(self, name: str) -> Colour:
        return self.looks[index(self.session, name)].ui


def dropped(seen: Preview, cue: str, holes: Mapping[str, Hole]) -> dict[str, Hole]:
    """The balls that a preview sees fall, and where: not those that fall when all is settled."""
    ways = {cue: seen.beyond or seen.way, **seen.others}
    found = {}
    for mark in seen.story.events:
        name, hole = mark.balls[0], holes.get(mark.wall or "")
        if mark.kind == "pocket" and hole is not None and ways.get(name):
            end = complex(*ways[name][-1])
            if abs(end - hole.at) < hole.radius + ROUNDING:
                found[name] = hole
    return found


def paths(layout: Layout, seen: Preview) -> list[Points]:
    """The paths of a preview that must stay free of anything written, px."""
    first = seen.others.get(seen.contact.ball, ()) if seen.contact else ()
    return [on_screen(layout, way) for way in (seen.way, seen.beyond, first)]


def on_screen(layout: Layout, points: Sequence[Place]) -> Points:
    """A path as screen points, without those that do not matter; empty for a single point."""
    if len(points) < 2:
        return []
    path = [layout.to_screen(*p) for p in points]
    return lines.decimated(path) if len(path) > FEW else path


def index(session: Session, name: str) -> int:
    """The place of a ball among the balls."""
    return [ball.name for ball in session.world.balls].index(name)


def _clear(points: Points, gap: float) -> Points:
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


def _split(points: Sequence[Place], reach: float) -> tuple[list[Place], list[Place]]:
    """The first `reach` metres of a path, and what is left of it."""
    kept = list(points[:1])
    for k, p in enumerate(points[1:], 1):
        (x, y), step = kept[-1], hypot(p[0] - kept[-1][0], p[1] - kept[-1][1])
        if step > reach:
            share = reach / step
            kept.append((x + share * (p[0] - x), y + share * (p[1] - y)))
            return kept, [kept[-1], *points[k:]]
        reach -= step
        kept.append(p)
    return kept, []
