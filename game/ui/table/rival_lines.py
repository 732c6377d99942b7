"""The shot on show as other laws and the other engine have it, drawn over it, and how far off."""

from __future__ import annotations

import pygame

from game.input.captions import words
from game.render import theme
from game.render.font import type_at
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.table import lines
from game.session.compared import Rival, rivals
from game.session.session import Session

from . import preview_lines

INKS = (theme.LILAC, theme.WARNING, theme.GOOD, theme.ACCENT)
"""As many as there can be rivals: of a table with laws of its own, each set of laws is one."""
DASHES = ((10, 5), (4, 4), (14, 4, 3, 4), (2, 4))
ROW, PAD, SIZE, SAMPLE = 19, 10, 12, 26
OTHERS = 0.35
"""Alpha of the ways of balls that were not struck."""


class Rivals:
    """What is drawn; computed once for a shot, when its balls lie still."""

    def __init__(self) -> None:
        self._of: tuple[object, ...] = ()
        self._found: tuple[Rival, ...] = ()

    def key(self, session: Session, on: bool) -> object:
        """What the picture depends on: equal keys, equal pictures."""
        return (on and shown(session)) and (session.stamp, session.began, session.language)

    def of(self, session: Session) -> tuple[Rival, ...]:
        """The rivals of the shot on show."""
        key = session.world, session.stamp, session.began
        if not self._of or self._of[0] is not key[0] or self._of[1:] != key[1:]:
            given = session.law, session.engine, session.edition, session.came_with
            self._found = rivals(session.world, session.shooter, session.began, *given)
            self._of = key
        return self._found

    def draw(
        self, surface: pygame.Surface, layout: Layout, session: Session, on: bool
    ) -> list[pygame.Rect]:
        """Draw them, if that is wished for; returns the rectangles around them."""
        if not (on and shown(session)):
            return []
        found = self.of(session)
        rects = []
        for rival, ink, dashes in zip(found, INKS, DASHES, strict=False):
            rects += _ways(surface, layout, session, rival, (ink, dashes))
        return [*rects, _legend(surface, layout, session, found)]


def shown(session: Session) -> bool:
    """Is there a shot to compare?"""
    return session.shown_shot and not session.moving


def _ways(
    surface: pygame.Surface, layout: Layout, session: Session, rival: Rival,
    style: tuple[theme.Colour, tuple[int, ...]],
) -> list[pygame.Rect]:  # fmt: skip
    s, rects, (ink, dashes) = layout.s, [], style
    for name, way in rival.ways.items():
        own = name == session.shooter
        if not own and name not in session.traced:
            continue
        points, alpha = preview_lines.on_screen(layout, way), 0.95 if own else OTHERS
        long = [d * s for d in dashes]
        rects.append(lines.polyline(surface, points, ink, 1.5 * s, alpha, dashes=long))
        if name in rival.ends:
            radius = session.world.ball(name).radius * layout.scale
            at = layout.to_screen(*rival.ends[name])
            rects.append(lines.ring(surface, at, radius, ink, 1.5 * s, alpha))
    return rects


def _legend(
    surface: pygame.Surface, layout: Layout, session: Session, found: tuple[Rival, ...]
) -> pygame.Rect:
    """A line for each: its name, and how far off the struck ball and the farthest one end."""
    s, type_, w = layout.s, type_at(layout.s), words(session.language)
    said = [_said(rival, w) for rival in found] or [w["compare.none"]]
    pad, sample = PAD * s, (SAMPLE + 8) * s if found else 0.0
    wide = round(max(type_.width(line, SIZE) for line in said) + sample + 2 * pad)
    rect = pygame.Rect(0, 0, wide, round((len(said) * ROW + 10) * s))
    rect.topleft = layout.bed.x + round(8 * s), layout.bed.y + round(8 * s)
    shapes.box(surface, rect, s, theme.PANEL, theme.LINE)
    for place, line in enumerate(said):
        base = rect.y + (place * ROW + 18) * s
        if found:
            ends = [(rect.x + pad, base - 4 * s), (rect.x + pad + SAMPLE * s, base - 4 * s)]
            dashes = [d * s for d in DASHES[place]]
            lines.polyline(surface, ends, INKS[place], 1.8 * s, dashes=dashes)
        type_.draw(surface, line, (rect.x + pad + sample, base), SIZE, theme.TEXT)
    return rect


def _said(rival: Rival, w: dict[str, str]) -> str:
    name = w[f"{rival.kind}.{rival.key}"]
    return w["compare.row"].format(
        name=name, cue=f"{100.0 * rival.cue:.1f}", most=f"{100.0 * rival.most:.1f}"
    )
