"""From event to event."""

from .cluster import TOUCHING, blows, collide, crowded, crowded_near, gather
from .contact import first_fall, meeting
from .flight import LEAVES, aloft, hit_aloft, hit_nose, land, leave_table, plan_flight
from .grid import NOBODY, locate, pass_by, plan_crossing, plan_near, sooner
from .impulses import WALL
from .lasting import FEW, FEWER, NEVER, forget, lean, leans, meets_slowly, rests_on
from .laws import hit_ball, hit_wall
from .motion import AIRBORNE, OFF, RESTING, carry, length, motion, settle, swept
from .subset import complex, inf, kernel, whole

PHASE_ENDS = -1
UNKNOWN = -1
INSTANT = 1e-8  # s: no contact of real balls is so short; a leg that short goes nowhere
FACING = 1e-8  # of walls: the length of the sum of their normals when they face each other
PATIENCE = 16  # how many of them at cushions make a trap
PHASE, CUSHION, PAIR, CLUSTER, LASTING, NOTHING, UNSOLVED = 0, 1, 2, 3, 4, 5, 6  # an event is


@kernel
def plan_leg(ball, walls, cloth, rule):
    """How the ball moves from now on, until when, and where it may come."""
    if aloft(ball):
        ball.goal = PHASE_ENDS
        lasts = plan_flight(ball, walls, cloth, rule)
        ball.leg_end = ball.since + lasts
        reach(ball, ball.position, ball.velocity, 0j, lasts)
        return
    phase, a, lasts = motion(ball.velocity, ball.roll, cloth)
    if phase == RESTING:
        ball.velocity = 0j
        ball.roll = 0j
    ball.phase = phase
    ball.acceleration = a
    ball.goal = PHASE_ENDS
    p, v = ball.position, ball.velocity
    if phase != RESTING:
        for k in range(len(walls)):
            wall = walls[k]
            inward = wall.inward
            speed, bend = (inward * v).real, (inward * a).real
            if speed < 0.0 or bend < 0.0:
                wait = first_fall((inward * p).real - wall.offset - ball.radius, speed, bend)
                if wait < lasts:
                    lasts, ball.goal = wait, k
    ball.leg_end = ball.since + lasts
    reach(ball, p, v, a, lasts)


@kernel
def reach(ball, p, v, a, lasts):
    """The box that the ball sweeps on its leg: the whole plane if the leg never ends, nothing if
    the ball is off the table."""
    r = ball.radius
    if ball.phase == RESTING:
        ball.west, ball.east, ball.south, ball.north = (
            p.real - r,
            p.real + r,
            p.imag - r,
            p.imag + r,
        )
    elif lasts == inf:
        far = -inf if ball.phase == OFF else inf
        ball.west, ball.east, ball.south, ball.north = -far, far, -far, far
    else:
        low, high = swept(p.real, v.real, a.real, lasts)
        ball.west, ball.east = low - r, high + r
        low, high = swept(p.imag, v.imag, a.imag, lasts)
        ball.south, ball.north = low - r, high + r


@kernel
def start_leg(i, scene):
    """Ball i goes on from where it is, as it is."""
    ball = scene.balls[i]
    plan_leg(ball, scene.walls, scene.cloth, scene.cushion_rule)
    if scene.celled:
        scene.grid.seats[i].turn += 1
        plan_crossing(i, ball, ball.since, scene.grid)


@kernel
def plan_meetings(i, scene):
    """Enter in the calendar which ball ball i will meet first, and when."""
    if scene.celled:
        plan_near(i, scene.balls, scene.grid)
    else:
        plan_table(i, scene.balls, scene.meetings)


# Compiled, passing a scene means passing every array in it, which takes longer than planning a leg.
# So the functions that every event calls without cells take only what they need.


@kernel
def plan_table(i, balls, meetings):
    """Without cells there is a table of all meetings."""
    n = len(balls)
    ball = balls[i]
    west, east, south, north = ball.west, ball.east, ball.south, ball.north
    ball.meets, ball.partner = inf, NOBODY
    for j in range(n):
        if j == i:
            continue
        other = balls[j]
        when = inf
        if (
            other.west <= east
            and other.east >= west
            and other.south <= north
            and other.north >= south
        ):
            when = meeting(ball, other)
        meetings[n * i + j] = meetings[n * j + i] = when
        if other.partner == i or (when < inf and sooner(when, i, other)):
            appoint(j, i, when, balls, meetings)
        if when < ball.meets:
            ball.meets, ball.partner = when, j
    ball.next = ball.meets if ball.meets < ball.leg_end else ball.leg_end


