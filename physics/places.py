"""Do the balls fit where they were placed: inside the walls, and not into one another?"""

from collections.abc import Iterable, Iterator, Sequence
from math import hypot

from .ball import Ball
from .kernel.body import Rule
from .kernel.motion import length
from .kernel.obstacle import Shape, nose
from .laws import cushion_rule
from .wall import Obstacle

OVERLAP = 1e-9  # m: how far things may overlap, by rounding, in a scene typed by hand


def check_places(
    balls: Sequence[Ball],
    walls: Sequence[Obstacle],
    fresh: Sequence[Obstacle],
    rule: Rule,
    dt: float,
) -> None:
    """ValueError, naming the ball, if one that was placed lies outside the walls, in a post, over a
    pocket or in another ball, or if any lies so at a new one of these.

    Overlaps left by an engine of fixed steps are not the caller's fault. rule: the cushions'.
    dt: the engine's step, s, or 0.
    """
    # fixed steps notice a contact when things overlap by what they move in a step
    fastest = max((length(complex(*ball.velocity)) for ball in balls), default=0.0)
    slack = 2.0 * fastest * dt
    here = [ball for ball in balls if not ball.gone]
    for ball in here:
        (x, y), r = ball.position, ball.radius
        for wall in walls if ball.put else fresh:
            if _beside(wall.shape, x, y, r) and _depth(ball, wall, rule) > slack + OVERLAP:
                where = "outside" if wall.kind == "line" else "in"
                raise ValueError(f"{ball!r} is {where} the {wall.noun} {wall.name or wall!r}")
    for ball, other in overlapping(here, slack + OVERLAP):
        if ball.put or other.put:
            raise ValueError(f"{ball!r} and {other!r} overlap")


def overlapping(balls: Iterable[Ball], slack: float) -> Iterator[tuple[Ball, Ball]]:
    """The pairs that overlap by more than slack, m."""
    here = sorted(balls, key=lambda ball: ball.position[0] - ball.radius)
    spots = [(*ball.position, ball.height + ball.body.lift, ball.radius) for ball in here]
    for i, (x, y, z, r) in enumerate(spots):
        for k in range(i + 1, len(here)):
            u, v, w, s = spots[k]
            if u - s > x + r:
                break
            if hypot(u - x, v - y, w - z) < r + s - slack:
                yield here[i], here[k]


def _beside(shape: Shape, x: float, y: float, r: float) -> bool:
    """Do the boxes around it and a ball touch?  On a table with pockets they seldom do."""
    across = shape.west <= x + r and shape.east >= x - r
    return across and shape.south <= y + r and shape.north >= y - r


def _depth(ball: Ball, wall: Obstacle, rule: Rule) -> float:
    """How far the ball is in the wall, m; in the air only the wall's nose is in its way."""
    if not wall.pushes:
        return -wall.distance(ball.position) if ball.height == 0.0 else 0.0
    if wall.own_law is not None:
        rule = cushion_rule(wall.own_law, rule.parting, rule)
    across, above = nose(wall.shape, complex(*ball.position), ball.radius, ball.height, rule)
    if ball.height > 0.0 and across > 0.0:
        return ball.radius - hypot(across, above)
    return ball.radius - wall.distance(ball.position)
