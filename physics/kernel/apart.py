"""How contacts that last are pushed apart: pushes, their friction, and no energy unless lent."""

from .impulses import FAILS, PUSH, RUB, WALL, ask, parting, slip_between, solve, speed
from .laws import (
    CUSTOM_BALL,
    SMOOTH_BALL,
    THESIS_BALL,
    ball_law,
    grip,
    law_at,
    reduced,
    rigid_cushion,
)
from .motion import length
from .plastic import energy, keep, loan
from .subset import complex, kernel
from .tilt import tilt

SLIGHT = 1e-9  # of the energy: what one contact lends another, and rounding


@kernel
def hop_apart(members, chosen, scene):
    """Make the chosen contacts part as they should; False if that takes more energy than hops are
    lent, as where contacts face each other."""
    balls, ties = scene.balls, scene.ties
    most = energy(members, balls, ties) + loan(chosen, balls, ties)
    keep(members, balls, ties)
    if not press_apart(chosen, balls, ties, scene.ball_rule, scene.rules, scene.cushion_rule):
        return False
    return opened(chosen, balls, ties) and energy(members, balls, ties) <= (1.0 + SLIGHT) * most


@kernel
def opened(chosen, balls, ties):
    """Do they part as they were asked to?  Huge pushes that cancel leave only their rounding."""
    fastest = speed(chosen, balls, ties)
    for k in range(chosen):
        tie = ties.contacts[ties.chosen[k]]
        if parting(tie, balls) < tie.target - FAILS * fastest:
            return False
    return True


@kernel
def press_apart(chosen, balls, ties, ball_rule, rules, cushion_rule):
    """Impulses that make the chosen contacts part as they should: pushes, what friction makes of
    them, and pushes once more against what that has closed."""
    for stage in range(3):
        kind, count = PUSH, chosen
        if stage == 1:
            kind, count = RUB, ask_rubs(chosen, balls, ties)
        else:
            for k in range(chosen):
                tie = ties.contacts[ties.chosen[k]]
                ask(PUSH, tie, balls)
                if stage == 0:
                    tie.grip = hold(tie, balls, ball_rule)
        if not solve(kind, count, balls, ties):
            return False
        for k in range(chosen):
            tie = ties.contacts[ties.chosen[k]]
            if kind == PUSH:
                tie.total += tie.size * tie.impulse.real
            elif tie.second <= WALL and tie.total > 0.0:
                rule = law_at(WALL - tie.second, rules, cushion_rule)
                brush(balls[tie.first], tie.total, -tie.line, rule)
    return True


@kernel
def ask_rubs(chosen, balls, ties):
    """Put the contacts that a push holds together first among the chosen; returns how many."""
    rubs = 0
    for k in range(chosen):
        c = ties.chosen[k]
        tie = ties.contacts[c]
        if tie.grip * tie.total > 0.0:
            ask(RUB, tie, balls)
            tie.bound = tie.grip * tie.total / tie.size
            ties.chosen[k], ties.chosen[rubs] = ties.chosen[rubs], c
            rubs += 1
    return rubs


@kernel
def hold(tie, balls, rule):
    """The coefficient of friction that the law has for two balls as they are now; 0 at walls."""
    if tie.second <= WALL or rule.kind == SMOOTH_BALL or rule.kind == THESIS_BALL:
        return 0.0
    a, b, line = balls[tie.first], balls[tie.second], tie.line
    if rule.kind != CUSTOM_BALL:
        return grip(slip_between(a, b, line), rule) / tilt(a, b)[0]
    turn = line.conjugate()
    v, roll = turn * (a.velocity - b.velocity), turn * (a.roll + b.roll)
    v = complex(max(v.real, rule.parting), v.imag)
    push, rub = ball_law(v, roll, a.side + b.side, reduced(a, b), 1.0, rule)
    return length(rub) / push if push > 0.0 else 0.0


@kernel
def brush(ball, push, normal, rule):
    """The friction of a cushion that has pushed the ball: the rigid law's, for every law."""
    inward = normal.conjugate()
    v, roll = inward * ball.velocity, inward * ball.roll
    push /= ball.mass * rule.level
    v, roll, ball.side = rigid_cushion(v, roll, ball.side, push, rule)
    v -= rule.level * push  # which the ball has felt
    ball.velocity, ball.roll = normal * v, normal * roll
