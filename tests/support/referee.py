"""A referee that never reads an event: it looks where the balls are, densely, and counts.

Balls are read off their legs at least every half millisecond.  A ball touches what it is next to
where a leg begins with a velocity that the leg before has not led to; it has left a cushion where a
sample is more than `apart` m away from it.
"""

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from physics import Leg, World

STEP = 5e-4  # s: between samples, so that a parabola rises no more than 1e-7 m between two
NEXT_TO = 1e-7  # m: a gap of rounding, also after a few hits
TURNED = 1e-9  # m/s


@dataclass
class Sighting:
    """What a cue ball did.

    hits      the balls it touched, each with the time of its first contact, s
    cushions  times and walls of the contacts that count
    close     whether a cushion was left by so nearly `apart` that samples cannot tell
    """

    hits: dict[str, float] = field(default_factory=dict)
    cushions: list[tuple[float, str]] = field(default_factory=list)
    close: bool = False

    def before(self, time: float) -> int:
        """How many contacts with cushions count before that time."""
        return sum(when < time - 1e-9 for when, _ in self.cushions)

    def cannon(self, cushions: int) -> bool:
        """Both other balls of three, the second after so many contacts with cushions."""
        return len(self.hits) == 2 and self.before(max(self.hits.values())) >= cushions


def watched(world: World, cue: str, apart: float) -> Sighting:
    """What the ball named `cue` did in the log of a world that has been played."""
    seen, others = Sighting(), [name for name in world.log.names if name != cue]
    own = world.log.legs(cue)
    rest = {name: world.log.legs(name) for name in others}
    far = {wall.name: 0.0 for wall in world.walls}
    for leg, after in pairwise(own):
        samples = _places(leg, after.time - leg.time)
        at, bent = after.position, abs(after.velocity - _velocity(leg, after.time)) > TURNED
        for wall in world.walls:
            gaps = (samples * wall.normal.conjugate()).real - wall.offset - leg.radius
            far[wall.name] = max(far[wall.name], float(gaps.max()))
            turned = (wall.normal.conjugate() * (after.velocity - _velocity(leg, after.time))).real
            if bent and gaps[-1] < NEXT_TO and turned > TURNED:
                seen.close |= abs(far[wall.name] - apart) < 1e-6
                if far[wall.name] > apart:
                    seen.cushions.append((after.time, wall.name))
                far[wall.name] = 0.0
        for name in others:
            met = _leg_at(rest[name], after.time)
            if bent and met.time == after.time and _gap(at, met, after) < NEXT_TO:
                seen.hits.setdefault(name, after.time)
    return seen


def _places(leg: Leg, lasts: float) -> np.ndarray:
    t = np.linspace(0.0, lasts, 2 + int(lasts / STEP))
    return leg.position + t * (leg.velocity + 0.5 * t * leg.acceleration)


def _velocity(leg: Leg, time: float) -> complex:
    return leg.velocity + (time - leg.time) * leg.acceleration


def _leg_at(legs: list[Leg], time: float) -> Leg:
    return next(leg for leg in reversed(legs) if leg.time <= time)


def _gap(at: complex, other: Leg, own: Leg) -> float:
    return abs(at - other.position) - own.radius - other.radius
