"""How far a cue must be raised to pass over the balls and the cushions behind the ball it plays."""

from __future__ import annotations

from math import asin, atan2, ceil, degrees, hypot, sqrt

from physics import World, direction

from .tip import STEEPEST

LENGTH = 1.45
"""Of the cue, m."""
THICK = 0.007
"""Half the thickness of a cue near its tip, m."""
LEVEL = 5.0
"""Degrees up to which a cue counts as level: over a rail nobody holds it lower."""
NOSE = 1.27
"""Height of a nose over the cloth, in radii, where the cushion's law has none."""
NEAR = 1e-4
"""Metres from a nose at which a line has reached it."""
STEPS = 60


def needed(world: World, cue: str, angle: float, up: float = 0.0) -> float:
    """The least elevation at which the cue can play that ball, degrees; 0 if a level one can.

    angle: that it points to, degrees.
    up: where the tip meets the ball as seen along the cue, in radii.
    At most STEEPEST, also where no cue has room.
    """
    own, back = world.ball(cue), -direction(angle)
    if own.gone:
        return 0.0
    low = up * own.radius
    found = [_over_balls(world, cue, back, low), _over_noses(world, cue, back, low)]
    steep = ceil(100.0 * max(found)) / 100.0
    return min(steep, STEEPEST) if steep > LEVEL else 0.0


def _over_balls(world: World, cue: str, back: complex, low: float) -> float:
    own, steepest = world.ball(cue), 0.0
    for ball in world.balls:
        if ball.name == cue or ball.gone:
            continue
        off = (complex(*ball.position) - complex(*own.position)) * back.conjugate()
        reach = ball.radius + THICK
        if 0.0 < off.real < LENGTH and abs(off.imag) < reach:
            room = sqrt(reach * reach - off.imag * off.imag)
            steepest = max(steepest, _raised(off.real, ball.radius - own.radius, room - low))
    return steepest


def _over_noses(world: World, cue: str, back: complex, low: float) -> float:
    own, steepest = world.ball(cue), 0.0
    for wall in world.walls:
        if not wall.pushes:
            continue
        away = 0.0
        for _ in range(STEPS):
            spot = complex(*own.position) + away * back
            gap = wall.distance((spot.real, spot.imag))
            away += gap
            if gap < NEAR or away > LENGTH:
                break
        if gap < NEAR:
            nose = getattr(wall.own_law or world.cushion_law, "nose", NOSE)
            steepest = max(steepest, _raised(away, (nose - 1.0) * own.radius, THICK - low))
    return steepest


def _raised(away: float, above: float, room: float) -> float:
    """The elevation of a line that passes what is so far away and so far above by that distance."""
    far = hypot(away, above)
    if room >= far:
        return STEEPEST
    return degrees(asin(max(room / far, -1.0)) + atan2(above, away))
