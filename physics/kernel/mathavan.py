"""A cushion whose nose and cloth rub while the ball is pressed in (Mathavan, Jackson, Parkin 2010).

The push of the nose, the rub at it (along the wall, upward) and the drag of the cloth (in its
plane) act together, and the slips that steer rub and drag turn meanwhile. So the motion is
integrated, over its normal speed, which always grows: steps are short where a slip turns fast or
ends, and a slip that has ended is held. Measured errors and cost: docs/accuracy.md.
"""

from .coefficients import restitution, roughness
from .motion import length
from .subset import complex, kernel, sqrt

NONE = 1e-8  # of the closing speed: a slip below this is none
SMALL = 1e-2  # of the closing speed: what a slip below this does in one step matters little
CLOSE = 1e-4  # of the closing speed: so near the end one straight step errs by the square of this
LEAP = 0.5  # of the closing speed: the longest step
PATIENCE = 500  # steps, after which a slip that still flickers between none and some counts as none
TURN, LOSS, MOST = 0.15, 0.4, 0.98  # a step's share of a slip: radians, loss, loss of a small one


@kernel
def slips(v, roll, side, rule):
    """The slips at nose and cloth; linear, so from the rates of motion come those of the slips."""
    along = v.imag + rule.height * roll.imag - rule.level * side
    return complex(along, rule.height * v.real + roll.real), v - roll


@kernel
def rubbing(nose, cloth, none, mu, rule):
    """The rub for a push of 1: against the slip, as long as there is any."""
    speed = length(nose)
    return -mu / speed * nose if speed > none else holding(cloth, none, mu, rule)


@kernel
def holding(cloth, none, mu, rule):
    """The rub that keeps a nose without slip so, while the cloth slips; or all the rub there is."""
    height, level = rule.height, rule.level
    speed = length(cloth)
    back = rule.slide / speed * cloth if speed > none else complex(rule.slide, 0.0)
    pull = (height - 2.5) * back.real
    rise = height * (pull - level) / (height * height + 2.5 + pull * level)
    most = max(0.0, height - level * rise)
    rub = complex((1.0 - 2.5 * height) / 3.5 * most * back.imag, rise)
    size = length(rub)
    return mu / size * rub if size > mu else rub


@kernel
def dragging(rub, cloth, none, rule):
    """The drag, if push and rub press the ball on the cloth: against the slip, or what holds it."""
    most = rule.slide * (rule.height - rule.level * rub.imag)
    if most <= 0.0:
        return 0j
    speed = length(cloth)
    if speed > none:
        return -most / speed * cloth
    lift, lean = rule.height - 2.5, 1.0 - 2.5 * rule.height
    drift = complex(rule.level + lift * rub.imag, lean * rub.real)
    speed = length(drift)
    return (-most / speed if speed > 3.5 * most else -1.0 / 3.5) * drift


@kernel
def rates(v, roll, side, none, mu, rule):
    """What v, roll, side and the push gain as the normal speed grows by 1."""
    nose, cloth = slips(v, roll, side, rule)
    rub = rubbing(nose, cloth, none, mu, rule)
    drag = dragging(rub, cloth, none, rule)
    force = complex(rule.level + rule.height * rub.imag, rub.real) + drag
    push = 1.0 / force.real
    turn = 2.5 * push
    spin = turn * (complex(rub.imag, rule.height * rub.real) - drag)
    return push * force, spin, -turn * rule.level * rub.real, push


@kernel
def leap(v, roll, side, h, rate, none, mu, rule):
    """One step of Runge and Kutta's fourth order; fourth comes the work of the push."""
    half, sixth, u = 0.5 * h, h / 6.0, v.real
    a1, b1, c1, p1 = rate
    a2, b2, c2, p2 = rates(v + half * a1, roll + half * b1, side + half * c1, none, mu, rule)
    a3, b3, c3, p3 = rates(v + half * a2, roll + half * b2, side + half * c2, none, mu, rule)
    a4, b4, c4, p4 = rates(v + h * a3, roll + h * b3, side + h * c3, none, mu, rule)
    return (
        v + sixth * (a1 + 2.0 * (a2 + a3) + a4),
        roll + sixth * (b1 + 2.0 * (b2 + b3) + b4),
        side + sixth * (c1 + 2.0 * (c2 + c3) + c4),
        sixth * rule.level * (u * p1 + (2.0 * u + h) * (p2 + p3) + (u + h) * p4),
    )


@kernel
def steady(slip, rate, none, closing, step):
    """How much of a step leaves the slip about as it is: no more than TURN and LOSS change it."""
    square = slip.real * slip.real + slip.imag * slip.imag
    if square <= none * none:
        return step
    haste = abs(slip.real * rate.imag - slip.imag * rate.real) / TURN
    loss = -(slip.real * rate.real + slip.imag * rate.imag)
    if loss > 0.0:
        haste += loss / LOSS
    if square < (SMALL * closing) * (SMALL * closing):
        haste *= LOSS / MOST
    return square / haste if haste * step > square else step


@kernel
def stride(v, roll, side, rate, rest, none, closing, mu, rule):
    """How far to go at once: both slips stay steady, and friction cannot overshoot."""
    nose, cloth = slips(v, roll, side, rule)
    turning, skidding = slips(rate[0], rate[1], rate[2], rule)
    h = steady(cloth, skidding, none, closing, min(rest, LEAP * closing))
    h = steady(nose, turning, none, closing, h)
    speed, stop = length(nose), 3.5 * mu * rate[3]
    if speed > none and h * stop > speed:
        h = speed / stop
    return 0.5 * rest if 0.6 * rest < h < rest else h


@kernel
def left(u, work, push, rule):
    """How much the normal speed will still grow, if the force stays, until that work is done."""
    square = u * u + 2.0 * work / (push * rule.level)
    return max(sqrt(max(square, 0.0)), rule.parting) - u


@kernel
def mathavan_cushion(v, roll, side, rule):
    """In until the normal speed is 0, then out until the share e² of the work has come back."""
    closing = max(-v.real, rule.parting)
    e, mu = restitution(rule.level * closing, rule), roughness(rule.level * closing, rule)
    none = NONE * closing
    work, goal, steps = 0.0, 0.0, 0
    while True:
        rate = rates(v, roll, side, none, mu, rule)
        u = v.real
        rest = -u if u < 0.0 else left(u, goal - work, rate[3], rule)
        # so written that a NaN ends it too
        if not (u < 0.0 or rest > CLOSE * closing):
            return v + rest * rate[0], roll + rest * rate[1], side + rest * rate[2]
        h = stride(v, roll, side, rate, rest, none, closing, mu, rule)
        v, roll, side, done = leap(v, roll, side, h, rate, none, mu, rule)
        work += done
        steps += 1
        if steps % PATIENCE == 0:
            none *= 10.0
        if u < 0.0 and h == rest:
            v = complex(0.0, v.imag)
            goal = (1.0 - e * e) * work
