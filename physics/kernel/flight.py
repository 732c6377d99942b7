"""Balls in the air: when they come down, and what they hit there.

Aloft a ball is a stone: its spin stays, its velocity over the table too, and gravity takes its
climb. All else is a contact in some direction (line, rise) from the centre of the ball: (0, -1) is
the cloth. `height` is how far the ball's lowest point is above the cloth, and below zero when it
has left the table.
"""

from .coefficients import roughness
from .contact import contact_time, first_fall
from .laws import SMOOTH_BALL, THESIS_BALL, ball_law, friction, rebound, reduced
from .motion import AIRBORNE, OFF
from .subset import complex, inf, kernel, sqrt

LEAVES = -2  # less the number of the wall: the goal of a leg over that cushion
BELOW = -1.0  # m: the height of a ball that has left the table


@kernel
def aloft(ball):
    """Is it anywhere but on the cloth?"""
    return ball.height != 0.0 or ball.climb != 0.0


@kernel
def plan_flight(ball, walls, cloth, rule):
    """How the ball flies, and until when."""
    ball.acceleration, ball.fall = 0j, 0.0
    if ball.height < 0.0:
        ball.phase = OFF
        return inf
    ball.phase, ball.fall = AIRBORNE, cloth.gravity
    lasts = first_fall(ball.height, ball.climb, -cloth.gravity)
    for k in range(len(walls)):
        across, above = nose(gap(ball, walls[k]), ball.radius, ball.height, rule)
        speed = (walls[k].inward * ball.velocity).real
        wait = contact_time(
            complex(across, -above), complex(speed, ball.climb), complex(0.0, -ball.fall),
            ball.radius, lasts,
        )  # fmt: skip
        if wait < lasts:
            lasts, ball.goal = wait, k
        if speed < 0.0:
            wait = max(0.0, -across / speed)
            if wait < lasts:
                lasts, ball.goal = wait, LEAVES - k
    return lasts


@kernel
def gap(ball, wall):
    """How far the ball is from touching the wall on the table."""
    return (wall.inward * ball.position).real - wall.offset - ball.radius


@kernel
def nose(gap, radius, height, rule):
    """How far the centre is from the nose of the cushion, across, and the nose above the centre.

    On the table a ball touches it at `rule.height` radii above the centre.
    """
    return gap + radius * rule.level, radius * rule.height - height


@kernel
def land(ball, cloth, parting):
    """It comes down, and stays there if it would go up more slowly than `parting`."""
    up = -cloth.bounce * ball.climb
    if up < parting or ball.climb >= 0.0:  # so small a hop that it took no time
        up = 0.0
    if ball.climb < 0.0:
        meet_fixed(ball, 0j, -1.0, up, cloth.grip)
    ball.height, ball.climb, ball.fall = 0.0, up, 0.0


@kernel
def leave_table(ball):
    """It is over the cushion, and off the table."""
    ball.velocity, ball.roll, ball.side = 0j, 0j, 0.0
    ball.height, ball.climb, ball.fall = BELOW, 0.0, 0.0


@kernel
def hit_nose(ball, wall, rule):
    """The push goes through the centre, wherever the nose meets the ball; friction as it can."""
    across, above = nose(gap(ball, wall), ball.radius, ball.height, rule)
    size = sqrt(across * across + above * above)
    line, rise = -across / size * wall.normal, above / size
    closing = (line.conjugate() * ball.velocity).real + rise * ball.climb
    grip = roughness(closing, rule)
    meet_fixed(ball, line, rise, rebound(closing, rule) - closing, grip)


@kernel
def meet_fixed(ball, line, rise, parting, grip):
    """A contact with what does not move: they part at that speed."""
    v, climb = ball.velocity, ball.climb
    closing = (line.conjugate() * v).real + rise * climb
    along, up = skin(ball.roll, ball.side, line, rise)
    along, up = v - closing * line + along, climb - closing * rise + up
    slip = sqrt(along.real * along.real + along.imag * along.imag + up * up)
    push = closing + parting
    ball.velocity -= push * line
    ball.climb -= push * rise
    if slip > 0.0:
        rub = friction(complex(slip, 0.0), grip * push, 3.5).real / slip
        ball.velocity += rub * along
        ball.climb += rub * up
        twist(ball, line, rise, rub * along, rub * up)


@kernel
def hit_aloft(a, b, rule):
    """Two balls, one at least in the air: the law of balls in the plane of normal and slip."""
    line, rise = b.position - a.position, b.height - a.height + (b.lift - a.lift)
    far = sqrt(line.real * line.real + line.imag * line.imag + rise * rise)
    line, rise = 1.0 / far * line, rise / far
    v, climb = a.velocity - b.velocity, a.climb - b.climb
    closing = (line.conjugate() * v).real + rise * climb
    along, up = skin(a.roll + b.roll, a.side + b.side, line, rise)
    along, up = v - closing * line + along, climb - closing * rise + up
    slip = sqrt(along.real * along.real + along.imag * along.imag + up * up)
    push, rub = pair(complex(closing, slip), reduced(a, b), rule)
    if slip > 0.0:
        along, up = rub / slip * along, rub / slip * up
    shove(a, push, line, rise, along, up)
    shove(b, -push, line, rise, -along, -up)
    twist(a, line, rise, 1.0 / a.mass * along, up / a.mass)
    twist(b, line, rise, 1.0 / b.mass * along, up / b.mass)
    return push


@kernel
def pair(v, mass, rule):
    """(push, rub) between balls that have v as their relative (normal speed, slip)."""
    if rule.kind == THESIS_BALL or rule.kind == SMOOTH_BALL:
        return mass * rebound(v.real, rule), 0.0
    push, rub = ball_law(v, 0j, 0.0, mass, 1.0, rule)
    return push, rub.real


@kernel
def shove(ball, push, line, rise, along, up):
    ball.velocity += 1.0 / ball.mass * (along - push * line)
    ball.climb += (up - push * rise) / ball.mass


@kernel
def skin(roll, side, line, rise):
    """Rω × n: how fast the ball's surface moves where it looks in the direction n."""
    return rise * roll + 1j * side * line, -(line.conjugate() * roll).real


@kernel
def twist(ball, line, rise, along, up):
    """A rub at the surface in that direction turns the ball: R Δω = 5/2 n × J/m."""
    ball.roll += 2.5 * (rise * along - up * line)
    ball.side += 2.5 * (line.conjugate() * along).imag
