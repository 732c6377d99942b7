"""Contacts that last: something presses things together, and they stay together.

Legs are parabolas of one ball each, so a contact under pressure is a row of hops. How high they
are is free: only their mean is physics. A contact that comes back soon, and slowly, lasts if what
presses it would bring it back again from a hop lower than HOP. Then it parts just fast enough to
hop that high, and all that hang together with it come down at the same time. The speed of a hop
is lent: when it comes back with it, nothing rebounds.

Nor does what is held: a light ball between a heavy one and a cushion hits both again and again,
losing energy each time, until nothing closes."""

from .apart import hop_apart
from .body import CONTACTS
from .cluster import NOISE, TOUCHING, join, pace, seat, touching
from .coefficients import restitution
from .grid import neighbours
from .impulses import WALL, dot, other, parting
from .laws import law_at
from .leg import carry, place
from .motion import length, motion
from .obstacle import clearance, facing, holds, opposed
from .plastic import wedge
from .subset import inf, kernel, room, sqrt
from .tilt import touching_distance

FEW = 10  # slow hits of two balls in a row: those of a break have parted before
HOP = 2e-3  # radii: how far things part that stay together
PATIENT = 100  # hops of that height; then higher ones: no player's ball spins for so long
GROWTH = 0.04  # of the length of a hop, each time
LONGEST = 12.0  # times the length of the first
SLOW = 4.4 * HOP  # times slide and radius: m²/s², of the highest hop and a little more, as sliding
# presses two balls together with twice its own deceleration
SPREAD = 2.0  # hops: gaps below that belong to the same contact
LIGHTLY = 0.1  # of the least parting speed: what parts when nothing presses it any more
FAR = 0.1  # radii: no gap above that does (cells are laid for it)
ALIKE = 0.99  # the cosine of the angle between two walls below which they are one: 8°
NEVER = -1.0  # when a ball met something slowly, if the last that it met it met quickly


@kernel
def leans(a, b, cloth):
    """Do two balls, which have just met, close so slowly that the cloth could keep them there?"""
    line = b.position - a.position
    closing = dot(line, a.velocity - b.velocity)
    square = dot(line, line)
    radius = a.radius if a.radius < b.radius else b.radius
    if closing * closing <= SLOW * cloth.slide * radius * square:
        return True
    if a.lent == 0.0:
        return False
    lent = 2.0 * min(a.lent, b.lent)
    return closing * closing <= lent * lent * square


@kernel
def rests_on(ball, normal, cloth):
    """Does a ball that has just met a wall close so slowly that the cloth could keep it there?"""
    closing = -(normal.conjugate() * ball.velocity).real
    return closing <= 2.0 * ball.lent or closing * closing <= SLOW * cloth.slide * ball.radius


@kernel
def meets_slowly(ball, time, i):
    """If it goes on like this, it stays together with what it meets in this event of ball i."""
    ball.hops = min(ball.hops + 1, FEW) if ball.hopped != NEVER else 1
    ball.hopped, ball.met, ball.lent = time, i, 0.0


@kernel
def met_last(a, b):
    """Was what both last met each other, or of one group, and slowly?"""
    return a.hopped == b.hopped and a.met == b.met and a.hopped != NEVER


@kernel
def forget(ball):
    """What it met does not count any more."""
    ball.hopped, ball.met, ball.hops, ball.lent = NEVER, -1, 0, 0.0


@kernel
def gather_slow(i, j, time, held, balls, ties, walls, grid, slide):
    """All that hangs together with ball i and ball j, or wall -1 - j, by small gaps that hardly
    change, or if it is held, by none: how many balls, in ties.member, and contacts."""
    near = TOUCHING if held else min(SPREAD * HOP * stretch(balls[i]) ** 2, FAR)
    member = ties.member
    member[0] = i
    room(ties, 1)
    join(i, j, ties.contacts[0])
    members, contacts, m = 1, 1, 0
    if j > WALL:
        member[1], members = j, 2
    else:
        measure(ties.contacts[0], time, balls, walls)
    while m < members:
        a = member[m]
        here = place(balls[a], time - balls[a].since)
        for n in range(neighbours(a, balls, grid)):
            k = grid.near[n]
            if not touching(balls[a], here, balls[k], time, near):
                continue
            at = seat(k, member, members)
            # a contact among members is found by the earlier of them; the first is there already
            if (m == 0 and k == j) or at <= m or contacts == CONTACTS * len(balls):
                continue
            room(ties, contacts + 1)
            join(a, k, ties.contacts[contacts])
            if clings(ties.contacts[contacts], near, time, held, balls, walls, slide):
                contacts += 1
                if at == members:
                    member[members] = k
                    members += 1
        known = WALL - j if m == 0 else -1
        contacts = gather_walls(a, known, contacts, near, time, held, balls, ties, walls, slide)
        m += 1
    return members, contacts


