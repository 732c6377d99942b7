"""Nominating by a click: on a ball that may be called or played with, or on a pocket."""

from __future__ import annotations

from math import dist

from game.session import calls
from game.session.action import Action
from game.session.match_commands import pockets
from game.ui.sight import Place, Sight

REACH = 1.2
"""Radii of a ball, or of a pocket, within which a click means it."""


def _may(sight: Sight) -> frozenset[str]:
    session = sight.session
    if session.contest is None or session.moving or session.shown_shot or session.arranging:
        return frozenset()
    return session.contest.may_call if session.contest.level is None else frozenset()


def pocket_at(at: Place, sight: Sight) -> str:
    """The pocket at a point of the window if one may be called, else ""."""
    if "pocket" not in _may(sight):
        return ""
    spot = sight.layout.to_table(*at)
    near = 2.0 * sight.session.world.balls[0].radius * REACH
    found = pockets(sight.session.world)
    name = min(found, key=lambda pocket: dist(found[pocket], spot))
    return name if dist(found[name], spot) < near else ""


def ball_at(at: Place, sight: Sight) -> tuple[Action, ...]:
    """What a click on a ball means beside aiming at it: it is called, or played with."""
    contest, name = sight.session.contest, _under(at, sight)
    if contest is None or not name or "ball" not in _may(sight):
        return ()
    match = contest.match
    if name not in calls.balls(match) or match.call.ball == name:
        return ()
    return (Action("call", f"ball {name}"),)


def cue_at(at: Place, sight: Sight) -> Action | None:
    """What the right button means on a ball, where any ball may be played with: that it is."""
    name = _under(at, sight)
    return Action("call", f"cue {name}") if name and "cue" in _may(sight) else None


def _under(at: Place, sight: Sight) -> str:
    """The ball at a point of the window, or ""."""
    spot = sight.layout.to_table(*at)
    balls = (ball for ball in sight.session.world.balls if not ball.gone)
    near = (ball.name for ball in balls if dist(ball.position, spot) < REACH * ball.radius)
    return next(near, "") if sight.layout.bed.collidepoint(at) else ""
