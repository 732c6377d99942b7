"""Balls in the air: when they come down, and what they hit there.

Aloft a ball is a stone: its spin stays, its velocity over the table too, and gravity takes its
climb. All else is a contact in some direction (line, rise) from the centre of the ball: (0, -1) is
the cloth. `height` is how far the ball's lowest point is above the cloth, and below zero when it
has left the table.
"""

from .coefficients import roughness
from .laws import SMOOTH_BALL, THESIS_BALL, ball_law, friction, rebound, reduced
from .obstacle import facing, nose
from .subset import complex, kernel, sqrt


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
def hit_nose(ball, wall, rule):
    """The push goes through the centre, wherever the nose meets the ball; friction as it can."""
    across, above = nose(wall, ball.position, ball.radius, ball.height, rule)
    size = sqrt(across * across + above * above)
    line, rise = -across / size * facing(wall, ball.position), above / size
    closing = (line.conjugate() * ball.velocity).real + rise * ball.climb
    grip = roughness(closing, rule)
    meet_fixed(ball, line, rise, rebound(closing, rule) - closing, grip)


@kernel
def meet_fixed(ball, line, rise, parting, grip):
    """A contact with what does not move: they part at that speed."""
    closing, along, up = approach(ball.velocity, ball.climb, ball.roll, ball.side, line, rise)
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
    closing, along, up = approach(v, climb, a.roll + b.roll, a.side + b.side, line, rise)
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
def approach(v, climb, roll, side, line, rise):
    """(closing speed, slip along the table, slip upward) of a contact in that direction.

    The surface there moves with Rω × n besides.
    """
    turn = line.conjugate()
    closing = (turn * v).real + rise * climb
    along, up = rise * roll + 1j * side * line, -(turn * roll).real
    return closing, v - closing * line + along, climb - closing * rise + up


@kernel
def twist(ball, line, rise, along, up):
    """A rub at the surface in that direction turns the ball: R Δω = 5/2 n × J/m."""
    ball.roll += 2.5 * (rise * along - up * line)
    ball.side += 2.5 * (line.conjugate() * along).imag
