"""The table in layers: background, lines, balls, cue.  Only what changed is redrawn."""

from __future__ import annotations

from collections.abc import Iterable
from math import ceil

import pygame

from game.aim.spread import SAMPLES, Spread
from game.practice.trainer import Trainer
from game.render.layout import Layout
from game.render.table import cue_stick, lines
from game.render.table.balls import BallSprites, Spot
from game.render.table.fan import Fan
from game.render.table.finish import FINISHES
from game.session.session import Session
from game.settings.settings import Settings

from . import balklines, labels, marks, preview_lines, zone_marks
from .cue_pose import Pose, pose
from .diamond_marks import DiamondMarks
from .dropped import AWAY, Dropped
from .furniture import falls_into, furnished, holes
from .looks import kind_of, looks_of
from .orientations import Orientations
from .over import Over
from .rival_lines import Rivals
from .sketch import Sketch
from .trail import Trail

SHADOW = 2.3
"""A ball with its shadow lies within this many radii of its centre."""
FAR = 3.0
"""Heights within which the shadow of a ball in the air lies, and all that the ball grows by."""
NOTHING = pygame.Rect(0, 0, 0, 0)
FIRST = 8
"""Samples after which the fan is shown for the first time, before it has them all."""
LEAP = 0.25
"""Seconds in one frame after which the balls' turns are taken from the log: they were not seen."""