@kernel
def gather_walls(a, known, contacts, near, time, held, balls, ties, walls, slide):
    """The same for the walls that ball a leans on, but for the known one: how many contacts now."""
    ball = balls[a]
    here = place(ball, time - ball.since)
    for k in range(len(walls)):
        if k == known or contacts == CONTACTS * len(balls):
            continue
        if not holds(walls[k], here, ball.radius, near * ball.radius):
            continue
        room(ties, contacts + 1)
        join(a, WALL - k, ties.contacts[contacts])
        if clings(ties.contacts[contacts], near, time, held, balls, walls, slide):
            contacts += not alike(contacts, ties)
    return contacts


@kernel
def clings(tie, near, time, held, balls, walls, slide):
    """Is it a contact, or was one just now, that opens and closes no faster than hops do, or is
    held?"""
    a, b = balls[tie.first], balls[other(tie)]
    if a.hopped == NEVER or b.hopped == NEVER:
        near = min(near, TOUCHING)
    gap, radius = measure(tie, time, balls, walls)
    if gap > near * radius or held:
        return gap <= near * radius
    speed = dot(tie.line, moving(a, time))
    if tie.second > WALL:
        speed -= dot(tie.line, moving(b, time))
    longest = stretch(a)
    return speed * speed <= 4.0 * longest * longest * SLOW * slide * radius


@kernel
def alike(c, ties):
    """Does another wall hold that ball from nearly the same direction, or from the opposite?"""
    tie = ties.contacts[c]
    for k in range(c):
        before = ties.contacts[k]
        same = before.first == tie.first and before.second <= WALL
        if same and (dot(tie.line, before.line) > ALIKE or opposed(tie.line, before.line)):
            return True
    return False


@kernel
def moving(ball, time):
    """Its velocity then."""
    return ball.velocity + (time - ball.since) * ball.acceleration


@kernel
def stretch(ball):
    """How many times longer than at first the ball hops by now."""
    return min(max(1.0, 1.0 + GROWTH * (ball.hops - PATIENT)), LONGEST)


@kernel
def press_of(tie, balls):
    """What presses the contact, m/s²."""
    acceleration = balls[tie.first].acceleration
    if tie.second > WALL:
        acceleration -= balls[tie.second].acceleration
    return (tie.line.conjugate() * acceleration).real


@kernel
def measure(tie, time, balls, walls):
    """Set the line of the contact; returns its gap and the smaller radius."""
    a = balls[tie.first]
    p = place(a, time - a.since)
    if tie.second <= WALL:
        wall = walls[WALL - tie.second]
        tie.line = -facing(wall, p)
        return clearance(wall, p, a.radius), a.radius
    b = balls[tie.second]
    q = place(b, time - b.since) - p
    far = length(q)
    tie.line = 1.0 / far * q
    return far - touching_distance(a, b), min(a.radius, b.radius)


@kernel
def pressure(contacts, time, balls, ties, walls, cloth):
    """What presses the contact that is pressed most, m/s², and how long they all hop: as long as
    that one, or until what presses ends, so that no hop is under way when nothing brings it back.
    """
    most, shortest = 0.0, inf
    for c in range(contacts):
        tie = ties.contacts[c]
        _, radius = measure(tie, time, balls, walls)
        press = press_of(tie, balls)
        if press > 0.0:
            most = max(most, press)
            longer = stretch(balls[tie.first])
            shortest = min(shortest, longer * sqrt(8.0 * HOP * radius / press))
            shortest = min(shortest, pressing(balls[tie.first], time, tie.line, cloth))
            if tie.second > WALL:
                shortest = min(shortest, pressing(balls[tie.second], time, -tie.line, cloth))
    return most, shortest


@kernel
def pressing(ball, time, line, cloth):
    """How long the cloth will still drive the ball in that direction; inf if it does not."""
    if dot(line, ball.acceleration) <= 0.0:
        return inf
    _, _, lasting = motion(ball.velocity, ball.roll, cloth)
    return lasting - (time - ball.since)


