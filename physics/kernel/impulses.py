"""Many contacts solved together: the pushes that make all of them part, then the rubs.

Pushes never pull, and a rub is no more than friction holds. Among those, the answer is the one that
leaves the least energy relative to what every contact asks for: a quadratic under bounds, in
which every contact is scaled so that it yields by 1 to its own impulse. Conjugate gradients search
among the contacts that are within their bounds, projected steps move the others (Z. Dostál and
J. Schöberl, "Minimizing quadratic functions subject to bound constraints", Comput. Optim. Appl. 30
(2005) 23). Pushes enter alike, so a symmetric cluster stays symmetric. As in
a hit of two balls, a rub is found as if it could lift them, and then it does not.
"""

from .laws import press, toward
from .motion import length
from .subset import complex, inf, kernel, sqrt
from .tilt import levelled

PUSH, RUB = 0, 1  # what is sought: complex in both cases, a push on the real axis
WALL = -1  # less the number of the wall: the second in a contact with a wall
AGREES = 1e-15  # of the greatest speed: how far from what it asks for a contact may be left
FAILS = 1e-9  # of the same: an answer further off than this is none
REFINED = 8  # times, as an answer is checked against the balls' own velocities
INSIDE = 1.0 - 1e-12  # of its bound: a rub above that is held there
TURNS = 100  # a contact, and TURNS more for all: conjugate gradients need about one a contact


@kernel
def ask(kind, tie, balls):
    """What a contact needs to know while it is solved for: its line (a wall's has been set) and its
    scale."""
    a = balls[tie.first]
    yielding = 1.0 / a.mass
    if tie.second > WALL:
        b = balls[tie.second]
        tie.line = toward(a, b)
        yielding = (a.mass + b.mass) / a.mass / b.mass
    tie.size = sqrt(1.0 / yielding if kind == PUSH else 1.0 / (3.5 * yielding))
    tie.impulse = 0j


@kernel
def other(tie):
    """The second ball, or the first again where that is a wall."""
    return tie.second if tie.second > WALL else tie.first


@kernel
def parting(tie, balls):
    """How fast the contact opens, m/s."""
    velocity = -balls[tie.first].velocity
    if tie.second > WALL:
        velocity += balls[tie.second].velocity
    return (tie.line.conjugate() * velocity).real


@kernel
def slip_between(a, b, line):
    turn = line.conjugate()
    across, roll = (turn * (a.velocity - b.velocity)).imag, turn * (a.roll + b.roll)
    if a.lift != b.lift:
        roll, side = levelled(a, b, roll, a.side + b.side)
        return complex(across + side, -roll.real)
    return complex(across + a.side + b.side, -roll.real)


@kernel
def asked(kind, tie, balls):
    """What the contact lacks or has too much of, in its scale."""
    if kind == PUSH:
        return complex(tie.size * parting(tie, balls), 0.0)
    return tie.size * slip_between(balls[tie.first], balls[tie.second], tie.line)


@kernel
def answers(kind, tie, ties):
    """The same of what has been tried, which may lift balls."""
    answer = asked(kind, tie, ties.blows)
    if kind == RUB:
        a, b = ties.blows[tie.first], ties.blows[tie.second]
        answer += complex(0.0, tie.size * (a.climb - b.climb))
    return answer


@kernel
def act(kind, tie, balls, impulse):
    """Apply it, in its scale, to both."""
    a, impulse = balls[tie.first], tie.size * impulse
    if kind == RUB:
        press(a, balls[tie.second], tie.line, 0.0, impulse)
    elif tie.second > WALL:
        press(a, balls[tie.second], tie.line, impulse.real, 0j)
    else:
        a.velocity -= impulse.real / a.mass * tie.line


@kernel
def attempt(kind, tie, ties, impulse):
    """The same as a trial."""
    act(kind, tie, ties.blows, impulse)
    if kind == RUB:
        a, b, up = ties.blows[tie.first], ties.blows[tie.second], tie.size * impulse.imag
        a.climb += up / a.mass
        b.climb -= up / b.mass