@kernel
def appoint(j, i, when, balls, meetings):
    """Enter for ball j when it will meet ball i, and which ball it now meets first."""
    ball = balls[j]
    if sooner(when, i, ball):
        ball.meets, ball.partner = when, i
    else:
        n = len(balls)
        ball.meets, ball.partner = inf, NOBODY
        for k in range(n):
            if meetings[n * j + k] < ball.meets:
                ball.meets, ball.partner = meetings[n * j + k], k
    ball.next = ball.meets if ball.meets < ball.leg_end else ball.leg_end


@whole
def plan(scene):
    """Start over from balls that have been placed or pushed."""
    balls, meetings, grid = scene.balls, scene.meetings, scene.grid
    n = len(balls)
    for k in range(len(meetings)):
        meetings[k] = inf
    for i in range(n):
        ball = balls[i]
        ball.trapped = 0
        forget(ball)
        if scene.celled:
            locate(i, ball, grid)
            start_leg(i, scene)
        else:
            plan_leg(ball, scene.walls, scene.cloth, scene.cushion_rule)
        ball.meets, ball.partner, ball.next = inf, NOBODY, ball.leg_end
    for i in range(n):
        if scene.celled:
            plan_near(i, balls, grid)
        elif balls[i].phase != RESTING:
            plan_table(i, balls, meetings)


@kernel
def soonest(scene):
    """The ball that the next event belongs to."""
    return scene.grid.tree[1] if scene.celled else earliest(scene.balls)


@kernel
def earliest(balls):
    """The ball whose next event is first."""
    first, time = 0, inf
    for i in range(len(balls)):
        if balls[i].next < time:
            first, time = i, balls[i].next
    return first


@whole
def happen(i, scene):
    """The next event of ball i; all that it touched is planned again.

    Returns what it was and with what: the wall, the other ball, or how many contacts.
    """
    balls, cloth = scene.balls, scene.cloth
    if scene.celled and pass_by(i, balls, scene.grid):
        return NOTHING, NOBODY
    ball = balls[i]
    time = ball.next
    instant = time - ball.since < INSTANT
    if not instant:
        ball.trapped = 0
    carry(ball, time, cloth)
    if ball.meets <= ball.leg_end:
        return meet(i, ball.partner, time, scene)
    kind, goal = PHASE, ball.goal
    if goal < 0:
        end(ball, goal, cloth, scene.cushion_rule.parting)
    elif ball.phase == AIRBORNE:
        kind = CUSHION
        hit_nose(ball, scene.walls[goal], scene.cushion_rule)
    elif ball.hopped == NEVER and not (instant or rests_on(ball, scene.walls[goal], cloth)):
        kind = CUSHION
        hit_wall(ball, scene.walls[goal], scene.cushion_rule)
    else:
        kind, contacts = bounce(i, goal, instant, time, scene)
        if kind != CUSHION:
            return kind, contacts
    if scene.celled:
        start_leg(i, scene)
        plan_near(i, balls, scene.grid)
    else:
        plan_leg(ball, scene.walls, cloth, scene.cushion_rule)
        plan_table(i, balls, scene.meetings)
    return kind, goal


@whole
def bounce(i, goal, instant, time, scene):
    """Ball i hits a cushion, slowly or at once after something else; perhaps it stays there."""
    ball, wall, rule = scene.balls[i], scene.walls[goal], scene.cushion_rule
    held = ball.trapped > PATIENCE
    slowly = rests_on(ball, wall, scene.cloth)
    if held or (slowly and ball.hops >= FEWER):
        what, contacts = stay(i, WALL - goal, time, held, scene)
        if what != NOTHING:
            return what, contacts
    if slowly:
        meets_slowly(ball, time, i)
    elif ball.hopped != NEVER:
        forget(ball)
    hit_wall(ball, wall, rule)
    if instant:
        ball.trapped += 1
    if held:
        release(ball, scene.walls, rule.parting)
    return CUSHION, goal


@kernel
def end(ball, goal, cloth, parting):
    """A phase is over, and nothing was hit; or only the cloth."""
    if goal <= LEAVES:
        leave_table(ball)
    elif ball.phase == AIRBORNE:
        land(ball, cloth, parting)
    else:
        settle(ball)


@kernel
def release(ball, walls, parting):
    """A ball that rattles between walls too near to tell apart rolls out, along their bisector.

    Between two walls that face each other there is no way out: it rolls on along them.
    """
    out, inward = 0j, 1.0 + 0j
    for k in range(len(walls)):
        wall = walls[k]
        if (wall.inward * ball.position).real - wall.offset - ball.radius < TOUCHING * ball.radius:
            out, inward = out + wall.normal, wall.inward
    size = length(out)
    faces = size < FACING
    out = 1j * inward.conjugate() if faces else 1.0 / size * out
    speed = (out.conjugate() * ball.velocity).real
    turning = (out.conjugate() * ball.roll).real
    if not faces:  # and no energy beyond what the floor may give
        speed = max(speed, parting)
        turning = min(max(turning, 0.0), speed)
    ball.velocity, ball.roll = speed * out, turning * out
    ball.side = 0.0
    ball.trapped = 0


