"""How the ball will leave the cue: its speed, its spin, and how far off the cue's line."""

from __future__ import annotations

from math import hypot, pi
from typing import NamedTuple

from physics import Ball, CueStroke, Shot, heading


class Launch(NamedTuple):
    """The ball just after the stroke.

    speed   m/s
    spin    turns a second, about whatever axis
    squirt  degrees by which it leaves the cue's line, + to the left; None where no cue gives this
    rise    degrees above the cloth at which it hops, 0 for a ball that stays down
    """

    speed: float
    spin: float
    squirt: float | None
    rise: float


def launch(shot: Shot, ball: Ball, bounce: float) -> Launch:
    """What a shot is for the ball that it is played with; bounce: the cloth's restitution."""
    spin = hypot(shot.follow, shot.masse, shot.side) / (2.0 * pi * ball.radius)
    rise = heading(complex(shot.speed, -shot.climb * bounce)) if shot.climb else 0.0
    return Launch(shot.speed, spin, _squirt(shot, ball), rise)


def _squirt(shot: Shot, ball: Ball) -> float | None:
    try:
        return CueStroke.of(shot, ball).squirt
    except ValueError:
        return None
