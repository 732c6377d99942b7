"""The lag for the first stroke: two balls to the far cushion and back (WPA 1.2, UMB 3.2)."""

from __future__ import annotations

from dataclasses import dataclass

from .stroke import Stroke


@dataclass(frozen=True, slots=True)
class Lag:
    """One player's lag.

    gap: from the near cushion to where the ball came to rest, m.
    good: whether it may win.
    """

    gap: float
    good: bool = True


def lagged(done: Stroke, gap: float, *, far: str, near: str, pool: bool = True) -> Lag:
    """A player's lag read from the stroke.

    gap: from the near cushion to where the ball came to rest, m.
    far: name of the cushion that must be met.
    near: name of the cushion to stop close to.
    pool: True for the WPA's rule (the far cushion once, no side cushion, no pocket), False for the
    UMB's (the far cushion, and no other ball).
    """
    walls = [rail.wall for rail in done.rails if rail.ball == done.cue]
    sides = [wall for wall in walls if wall not in (far, near)]
    good = not done.lost and not done.first and far in walls
    return Lag(gap, good and not (pool and (walls.count(far) != 1 or sides)))


def winner(first: Lag, second: Lag) -> int | None:
    """The player who wins the lag, 0 or 1; None if it is played again."""
    if first.good != second.good:
        return 0 if first.good else 1
    if not first.good or first.gap == second.gap:
        return None
    return 0 if first.gap < second.gap else 1
