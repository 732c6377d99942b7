"""Numbers at the diamonds: where a stroke over each of them meets its third cushion."""

from __future__ import annotations

from cmath import rect
from math import radians

import pygame

from game.aim import diamonds
from game.aim.diamonds import FIVE, Diamond, DiamondFan, DiamondStroke
from game.aim.entry import BOXES
from game.render.font import type_at
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.table import lines
from game.render.theme import ACCENT, BACKGROUND, LILAC, TEXT, TEXT_FAINT, Colour, mix
from game.session.session import Session

from . import marks

SIZE, HIGH, PAD = 12, 18, 5
ARROWS = {"north": "↑", "south": "↓", "west": "←", "east": "→"}
DARK = mix(BACKGROUND, (0, 0, 0), 0.3)


class DiamondMarks:
    """The numbers of the rail that is aimed at; computed again only when they may have changed.

    mode  "own": the stroke in the boxes, "five": the corner system's, or "off"
    """

    def __init__(self) -> None:
        self.mode = "off"
        self.fan: DiamondFan | None = None
        self._known: object = None

    def key(self, session: Session, mode: str) -> object:
        """Bring them up to date; returns what their picture depends on."""
        self.mode = mode
        asked = self._asked(session) if mode != "off" else None
        if asked is None:
            self.fan = None
        elif asked != self._known or self.fan is None:
            rail, stroke = asked[0], asked[1]
            self.fan = diamonds.fan(session.world, session.cue, rail, stroke)
        self._known = asked
        return asked, mode, self._right(session) if asked is not None else None

    def _asked(self, session: Session) -> tuple[str, DiamondStroke, int, str] | None:
        """The rail and the stroke that are asked about, and what else the numbers depend on."""
        aim = session.aim
        shows = marks.aiming(session) and not session.arranging and not session.sketching
        if not shows or aim.angle is None or session.world.ball(session.cue).gone:
            return None
        stroke = FIVE if self.mode == "five" else self._own(session)
        if stroke is None:
            return None
        rail = diamonds.aimed_at(session.world, session.cue, aim.angle)
        return rail, stroke, session.stamp, session.cue

    @staticmethod
    def _own(session: Session) -> DiamondStroke | None:
        numbers = [session.aim.number(name) for name in BOXES[:4]]
        known = [number for number in numbers if number is not None]
        if len(known) < 4 or known[0] <= 0.0:
            return None
        speed, follow, masse, side = known
        return DiamondStroke(speed, follow, masse, side)

    def _right(self, session: Session) -> bool:
        way = rect(1.0, radians(session.aim.angle or 0.0))
        return self.fan is not None and diamonds.turns_right(way, self.fan.rail)

    def draw(self, surface: pygame.Surface, layout: Layout, session: Session) -> list[pygame.Rect]:
        """Draw the numbers on the wood, and on the noses where the third cushions are met."""
        if self.fan is None or self.mode == "off":
            return []
        rects = []
        for sight in self.fan.sights:
            ink = ACCENT if sight.right == self._right(session) else LILAC
            if sight.rail:
                at = layout.to_screen(*sight.third)
                rects.append(lines.dot(surface, at, 3.2 * layout.s, BACKGROUND, 0.8))
                rects.append(lines.dot(surface, at, 2.4 * layout.s, ink))
            rects.append(_pill(surface, layout, layout.to_screen(*sight.at), self.said(sight), ink))
        return rects

    def said(self, sight: Diamond) -> str:
        """What is written at a diamond: the third cushion's place; in the corner system first and
        third, of which the sum is the cue ball's number."""
        if not sight.rail:
            return "–"
        if self.mode == "five" and sight.first is not None and sight.last is not None:
            return f"{sight.first:.0f} · {sight.last:.0f}"
        return f"{ARROWS[sight.rail]}{sight.value:.1f}"

    def words(self, session: Session, w: dict[str, str]) -> str:
        """What the numbers are, in a line; "" while there are none."""
        if self.fan is None or self.mode == "off":
            return ""
        if self.mode == "own":
            return w["diamonds.own"]
        start = self.fan.start(right=self._right(session))
        if start is None:
            return w["diamonds.five.none"]
        return w["diamonds.five"].format(start=f"{start[0]:.0f}", off=f"{start[1]:.0f}")


def _pill(
    surface: pygame.Surface, layout: Layout, at: tuple[float, float], text: str, ink: Colour
) -> pygame.Rect:
    """Write a number on the wood, inside the table."""
    type_ = type_at(layout.s)
    high = max(round(HIGH * layout.s), 14)
    box = pygame.Rect(0, 0, round(type_.width(text, SIZE) + 2 * PAD * layout.s), high)
    box.center = round(at[0]), round(at[1])
    box.clamp_ip(layout.table)
    shapes.box(surface, box, layout.s, DARK, mix(DARK, ink, 0.6), radius=HIGH // 2)
    tone = TEXT if text != "–" else TEXT_FAINT
    base = box.centery + type_.cap(SIZE) / 2
    type_.draw(surface, text, (box.centerx, base), SIZE, tone, "centre")
    return box
