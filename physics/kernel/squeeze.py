"""A ball between walls that leave it no room: it rolls on along them, or out.

Between two that face each other it would hit both in turn, with the least speed of parting each
time, as often as there is no room between them; and no impulse makes it part from both at once.
"""

from .cluster import TOUCHING
from .lasting import HOP
from .motion import length
from .obstacle import clearance, facing, holds, opposed, unit
from .subset import inf, kernel

CROSSING = 1.0  # s
DRIFT = 1e-14  # of the speed: above what rounding takes it to a wall with


@kernel
def room_behind(ball, normal, walls):
    """How far behind a ball the wall is that faces the one it leans on; inf if none is so near that
    there is no room to hop."""
    least = inf
    for k in range(len(walls)):
        behind = holds(walls[k], ball.position, ball.radius, HOP * ball.radius)
        if behind and opposed(facing(walls[k], ball.position), normal):
            least = min(least, clearance(walls[k], ball.position, ball.radius))
    return least


@kernel
def cross(ball, normal, gap):
    """It rolls on along the walls, and over the gap between them so slowly that it is seldom at
    one."""
    roll_along(ball, 1j * normal)
    if gap > 0.0:
        over = max(gap / CROSSING, DRIFT * length(ball.velocity)) * normal
        ball.velocity += over
        ball.roll += over


@kernel
def release(ball, walls, parting):
    """A ball that rattles between walls too near to tell apart rolls out, along their bisector.

    Between two walls that face each other there is no way out: it rolls on along them.
    """
    out, normal = 0j, 1.0 + 0j
    for k in range(len(walls)):
        if holds(walls[k], ball.position, ball.radius, TOUCHING * ball.radius):
            normal = facing(walls[k], ball.position)
            out += normal
    if opposed(out, 0j):
        roll_along(ball, 1j * normal)
        return
    out = unit(out)
    speed = max((out.conjugate() * ball.velocity).real, parting)
    turning = min(max((out.conjugate() * ball.roll).real, 0.0), speed)  # no energy beyond the floor
    go_along(ball, out, speed, turning)


@kernel
def roll_along(ball, way):
    """It keeps of its motion what is along that way."""
    inward = way.conjugate()
    go_along(ball, way, (inward * ball.velocity).real, (inward * ball.roll).real)


@kernel
def go_along(ball, way, speed, turning):
    ball.velocity, ball.roll = speed * way, turning * way
    ball.side = 0.0
    ball.trapped = 0
