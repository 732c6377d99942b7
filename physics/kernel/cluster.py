"""Several contacts at one instant: who is in them, and what becomes of them.

The contacts of a cluster that close fastest, to 1e-9, are solved together, the others wait; again
and again until none closes. So a symmetric rack stays symmetric, and a cradle passes its blow on
in line.
"""

from .body import CONTACTS
from .grid import neighbours
from .laws import (
    FOREIGN_BALL,
    SMOOTH_BALL,
    THESIS_BALL,
    friction,
    grip,
    hit_ball,
    press,
    rebound,
    toward,
)
from .motion import AIRBORNE, carry, length, place
from .subset import complex, kernel, room
from .tilt import between, levelled, tilt

TOUCHING = 1e-8  # m: balls closer than this are in contact
NOISE = 1e-11  # m/s: what closes more slowly within a cluster does so by rounding
TIED = 1e-9  # closing speeds that agree to this are equal
SWEEPS = 2000  # of the simultaneous solution: a tight rack needs a few dozen
AGREES = 1e-15  # of the greatest speed: what a sweep may still change
ROUNDS = 64  # a contact: then whatever still closes is left to the next event


@kernel
def beside(a, b, time):
    """Is b, on its leg, as near to a, which is at `time` already, as discs that touch are?  Boxes
    first: no root.

    Airborne balls are left out until the cluster is resolved.
    """
    x, y, r = a.position.real, a.position.imag, a.radius + TOUCHING
    if b.west > x + r or b.east < x - r or b.south > y + r or b.north < y - r:
        return False
    if b.phase == AIRBORNE:
        return False
    return length(place(b, time - b.since) - a.position) < r + b.radius


@kernel
def touching(a, b, time):
    """Is b in contact with a?  Balls of two sizes must be nearer for that than discs."""
    return beside(a, b, time) and (a.lift == b.lift or gapless(a, b, time))


@kernel
def gapless(a, b, time):
    """Are their centres in space no farther apart than both radii?"""
    return between(a, b, place(b, time - b.since) - a.position) < a.radius + TOUCHING + b.radius


# Nearly every third ball is not even beside the two. That is asked first, and by itself: so it is
# compiled into the loop over all balls; a break would cost 4 % more if it called `touching` alone.


@kernel
def crowded(i, j, time, balls):
    """Does a third ball touch one of the two?"""
    a, b = balls[i], balls[j]
    for k in range(len(balls)):
        if (
            k != i
            and k != j
            and (beside(a, balls[k], time) or beside(b, balls[k], time))
            and (touching(a, balls[k], time) or touching(b, balls[k], time))
        ):
            return True
    return False


@kernel
def crowded_near(i, j, time, scene):
    """The same, with cells."""
    balls = scene.balls
    a, b = balls[i], balls[j]
    return third(a, i, j, time, balls, scene.grid) or third(b, j, i, time, balls, scene.grid)


@kernel
def third(a, i, j, time, balls, grid):
    """Does a ball other than j touch ball i, which is a?"""
    for m in range(neighbours(i, balls, grid)):
        k = grid.near[m]
        if k != j and touching(a, balls[k], time):
            return True
    return False


@kernel
def gather(i, j, time, scene):
    """All that hangs together with balls i and j: how many balls, in ties.member, and contacts."""
    balls, ties, grid = scene.balls, scene.ties, scene.grid
    member = ties.member
    member[0], member[1] = i, j
    room(ties, 1)
    join(i, j, ties.contacts[0])
    members, contacts, m = 2, 1, 0
    while m < members:
        a = member[m]
        for near in range(neighbours(a, balls, grid)):
            k = grid.near[near]
            if (m < 2 and k == member[1 - m]) or not touching(balls[a], balls[k], time):
                continue
            at = 0
            while at < members and member[at] != k:
                at += 1
            if at == members:
                carry(balls[k], time, scene.cloth)
                member[members] = k
                members += 1
            if at > m and contacts < CONTACTS * len(balls):  # balls of nanometres may touch more
                room(ties, contacts + 1)
                join(a, k, ties.contacts[contacts])
                contacts += 1
        m += 1
    return members, contacts


@kernel
def join(i, j, tie):
    tie.first, tie.second, tie.total = i, j, 0.0


