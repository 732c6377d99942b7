"""A way to score that a search has found: the shot, how sure it is, and how to hit it."""

from __future__ import annotations

from dataclasses import dataclass
from math import atan2, degrees, hypot, sqrt

from danggu.rules.state import NO_CALL, Call
from physics import Shot

from .levels import Attempt

TIP = 0.012  # m: how wide a tip is, which players count offsets in
NO_TIP = 0.125  # tips: less than that is the centre
RANGE = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Tolerance:
    """How far each number of the shot may be off, alone, until a ball of the path is missed.

    By the exact derivatives at the shot itself, to first order; shorter where strokes that are off
    by parts of that do not score.  Each is (lowest, highest), not above and not below 0, or
    infinite where there is no limit.

    angle: degrees.
    speed: share of the speed.
    right, up: of the tip, radii of the ball.
    """

    angle: RANGE
    speed: RANGE
    right: RANGE
    up: RANGE


@dataclass(frozen=True, slots=True)
class Thickness:
    """How the first ball is hit.

    ball: its name.
    eighths: of it that the cue ball covers as it comes: 8 full, 4 half, 0 a graze.
    side: of that ball which is hit, "left" or "right" as the cue ball comes; "full" within a
    hundredth of the middle.
    """

    ball: str
    eighths: float
    side: str


@dataclass(frozen=True, slots=True)
class Tip:
    """Where the tip meets the ball, as on a clock face.

    hour: 1 to 12; 0 in the middle.
    tips: how far from the middle, in widths of a tip (12 mm).
    """

    hour: int
    tips: float

    @classmethod
    def of(cls, right: float, up: float, radius: float) -> Tip:
        """Of an offset in radii of a ball of `radius` m."""
        tips = hypot(right, up) * radius / TIP
        if tips < NO_TIP:
            return cls(0, tips)
        return cls(round(degrees(atan2(right, up)) / 30.0 - 1.0) % 12 + 1, tips)

    def __str__(self) -> str:
        if not self.hour:
            return "centre"
        return f"{self.hour} o'clock, {self.tips:.2g} tips"


@dataclass(frozen=True, slots=True, repr=False)
class Solution:
    """One way to score, the best shot that was found for its path.

    path: names of the balls and walls that the cue ball meets, up to the contact that scores; with
    pockets the ball that is potted and its pocket.
    aim: the stroke without error.
    share: how many such strokes of the level score, 0 to 1: on copies with fresh errors, none of
    those by which the shot was chosen.
    copies: how many those were.
    gain: points that such a stroke brings, on the same copies; 1 for one that wins without any.
    after: share of the next stroke, the best that there is in the positions which this one leaves
    when it scores; None where that was not looked at.
    worth: what it was chosen by: points to be expected from it and from what follows.
    thickness: how the first ball is hit.
    tip: where the tip meets the ball.
    tolerance: how far the shot may be off; None where no derivatives are known.
    call: what has to be declared before the stroke.
    """

    path: tuple[str, ...]
    aim: Attempt
    share: float
    copies: int
    gain: float
    after: float | None
    worth: float
    thickness: Thickness | None
    tip: Tip
    tolerance: Tolerance | None
    call: Call = NO_CALL

    def __repr__(self) -> str:
        sure = f"{100.0 * self.share:.0f} % ±{100.0 * self.error:.0f}"
        return f"<Solution {' '.join(self.path)}: {sure}, tip {self.tip}>"

    @property
    def shot(self) -> Shot:
        """What `physics.simulate` takes; `physics.CueStroke.of(shot, ball)` is the cue's part."""
        return self.aim.shot()

    @property
    def error(self) -> float:
        """The standard deviation of the share: of the chance in its copies."""
        return sqrt(self.share * (1.0 - self.share) / self.copies) if self.copies else 0.0
