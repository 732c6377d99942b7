"""The open sides of a table that does not close: when a ball's centre leaves through one.

An opening is a segment with the table on its left. Nothing is there: only the way out counts.
"""

from .kinds import LEAVE
from .leg import first_fall, travelled
from .obstacle import NOBODY, beside
from .subset import inf, kernel


@kernel
def leave_through(ball, openings, lasts):
    """Through which of them the ball leaves first, if it does within `lasts`; returns how long the
    leg lasts now.  Their numbers go down from NOBODY, so that none is a wall's."""
    p, v, a = ball.position, ball.velocity, ball.acceleration
    for k in range(len(openings)):
        wait = go_out(openings[k], p, v, a)
        if wait < lasts and beside(openings[k], travelled(p, v, a, wait)):
            lasts, ball.goal, ball.ending = wait, NOBODY - k, LEAVE
    return lasts


@kernel
def go_out(opening, p, v, a):
    """When that path crosses the line of the opening outward: a parabola does so once.

    What is outside has to come in first.
    """
    gap = (opening.inward * p).real - opening.offset
    speed, bend = (opening.inward * v).real, (opening.inward * a).real
    if gap < 0.0 and (speed <= 0.0 or bend >= 0.0 or speed * speed <= 2.0 * bend * gap):
        return inf
    return first_fall(gap, speed, bend)


@kernel
def just_left(openings, p, v, radius):
    """The number of the opening through which a ball there has come out, not farther than its
    radius, or NOBODY: for fixed steps, which notice it afterwards."""
    for k in range(len(openings)):
        inward = openings[k].inward
        gap = (inward * p).real - openings[k].offset
        if -radius <= gap <= 0.0 and (inward * v).real < 0.0 and beside(openings[k], p):
            return k
    return NOBODY
