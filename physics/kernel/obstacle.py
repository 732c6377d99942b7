"""What stands on a table: how far it is, with what normal it meets a ball, and when.

Nothing else knows what an obstacle looks like. `Wall` (wall.py) and its like are obstacles with a
name, and answer the same way.
"""

from dataclasses import dataclass

from .contact import contact_time, rise_time
from .kinds import CUSHION, DROP, LAND, LEAVE
from .laws import law_at
from .leg import first_fall, swept, travelled
from .motion import length
from .subset import complex, inf, kernel

LINE, SEGMENT, ARC, POST, POCKET = 0, 1, 2, 3, 4
NOBODY = -1
FACING = 1e-5  # the length of the sum of the normals of two walls that face each other: it takes
# about one over that many hits to hop out from between two
MARGIN = 1e-4  # radii from the end of a rail, and of the speed across it: above all rounding


@dataclass(slots=True, eq=False)
class Shape:
    """What it is, and its numbers.

    Of a line, the table is where (inward * p).real > offset. A segment is a part of a line, an arc
    of a circle: both have two sides and two ends. A post is a disc in the way, a pocket a hole that
    a ball falls into when its centre is over it.
    """

    normal: complex = 1 + 0j
    offset: float = 0.0
    inward: complex = 1 - 0j  # the conjugate normal: (inward * v).real is the speed away from it
    kind: int = 0
    size: float = 0.0  # a segment's length, the radius of what is round
    centre: complex = 0j  # of what is round
    first: complex = 0j  # the ends of a segment or an arc
    last: complex = 0j
    middle: complex = 1 + 0j  # the direction from an arc's centre to its middle
    span: float = -1.0  # and the cosine of half of its angle
    west: float = -inf  # a box around it
    east: float = inf
    south: float = -inf
    north: float = inf


@kernel
def clearance(wall, p, radius):
    """How far a ball at p is from touching it on the cloth; below 0 in it or behind a line.

    Of a pocket, how far the ball's centre is from its rim.
    """
    if wall.kind == LINE:
        return (wall.inward * p).real - wall.offset - radius
    if wall.kind == POCKET:
        return length(p - wall.centre) - wall.size
    if wall.kind == POST:
        return length(p - wall.centre) - wall.size - radius
    if not beside(wall, p):
        return min(length(p - wall.first), length(p - wall.last)) - radius
    if wall.kind == SEGMENT:
        return abs((wall.inward * p).real - wall.offset) - radius
    return abs(length(p - wall.centre) - wall.size) - radius


@kernel
def facing(wall, p):
    """The direction, of length 1, in which it pushes a ball at p."""
    if wall.kind == LINE:
        return wall.normal
    if wall.kind >= POST:
        return unit(p - wall.centre)
    if not beside(wall, p):
        first, last = p - wall.first, p - wall.last
        return unit(first if length(first) < length(last) else last)
    if wall.kind == SEGMENT:
        return wall.normal if (wall.inward * p).real >= wall.offset else -wall.normal
    q = p - wall.centre
    return -unit(q) if length(q) <= wall.size else unit(q)


@kernel
def opposed(a, b):
    """Are two normals those of walls that face each other?"""
    return length(a + b) < FACING


@kernel
def unit(z):
    """Its direction; any, if it has none."""
    far = length(z)
    return 1.0 / far * z if far > 0.0 else 1.0 + 0.0 * z


@kernel
def beside(wall, p):
    """Is the point beside the line, the segment or the arc, and not beyond its ends?"""
    if wall.kind == SEGMENT:
        since, left = wall.inward * (wall.first - p), wall.inward * (p - wall.last)
        return since.imag >= 0.0 and left.imag >= 0.0  # both ends alike, to the last bit
    if wall.kind == ARC:
        q = p - wall.centre
        return (wall.middle.conjugate() * q).real >= wall.span * length(q)
    return wall.kind == LINE


