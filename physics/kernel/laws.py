"""What a collision does.

A cushion law sees the wall as the line x = 0 with the table at x > 0, a ball law sees the second
ball in the direction +x: the caller turns the picture there and back, and spins about the third
axis too where the line of centres is tilted. A complex rub is (along, upward).
"""

from .coefficients import fraction, roughness
from .elementary import exp
from .mathavan import mathavan_cushion
from .motion import length
from .subset import complex, custom_ball, custom_cushion, kernel
from .tilt import levelled, tilt

RIGID_CUSHION, THESIS_CUSHION, CAPPED_CUSHION, MATHAVAN_CUSHION, CUSTOM_CUSHION = 0, 1, 2, 3, 4
SMOOTH_BALL, ROUGH_BALL, ALCIATORE_BALL, CUSTOM_BALL, THESIS_BALL = 0, 1, 2, 3, 4


@kernel
def rebound(closing, rule):
    """The change of the normal velocity.

    Touching bodies always separate; otherwise contacts could last forever.
    """
    e = rule.restitution
    if rule.restitution_slope != 0.0:
        e = fraction(e, rule.restitution_slope, closing)
    parting = e * closing
    return closing + (parting if parting > rule.parting else rule.parting)


@kernel
def friction(slip, most, yielding):
    """Against the slip, no more than `most` and no more than stops it."""
    speed = length(slip)
    if speed > most * yielding and speed > 0.0:
        return -most / speed * slip
    return -1.0 / yielding * slip


@kernel
def rigid_cushion(v, roll, side, push, rule):
    """A push through the centre of the ball, m/s, and friction in the plane across it."""
    height, level = rule.height, rule.level
    slip = complex(v.imag + height * roll.imag - level * side, height * v.real + roll.real)
    rub = friction(slip, roughness(-level * v.real, rule) * push, 3.5)
    v += complex(level * push + height * rub.imag, rub.real)
    roll += 2.5 * complex(rub.imag, height * rub.real)
    return v, roll, side - 2.5 * level * rub.real


@kernel
def thesis_cushion(v, roll, side, rule):
    """A push at 7/5 R that keeps a rolling ball rolling, and Coulomb's friction without a cap."""
    push = rebound(-v.real, rule)
    slip = v.imag - rule.level * side
    rub = -rule.friction * push if slip > 0.0 else rule.friction * push if slip < 0.0 else 0.0
    return v + complex(push, rub), roll + push, side - 2.5 * rule.level * rub


@kernel
def capped_cushion(v, roll, side, rule):
    """The same push; friction with its whole lever arm, and no more of it than stops the slip."""
    height, level = rule.height, rule.level
    push = rebound(-v.real, rule)
    slip = v.imag + height * roll.imag - level * side
    rub = friction(complex(slip, 0.0), rule.friction * push, 3.5).real
    return (
        v + complex(push, rub),
        roll + complex(push, 2.5 * height * rub),
        side - 2.5 * level * rub,
    )


@kernel
def cushion(v, roll, side, rule):
    if rule.kind == RIGID_CUSHION:
        return rigid_cushion(v, roll, side, rebound(-rule.level * v.real, rule), rule)
    if rule.kind == MATHAVAN_CUSHION:
        return mathavan_cushion(v, roll, side, rule)
    if rule.kind == CAPPED_CUSHION:
        return capped_cushion(v, roll, side, rule)
    if rule.kind == CUSTOM_CUSHION:
        return custom_cushion(v, roll, side, rule)
    return thesis_cushion(v, roll, side, rule)


@kernel
def law_at(k, rules, common):
    """The law of wall k: its own, where any has one."""
    return rules[k] if len(rules) > 0 else common


@kernel
def grip(slip, rule):
    """The coefficient of friction between two balls."""
    if rule.kind == ALCIATORE_BALL:
        return 0.009951 + 0.108 * exp(-1.088 * length(slip))
    if rule.friction_slope != 0.0:
        return fraction(rule.friction, rule.friction_slope, length(slip))
    return rule.friction


