"""What is wedged, so that no impulse makes all its contacts part, rolls on where it may.

Contacts that face each other cannot both open, and those that nearly do could only with a huge
speed along the little way out. The group then goes on as the nearest motion in which every ball
rolls and no contact closes: a projection on a convex cone, which never makes energy.
"""

from .impulses import PUSH, act, ask, other, parting, solve
from .motion import length
from .subset import complex, kernel

SQUEEZED = 1000  # for the count of hits in one instant: it goes along the walls that hold it
CREEP = 1e-7  # m/s: what is wedged and slower stops, or hops would keep it going
LEAST = 1e-300  # of a push
SWEEPS = 100  # through all contacts: what still closes then meets again at once, and stops
ROUNDING = 1e-12  # of the energy, and of a speed


@kernel
def energy(members, balls, ties):
    """Of what moves along the cloth and spins, J."""
    total = 0.0
    for m in range(members):
        ball = balls[ties.member[m]]
        moves, rolls = length(ball.velocity), length(ball.roll)
        spins = rolls * rolls + ball.side * ball.side
        total += ball.mass * (0.5 * moves * moves + 0.2 * spins)
    return total


@kernel
def loan(chosen, balls, ties):
    """The most that hops may add, J: a row that hops has every ball as fast as all before it.

    What they close with does not count, as it pushes those on that open already.
    """
    lent = 0.0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        if tie.target > 0.0:
            mass = max(balls[tie.first].mass, balls[other(tie)].mass)
            lent += mass * tie.target * tie.target
    return 2.0 * chosen * lent


@kernel
def keep(members, balls, ties):
    """Remember how they move."""
    for m in range(members):
        ball, blow = balls[ties.member[m]], ties.blows[ties.member[m]]
        blow.kept, blow.kept_roll = ball.velocity, ball.roll


@kernel
def wedge(members, contacts, least, balls, ties):
    """From how they moved before: roll where no contact closes, or if that was done just now, stop.

    No energy comes of it.
    """
    again = balls[ties.member[0]].trapped >= SQUEEZED  # the ball that the event belongs to
    turn_to_rolling(members, balls, ties)
    had = energy(members, balls, ties)
    if again:
        stop(members, balls, ties)
    elif not part(contacts, least, balls, ties) or not lossy(members, had, balls, ties):
        turn_to_rolling(members, balls, ties)
        give_way(contacts, balls, ties)
    if pace(members, balls, ties) < CREEP:
        stop(members, balls, ties)
    for m in range(members):
        ball = balls[ties.member[m]]
        ball.roll, ball.trapped = ball.velocity, SQUEEZED
    for c in range(contacts):  # all are events, as the cloth has pushed too
        tie = ties.contacts[c]
        tie.total = max(tie.total, LEAST)


@kernel
def lossy(members, had, balls, ties):
    """Do they have no more energy than they had, if they roll?"""
    for m in range(members):
        ball = balls[ties.member[m]]
        ball.roll = ball.velocity
    return energy(members, balls, ties) <= (1.0 + ROUNDING) * had


@kernel
def pace(members, balls, ties):
    """The speed of the fastest."""
    fastest = 0.0
    for m in range(members):
        fastest = max(fastest, length(balls[ties.member[m]].velocity))
    return fastest


@kernel
def stop(members, balls, ties):
    for m in range(members):
        ball = balls[ties.member[m]]
        ball.velocity, ball.roll = 0j, 0j


@kernel
def turn_to_rolling(members, balls, ties):
    """As each would roll by itself; the spin about the vertical is gone."""
    for m in range(members):
        ball, blow = balls[ties.member[m]], ties.blows[ties.member[m]]
        ball.velocity = 1.0 / 7.0 * (5.0 * blow.kept + 2.0 * blow.kept_roll)
        ball.roll, ball.side = ball.velocity, 0.0


@kernel
def part(contacts, least, balls, ties):
    """Pushes that open all contacts at least so fast; False if they cannot be found."""
    for c in range(contacts):
        tie = ties.contacts[c]
        ties.chosen[c], tie.target, tie.total = c, least, 0.0
        ask(PUSH, tie, balls)
    if not solve(PUSH, contacts, balls, ties):
        return False
    for c in range(contacts):
        tie = ties.contacts[c]
        tie.total = tie.size * tie.impulse.real
        if parting(tie, balls) < 0.0:
            return False
    return True


@kernel
def give_way(contacts, balls, ties):
    """One contact after the other stops closing, again and again: each takes energy."""
    for c in range(contacts):
        ties.contacts[c].total = 0.0
    for _ in range(SWEEPS):
        for c in range(contacts):
            tie = ties.contacts[c]
            closing = -parting(tie, balls)
            if closing > 0.0:
                act(PUSH, tie, balls, complex(tie.size * closing, 0.0))
                tie.total += tie.size * tie.size * closing
