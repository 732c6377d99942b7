"""Where the tip meets the ball and how steep the cue is, and the three spins that come of it.

The boxes are the truth: a tip point is another way to write the spins Wx·R, Wy·R and Wz·R. A cue
of elevation e that leaves the ball with the speed V, and meets it `right` and `up` of the centre
as seen along the cue, gives (docs/physics.md, "Cue", along the ball's own course)

    Wz·R = 5/2 V right        Wx·R = 5/2 V up / cos e        Wy·R = 5/2 V right tan e

and drives it into the cloth at V tan e, off which it hops.
"""

from __future__ import annotations

from math import hypot
from typing import NamedTuple

from physics import CueStroke, Shot, direction, heading

LEVER = 2.5
"""Surface speed over speed for a tip one radius off the centre: F r = (2/5) m R² ω."""
STEEPEST = 80.0
"""Degrees: a cue held steeper than this cannot be drawn back over a rail."""
LIMIT = CueStroke(1.0).limit
"""Farthest from the centre a chalked tip holds, in ball radii: the miscue ring."""


class Tip(NamedTuple):
    """Offsets in ball radii as seen along the cue, and the cue's elevation in degrees.

    The elevation is None where no cue gives such spins: massé without side, or against it.
    """

    right: float
    up: float
    elevation: float | None = 0.0

    @property
    def away(self) -> float:
        """Distance from the centre, in ball radii."""
        return hypot(self.right, self.up)

    @property
    def holds(self) -> bool:
        """Is it a stroke that a cue can make?"""
        return self.elevation is not None and self.away <= LIMIT

    def within(self, limit: float = LIMIT) -> Tip:
        """The nearest point of the ring, for a tip beyond it."""
        size = max(1.0, self.away / limit)
        return Tip(self.right / size, self.up / size, self.elevation)

    def spins(self, speed: float) -> dict[str, float]:
        """The three spins that this gives a ball of that speed, m/s, by the names of the boxes."""
        lever, cue = LEVER * speed, direction(self.elevation or 0.0)
        return {
            "follow": lever * self.up / cue.real,
            "masse": lever * self.right * cue.imag / cue.real,
            "side": lever * self.right,
        }


def squirt(right: float) -> float:
    """By how many degrees the ball leaves the cue's line for a tip so far right, + to the left."""
    return CueStroke(1.0, side=min(max(right, -LIMIT), LIMIT)).squirt


def tip_of(shot: Shot) -> Tip:
    """The tip point and the elevation that give a shot its spins."""
    lever = LEVER * shot.speed
    right, up = shot.side / lever, shot.follow / lever
    if shot.climb < 0.0:
        elevation = heading(complex(shot.speed, -shot.climb))
        return Tip(right, up * direction(elevation).real, elevation)
    if shot.masse == 0.0:
        return Tip(right, up)
    sign = 1.0 if shot.side >= 0.0 else -1.0
    elevation = heading(complex(shot.side * sign, shot.masse * sign))
    if not 0.0 < elevation <= STEEPEST:
        return Tip(right, up, None)
    return Tip(right, up * direction(elevation).real, elevation)
