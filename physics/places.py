"""Do the balls fit where somebody has put them: inside the walls, and not into one another?"""

from collections.abc import Sequence
from math import hypot

from .ball import Ball
from .kernel.body import Rule
from .kernel.flight import nose
from .wall import Wall

OVERLAP = 1e-9  # m: how far things may overlap, by rounding, in a scene that somebody typed


def check_places(balls: Sequence[Ball], walls: Sequence[Wall], rule: Rule, slack: float) -> None:
    """ValueError, naming the ball, if one lies outside the walls or in another one.

    rule: the cushions'.  slack: how far things may overlap beyond OVERLAP, m.
    """
    here = [ball for ball in balls if ball.phase != "off"]
    for ball in here:
        for wall in walls:
            if _depth(ball, wall, rule) > slack + OVERLAP:
                raise ValueError(f"{ball!r} is outside the wall {wall.name or wall!r}")
    here.sort(key=lambda ball: ball.position[0] - ball.radius)
    spots = [(*ball.position, ball.height + ball.body.lift, ball.radius) for ball in here]
    for i, (x, y, z, r) in enumerate(spots):
        for k in range(i + 1, len(here)):
            u, v, w, s = spots[k]
            if u - s > x + r:
                break
            if hypot(u - x, v - y, w - z) < r + s - slack - OVERLAP:
                raise ValueError(f"{here[i]!r} and {here[k]!r} overlap")


def _depth(ball: Ball, wall: Wall, rule: Rule) -> float:
    """How far the ball is in the wall, m; in the air only the wall's nose is in its way."""
    gap = wall.distance(ball.position) - ball.radius
    across, above = nose(gap, ball.radius, ball.height, rule)
    if ball.height > 0.0 and across > 0.0:
        return ball.radius - hypot(across, above)
    return -gap
