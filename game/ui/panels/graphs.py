"""The graphs of the shot in place of its log, with the moment on show."""

from __future__ import annotations

from collections.abc import Hashable
from math import ceil

import pygame

from game.aim.curves import Curves, curves
from game.render import theme
from game.render.parts import cards, graph
from game.render.parts.graph import Curve
from game.session.action import Action
from game.session.session import Session
from game.session.ticks import TICKS
from game.ui.sight import Place, Sight

GRAPHS = ("speed", "momentum", "energy")
HEAD, PAD, GAP = 36, 12, 8
SAMPLES = 400


class _Seen:
    """The curves of the shot on show, kept until something other than time has changed it."""

    def __init__(self) -> None:
        self.of: tuple[object, ...] = ()
        self.curves: Curves | None = None

    def get(self, session: Session) -> Curves | None:
        """Its curves, those to come among them."""
        world, key = session.world, (session.stamp, session.began)
        beyond = self.curves is not None and world.time - session.began > self.curves.duration
        if not self.of or self.of[0] is not world or self.of[1:] != key or beyond:
            self.of, self.curves = (world, *key), curves(world, session.began, SAMPLES)
        return self.curves


_SEEN = _Seen()


def key(sight: Sight) -> Hashable:
    """What the graphs depend on."""
    session = sight.session
    long = int(session.readout_time) if session.moving else 0  # a shot without an end grows
    return "graphs", session.stamp, session.began, session.readout_time, long


def rects(rect: pygame.Rect, s: float) -> list[pygame.Rect]:
    """Return where the graphs are, one beneath another."""
    pad, gap, head = round(PAD * s), round(GAP * s), round(HEAD * s)
    high = (rect.h - head - pad - gap * (len(GRAPHS) - 1)) // len(GRAPHS)
    left, wide = rect.x + pad, rect.w - 2 * pad
    return [
        pygame.Rect(left, rect.y + head + k * (high + gap), wide, high) for k in range(len(GRAPHS))
    ]


def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw the card with its graphs."""
    s, type_, w = sight.layout.s, sight.type, sight.words
    cards.card(surface, rect, s)
    type_.draw(surface, w["graphs.title"], (rect.x + 12 * s, rect.y + 23 * s), 13, theme.TEXT_SOFT)
    back = (rect.right - 12 * s, rect.y + 23 * s)
    type_.draw(surface, w["events"], back, 12, theme.TEXT_SOFT, "right")
    found = _SEEN.get(sight.session)
    if found is None:
        return rect
    share = min(max(sight.session.readout_time / found.duration, 0.0), 1.0)
    drawn = {
        "speed": [Curve(v, sight.look(name).ui) for name, v in found.speeds.items()],
        "momentum": [Curve(found.momentum[1], theme.LILAC), Curve(found.momentum[0], theme.WHITE)],
        "energy": [Curve(found.moving, theme.WHITE, True), Curve(found.energy, theme.WHITE)],
    }
    for name, room in zip(GRAPHS, rects(rect, s), strict=True):
        graph.graph(surface, room, type_, w[f"graphs.{name}"], drawn[name], share)
    return rect


def touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    """The head goes back to the log; on a graph, while the mouse is held, it scrubs."""
    pointer, s, found = sight.pointer, sight.layout.s, _SEEN.get(sight.session)
    if pointer.pressing and at[1] < rect.y + HEAD * s:
        return Action("graphs")
    room = rects(rect, s)[0]
    if found is None or (not pointer.pressing and pointer.grip != "graphs"):
        return None
    pointer.grip = "graphs"
    share = min(max((at[0] - room.x) / room.w, 0.0), 1.0)
    return Action("scrub", ceil(share * found.duration * TICKS))
