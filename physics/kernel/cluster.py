"""Several contacts at one instant: which balls take part, and how they part.

The contacts of a cluster that close fastest, to 1e-9, are solved together, the others wait; again
and again until none closes. So a symmetric rack stays symmetric, and a cradle passes its blow on
in line.
"""

from .body import CONTACTS
from .grid import neighbours
from .impulses import PUSH, RUB, ask, other, slip_between, solve
from .kinds import AIRBORNE
from .laws import CUSTOM_BALL, SMOOTH_BALL, THESIS_BALL, grip, hit_ball, rebound, toward
from .leg import place
from .motion import length
from .subset import kernel, room
from .tilt import between, tilt

TOUCHING = 3e-7  # radii: balls closer than this are in contact; 1e-8 m on a carom table
NOISE = 1e-11  # of the fastest: what closes more slowly within a cluster does so by rounding
TIED = 1e-9  # closing speeds that agree to this are equal
ROUNDS = 64  # a contact: then all that still close are solved together


@kernel
def beside(p, reach, b, time):
    """Does b, on its leg, come as near to p at that time as a disc of that reach?  Boxes first: no
    root.

    Airborne balls are left out until the cluster is resolved.
    """
    x, y = p.real, p.imag
    if b.west > x + reach or b.east < x - reach or b.south > y + reach or b.north < y - reach:
        return False
    if b.phase == AIRBORNE:
        return False
    return length(place(b, time - b.since) - p) < reach + b.radius


@kernel
def reach(ball, margin):
    """How far it reaches, and a margin in radii."""
    return ball.radius * (1.0 + margin)


@kernel
def touching(a, p, b, time, margin):
    """Is b within a margin, in radii, of a, which is at p?  Balls of two sizes must be nearer for
    that than discs."""
    if a.lift == b.lift:
        return beside(p, reach(a, margin), b, time)
    return beside(p, reach(a, margin), b, time) and gapless(a, p, b, time, margin)


@kernel
def gapless(a, p, b, time, margin):
    """Are their centres in space no farther apart than both radii and the margin?"""
    return between(a, b, place(b, time - b.since) - p) < reach(a, margin) + b.radius


# Nearly every third ball is not even beside the two. That is asked first, and by itself: so it is
# compiled into the loop over all balls; a break would cost 4 % more if it called `touching` alone.


@kernel
def crowded(i, j, time, balls):
    """Does a third ball touch one of the two?"""
    a, b = balls[i], balls[j]
    p, q = a.position, b.position
    r, s = reach(a, TOUCHING), reach(b, TOUCHING)
    for k in range(len(balls)):
        if k != i and k != j and (beside(p, r, balls[k], time) or beside(q, s, balls[k], time)):
            c = balls[k]
            if touching(a, p, c, time, TOUCHING) or touching(b, q, c, time, TOUCHING):
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
        if k != j and touching(a, a.position, balls[k], time, TOUCHING):
            return True
    return False


@kernel
def gather(i, j, time, scene):
    """All balls connected with balls i and j: how many, in ties.member, and how many contacts."""
    balls, ties, grid = scene.balls, scene.ties, scene.grid
    member = ties.member
    member[0], member[1] = i, j
    room(ties, 1)
    join(i, j, ties.contacts[0])
    members, contacts, m = 2, 1, 0
    while m < members:
        a = member[m]
        here = place(balls[a], time - balls[a].since)
        far = reach(balls[a], TOUCHING)
        for near in range(neighbours(a, balls, grid)):
            k = grid.near[near]
            if not beside(here, far, balls[k], time) or (a == i and k == j) or (a == j and k == i):
                continue
            if not touching(balls[a], here, balls[k], time, TOUCHING):
                continue
            at = seat(k, member, members)
            if at == members:
                member[members] = k
                members += 1
            if at > m and contacts < CONTACTS * len(balls):  # balls of nanometres may touch more
                room(ties, contacts + 1)
                join(a, k, ties.contacts[contacts])
                contacts += 1
        m += 1
    return members, contacts


