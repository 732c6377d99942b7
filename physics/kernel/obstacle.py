"""What stands on a table: how far it is, with what normal it meets a ball, and when.

Nothing else knows what an obstacle looks like. `Wall` (wall.py) is one with a name, and answers the
same way.
"""

from dataclasses import dataclass

from .contact import contact_time
from .kinds import CUSHION, LEAVE
from .leg import first_fall, travelled
from .subset import complex, kernel


@dataclass(slots=True, eq=False)
class Shape:
    """A line: the table is where (inward * p).real > offset."""

    normal: complex = 1 + 0j
    offset: float = 0.0
    inward: complex = 1 - 0j  # the conjugate normal: (inward * v).real is the speed away from it


@kernel
def clearance(wall, p, radius):
    """How far a ball at p is from touching it on the cloth; below 0 in it or behind it."""
    return (wall.inward * p).real - wall.offset - radius


@kernel
def facing(wall, p):
    """The direction, of length 1, in which it pushes a ball at p."""
    return wall.normal


@kernel
def farthest(wall, p, v, a, t):
    """The greatest clearance that a point on that path has within t."""
    inward = wall.inward
    out, pull, gained = (inward * v).real, (inward * a).real, 0.0
    if out > 0.0:  # or else it is farthest at the start, or where the next leg starts
        turns = out < -pull * t
        gained = -0.5 * out * out / pull if turns else travelled(0.0, out, pull, t)
    return (inward * p).real + gained - wall.offset


@kernel
def meet_first(ball, walls, lasts):
    """Which obstacle the ball meets first on its leg, if it does within `lasts`; returns how long
    the leg lasts now."""
    p, v, a, radius = ball.position, ball.velocity, ball.acceleration, ball.radius
    for k in range(len(walls)):
        wall = walls[k]
        inward = wall.inward
        speed, bend = (inward * v).real, (inward * a).real
        if speed < 0.0 or bend < 0.0:
            gap = (inward * p).real - wall.offset - radius
            if speed >= 0.0 and gap >= 0.0 and speed + lasts * bend >= 0.0:
                continue  # away from it, to the end of the leg
            wait = first_fall(gap, speed, bend)
            if wait < lasts:
                lasts, ball.goal, ball.ending = wait, k, CUSHION
    return lasts


@kernel
def meet_first_aloft(ball, walls, rule, lasts):
    """The same in the air: which nose it hits, or which cushion it passes over."""
    for k in range(len(walls)):
        wall = walls[k]
        across, above = nose(wall, ball.position, ball.radius, ball.height, rule)
        speed = (wall.inward * ball.velocity).real
        wait = contact_time(
            complex(across, -above), complex(speed, ball.climb), complex(0.0, -ball.fall),
            ball.radius, lasts,
        )  # fmt: skip
        if wait < lasts:
            lasts, ball.goal, ball.ending = wait, k, CUSHION
        if speed < 0.0:
            wait = max(0.0, -across / speed)
            if wait < lasts:
                lasts, ball.goal, ball.ending = wait, k, LEAVE
    return lasts


@kernel
def nose(wall, p, radius, height, rule):
    """How far the centre is from the nose of the cushion, across, and the nose above the centre.

    On the table a ball touches it at `rule.height` radii above the centre.
    """
    return clearance(wall, p, radius) + radius * rule.level, radius * rule.height - height
