"""How far strokes go wrong, for many at once: the levels of players, and FastFiz's noise."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from danggu.players.levels import LEVELS, MISCUE, SLOWEST, Level

DRAWS = 5  # numbers that a stroke's errors need


class Aims(NamedTuple):
    """Strokes, (strokes,) each.

    angle: direction, degrees.
    speed: of the ball, m/s.
    right, up: offset of the tip from the centre in radii of the ball, seen from behind.
    """

    angle: Any
    speed: Any
    right: Any
    up: Any


@dataclass(frozen=True, slots=True)
class Noise:
    """Standard deviations of a stroke, each independent and normal.

    angle: degrees.
    share: of the speed, relative.
    speed: of the speed, m/s.
    tip: mm on the ball, in each direction.
    elevation: of a cue that should be level, degrees; it is never below level.
    """

    angle: float = 0.0
    share: float = 0.0
    speed: float = 0.0
    tip: float = 0.0
    elevation: float = 0.0

    @classmethod
    def of(cls, level: Level) -> Noise:
        """That of a level of players."""
        return cls(level.angle, level.speed, 0.0, level.tip)

    def shots(self, aims: Aims, errors: Any, radius: float) -> Any:
        """(strokes, 6): the shots that come of the aims, as `physics.simulate_many` takes them.

        errors: (strokes, DRAWS) normal numbers.
        radius: of the ball, m.
        """
        tip = 1e-3 * self.tip / radius
        right, up = aims.right + tip * errors[:, 2], aims.up + tip * errors[:, 3]
        out = np.sqrt(right * right + up * up)
        within = MISCUE / np.maximum(out, MISCUE)
        spread = self.share * aims.speed + self.speed
        speed = np.maximum(SLOWEST, aims.speed + spread * errors[:, 1])
        raised = np.radians(self.elevation) * abs(errors[:, 4])
        side = 2.5 * speed * right * within
        follow = 2.5 * speed * up * within
        # a raised cue presses the ball down beside its centre; its angle is small
        columns = speed, aims.angle + self.angle * errors[:, 0], follow, side * raised, side
        return np.stack([*columns, np.zeros(len(speed))], axis=1)


FASTFIZ = Noise(angle=0.125, speed=0.075, tip=0.5, elevation=0.1)
"""Of the computer pool tournaments (Archibald, Altman and Shoham, 2009)."""

NOISES = {**{level.key: Noise.of(level) for level in LEVELS}, "fastfiz": FASTFIZ}


def noise_of(given: str | Noise | Level | None) -> Noise:
    """The noise by its name, by a level of players, or as it is; ValueError if it is none."""
    if given is None:
        return Noise()
    if isinstance(given, Level):
        return Noise.of(given)
    if isinstance(given, str) and given in NOISES:
        return NOISES[given]
    if not isinstance(given, Noise):
        raise ValueError(f"noise must be None, a Noise or one of {', '.join(NOISES)}: {given!r}")
    return given
