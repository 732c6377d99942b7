"""How well a stroke is carried out: an aim, and the error that a level makes in it."""

from __future__ import annotations

from dataclasses import dataclass
from math import hypot
from random import Random

from physics import Shot

# Radii off the centre of the ball beyond which a chalked tip slips (friction 0.6: 0.6/√1.36).
MISCUE = 0.51
WILDEST = 1000  # an error of any kind: a ball at a million m/s would roll for days
SLOWEST = 0.05  # m/s: an error never makes a stroke none


@dataclass(frozen=True, slots=True)
class Attempt:
    """A stroke with a horizontal cue.

    angle: direction, degrees.
    speed: of the ball, m/s.
    right, up: offset of the tip from the centre in radii of the ball, seen from behind.
    """

    angle: float
    speed: float
    right: float = 0.0
    up: float = 0.0

    def shot(self) -> Shot:
        """The shot it gives: a push at the offset d spins the ball with Rω = 5/2 d v."""
        spin = 2.5 * self.speed
        return Shot(self.speed, self.angle, follow=spin * self.up, side=spin * self.right)

    def within(self, limit: float) -> Attempt:
        """The same with the tip no farther out than `limit` radii."""
        out = hypot(self.right, self.up)
        if out <= limit:
            return self
        return Attempt(self.angle, self.speed, self.right * limit / out, self.up * limit / out)


@dataclass(frozen=True, slots=True)
class Level:
    """A player's skill: standard deviations of a stroke, each independent and normal.

    key: in the texts.
    angle: degrees.
    speed: share of the speed.
    tip: mm on the ball, in each direction.
    ValueError for one that is not from 0 to 1000.
    """

    key: str
    angle: float
    speed: float
    tip: float

    def __post_init__(self) -> None:
        for name in ("angle", "speed", "tip"):
            error = getattr(self, name)
            if not 0.0 <= error <= WILDEST:
                raise ValueError(f"Level.{name} must be from 0 to {WILDEST}, not {error!r:.60}")

    def missed(self, aim: Attempt, rng: Random, radius: float) -> Attempt:
        """The aim as this level carries it out on a ball of `radius` m; four draws of `rng`."""
        tip = 1e-3 * self.tip / radius
        return Attempt(
            aim.angle + rng.gauss(0.0, self.angle),
            max(SLOWEST, aim.speed * (1.0 + rng.gauss(0.0, self.speed))),
            aim.right + rng.gauss(0.0, tip),
            aim.up + rng.gauss(0.0, tip),
        ).within(MISCUE)

    def or_more(self, other: Level) -> Level:
        """The larger error of the two, one by one."""
        return Level(
            self.key,
            max(self.angle, other.angle),
            max(self.speed, other.speed),
            max(self.tip, other.tip),
        )


NOVICE = Level("novice", 1.5, 0.15, 4.0)
CLUB = Level("club", 0.8, 0.10, 2.5)
EXPERT = Level("expert", 0.35, 0.06, 1.5)
MASTER = Level("master", 0.12, 0.03, 0.8)
PERFECT = Level("perfect", 0.0, 0.0, 0.0)
LEVELS = (NOVICE, CLUB, EXPERT, MASTER, PERFECT)


def level_of(given: Level | str) -> Level:
    """The level by its key, or as it is; ValueError, naming all, if there is none."""
    found = next((level for level in LEVELS if level.key == given), given)
    if isinstance(found, Level):
        return found
    names = ", ".join(level.key for level in LEVELS)
    raise ValueError(f"level must be a Level or one of {names}, not {given!r:.60}")