@kernel
def solve(kind, chosen, balls, ties):
    """Find the impulse of every chosen contact and apply it; False if there is no telling.

    Pushes are checked against the velocities that they lead to, and corrected.
    """
    turns = TURNS * (chosen + 1)
    stride, fastest, left = 1.0 / crowding(chosen, ties), 0.0, inf
    for _ in range(REFINED if kind == PUSH else 1):
        fastest = max(fastest, speed(chosen, balls, ties))
        for k in range(chosen):
            tie = ties.contacts[ties.chosen[k]]
            tie.slope = asked(kind, tie, balls)
            if kind == PUSH:
                tie.slope -= complex(tie.size * tie.target, 0.0)
            tie.more = 0j
        left, _, _ = unmet(kind, chosen, ties)
        if left <= AGREES * fastest:
            return True
        turns, left = search(kind, chosen, balls, ties, stride, AGREES * fastest, turns)
        for k in range(chosen):
            tie = ties.contacts[ties.chosen[k]]
            act(kind, tie, balls, tie.more)
    return left <= FAILS * fastest


@kernel
def speed(chosen, balls, ties):
    """How fast the fastest of the balls is, or spins."""
    fastest = 0.0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        for i in (tie.first, other(tie)):
            ball = balls[i]
            fastest = max(fastest, length(ball.velocity), length(ball.roll), abs(ball.side))
    return fastest


@kernel
def crowding(chosen, ties):
    """No impulses change what they are asked for by more than this times their own size."""
    most = 1
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        ties.blows[tie.first].contacts = ties.blows[other(tie)].contacts = 0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        ties.blows[tie.first].contacts += 1
        ties.blows[other(tie)].contacts += 1
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        most = max(most, ties.blows[tie.first].contacts + ties.blows[other(tie)].contacts - 1)
    return most


@kernel
def search(kind, chosen, balls, ties, stride, least, turns):
    """Go downhill until no contact asks for more than `least`, m/s: (turns left, what one asks)."""
    project(kind, chosen, balls, ties, stride)
    fresh, left = True, inf
    while turns > 0:
        turns -= 1
        left, inner, edge = unmet(kind, chosen, ties)
        if left <= least:
            break
        if edge > inner:
            project(kind, chosen, balls, ties, stride)
            fresh = True
            continue
        if fresh:
            for k in range(chosen):
                tie = ties.contacts[ties.chosen[k]]
                tie.way = tie.slope if free(kind, tie) else 0j
        fresh = step(kind, chosen, balls, ties, stride)
    return turns, left


@kernel
def step(kind, chosen, balls, ties, stride):
    """A conjugate step among the free contacts; True if it ended at a bound."""
    respond(kind, chosen, balls, ties)
    down, bend, room = 0.0, 0.0, inf
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        down += dot(tie.slope, tie.way)
        bend += dot(tie.way, tie.answer)
        room = min(room, reach(kind, tie))
    far = down / bend if bend > 0.0 else inf
    if far >= room:
        if far == inf or not leap(kind, chosen, balls, ties, far):
            project(kind, chosen, balls, ties, stride)
        return True
    move(chosen, ties, far)
    turn = 0.0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        if free(kind, tie):
            turn += dot(tie.slope, tie.answer)
    turn /= bend
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.way = tie.slope - turn * tie.way if free(kind, tie) else 0j
    return False


@kernel
def leap(kind, chosen, balls, ties, far):
    """Go so far along the way and back within the bounds; False, and not at all, if that is up."""
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.way = tie.impulse - within(kind, tie, tie.impulse - far * tie.way)
    respond(kind, chosen, balls, ties)
    gain = 0.0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        gain += dot(tie.slope, tie.way) - 0.5 * dot(tie.way, tie.answer)
    if not gain > 0.0:
        return False
    move(chosen, ties, 1.0)
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.impulse = within(kind, tie, tie.impulse)
    return True