@kernel
def holds(wall, p, radius, near):
    """Does it keep a ball at p, no farther away than `near`, from going on?  No pocket does."""
    return wall.kind != POCKET and clearance(wall, p, radius) <= near


@kernel
def farthest(wall, p, v, a, t):
    """The greatest clearance that a point on that path has within t, of a line."""
    inward = wall.inward
    out, pull, gained = (inward * v).real, (inward * a).real, 0.0
    if out > 0.0:  # or else it is farthest at the start, or where the next leg starts
        turns = out < -pull * t
        gained = -0.5 * out * out / pull if turns else travelled(0.0, out, pull, t)
    return (inward * p).real + gained - wall.offset


@kernel
def meet_first(ball, walls, lasts):
    """Which of these lines the ball meets first on its leg, if it does within `lasts`; returns how
    long the leg lasts now."""
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
def meet_any(ball, walls, lasts):
    """The same of obstacles of all kinds: those whose boxes the leg touches are asked."""
    p, v, a, radius = ball.position, ball.velocity, ball.acceleration, ball.radius
    west, east, south, north = -inf, inf, -inf, inf
    if lasts < inf:
        q, r = travelled(p, v, a, lasts), (1.0 + MARGIN) * radius
        west, east = swept(p.real, q.real, v.real, a.real, lasts)
        south, north = swept(p.imag, q.imag, v.imag, a.imag, lasts)
        west, east, south, north = west - r, east + r, south - r, north + r
    for k in range(len(walls)):
        wall = walls[k]
        if wall.west > east or wall.east < west or wall.south > north or wall.north < south:
            continue
        wait = touch(wall, p, v, a, radius, lasts)
        if wait < lasts:
            lasts, ball.goal = wait, k
            ball.ending = DROP if wall.kind == POCKET else CUSHION
    return lasts


@kernel
def meet_framed(ball, walls, frame, lasts):
    """The same where the ball stays inside the frame and meets no more than one of its sides, well
    within a straight part of it: then nothing else has to be asked.  Below 0 where that is not
    certain to the last bit.

    The frame lists how many walls each side has, and their numbers (framing.py).
    """
    p, v, a, radius = ball.position, ball.velocity, ball.acceleration, ball.radius
    margin, slow = MARGIN * radius, MARGIN * (abs(v.real) + abs(v.imag))
    side, m = NOBODY, 0
    if len(frame) == 0:
        return -1.0
    while m < len(frame):
        wall = walls[frame[m + 1]]
        inward = wall.inward
        gap = (inward * p).real - wall.offset - radius
        speed, bend = (inward * v).real, (inward * a).real
        if gap < margin and (
            gap < -margin or speed < slow or straight(walls, frame, m, p, margin) == NOBODY
        ):
            return -1.0  # behind it, along it, or in a mouth
        if speed < 0.0 or (bend < 0.0 and speed + lasts * bend < 0.0):
            wait = first_fall(gap, speed, bend)
            if wait < lasts:
                lasts, side = wait, m
        m += frame[m] + 1
    if side != NOBODY:
        k = straight(walls, frame, side, travelled(p, v, a, lasts), margin)
        if k == NOBODY or -(walls[k].inward * (v + lasts * a)).real < slow:
            return -1.0
        ball.goal, ball.ending = k, CUSHION
    return lasts


@kernel
def straight(walls, frame, m, p, margin):
    """Which wall of the side that is listed from m on has the point beside it, and no end near."""
    for n in range(m + 1, m + 1 + frame[m]):
        wall = walls[frame[n]]
        along = (wall.inward * (wall.first - p)).imag
        if wall.kind == LINE or margin <= along <= wall.size - margin:
            return frame[n]
    return NOBODY


