"""Thickness (두께) the other way round: the angle at which the first ball is met by an exact part.

The cue ball may run in a curve or come off a cushion, so the angle is found by asking the engine.
"""

from __future__ import annotations

from dataclasses import replace
from math import ceil, copysign, floor, radians, sqrt

from physics import Shot, World, heading

from .preview import FirstContact, Preview, preview

EIGHTHS = 8
CLOSE = 1e-3
"""Eighths by which the result may be off: 4 μm on a carom ball, less than the box can say."""
TRIES = 12
NEAR = 0.02
"""Degrees that a shot off a cushion is turned at first: it is sensitive."""
STRIDE = 4.0
"""Degrees an attempt may be turned at most."""


def aside(contact: FirstContact) -> float:
    """How far the line of aim passes the ball, in eighths: 0 is full, 8 a miss, + on its right."""
    return EIGHTHS * copysign(1.0 - abs(contact.overlap), contact.overlap)


def neighbour(now: float, way: int) -> int:
    """The next whole eighth in that direction, between 1/8 on either side."""
    sure = 1e-2
    to = floor(now + sure) + 1 if way > 0 else ceil(now - sure) - 1
    return min(max(to, 1 - EIGHTHS), EIGHTHS - 1)


def angle(world: World, cue: str, shot: Shot, seen: Preview, eighths: int) -> float | None:
    """The angle, radians, at which the ball that is `seen` to be met first is met so, or None."""
    contact = seen.contact
    assert contact is not None, "there is a thickness only where a ball is met"
    name = contact.ball

    def off(degrees_: float) -> float | None:
        """By how many eighths an angle misses what is wanted."""
        then = preview(world, cue, replace(shot, angle=degrees_))
        if then is None or then.contact is None or then.contact.ball != name:
            return None
        return aside(then.contact) - eighths

    at, missed = shot.angle, aside(contact) - eighths
    met = next(event for event in seen.story.events if cue in event.balls)
    to = at + NEAR if met.kind == "cushion" else _straight(world, cue, contact, eighths)
    for _ in range(TRIES):
        found = off(to)
        if found is None:
            to = (at + to) / 2  # past the ball or into another one: half as far
            continue
        if abs(found) < CLOSE:
            return radians(to)
        slope = (found - missed) / (to - at) if to != at else 0.0
        at, missed = to, found
        step = -found / slope if slope else 0.01
        to += min(max(step, -STRIDE), STRIDE)
    return None


def _straight(world: World, cue: str, contact: FirstContact, eighths: int) -> float:
    """The angle if the cue ball runs straight to the ball, degrees."""
    own, other = world.ball(cue), world.ball(contact.ball)
    line = complex(*other.position) - complex(*own.position)
    past = eighths / EIGHTHS * own.touching_distance(other)
    ahead = line.real * line.real + line.imag * line.imag - past * past
    # fixed steps may leave one ball in the other
    return heading(line * complex(sqrt(max(ahead, 1e-18)), -past))