@kernel
def move(chosen, ties, far):
    """Go so far along the way, of which the answer is known."""
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.impulse -= far * tie.way
        tie.more -= far * tie.way
        tie.slope -= far * tie.answer


@kernel
def project(kind, chosen, balls, ties, stride):
    """Downhill, and back within the bounds: pushes all by one stride, as none may come first; rubs
    one after the other, which takes fewer turns."""
    if kind == RUB:
        sweep(chosen, balls, ties)
        return
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        there = within(kind, tie, tie.impulse - stride * tie.slope)
        tie.way = tie.impulse - there
    respond(kind, chosen, balls, ties)
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.impulse = within(kind, tie, tie.impulse - tie.way)
        tie.more -= tie.way
        tie.slope -= tie.answer


@kernel
def sweep(chosen, balls, ties):
    """Each rub takes the slip that those before have left."""
    clear(chosen, balls, ties)
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        there = within(RUB, tie, tie.impulse - tie.slope - answers(RUB, tie, ties))
        change = there - tie.impulse
        attempt(RUB, tie, ties, change)
        tie.impulse = there
        tie.more += change
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.slope += answers(RUB, tie, ties)


@kernel
def clear(chosen, balls, ties):
    """Nothing has been tried on the balls."""
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        for i in (tie.first, other(tie)):
            blow = ties.blows[i]
            ball = balls[i]
            blow.mass, blow.radius, blow.lift, blow.climb = ball.mass, ball.radius, ball.lift, 0.0
            blow.velocity, blow.roll, blow.side = 0j, 0j, 0.0


@kernel
def respond(kind, chosen, balls, ties):
    """What impulses along the way would change, contact by contact: into tie.answer."""
    clear(chosen, balls, ties)
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        attempt(kind, tie, ties, tie.way)
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        tie.answer = answers(kind, tie, ties)


@kernel
def dot(x, y):
    return x.real * y.real + x.imag * y.imag


@kernel
def free(kind, tie):
    """Is the contact's impulse off its bound?"""
    if kind == PUSH:
        return tie.impulse.real > 0.0
    return length(tie.impulse) < INSIDE * tie.bound


@kernel
def wish(kind, tie):
    """The part of the slope that the bound allows to follow."""
    slope = tie.slope
    if free(kind, tie):
        return slope
    if kind == PUSH:
        return slope if slope.real < 0.0 else 0j
    if tie.bound <= 0.0:
        return 0j
    outward = 1.0 / tie.bound * tie.impulse
    out = -dot(outward, slope)
    return slope + out * outward if out > 0.0 else slope


@kernel
def unmet(kind, chosen, ties):
    """The most that a contact still asks for, m/s; and all that those off their bounds ask for, and
    those on them, squared."""
    most, inner, edge = 0.0, 0.0, 0.0
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        pull = wish(kind, tie)
        square = dot(pull, pull)
        if free(kind, tie):
            inner += square
        else:
            edge += square
        lacks = sqrt(square) / tie.size
        if not lacks <= most:  # what is no number is the most
            most = lacks
    return most, inner, edge


@kernel
def within(kind, tie, impulse):
    """The nearest that the bound allows."""
    if kind == PUSH:
        return complex(max(impulse.real, 0.0), 0.0)
    size = length(impulse)
    return tie.bound / size * impulse if size > tie.bound else impulse


@kernel
def reach(kind, tie):
    """How far along its way the contact can go before its bound."""
    way, here = tie.way, tie.impulse
    if kind == PUSH:
        return here.real / way.real if way.real > 0.0 else inf
    square = dot(way, way)
    if square == 0.0:
        return inf
    along = dot(here, way)
    spare = max(tie.bound * tie.bound - dot(here, here), 0.0)
    return (along + sqrt(along * along + square * spare)) / square