@kernel
def ball_law(v, roll, side, mass, level, rule):
    """(push, rub) on the first ball, from relative velocity, summed roll and side, reduced mass.

    The push is along the table. It is the share `level` of all that presses the balls together.
    """
    if rule.kind == CUSTOM_BALL:
        return custom_ball(v, roll, side, mass, rule)
    push = mass * rebound(v.real, rule)
    if rule.kind == SMOOTH_BALL:
        return push, 0j
    slip = complex(v.imag + side, -roll.real)
    return push, friction(slip, grip(slip, rule) * push / level, 3.5 / mass)


@kernel
def hit_wall(ball, normal, rule):
    """Turn the picture so that the wall's normal is the x axis, and back."""
    inward = normal.conjugate()
    v, roll, ball.side = cushion(inward * ball.velocity, inward * ball.roll, ball.side, rule)
    if v.real < rule.parting:  # no law may let it go on into the wall
        v = complex(rule.parting, v.imag)
    ball.velocity, ball.roll = normal * v, normal * roll


@kernel
def toward(a, b):
    """The direction from ball a to ball b, which are where they touch."""
    line = b.position - a.position
    return 1.0 / length(line) * line


@kernel
def reduced(a, b):
    """The reduced mass."""
    return a.mass * (b.mass / (a.mass + b.mass))


@kernel
def hit_ball(a, b, rule):
    """One law for the pair; returns the push between them."""
    line = toward(a, b)
    if rule.kind == THESIS_BALL:
        return swap(a, b, line, rule)
    if a.lift != b.lift:
        return hit_tilted(a, b, line, rule)
    turn = line.conjugate()
    mass = a.mass * (b.mass / (a.mass + b.mass))  # the product of two small masses may be none
    v, roll = turn * (a.velocity - b.velocity), turn * (a.roll + b.roll)
    push, rub = ball_law(v, roll, a.side + b.side, mass, 1.0, rule)
    press(a, b, line, push, rub)
    return push


@kernel
def hit_tilted(a, b, line, rule):
    """The same law for balls of two sizes: their spins are turned until the line is level."""
    turn = line.conjugate()
    mass = reduced(a, b)
    roll, side = levelled(a, b, turn * (a.roll + b.roll), a.side + b.side)
    push, rub = ball_law(turn * (a.velocity - b.velocity), roll, side, mass, tilt(a, b)[0], rule)
    press(a, b, line, push, rub)
    return push


@kernel
def press(a, b, line, push, rub):
    """Equal and opposite impulses; equal and opposite rubs turn both balls the same way."""
    impulse = complex(push, -rub.real) * line
    a.velocity -= 1.0 / a.mass * impulse
    b.velocity += 1.0 / b.mass * impulse
    if rub != 0j:
        if a.lift == b.lift:
            gear(a, rub, line)
            gear(b, rub, line)
        else:
            gear_tilted(a, b, rub, line)


@kernel
def gear(ball, rub, line):
    lever = 2.5 / ball.mass
    ball.roll -= lever * rub.imag * line
    ball.side += lever * rub.real


@kernel
def gear_tilted(a, b, rub, line):
    """The rub turns balls about axes that are tilted as their line of centres is."""
    level, rise = tilt(a, b)
    roll, side = 2.5 * complex(-rub.imag, rise * rub.real) * line, 2.5 * level * rub.real
    a.roll += 1.0 / a.mass * roll
    b.roll += 1.0 / b.mass * roll
    a.side += side / a.mass
    b.side += side / b.mass


@kernel
def swap(a, b, line, rule):
    """The thesis's law: along the line of centres each gets e times what the other had.

    It loses momentum, and so is the one law that moves both balls itself; the floor of the parting
    speed is shared between them.
    """
    turn = line.conjugate()
    va, vb = turn * a.velocity, turn * b.velocity
    ra, rb = turn * a.roll, turn * b.roll
    e = rule.restitution
    out_a, out_b = e * vb.real, e * va.real
    lacks = rule.parting - (out_b - out_a)
    if lacks > 0.0:
        out_a -= 0.5 * lacks
        out_b += 0.5 * lacks
    a.velocity, b.velocity = line * complex(out_a, va.imag), line * complex(out_b, vb.imag)
    # ω along the tangent is roll / R along the line of centres
    scale = a.radius / b.radius
    a.roll = line * complex(e * scale * rb.real, ra.imag)
    b.roll = line * complex(e / scale * ra.real, rb.imag)
    return a.mass * (va.real - out_a)
