"""What a batch keeps of its shots: which balls, cushions and pockets met, and when."""

from .gap import leaves
from .impulses import WALL
from .kinds import AIRBORNE, CLUSTER, CUSHION, DROP, LASTING, LEAVE, NOTHING, PAIR
from .subset import inf, kernel, whole

TOGETHER = 2e-9  # s: rules call what is closer (1e-9) one instant
BALL_TOUCH, CUSHION_TOUCH, POCKET_TOUCH, OFF_TOUCH = 1, 2, 3, 4  # in the notes; 0 is none


@kernel
def open_notes(balls, walls, ways, near):
    """A shot begins: every ball may lie at any wall."""
    for i in range(len(balls)):
        ways[i].near, ways[i].met = walls, inf
        set_off(balls[i], ways[i])
    for k in range(len(near)):
        near[k] = True


@kernel
def set_off(ball, way):
    """The ball is on a new leg."""
    way.since, way.position = ball.since, ball.position
    way.velocity, way.acceleration = ball.velocity, ball.acceleration


@whole
def note(kind, i, other, time, s, scene, notes):
    """That has happened to ball i in shot s, and to what else there was in it."""
    if kind in (CLUSTER, LASTING):
        note_group(other, time, s, scene.balls, scene.walls, scene.ties.contacts, notes)
    elif kind != NOTHING:
        if notes.ways[i].near > 0:
            part(i, scene.balls[i], notes.ways[i], scene.walls, notes.near)
        if kind == PAIR and notes.ways[other].near > 0:
            part(other, scene.balls[other], notes.ways[other], scene.walls, notes.near)
        if kind == CUSHION:
            at = i * len(scene.walls) + other
            again = come_to(at, scene.balls[i], notes.ways[i], notes.near)
            enter(CUSHION_TOUCH, again, i, other, time, s, notes.most, notes.contacts, notes.found)
        elif kind in (PAIR, LEAVE, DROP):
            what = BALL_TOUCH
            if kind != PAIR:
                what = OFF_TOUCH if kind == LEAVE else POCKET_TOUCH
            enter(what, False, i, other, time, s, notes.most, notes.contacts, notes.found)


@kernel
def note_group(contacts, time, s, balls, walls, ties, notes):
    """So many contacts of one instant."""
    ways, near = notes.ways, notes.near
    for c in range(contacts):
        i, j = ties[c].first, ties[c].second
        part(i, balls[i], ways[i], walls, near)
        if j > WALL:
            part(j, balls[j], ways[j], walls, near)
    for c in range(contacts):
        if ties[c].total > 0.0:
            i, j = ties[c].first, ties[c].second
            what, again = BALL_TOUCH, False
            if j <= WALL:
                j = WALL - j
                what, again = CUSHION_TOUCH, come_to(i * len(walls) + j, balls[i], ways[i], near)
            enter(what, again, i, j, time, s, notes.most, notes.contacts, notes.found)


@kernel
def part(i, ball, way, walls, near):
    """Ball i is on a new leg: which walls did it leave on the one before?"""
    t, n = ball.since - way.since, len(walls)
    for k in range(n):
        if near[n * i + k] and leaves(
            walls[k], way.position, way.velocity, way.acceleration, t, ball.radius
        ):
            near[n * i + k] = False
            way.near -= 1
    set_off(ball, way)


@kernel
def come_to(at, ball, way, near):
    """The ball has touched a wall: had it not left it?"""
    again = near[at]
    if not again:
        near[at] = True
        way.near += 1
        set_off(ball, way)
    return again


@kernel
def enter(what, again, i, other, time, s, most, contacts, found):
    """A line about it, if there is room."""
    if found[s] < most:
        touch = contacts[s][found[s]]
        touch.kind, touch.again = what, again
        touch.first, touch.second, touch.time = i, other, time
    found[s] += 1


@whole
def all_met(kind, i, other, time, struck, scene, notes):
    """After this event of ball i: has the ball that was struck met all balls in notes.until, more
    than an instant ago, and can none leave the table any more?"""
    ways, balls = notes.ways, scene.balls
    if kind == PAIR:
        meet(i, other, struck, time, ways)
    elif kind in (CLUSTER, LASTING):
        meet_group(other, struck, time, scene.ties.contacts, ways)
    for k in range(len(balls)):
        if balls[k].phase == AIRBORNE:
            return False
        if notes.until >> k & 1 == 1 and not ways[k].met < time - TOGETHER:
            return False
    return len(scene.openings) == 0


@kernel
def meet(i, j, struck, time, ways):
    """Balls i and j have met."""
    if i == struck:
        ways[j].met = min(ways[j].met, time)
    elif j == struck:
        ways[i].met = min(ways[i].met, time)


@kernel
def meet_group(contacts, struck, time, ties, ways):
    """So many contacts of one instant."""
    for c in range(contacts):
        if ties[c].total > 0.0 and ties[c].second > WALL:
            meet(ties[c].first, ties[c].second, struck, time, ways)