@kernel
def closing_speed(a, b):
    return (toward(a, b).conjugate() * (a.velocity - b.velocity)).real


@kernel
def choose(contacts, balls, ties):
    """Put the contacts that close fastest into ties.chosen; returns how many."""
    fastest = 0.0
    for c in range(contacts):
        tie = ties.contacts[c]
        tie.target = closing_speed(balls[tie.first], balls[tie.second])
        if tie.target > fastest:
            fastest = tie.target
    chosen = 0
    for c in range(contacts):
        target = ties.contacts[c].target
        if target > 0.0 and target >= (1.0 - TIED) * fastest:
            ties.chosen[chosen] = c
            chosen += 1
    return chosen


@kernel
def collide(contacts, balls, rule, ties):
    """Blow after blow until no contact closes; the pushes add up in ties.total."""
    tie = ties.contacts[0]
    a, b = balls[tie.first], balls[tie.second]
    if closing_speed(a, b) < NOISE:  # it grazed, or something drives it
        tie.total = hit_ball(a, b, rule)
    for _ in range(ROUNDS * contacts):
        chosen = choose(contacts, balls, ties)
        if chosen == 0:
            return
        alone = chosen == 1 and ties.contacts[ties.chosen[0]].target >= NOISE
        if alone or rule.kind == THESIS_BALL or rule.kind == FOREIGN_BALL:
            for k in range(chosen):
                tie = ties.contacts[ties.chosen[k]]
                tie.total += hit_ball(balls[tie.first], balls[tie.second], rule)
        else:
            together(chosen, balls, rule, ties)


@kernel
def together(chosen, balls, rule, ties):
    """Impulses that make every chosen contact part as its law wants, none of them a pull."""
    fastest = 0.0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        a, b = balls[tie.first], balls[tie.second]
        closing = tie.target
        fastest = max(fastest, length(a.velocity), length(b.velocity))
        # what closes by rounding alone, as in a chain that passed a blow on, is not thrown apart
        tie.target = rebound(closing, rule) - closing if closing >= NOISE else 2.0 * closing
        tie.grip = grip(slip_between(a, b, toward(a, b)), rule) / tilt(a, b)[0]
        tie.push, tie.rub = 0.0, 0j
    for _ in range(SWEEPS):
        change = 0.0
        for k in range(chosen):
            change = max(change, relax_push(ties.contacts[ties.chosen[k]], balls))
        if change <= AGREES * fastest:
            break
    if rule.kind != SMOOTH_BALL:
        for _ in range(SWEEPS):
            change = 0.0
            for k in range(chosen):
                change = max(change, relax_rub(ties.contacts[ties.chosen[k]], balls))
            if change <= AGREES * fastest:
                break
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.total += tie.push


@kernel
def slip_between(a, b, line):
    turn = line.conjugate()
    across, roll = (turn * (a.velocity - b.velocity)).imag, turn * (a.roll + b.roll)
    if a.lift != b.lift:
        roll, side = levelled(a, b, roll, a.side + b.side)
        return complex(across + side, -roll.real)
    return complex(across + a.side + b.side, -roll.real)


@kernel
def relax_push(tie, balls):
    """Make one contact part as it should, given what the others did; returns by how much, m/s."""
    a, b = balls[tie.first], balls[tie.second]
    line = toward(a, b)
    mass = a.mass * b.mass / (a.mass + b.mass)
    closing = (line.conjugate() * (a.velocity - b.velocity)).real
    push = max(0.0, tie.push + mass * (closing + tie.target))
    more = push - tie.push
    press(a, b, line, more, 0j)
    tie.push = push
    return abs(more) / mass


@kernel
def relax_rub(tie, balls):
    """Take as much slip from one contact as its push allows; returns by how much, m/s.

    The pushes stand by now, so rubs only take energy: pushes that answer to rubs would make it.
    """
    a, b = balls[tie.first], balls[tie.second]
    line = toward(a, b)
    yielding = 3.5 * (a.mass + b.mass) / (a.mass * b.mass)
    wish = slip_between(a, b, line) - yielding * tie.rub
    rub = friction(wish, tie.grip * tie.push, yielding)
    change = rub - tie.rub
    press(a, b, line, 0.0, change)
    tie.rub = rub
    return length(change) * yielding