@kernel
def lent_to(tie, balls):
    """What the contact was lent for the hop from which it comes, or 0, m/s."""
    a, b = balls[tie.first], balls[other(tie)]
    return min(a.lent, b.lent) if met_last(a, b) else 0.0


@kernel
def stays(tie, most, balls, rule):
    """Does the contact come back with what it was lent, or would it soon, if it rebounded?"""
    lent, closing = lent_to(tie, balls), -parting(tie, balls)
    if lent > 0.0 and closing <= 2.0 * lent:
        return True
    lift = 2.0 * most * HOP * balls[tie.first].radius  # the square of the speed of a hop
    apart = restitution(closing, rule) * closing
    fits = apart * apart <= lift and closing * closing <= 4.0 * lift
    return fits and rule.parting * rule.parting <= lift


@kernel
def aim(tie, time, most, lasting, least, held, balls, walls, rule):
    """Set how fast the contact has to part: so that it is closed again `lasting` seconds from now.

    Returns the speed of its hop, m/s.
    """
    gap, radius = measure(tie, time, balls, walls)
    press, closing, lent = press_of(tie, balls), -parting(tie, balls), lent_to(tie, balls)
    lift = 0.5 * press * lasting if press > 0.0 else 0.0
    hop = sqrt(2.0 * most * HOP * radius) * stretch(balls[tie.first])
    back = held or closing <= 2.0 * max(lent, hop)
    if gap >= TOUCHING * radius:
        together = back and 0.0 < lasting < inf
        tie.target = lift - gap / lasting if together else -inf
        return max(lift, lent)  # if it closes later, it still knows what it was lent
    if closing <= 0.0 and press <= 0.0:
        tie.target = least
    elif back:
        tie.target = max(LIGHTLY * rule.parting, lift, least)
    else:
        tie.target = max(restitution(closing, rule) * closing, rule.parting, lift)
    return lift


@kernel
def aside(contacts, balls, ties):
    """What parts so fast does not come back by rounding, m/s."""
    return 1e-3 * NOISE * pace(contacts, balls, ties)


@kernel
def aim_all(contacts, time, most, lasting, held, scene):
    """Set it for all contacts, and choose those that have to part: (the highest speed of a hop, how
    many are chosen)."""
    balls, ties = scene.balls, scene.ties
    least = aside(contacts, balls, ties)
    lent, chosen = 0.0, 0
    for c in range(contacts):
        tie = ties.contacts[c]
        rule = scene.ball_rule
        if tie.second <= WALL:
            rule = law_at(WALL - tie.second, scene.rules, scene.cushion_rule)
        lift = aim(tie, time, most, lasting, least, held, balls, scene.walls, rule)
        lent = max(lent, lift)
        if tie.target > -inf:
            ties.chosen[chosen] = c
            chosen += 1
    return lent, chosen


@kernel
def lean(i, j, time, held, scene):
    """Ball i meets ball j, or wall -1 - j, slowly, or is held between balls and walls: (balls,
    contacts) if they stay together.

    No contacts if they do not.
    """
    balls, ties, walls, cloth = scene.balls, scene.ties, scene.walls, scene.cloth
    members, contacts = gather_slow(i, j, time, held, balls, ties, walls, scene.grid, cloth.slide)
    most, lasting = pressure(contacts, time, balls, ties, walls, cloth)
    first_rule, least = scene.ball_rule, scene.ball_rule.restitution
    if j <= WALL:
        first_rule = law_at(WALL - j, scene.rules, scene.cushion_rule)
    if held:
        least = min(least, scene.cushion_rule.restitution)
        for k in range(len(scene.rules)):
            least = min(least, scene.rules[k].restitution)
        if members == 1 or least >= 1.0:
            return members, 0
    elif not stays(ties.contacts[0], most, balls, first_rule):
        return members, 0
    for m in range(members):
        carry(balls[ties.member[m]], time, cloth)
    lent, chosen = aim_all(contacts, time, most, lasting, held, scene)
    hops = hop_apart(members, chosen, scene)
    if not hops:
        wedge(members, contacts, aside(contacts, balls, ties), balls, ties)
    for m in range(members):
        ball = balls[ties.member[m]]
        ball.hopped, ball.met, ball.lent = time, i, lent if hops else 0.0
        ball.hops = max(ball.hops, FEW) + 1
        if held and hops:
            ball.trapped = 0
    return members, contacts
