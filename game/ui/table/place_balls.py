"""Placing balls: click one to take it, drag it or click where it is to lie; or Tab and arrows."""

from __future__ import annotations

from math import dist

import pygame

from game.session.action import Action
from game.session.session import Session
from game.ui.sight import Place, Sight

REACH = 1.6
"""Radii from its centre within which a press takes a ball."""
STEP, FINE = 0.02, 0.001
"""Metres by which an arrow key moves a ball, and with Shift."""
WAYS = {
    pygame.K_LEFT: (-1, 0),
    pygame.K_RIGHT: (1, 0),
    pygame.K_UP: (0, 1),
    pygame.K_DOWN: (0, -1),
}
DONE = (pygame.K_ESCAPE, pygame.K_RETURN, pygame.K_KP_ENTER)


def touch(at: Place, sight: Sight) -> Action | None:
    """What a press on the cloth, or a drag from there, means while balls are placed."""
    session, spot = sight.session, sight.layout.to_table(*at)
    if session.contest is not None and not session.contest.match.finished:
        return _in_hand(spot, sight)
    if sight.pointer.pressing:
        near = min(session.world.balls, key=lambda ball: dist(ball.position, spot))
        if dist(near.position, spot) < REACH * near.radius:
            sight.pointer.grip = tuple(p - q for p, q in zip(near.position, spot, strict=True))
            return Action("hold", near.name)
        sight.pointer.grip = (0.0, 0.0)
    off, pointer = sight.pointer.grip, sight.pointer
    if not isinstance(off, tuple) or not (pointer.pressing or pointer.stirred):
        return None
    return Action("move", f"{spot[0] + off[0]:.5f} {spot[1] + off[1]:.5f}")


def put_again(at: Place, sight: Sight) -> tuple[bool, Action | None]:
    """Whether a press or a drag on the cloth has hold of a cue ball in hand that had been put down
    already; and what it means: the ball is put elsewhere, and the aim stays."""
    session, pointer = sight.session, sight.pointer
    contest, spot = session.contest, sight.layout.to_table(*at)
    if contest is None or not contest.in_hand or contest.level is not None or session.shown_shot:
        return False, None
    ball = session.world.ball(session.cue)
    if pointer.pressing and dist(ball.position, spot) < ball.radius:
        pointer.grip = tuple(p - q for p, q in zip(ball.position, spot, strict=True))
    off = pointer.grip
    if not isinstance(off, tuple):
        return False, None
    to = f"{spot[0] + off[0]:.5f} {spot[1] + off[1]:.5f}"
    return True, Action("put", to) if pointer.stirred else None


def _in_hand(spot: Place, sight: Sight) -> Action | None:
    """Where the cue ball of a match goes: where the mouse is, or by as much as it is dragged."""
    pointer = sight.pointer
    if pointer.pressing:
        ball = sight.session.world.ball(sight.session.held_ball)
        near = dist(ball.position, spot) < REACH * ball.radius
        away = tuple(p - q for p, q in zip(ball.position, spot, strict=True))
        pointer.grip = away if near else (0.0, 0.0)
        if near:
            return None
    off = pointer.grip
    if not isinstance(off, tuple) or not (pointer.pressing or pointer.stirred):
        return None
    return Action("move", f"{spot[0] + off[0]:.5f} {spot[1] + off[1]:.5f}")


def key(event: pygame.event.Event, session: Session) -> Action | None:
    """What a key means while balls are placed; None for one that means what it always does."""
    mod = getattr(event, "mod", 0)
    in_hand = session.contest is not None and not session.contest.match.finished
    if event.key in DONE and not (in_hand and event.key == pygame.K_ESCAPE):
        return Action("arrange")
    if event.key == pygame.K_TAB:
        names = [ball.name for ball in session.world.balls]
        way = -1 if mod & pygame.KMOD_SHIFT else 1
        return Action("hold", names[(names.index(session.held_ball) + way) % len(names)])
    if event.key not in WAYS:
        return None
    size = FINE if mod & pygame.KMOD_SHIFT else STEP
    (x, y), (dx, dy) = session.world.ball(session.held_ball).position, WAYS[event.key]
    return Action("move", f"{x + size * dx!r} {y + size * dy!r}")
