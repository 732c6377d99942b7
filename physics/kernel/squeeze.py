"""A ball between walls that leave it no room: it rolls on along them, or out.

Between two that face each other it would hit both in turn, with the least speed of parting each
time, as often as there is no room between them; and no impulse makes it part from both at once.
"""

from .cluster import TOUCHING
from .kinds import CUSHION, DROP
from .lasting import HOP
from .motion import length
from .obstacle import ARC, POCKET, facing, holds, opposed, touch, unit
from .plastic import ROUNDING, SQUEEZED
from .subset import kernel

NARROW = 3e-5  # radii: between circles it hops on, but not in less room, where it would do so for
# 100 000 events a second


@kernel
def clamped(ball, goal, walls):
    """Is there a wall that faces the one it leans on, so near that there is no room to hop?"""
    wall, p, radius = walls[goal], ball.position, ball.radius
    inside = within(wall, p)
    if inside and wall.size - radius <= HOP * radius:
        return True
    normal = facing(wall, p)
    for k in range(len(walls)):
        near = NARROW if inside or within(walls[k], p) else HOP
        if holds(walls[k], p, radius, near * radius) and opposed(facing(walls[k], p), normal):
            return True
    return False


@kernel
def within(wall, p):
    """Is the point within the circle of an arc?"""
    return wall.kind == ARC and length(p - wall.centre) <= wall.size


@kernel
def meet_others(ball, walls, lasts):
    """The first obstacle that a squeezed ball meets, but for walls that it goes along: rounding
    alone would take it to those, again and again."""
    p, v, a, radius = ball.position, ball.velocity, ball.acceleration, ball.radius
    for k in range(len(walls)):
        wall = walls[k]
        if holds(wall, p, radius, HOP * radius) and along(wall, p, v, a):
            continue
        wait = touch(wall, p, v, a, radius, lasts)
        if wait < lasts:
            lasts, ball.goal = wait, k
            ball.ending = DROP if wall.kind == POCKET else CUSHION
    return lasts


@kernel
def along(wall, p, v, a):
    """Does the motion, but for rounding, not lead into the wall?"""
    inward = facing(wall, p).conjugate()
    if within(wall, p):
        return False
    out, pull = (inward * v).real, (inward * a).real
    return out >= -ROUNDING * length(v) and pull >= -ROUNDING * length(a)


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
    ball.trapped = 0


@kernel
def roll_along(ball, way):
    """It keeps of its motion what is along that way; nothing, if it was squeezed just now."""
    inward = way.conjugate()
    speed, turning = (inward * ball.velocity).real, (inward * ball.roll).real
    if ball.trapped >= SQUEEZED:
        speed = turning = 0.0
    go_along(ball, way, speed, turning)
    ball.trapped = SQUEEZED


@kernel
def go_along(ball, way, speed, turning):
    ball.velocity, ball.roll = speed * way, turning * way
    ball.side = 0.0
