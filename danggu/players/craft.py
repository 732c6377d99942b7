"""How far a level thinks: of a pot, of the one after it too, or of what a miss leaves as well."""

from __future__ import annotations

from dataclasses import dataclass

from .levels import Level


@dataclass(frozen=True, slots=True)
class Craft:
    """What a player thinks of in a game with pockets.

    ways: how many pots it considers, the most likely first.
    speeds: multiples of the speed that just takes the ball to the pocket.
    tips: places of the tip, radii right of and above the centre.
    position: how much it cares for the lie that it leaves, 0 to 1.
    defends: chance of a pot below which it thinks of playing safe.
    safeties: how many strokes it tries that pot nothing.
    banks: how many pots off a cushion it considers when none is likely.
    copies: with its error, of each stroke that is in the running, round by round, and how many
    strokes are kept after each.
    refined: how many of the most promising strokes are varied a little.
    """

    ways: int
    speeds: tuple[float, ...]
    tips: tuple[tuple[float, float], ...]
    position: float
    defends: float
    safeties: int
    banks: int
    copies: tuple[tuple[int, int], ...]
    refined: int


HIGH, LOW, STUN = (0.0, 0.35), (0.0, -0.4), (0.0, 0.0)

PLAIN = Craft(2, (2.4,), (STUN, LOW), 0.0, 0.0, 12, 0, ((2, 1),), 0)
SOUND = Craft(4, (1.5, 2.4), (STUN, HIGH, LOW), 0.6, 0.2, 40, 2, ((4, 4), (8, 1)), 0)
FULL = Craft(
    7, (1.25, 1.8, 2.6, 3.6), (STUN, HIGH, LOW), 1.0, 0.75, 100, 4, ((5, 9), (10, 4), (20, 1)), 2
)


def craft(level: Level) -> Craft:
    """What a player thinks of whose aim errs so much."""
    if level.angle >= 1.2:
        return PLAIN
    return SOUND if level.angle >= 0.6 else FULL