class Stage:
    """The pictures of one table at one size of the window.

    `base` is the background, `lines` the background with what lies under the balls.
    """

    def __init__(
        self, layout: Layout, session: Session, settings: Settings, spread: Spread | None = None
    ) -> None:
        self.layout = layout
        self.base, wells = furnished(layout, session.world)
        balklines.draw(self.base, layout, session)
        self.lines = self.base.copy()
        self.settings, self.sketch, self.rivals = settings, Sketch(), Rivals()
        kind, radii = kind_of(session.world), [ball.radius for ball in session.world.balls]
        self.looks = looks_of(session.world, settings.colours)
        cloth, many = FINISHES[kind].cloth, kind != "carom"
        self.sprites = BallSprites(layout, self.looks, radii, cloth, many=many)
        self.sprites.wells = wells
        self.holes = holes(session.world)
        self.dropped = Dropped(falls_into(session.world), fine=many)
        self.trail, self.orientations = Trail(), Orientations(self.sprites)
        self.trainer: Trainer | None = None
        self.over, self.diamonds = Over(), DiamondMarks()
        self.spread, self.fan = spread or Spread(), Fan(layout)
        self._time, self._shown = session.world.time, (session.began, session.timeline.at)
        self._under: object = None
        self._marked: list[pygame.Rect] = []
        self._balls: list[tuple[object, pygame.Rect]] = [(None, NOTHING)] * len(self.looks)
        self._cue: tuple[object, pygame.Rect] = (None, NOTHING)
        self._reach = ceil(SHADOW * self.sprites.px) + 3

    def follow(self, session: Session) -> None:
        """Turn the balls as they have rolled since the last time, and let their trails grow."""
        before, self._time = self._time, session.world.time
        shown, self._shown = self._shown, (session.began, session.timeline.at)
        new = self.orientations.begin(session)
        since = session.world.time - (session.began if new else before)
        if session.timeline.at is not None or (shown != self._shown and not new) or since > LEAP:
            if session.shown_shot:
                self.orientations.show(session, session.timeline.moment - session.began)
        elif since > 0.0:
            for index, ball in enumerate(session.world.balls):
                spin = ball.spin
                if any(spin):
                    self.sprites.rotate(index, spin, since)
        if session.timeline.runs:
            self.trail.grow(session)
        self.dropped.follow(session)

    def take_over(self, other: Stage) -> None:
        """Go on where the stage of another size has been."""
        for i in range(len(self.looks)):
            self.sprites.orient(i, other.sprites.orientation(i))
        self.trail, self.orientations = other.trail, other.orientations.on(self.sprites)
        self.dropped.take_over(other.dropped)
        self._time, self._shown = other._time, other._shown

    def draw(self, surface: pygame.Surface, session: Session) -> list[pygame.Rect]:
        """Bring the table up to date; returns the rectangles that changed."""
        dirty = self._draw_lines(session) + self.over.changed()
        if marks.aiming(session):
            self.sprites.settle()
        places = [spot for spot in self.dropped.spots(session) if spot.height > AWAY]
        dirty += self._moved(places)
        self.sprites.prepare(places)
        stroke = pose(session, self.settings.still)
        if stroke != self._cue[0]:
            dirty += [self._cue[1], self._cue_room(stroke)]
            self._cue = (stroke, dirty[-1])
        table = self.layout.table  # a ball high in the air reaches over the cards
        area = [rect for room in _merged(dirty) if (rect := room.clip(table)).w and rect.h]
        rooms = [self._balls[spot.ball][1] for spot in places]
        for rect in area:
            near = [places[k] for k in rect.collidelistall(rooms)]
            self._compose(surface, rect, near, stroke)
        return area

    def everything(self, surface: pygame.Surface, session: Session) -> None:
        """Draw the whole window's background and table again."""
        self._under = None
        self.trail.undrawn()
        self.over.undrawn()
        self._balls = [(None, NOTHING)] * len(self.looks)
        self._cue = (None, NOTHING)
        self.lines.blit(self.base, (0, 0))
        self._marked = []
        surface.blit(self.base, (0, 0))
        self.draw(surface, session)

    def _draw_lines(self, session: Session) -> list[pygame.Rect]:
        """Redraw what lies under the balls if it is not what it was."""
        aids = self.settings.aids
        compare = self.settings.compare
        key = (
            marks.key(session, aids), self._fanned(session), self.sketch.key(session),
            self.diamonds.key(session, self.settings.diamonds), zone_marks.key(self.trainer),
            self.rivals.key(session, compare),
        )  # fmt: skip
        if key == self._under:
            grown = self.trail.draw(self.lines, self.layout, session, self.looks)
            self._marked += grown
            return grown
        self._under = key
        old, self._marked = self._marked, []
        for rect in _merged(old):
            self.lines.blit(self.base, rect, rect)
        self.lines.set_clip(self.layout.table)
        fan = zone_marks.draw(self.lines, self.layout, self.trainer) + self._draw_fan(session)
        given = self.lines, self.layout, session, self.looks
        self._marked = fan + marks.draw(*given, aids, self.holes)
        self._marked += self.diamonds.draw(self.lines, self.layout, session)
        self._marked += self._labels(session)
        self._marked += self.sketch.draw(self.lines, self.layout, session)
        self._marked += self.rivals.draw(self.lines, self.layout, session, compare)
        self.lines.set_clip(None)
        self.trail.undrawn()
        self._marked += self.trail.draw(self.lines, self.layout, session, self.looks)
        return old + self._marked

    def _labels(self, session: Session) -> list[pygame.Rect]:
        """Write what stands beside balls and pockets while nothing moves."""
        if session.moving or session.timeline.at is not None:
            return []
        args = self.lines, self.layout, session, self.looks
        aims = marks.aiming(session) and not session.arranging and self.settings.aids == "full"
        preview = session.preview if aims else None
        rects = []
        if preview is not None and self._fanned(session) == SAMPLES:
            rects += labels.share(*args, preview, self.holes, self.spread.share)
        paths = preview_lines.paths(self.layout, preview) if preview is not None else []
        spots = [spot for spot in self.dropped.spots(session) if spot.height >= 0.0]
        return rects + labels.tags_of(*args, self.settings.colours, spots, paths)

    def _moved(self, places: list[Spot]) -> list[pygame.Rect]:
        dirty = []
        for index in {*range(len(self._balls))} - {spot.ball for spot in places}:
            if self._balls[index][0] is not None:
                dirty.append(self._balls[index][1])
                self._balls[index] = (None, NOTHING)
        for spot in places:
            index = spot.ball
            key = (spot, self.sprites.orientation(index))
            was, room = self._balls[index]
            if key != was:
                now = self._room(spot)
                dirty.append(room.union(now) if room.colliderect(now) else now)
                if not room.colliderect(now):
                    dirty.append(room)
                self._balls[index] = (key, now)
        return dirty

    def _room(self, spot: Spot) -> pygame.Rect:
        """The square around a ball and its shadow, which a ball in the air leaves behind."""
        x, y = self.layout.to_screen(*spot.at)
        reach = self._reach
        if spot.height > 0.0:
            reach += ceil(FAR * spot.height * self.layout.scale)
        return pygame.Rect(int(x) - reach, int(y) - reach, 2 * reach, 2 * reach)

    def _fanned(self, session: Session) -> int:
        """How many samples of the spread are on show: none, the first ones, or all of them."""
        count = len(self.spread.samples) if marks.aiming(session) else 0
        return count if count == SAMPLES else FIRST if count >= FIRST else 0

    def _draw_fan(self, session: Session) -> list[pygame.Rect]:
        count = self._fanned(session)
        if not count:
            return []
        self.fan.clear()
        for one in self.spread.samples[:count]:
            way = [self.layout.to_screen(*p) for p in one.way]
            self.fan.add(lines.decimated(way) if len(way) > 1 else way)
        return [self.fan.draw(self.lines)]

    def _cue_room(self, stroke: Pose | None) -> pygame.Rect:
        """The rectangle around cue and shadow, inside the table."""
        if stroke is None:
            return NOTHING
        ball, angle, back, _, radius, elevation = stroke
        return cue_stick.room(self.layout, ball, angle, back, radius, elevation)

    def _compose(
        self,
        surface: pygame.Surface,
        rect: pygame.Rect,
        near: list[Spot],
        stroke: Pose | None,
    ) -> None:
        """Put the layers together inside `rect`, with the balls that reach into it."""
        surface.set_clip(rect)
        surface.blit(self.lines, rect, rect)
        self.sprites.draw_all(surface, near)
        if stroke is not None and self._cue[1].colliderect(rect):
            cue_stick.draw(surface, self.layout, *stroke)
        self.over.draw(surface, rect)
        surface.set_clip(None)


def _merged(rects: Iterable[pygame.Rect]) -> list[pygame.Rect]:
    """Join rectangles that overlap where the union is not much larger than both."""
    merged: list[pygame.Rect] = []
    for rect in rects:
        for i, other in enumerate(merged):
            if not other.colliderect(rect):
                continue
            union = other.union(rect)
            if union.w * union.h <= 1.5 * (other.w * other.h + rect.w * rect.h):
                merged[i] = union
                break
        else:
            merged.append(rect.copy())
    return merged