@kernel
def touch(wall, p, v, a, radius, horizon):
    """When a ball on that path meets it, if before the horizon; else that or later."""
    if wall.kind == LINE:
        gap = (wall.inward * p).real - wall.offset - radius
        return first_fall(gap, (wall.inward * v).real, (wall.inward * a).real)
    if wall.kind == POCKET:
        return contact_time(wall.centre - p, -v, -a, wall.size, horizon)
    if wall.kind == SEGMENT:
        wait = meet_side(wall, p, v, a, radius)
        return min(wait, meet_round(wall, p, v, a, radius, min(wait, horizon)))
    return meet_round(wall, p, v, a, radius, horizon)


@kernel
def meet_round(wall, p, v, a, radius, horizon):
    """When it meets a post, the sides of an arc, or the ends of an arc or a segment."""
    if wall.kind == POST:
        return contact_time(wall.centre - p, -v, -a, wall.size + radius, horizon)
    wait = inf
    if wall.kind == ARC:
        if radius <= wall.size:  # or else it does not fit inside
            wait = meet_inside(wall, p, v, a, wall.size - radius, horizon)
        wait = min(wait, meet_outside(wall, p, v, a, wall.size + radius, horizon))
        horizon = min(horizon, wait)
    wait = min(wait, contact_time(wall.first - p, -v, -a, radius, horizon))
    return min(wait, contact_time(wall.last - p, -v, -a, radius, horizon))


@kernel
def meet_side(wall, p, v, a, radius):
    """When the ball meets one of the two sides of a segment, and not its ends."""
    far = (wall.inward * p).real - wall.offset
    speed, bend = (wall.inward * v).real, (wall.inward * a).real
    wait = come_down(far, speed, bend, radius)
    if wait < inf and not beside(wall, travelled(p, v, a, wait)):
        wait = inf
    back = come_down(-far, -speed, -bend, radius)
    if back < wait and beside(wall, travelled(p, v, a, back)):
        return back
    return wait


@kernel
def come_down(far, speed, bend, radius):
    """When a ball comes down on this side of a line that it is so far from: a parabola does so
    once.

    One that is behind the line has to come out first.
    """
    gap = far - radius
    if far <= 0.0 and (speed <= 0.0 or bend >= 0.0 or speed * speed <= 2.0 * bend * gap):
        return inf
    return first_fall(gap, speed, bend)


@kernel
def meet_inside(wall, p, v, a, reach, horizon):
    """When the centre, within the arc's circle, gets as far out as `reach` beside the arc.

    A path crosses a circle four times at most: through the gap of the arc, out and in again.
    """
    time = 0.0
    for turn in range(2):
        q, w = travelled(p, v, a, time) - wall.centre, v + time * a
        far = length(q)
        if turn == 1 or far > wall.size or (far > reach and not beside(wall, p)):
            time += contact_time(-q, -w, -a, reach, horizon - time)  # it has to come in first
            if time >= horizon:
                return inf
            q, w = travelled(p, v, a, time) - wall.centre, v + time * a
        time += rise_time(q, w, a, reach, horizon - time)
        if time >= horizon or beside(wall, travelled(p, v, a, time)):
            return time
    return inf


@kernel
def meet_outside(wall, p, v, a, reach, horizon):
    """The same from behind the arc: when the centre gets as near as `reach`."""
    time = 0.0
    for turn in range(2):
        q, w = travelled(p, v, a, time) - wall.centre, v + time * a
        if turn == 1 or length(q) <= wall.size:  # it has to go out first
            time += rise_time(q, w, a, reach, horizon - time)
            if time >= horizon:
                return inf
            q, w = travelled(p, v, a, time) - wall.centre, v + time * a
        time += contact_time(-q, -w, -a, reach, horizon - time)
        if time >= horizon or beside(wall, travelled(p, v, a, time)):
            return time
    return inf


