"""The program that the thesis prints, number for number and bug for bug.

Its contacts have no test of approach, its spin about the vertical knows one sign, its sliding
friction stops a slip u by turning it into -6 u, and its rolling friction is a force and a torque
that sliding friction undoes. That chatter multiplies a rounding error by six in a substep, so every
operation below comes in the program's order: complex numbers stand for its vectors of three.
Constants and laws are its own; walls, radii and masses are the world's.
"""

from math import sqrt
from typing import Any

from physics.engines.engine import Movable
from physics.kernel.kinds import CUSHION, OFF, PAIR, RESTING, SLIDING
from physics.kernel.motion import length
from physics.kernel.obstacle import NOBODY, POCKET, clearance, facing
from physics.kernel.opening import just_left
from physics.kernel.tilt import between

from .overlap import catch_up, drop, go_off, kept, launch, mark, note

WALL_RESTITUTION = 0.9
WALL_FRICTION = (0.2, 0.5)  # multiplied one after the other
BALL_RESTITUTION = 0.98
SLIDE = 0.2
ROLL = 0.01
ROLL_SPEED = 7.0  # m/s: rolling friction is ROLL times this over the speed
SPIN_DECAY = 10.0  # rad/s²
GRAVITY = 9.8  # m/s²
REACH = sqrt(21.0 / 25.0)  # distance of the nose's contact from the vertical axis, in radii
WALL_NUDGE = 0.5  # of a substep: how far a ball is moved on from a contact
BALL_NUDGE = 0.25


def start(world: Movable, disturbed: list[int]) -> None:
    """Placed or pushed balls, and all others with them, are at a substep's start."""
    catch_up(world)
    for i, ball in enumerate(world.scene.balls):
        if ball.height < 0.0:  # it is gone
            launch(ball, world.scene.cloth)
            mark(world, i)
            continue
        roll, side = ball.roll, ball.side
        w = 1j * (roll / ball.radius)
        begin(ball, 0j, w, side / ball.radius)
        remember(ball, w, side / ball.radius)
        ball.roll, ball.side = roll, side  # R ω as it was given, not rounded twice
        if ball.phase != RESTING or i in disturbed:
            mark(world, i)


# The program keeps ω, and R ω would round it. Fixed steps sweep no boxes: three floats of the box
# that the record has for them hold ω, rad/s, as it will be at the next grid time.


def remember(ball: Any, w: complex, wz: float) -> None:
    """Keep ω: horizontal as w_x + i w_y, and vertical."""
    ball.west, ball.east, ball.south = w.real, w.imag, wz


def spin(ball: Any) -> tuple[complex, float]:
    """ω as it was kept."""
    return complex(ball.west, ball.east), ball.south


def begin(ball: Any, a: complex, w: complex, wz: float) -> None:
    """The leg that the world reads: the program's forces all act at the cloth, as in sliding."""
    ball.acceleration = a
    ball.roll, ball.side = -1j * w * ball.radius, wz * ball.radius
    ball.phase = RESTING if ball.velocity == 0j and w == 0j else SLIDING


def substep(world: Movable, time: float, dt: float, k: int) -> None:
    """Motion, collisions, accelerations: the program's order, begun at its last third."""
    balls = world.scene.balls
    for ball in balls:
        if k:
            travel(ball, dt)
        ball.since = time
    for i, ball in enumerate(balls):
        if ball.phase >= OFF:
            continue
        for j in range(i + 1, len(balls)):
            if balls[j].phase >= OFF:
                continue
            offset = ball.position - balls[j].position
            if between(ball, balls[j], offset) <= ball.radius + balls[j].radius:
                meet(world, time, dt, i, j)
        for n, wall in enumerate(world.scene.walls):
            if wall.kind == POCKET:
                if clearance(wall, ball.position, 0.0) < 0.0:
                    drop(world, time, i, n)
                    break
            elif abs(clearance(wall, ball.position, 0.0)) < ball.radius:
                bounce(world, time, dt, i, n)
        through = just_left(world.scene.openings, ball.position, ball.velocity, ball.radius)
        if through != NOBODY and ball.phase < OFF:
            go_off(world, time, i, NOBODY - through)
    rate = per_second(dt)
    for i, ball in enumerate(balls):
        if ball.phase >= OFF:
            continue
        w, wz = spin(ball)
        a, alpha, alpha_z = forces(ball, w, wz, dt, rate)
        begin(ball, a, w, wz)
        remember(ball, w + alpha * dt, wz + alpha_z * dt)
        if kept(k, dt) and ball.phase != RESTING:
            mark(world, i)


