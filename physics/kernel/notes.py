"""What a batch keeps of its shots: which balls, cushions and pockets met, and when."""

from .away import leaves
from .impulses import WALL
from .kinds import CLUSTER, CUSHION, DROP, LASTING, LEAVE, NOTHING, PAIR
from .subset import kernel

NO_TOUCH, BALL_TOUCH, CUSHION_TOUCH, POCKET_TOUCH, OFF_TOUCH = 0, 1, 2, 3, 4  # in the notes


@kernel
def open_notes(s, balls, notes):
    """Shot s begins: every ball may lie at any wall."""
    notes.found[s] = 0
    for i in range(len(balls)):
        set_off(balls[i], notes.ways[i])
    for k in range(len(notes.near)):
        notes.near[k] = True


@kernel
def set_off(ball, way):
    """The ball is on a new leg, the way."""
    way.since, way.position = ball.since, ball.position
    way.velocity, way.acceleration = ball.velocity, ball.acceleration


@kernel
def note(kind, i, other, time, s, balls, walls, ties, notes):
    """That has happened to ball i in shot s, and to what else there was in it."""
    if kind in (CLUSTER, LASTING):
        for c in range(other):
            part(ties[c].first, balls, walls, notes)
            if ties[c].second > WALL:
                part(ties[c].second, balls, walls, notes)
        for c in range(other):
            if ties[c].total > 0.0:
                j = ties[c].second
                if j > WALL:
                    enter(PAIR, ties[c].first, j, time, s, len(walls), notes)
                else:
                    enter(CUSHION, ties[c].first, WALL - j, time, s, len(walls), notes)
    elif kind != NOTHING:
        part(i, balls, walls, notes)
        if kind == PAIR:
            part(other, balls, walls, notes)
        if kind in (PAIR, CUSHION, LEAVE, DROP):
            enter(kind, i, other, time, s, len(walls), notes)


@kernel
def part(i, balls, walls, notes):
    """Ball i is on a new leg: which walls did it leave on the one before?"""
    ball, way, n = balls[i], notes.ways[i], len(walls)
    t = ball.since - way.since
    for k in range(n):
        if notes.near[n * i + k] and leaves(
            walls[k], way.position, way.velocity, way.acceleration, t, ball.radius
        ):
            notes.near[n * i + k] = False
    set_off(ball, way)


@kernel
def enter(kind, i, other, time, s, walls, notes):
    """A line about it, if there is room."""
    again = False
    if kind == CUSHION:
        again = notes.near[walls * i + other]
        notes.near[walls * i + other] = True
    if notes.found[s] < notes.most:
        touch = notes.contacts[s][notes.found[s]]
        touch.kind, touch.again = touch_of(kind), again
        touch.first, touch.second, touch.time = i, other, time
    notes.found[s] += 1


@kernel
def touch_of(kind):
    """The kind of an event, as notes have it."""
    if kind == PAIR:
        return BALL_TOUCH
    if kind == CUSHION:
        return CUSHION_TOUCH
    return POCKET_TOUCH if kind == DROP else OFF_TOUCH
