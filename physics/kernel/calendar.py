"""From event to event."""

from .beginning import lay, strike
from .body import X, Y
from .cluster import blows, collide, crowded, crowded_near, gather
from .contact import meeting
from .flight import hit_aloft, hit_nose, land
from .grid import MISSING, locate, pass_by, plan_crossing, plan_near, sooner
from .impulses import WALL
from .kinds import (
    AIRBORNE,
    CLUSTER,
    CUSHION,
    LAND,
    LASTING,
    NOTHING,
    OFF,
    PAIR,
    REST,
    RESTING,
    ROLL,
    ROLLING,
    UNSOLVED,
)
from .lasting import FEW, NEVER, forget, lean, leans, meets_slowly, rests_on
from .laws import hit_ball, hit_wall, law_at
from .leg import begin, brake, carry, end, reach
from .notes import all_met, note, open_notes
from .obstacle import facing, meet_any, meet_first, meet_first_aloft, meet_framed
from .opening import leave_through
from .plastic import SQUEEZED
from .squeeze import clamped, meet_others, release, roll_along
from .subset import inf, kernel, nan, whole

UNKNOWN = -1
INSTANT = 1e-8  # s: no contact of real balls is so short; a leg that short goes nowhere
PATIENCE = 16  # how many of them at cushions make a trap


@whole
def start_leg(i, scene):
    """Ball i goes on from where it is, as it is: how, until when, and where it may come."""
    ball = scene.balls[i]
    lasts = begin(ball, scene.cloth)
    phase, ball.goal = ball.phase, MISSING
    if phase == AIRBORNE:
        lasts = meet_first_aloft(ball, scene.walls, scene.rules, scene.cushion_rule, lasts)
    elif RESTING < phase < OFF:
        if phase == ROLLING and len(scene.bands) > 0:
            lasts = brake(ball, scene.cloth, scene.bands)
        if ball.trapped >= SQUEEZED:
            lasts = meet_others(ball, scene.walls, lasts)
        elif scene.lines:
            lasts = meet_first(ball, scene.walls, lasts)
        else:
            until = meet_framed(ball, scene.walls, scene.frame, lasts)
            lasts = until if until >= 0.0 else meet_any(ball, scene.walls, lasts)
    if len(scene.openings) > 0 and RESTING < ball.phase < OFF:
        lasts = leave_through(ball, scene.openings, lasts)
    ball.leg_end = ball.since + lasts
    reach(ball, lasts)
    if scene.celled:
        scene.grid.seats[i].turn += 1
        plan_crossing(i, ball, ball.since, scene.grid)


@whole
def plan_meetings(i, scene):
    """Enter in the calendar which ball ball i will meet first, and when."""
    balls, meetings = scene.balls, scene.meetings
    if scene.celled:
        plan_near(i, balls, scene.grid)
        return
    n, ball = len(balls), balls[i]
    west, east, south, north = ball.west, ball.east, ball.south, ball.north
    meets, partner, row = inf, MISSING, n * i
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
        meetings[row + j] = meetings[n * j + i] = when
        if when < inf:
            if other.partner == i or sooner(when, i, other):
                appoint(j, i, when, balls, meetings)
            if when < meets:
                meets, partner = when, j
        elif other.partner == i:
            appoint(j, i, inf, balls, meetings)
    ball.meets, ball.partner = meets, partner
    ball.next = meets if meets < ball.leg_end else ball.leg_end


@kernel
def appoint(j, i, when, balls, meetings):
    """Enter for ball j when it will meet ball i, and which ball it now meets first."""
    ball = balls[j]
    if sooner(when, i, ball):
        ball.meets, ball.partner = when, i
    else:
        n = len(balls)
        ball.meets, ball.partner = inf, MISSING
        for k in range(n):
            if meetings[n * j + k] < ball.meets:
                ball.meets, ball.partner = meetings[n * j + k], k
    ball.next = ball.meets if ball.meets < ball.leg_end else ball.leg_end


@whole
def plan(scene):
    """Start over from balls that have been placed or pushed."""
    balls = scene.balls
    for i in range(len(balls)):
        balls[i].trapped = 0
        forget(balls[i])
    plan_all(scene)


@whole
def plan_all(scene):
    """All balls start from where they are; pairs that rest need not be asked."""
    balls, meetings, grid = scene.balls, scene.meetings, scene.grid
    n = len(balls)
    for k in range(len(meetings)):
        meetings[k] = inf
    for i in range(n):
        ball = balls[i]
        if scene.celled:
            locate(i, ball, grid)
        start_leg(i, scene)
        ball.meets, ball.partner, ball.next = inf, MISSING, ball.leg_end
    for i in range(n):
        if scene.celled or balls[i].phase != RESTING:
            plan_meetings(i, scene)