@kernel
def meet_first_aloft(ball, walls, rules, common, lasts):
    """In the air: which nose it hits, which cushion it passes over, or which pocket it comes down
    in."""
    for k in range(len(walls)):
        wall, rule = walls[k], law_at(k, rules, common)
        if wall.kind <= SEGMENT:
            wait, over = meet_nose(wall, ball, rule, lasts)
        else:
            wait, over = inf, pass_over(wall, ball, lasts)
        if wall.kind != LINE and wall.kind != POCKET:
            wait = min(wait, meet_upright(wall, ball, rule, min(wait, lasts)))
        if wait < lasts:
            lasts, ball.goal, ball.ending = wait, k, CUSHION
        if over < lasts:
            lasts, ball.goal, ball.ending = over, k, LEAVE
    if ball.ending == LAND:
        spot = ball.position + lasts * ball.velocity
        for k in range(len(walls)):
            if walls[k].kind == POCKET and clearance(walls[k], spot, 0.0) < 0.0:
                ball.goal, ball.ending = k, DROP
            elif ball.ending == LAND and came_down_on(walls[k], spot, ball.radius):
                ball.goal, ball.ending = k, LEAVE
    return lasts


@kernel
def came_down_on(wall, p, radius):
    """Would a ball that lands there lie in it, having come over its top?"""
    if wall.kind == LINE or wall.kind == POCKET:
        return False
    return clearance(wall, p, radius) < -MARGIN * radius


@kernel
def meet_nose(wall, ball, rule, lasts):
    """When a ball in the air hits the nose of a line or a segment, and when it passes over it, out
    of the table: each before `lasts`, or inf."""
    p, v, radius = ball.position, ball.velocity, ball.radius
    gap, speed = (wall.inward * p).real - wall.offset - radius, (wall.inward * v).real
    behind = wall.kind == SEGMENT and gap + radius < 0.0
    if behind:
        gap, speed = -(gap + radius) - radius, -speed
    across, above = gap + radius * rule.level, radius * rule.height - ball.height
    wait = contact_time(
        complex(across, -above), complex(speed, ball.climb), complex(0.0, -ball.fall), radius, lasts
    )
    if wait < lasts and not beside(wall, p + wait * v):
        wait = inf
    if wait == 0.0 and length(complex(across, above)) < radius * (1.0 - MARGIN):
        wait = inf  # it came down over the nose's end, and in it: a push would not part them
    if wall.kind == SEGMENT:  # over where it stands, so that it is over one or the other at a bend
        across = gap + radius
    over = max(0.0, -across / speed) if speed < 0.0 and not behind else inf
    if over < lasts and clearance(wall, p + over * v, MARGIN * radius) > 0.0 and wall.kind != LINE:
        over = inf
    return wait, over


@kernel
def pass_over(wall, ball, lasts):
    """When a ball in the air passes over an arc, out of its circle; it may come in first."""
    if wall.kind != ARC:
        return inf
    return meet_inside(wall, ball.position, ball.velocity, 0j, wall.size, lasts)


@kernel
def meet_upright(wall, ball, rule, lasts):
    """When a ball in the air hits what is round, which stands upright as high as a nose.

    What it overlaps already it is above, having come over the top.
    """
    if clearance(wall, ball.position, ball.radius) < -MARGIN * ball.radius:
        return inf
    wait = meet_round(wall, ball.position, ball.velocity, 0j, ball.radius, lasts)
    if wait >= lasts:
        return inf
    if wall.kind == SEGMENT and beside(wall, ball.position + wait * ball.velocity):
        return inf  # there it has a nose
    height = travelled(ball.height, ball.climb, -ball.fall, wait)
    return wait if height < ball.radius * (1.0 + rule.height) else inf


@kernel
def nose(wall, p, radius, height, rule):
    """How far the centre is from the nose of the cushion, across, and the nose above the centre.

    On the table a ball touches it at `rule.height` radii above the centre. What is upright, it
    meets level.
    """
    if wall.kind <= SEGMENT and beside(wall, p):
        return clearance(wall, p, radius) + radius * rule.level, radius * rule.height - height
    return max(clearance(wall, p, 0.0), MARGIN * radius), 0.0  # though it may have come down in it