@whole
def meet(i, j, time, scene):
    """Two balls touch, and perhaps others with them."""
    balls = scene.balls
    a, b = balls[i], balls[j]
    carry(b, time, scene.cloth)
    if a.phase == AIRBORNE or b.phase == AIRBORNE:
        hit_aloft(a, b, scene.ball_rule)
        go_on_two(i, j, scene)
        return PAIR, j
    slowly = leans(a, b, scene.cloth)
    if slowly and a.hops >= FEW and b.hops >= FEW:
        held = a.trapped < 0  # never: False itself would be compiled for once more
        what, contacts = stay(i, j, time, held, scene)
        if what != NOTHING:
            return what, contacts
    if crowded(i, j, time, balls) if not scene.celled else crowded_near(i, j, time, scene):
        return crowd(i, j, time, slowly, scene)
    if slowly:
        meets_slowly(a, time, i)
        meets_slowly(b, time, i)
    else:
        if a.hopped != NEVER:
            forget(a)
        if b.hopped != NEVER:
            forget(b)
    hit_ball(a, b, scene.ball_rule)
    go_on_two(i, j, scene)
    return PAIR, j


@kernel
def go_on_two(i, j, scene):
    balls = scene.balls
    if scene.celled:
        start_leg(i, scene)
        start_leg(j, scene)
        plan_near(i, balls, scene.grid)
        plan_near(j, balls, scene.grid)
    else:
        plan_leg(balls[i], scene.walls, scene.cloth, scene.cushion_rule)
        plan_leg(balls[j], scene.walls, scene.cloth, scene.cushion_rule)
        plan_table(i, balls, scene.meetings)
        plan_table(j, balls, scene.meetings)


@kernel
def crowd(i, j, time, slowly, scene):
    """Many balls touch."""
    balls, ties = scene.balls, scene.ties
    members, contacts = gather(i, j, time, scene)
    for m in range(members):
        carry(balls[ties.member[m]], time, scene.cloth)
    if not collide(contacts, balls, scene.ball_rule, ties):
        return UNSOLVED, contacts
    for m in range(members):
        meets_slowly(balls[ties.member[m]], time if slowly else NEVER, i)
    go_on(members, scene)
    return CLUSTER, contacts


@kernel
def stay(i, j, time, held, scene):
    """Ball i meets ball j or wall -1 - j slowly, or is held between walls and balls: NOTHING yet,
    if they do not stay together."""
    members, contacts = lean(i, j, time, held, scene)
    if contacts <= 0:
        return NOTHING if contacts == 0 else UNSOLVED, members
    go_on(members, scene)
    return LASTING, contacts


@kernel
def go_on(members, scene):
    """All balls of a cluster have new legs."""
    for m in range(members):
        start_leg(scene.ties.member[m], scene)
    for m in range(members):
        plan_meetings(scene.ties.member[m], scene)


@whole
def advance(until, budget, scene):
    """Everything that happens up to `until`: (how much it was, when the last of it was).

    UNKNOWN events, if impulses between balls that touch could not be found.
    """
    balls = scene.balls
    events, last = 0, 0.0
    while events <= budget:
        i = scene.grid.tree[1] if scene.celled else earliest(balls)
        time = balls[i].next
        if time > until or time == inf:
            break
        kind, other = happen(i, scene)
        if kind == UNSOLVED:
            return UNKNOWN, time
        if kind in (CLUSTER, LASTING):
            happened = blows(other, scene.ties)
            events += happened
            budget -= happened == 0  # which must not go on forever either
        elif kind != NOTHING:
            events += 1
        last = time
    return events, last


@whole
def many(starts, rests, times, counts, budget, scene):
    """Shot after shot, each to rest: `starts` (shots, balls, 9), `rests` (shots, balls, 2)."""
    balls = scene.balls
    for s in range(len(starts)):
        for i in range(len(balls)):
            x = starts[s][i]
            ball = balls[i]
            ball.since = 0.0
            ball.position, ball.velocity = complex(x[0], x[1]), complex(x[2], x[3])
            ball.roll, ball.side = complex(x[4], x[5]), x[6]
            ball.height, ball.climb = x[7], x[8]
        plan(scene)
        counts[s], times[s] = advance(inf, budget, scene)
        for i in range(len(balls)):
            rests[s][i][0] = balls[i].position.real
            rests[s][i][1] = balls[i].position.imag