def per_second(dt: float) -> float:
    """Substeps a second: the program's own number, where dt is its reciprocal."""
    rate = 1.0 / dt
    return round(rate) if 1.0 / round(rate) == dt else rate


def travel(ball: Any, dt: float) -> None:
    """A substep of the motion."""
    ball.position += ball.velocity * dt + 0.5 * ball.acceleration * (dt * dt)
    ball.velocity += ball.acceleration * dt


def forces(
    ball: Any, w: complex, wz: float, dt: float, rate: float
) -> tuple[complex, complex, float]:
    """Acceleration, and angular acceleration about the horizontal and about the vertical."""
    v, r, m = ball.velocity, ball.radius, ball.mass
    inertia = 2 * (m * (r * r)) / 5
    a = alpha = 0j
    slip = v + 1j * r * w
    size = length(slip)
    if size > 0.0:
        if SLIDE * GRAVITY * dt >= size:
            force = -0.5 * slip * rate  # without the mass: 1 / m times too much
        else:
            force = m * SLIDE * GRAVITY * -1 * (slip / size)
        a += force / m
        alpha += (1 / inertia) * (-1j * r * force)
    size = length(v)
    if size != 0.0:
        if ROLL * GRAVITY * dt * (ROLL_SPEED / size) <= size:
            force = -ROLL * m * GRAVITY * (v / size) * (ROLL_SPEED / size)
        else:
            force = -m * v * rate
        a += force / m
        alpha += -1j * r * force / inertia
    return a, alpha, -SPIN_DECAY if wz >= SPIN_DECAY * dt else -wz * rate


def bounce(world: Movable, time: float, dt: float, i: int, n: int) -> None:
    """Ball i overlaps wall n, coming or going."""
    ball = world.scene.balls[i]
    normal = facing(world.scene.walls[n], ball.position)
    w, wz = come(world, i)
    v, r, m = ball.velocity, ball.radius, ball.mass
    toward = (v * normal.conjugate()).real
    w += (1 + WALL_RESTITUTION) / r * -toward * (1j * normal)
    ball.velocity += (1 + WALL_RESTITUTION) * -toward * normal
    slip = -(REACH * r) * (1j * (wz * normal)) + (v - toward * normal)
    size = length(slip)
    if size > 0.0:
        rub = m * (1 + WALL_RESTITUTION) * -toward * WALL_FRICTION[0] * WALL_FRICTION[1]
        if rub >= size:  # an impulse against a velocity
            rub = 0.5 * size
        impulse = rub * (-1 * (slip / size))
        ball.velocity += impulse / m
        lever = -1 * r * REACH * normal
        wz += (lever.conjugate() * impulse).imag / (2 * (m * (r * r)) / 5)
    ball.position += WALL_NUDGE * ball.velocity * dt
    leave(world, time, i, w, wz)
    note(world, time, CUSHION, i, n)


def meet(world: Movable, time: float, dt: float, i: int, j: int) -> None:
    """Balls i and j overlap, coming or going: what each had along the line, the other gets."""
    a, b = world.scene.balls[i], world.scene.balls[j]
    (wa, za), (wb, zb) = come(world, i), come(world, j)
    line = b.position - a.position
    line = line / (length(line) or 2.0**-52)
    across, e = 1j * line, BALL_RESTITUTION
    va = (a.velocity * line.conjugate()).real * line
    vb = (b.velocity * line.conjugate()).real * line
    ta = (wa * across.conjugate()).real * across
    tb = (wb * across.conjugate()).real * across
    a.velocity, b.velocity = a.velocity - va + e * vb, b.velocity - vb + e * va
    a.position += BALL_NUDGE * a.velocity * dt
    b.position += BALL_NUDGE * b.velocity * dt
    leave(world, time, i, wa + (-1 * ta + e * tb), za)
    leave(world, time, j, wb + (-1 * tb + e * ta), zb)
    if line != 0j:  # balls in one place have no line: nothing has passed between them
        note(world, time, PAIR, i, j)


def come(world: Movable, i: int) -> tuple[complex, float]:
    """The spin with which ball i comes to a contact; its state then goes into the log."""
    ball = world.scene.balls[i]
    w, wz = spin(ball)
    begin(ball, 0j, w, wz)
    mark(world, i)
    return w, wz


def leave(world: Movable, time: float, i: int, w: complex, wz: float) -> None:
    """Ball i after a contact; its acceleration follows when all contacts are done."""
    ball = world.scene.balls[i]
    begin(ball, 0j, w, wz)
    remember(ball, w, wz)
    mark(world, i)