@kernel
def seat(k, member, members):
    """Which of the members ball k is, or how many there are if it is none."""
    at = 0
    while at < members and member[at] != k:
        at += 1
    return at


@kernel
def join(i, j, tie):
    tie.first, tie.second, tie.total = i, j, 0.0


@kernel
def closing_speed(a, b):
    return (toward(a, b).conjugate() * (a.velocity - b.velocity)).real


@kernel
def choose(contacts, balls, ties, fastest_only):
    """Put the contacts that close (or of them the fastest) into ties.chosen; returns how many."""
    fastest = 0.0
    for c in range(contacts):
        tie = ties.contacts[c]
        tie.target = closing_speed(balls[tie.first], balls[tie.second])
        if tie.target > fastest:
            fastest = tie.target
    chosen = 0
    for c in range(contacts):
        target = ties.contacts[c].target
        if target > 0.0 and (target >= (1.0 - TIED) * fastest or not fastest_only):
            ties.chosen[chosen] = c
            chosen += 1
    return chosen


@kernel
def collide(contacts, balls, rule, ties):
    """Blow after blow until no contact closes; the pushes add up in ties.total.

    False if impulses that make all contacts part could not be found.
    """
    tie = ties.contacts[0]
    a, b = balls[tie.first], balls[tie.second]
    noise = NOISE * pace(contacts, balls, ties)
    if closing_speed(a, b) < noise:  # it grazed, or something drives it
        tie.total = hit_ball(a, b, rule)
    for turn in range(ROUNDS * contacts + 1):
        chosen = choose(contacts, balls, ties, turn < ROUNDS * contacts)
        if chosen == 0:
            return True
        alone = chosen == 1 and ties.contacts[ties.chosen[0]].target >= noise
        if alone or rule.kind == THESIS_BALL or rule.kind == CUSTOM_BALL:
            for k in range(chosen):
                tie = ties.contacts[ties.chosen[k]]
                tie.total += hit_ball(balls[tie.first], balls[tie.second], rule)
        elif not together(chosen, balls, rule, ties, noise):
            return False
    return True


@kernel
def blows(contacts, ties):
    """How many events a cluster was: every contact that passed an impulse is one."""
    count = 0
    for c in range(contacts):
        if ties.contacts[c].total > 0.0:
            count += 1
    return count


@kernel
def pace(contacts, balls, ties):
    """The speed of the fastest ball."""
    fastest = 0.0
    for c in range(contacts):
        tie = ties.contacts[c]
        a, b = balls[tie.first], balls[other(tie)]
        fastest = max(fastest, length(a.velocity), length(b.velocity))
    return fastest


@kernel
def together(chosen, balls, rule, ties, noise):
    """Impulses that make every chosen contact part as its law wants, none of them a pull.

    The rubs come when the pushes stand, so they only take energy: pushes that answered to rubs
    would make it.
    """
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        a, b = balls[tie.first], balls[tie.second]
        closing = tie.target
        # what closes by rounding alone, as in a chain that passed a blow on, is not thrown apart,
        # and what shall not part at all parts by more than rounding could take
        apart = rebound(closing, rule) - closing if closing >= noise else closing
        tie.target = max(apart, 1e-3 * noise)
        tie.grip = grip(slip_between(a, b, toward(a, b)), rule) / tilt(a, b)[0]
        ask(PUSH, tie, balls)
    for kind in range(PUSH, PUSH + 1 if rule.kind == SMOOTH_BALL else RUB + 1):
        if not solve(kind, chosen, balls, ties):
            return False
        for k in range(chosen):
            tie = ties.contacts[ties.chosen[k]]
            if kind == PUSH:
                push = tie.size * tie.impulse.real
                tie.total += push
                ask(RUB, tie, balls)
                tie.bound = tie.grip * push / tie.size
    return True