@whole
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
        return NOTHING, MISSING
    ball = balls[i]
    time = ball.next
    instant = time - ball.since < INSTANT
    if not instant:
        ball.trapped = 0
    carry(ball, time, cloth)
    if ball.meets <= ball.leg_end:
        return meet(i, ball.partner, instant, time, scene)
    kind, goal = ball.ending, ball.goal
    if kind == LAND:
        land(ball, cloth, scene.cushion_rule.parting)
    elif kind != CUSHION:
        end(ball, kind)
    elif ball.phase == AIRBORNE:
        hit_nose(ball, scene.walls[goal], law_at(goal, scene.rules, scene.cushion_rule))
    else:
        normal = facing(scene.walls[goal], ball.position)
        if instant or ball.hopped != NEVER or rests_on(ball, normal, cloth):
            kind, contacts = bounce(i, goal, normal, instant, time, scene)
            if kind != CUSHION:
                return kind, contacts
        else:
            hit_wall(ball, normal, law_at(goal, scene.rules, scene.cushion_rule))
    start_leg(i, scene)
    plan_meetings(i, scene)
    if kind == ROLL and ball.phase == RESTING:
        kind = REST
    return kind, goal


@whole
def bounce(i, goal, normal, instant, time, scene):
    """Ball i hits a cushion, slowly or at once after something else; perhaps it stays there."""
    ball, rule = scene.balls[i], law_at(goal, scene.rules, scene.cushion_rule)
    held = ball.trapped > PATIENCE
    slowly = rests_on(ball, normal, scene.cloth)
    if (slowly or held) and clamped(ball, goal, scene.walls):
        forget(ball)
        roll_along(ball, 1j * normal)
        return CUSHION, goal
    if held or (slowly and ball.hopped != NEVER):
        what, contacts = stay(i, WALL - goal, time, held, scene)
        if what != NOTHING:
            return what, contacts
    if slowly:
        meets_slowly(ball, time, i)
    elif ball.hopped != NEVER:
        forget(ball)
    hit_wall(ball, normal, rule)
    if instant:
        ball.trapped += 1
    if held:
        release(ball, scene.walls, rule.parting)
    return CUSHION, goal


@whole
def meet(i, j, instant, time, scene):
    """Two balls touch, and perhaps others with them."""
    balls = scene.balls
    a, b = balls[i], balls[j]
    carry(b, time, scene.cloth)
    if a.phase == AIRBORNE or b.phase == AIRBORNE:
        hit_aloft(a, b, scene.ball_rule)
        go_on_two(i, j, scene)
        return PAIR, j
    slowly = leans(a, b, scene.cloth)
    held = a.trapped > PATIENCE
    if held or (slowly and a.hops >= FEW and b.hops >= FEW):
        what, contacts = stay(i, j, time, held, scene)
        if what != NOTHING:
            return what, contacts
    if instant:
        a.trapped += 1
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
    start_leg(i, scene)
    start_leg(j, scene)
    plan_meetings(i, scene)
    plan_meetings(j, scene)


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
    if contacts == 0:
        return NOTHING, members
    go_on(members, scene)
    return LASTING, contacts


@kernel
def go_on(members, scene):
    """So many balls, those in ties.member, have new legs."""
    member = scene.ties.member
    for m in range(members):
        start_leg(member[m], scene)
    for m in range(members):
        plan_meetings(member[m], scene)


@whole
def advance(until, budget, scene, notes=None, s=0, struck=-1):
    """Everything that happens up to `until`: (how much it was, when the last of it was).

    UNKNOWN events, if impulses between balls that touch could not be found. What happens is kept in
    the notes, if there are any, as that of shot s; they may say when it is enough.
    """
    balls = scene.balls
    events, last = 0, 0.0
    while events <= budget:
        i = soonest(scene)
        time = balls[i].next
        if time > until or time == inf:
            break
        kind, other = happen(i, scene)
        if kind == UNSOLVED:
            return UNKNOWN, time
        if notes is not None and notes.most > 0:
            note(kind, i, other, time, s, scene, notes)
            if notes.until > 0 and all_met(kind, i, other, time, struck, scene, notes):
                budget = -1  # enough
        if kind in (CLUSTER, LASTING):
            happened = blows(other, scene.ties)
            events += happened
            budget -= happened == 0  # which must not go on forever either
        elif kind != NOTHING:
            events += 1
        last = time
    return events, last


@whole
def many(before, places, shots, struck, rests, times, counts, budget, scene, notes):
    """Each shot to its rest: `before` (balls, COLUMNS), `places` (shots or none, balls, 2), `shots`
    (shots, NUMBERS) at the ball struck, or at none if that is below 0; `rests` (shots, balls, 2).
    """
    balls = scene.balls
    for s in range(len(shots)):
        lay(balls, before, places, s)
        if struck >= 0:
            strike(balls[struck], shots[s])
        plan(scene)
        if notes.most > 0:
            notes.found[s] = 0
            open_notes(balls, len(scene.walls), notes.ways, notes.near)
        counts[s], times[s] = advance(inf, budget, scene, notes, s, struck)
        if notes.until > 0:
            for i in range(len(balls)):
                carry(balls[i], times[s], scene.cloth)
        for i in range(len(balls)):
            gone = balls[i].phase >= OFF
            rests[s][i][X] = balls[i].position.real if not gone else nan
            rests[s][i][Y] = balls[i].position.imag if not gone else nan
