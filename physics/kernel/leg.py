"""A leg: what a ball does from one event to the next.

Where it is on a leg is a polynomial of the time. Which leg it is on follows from its state alone,
and is a matter of its phase (kinds.py): `begin` finds the phase, `moved` goes along it, `end` ends
it.
"""

from .kinds import AIRBORNE, DROP, LAND, LEAVE, OFF, POCKETED, RESTING, ROLL, ROLLING, SLOW
from .motion import faded, length, motion
from .subset import inf, kernel, sqrt

BELOW = -1.0  # m: the height of a ball that has left the table
DOWN = -2.0  # m: and of one in a pocket
JUST = 1.0 + 1e-9  # times a speed: what is no faster has come down to it


@kernel
def travelled(p, v, a, t):
    """Where that is after t which is at p now, and has velocity v and acceleration a."""
    return p + t * (v + 0.5 * t * a)


@kernel
def first_fall(gap, speed, bend):
    """The first t at which gap + speed t + bend t²/2 is not positive and falling."""
    if speed < 0.0:
        if gap <= 0.0:
            return 0.0
        square = speed * speed - 2.0 * bend * gap
        return 2.0 * gap / (sqrt(square) - speed) if square >= 0.0 else inf
    if bend >= 0.0:
        return inf
    square = speed * speed - 2.0 * bend * gap
    return (speed + sqrt(square)) / -bend if square > 0.0 else 0.0


@kernel
def swept(x, y, v, a, t):
    """The interval that x + v t + a t²/2 has visited after t, when it is y."""
    low, high = (x, y) if x < y else (y, x)
    if v * (v + a * t) < 0.0:
        turn = x - 0.5 * v * v / a
        return min(low, turn), max(high, turn)
    return low, high


@kernel
def place(leg, t):
    """Where the ball is, t into its leg."""
    return travelled(leg.position, leg.velocity, leg.acceleration, t)


@kernel
def aloft(ball):
    """Is it anywhere but on the cloth?"""
    return ball.height != 0.0 or ball.climb != 0.0


@kernel
def begin(ball, cloth):
    """The phase that a ball is in, as it lies or moves now; returns how long that lasts if nothing
    meets it."""
    if ball.height != 0.0 or ball.climb != 0.0:  # `aloft`, which every leg would call
        ball.acceleration, ball.fall = 0j, 0.0
        if ball.height < 0.0:
            ball.phase = OFF if ball.height > DOWN else POCKETED
            return inf
        ball.phase, ball.ending, ball.fall = AIRBORNE, LAND, cloth.gravity
        return first_fall(ball.height, ball.climb, -cloth.gravity)
    phase, ball.acceleration, lasts = motion(ball.velocity, ball.roll, cloth)
    if phase == RESTING:
        ball.velocity = 0j
        ball.roll = 0j
    ball.phase, ball.ending = phase, ROLL
    return lasts


@kernel
def brake(ball, cloth, bands):
    """Rolling resistance that depends on the speed: that of the ball's band, until it has come down
    to the next one; returns how long that lasts."""
    speed = length(ball.velocity)
    k = len(bands) - 1
    while k > 0 and speed <= JUST * bands[k].speed:
        k -= 1
    loss = bands[k].share * cloth.roll
    if k > 0:
        ball.ending = SLOW
    ball.acceleration = -loss / speed * ball.velocity
    return (speed - bands[k].speed) / loss if loss > 0.0 else inf


@kernel
def moved(leg, t, fade):
    """Its motion t into the leg: position, velocity, roll and side."""
    velocity, a = leg.velocity, leg.acceleration
    gain = t * a
    roll = leg.roll + (gain if leg.phase == ROLLING else -2.5 * gain)
    side = leg.side if leg.phase == AIRBORNE else faded(leg.side, t * leg.radius * fade)
    return travelled(leg.position, velocity, a, t), velocity + gain, roll, side


@kernel
def risen(leg, t):
    """Its height and climb t into the leg."""
    return travelled(leg.height, leg.climb, -leg.fall, t), leg.climb - t * leg.fall


@kernel
def carry(ball, time, cloth):
    """Move a ball along its leg to `time`."""
    t = time - ball.since
    ball.position, ball.velocity, ball.roll, ball.side = moved(ball, t, cloth.fade)
    if ball.phase == AIRBORNE:
        ball.height, ball.climb = risen(ball, t)
    ball.since = time


@kernel
def end(ball, kind):
    """What that event leaves of a ball that nothing has hit."""
    if kind == ROLL:  # exactly: sliding ends in rolling, rolling in rest
        if ball.phase == ROLLING:
            ball.velocity = 0j
        ball.roll = ball.velocity
    elif kind in (LEAVE, DROP):
        ball.velocity, ball.roll, ball.side = 0j, 0j, 0.0
        ball.height, ball.climb, ball.fall = DOWN if kind == DROP else BELOW, 0.0, 0.0


@kernel
def reach(ball, lasts):
    """The box that the ball sweeps on its leg: the whole plane if the leg never ends, nothing if
    the ball is gone."""
    p, r = ball.position, ball.radius
    if ball.phase == RESTING:
        ball.west, ball.east, ball.south, ball.north = (
            p.real - r,
            p.real + r,
            p.imag - r,
            p.imag + r,
        )
    elif lasts == inf:
        far = -inf if ball.phase >= OFF else inf
        ball.west, ball.east, ball.south, ball.north = -far, far, -far, far
    else:
        v, a = ball.velocity, ball.acceleration
        q = travelled(p, v, a, lasts)
        low, high = swept(p.real, q.real, v.real, a.real, lasts)
        ball.west, ball.east = low - r, high + r
        low, high = swept(p.imag, q.imag, v.imag, a.imag, lasts)
        ball.south, ball.north = low - r, high + r
