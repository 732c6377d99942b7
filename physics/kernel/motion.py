"""How the cloth moves a ball from one event to the next.

`roll` is the velocity at which the ball would roll with the spin it has, -i R ω; so the slip at the
cloth is velocity - roll, and neither radius nor moment of inertia appears again. `side` is R ω_z.
"""

from .subset import inf, kernel, sqrt

RESTING, ROLLING, SLIDING, AIRBORNE, OFF = 0, 1, 2, 3, 4
STILL = 3e-11  # radii/s: what is slower does not move; 1e-12 m/s on a carom table


@kernel
def length(z):
    return sqrt(z.real * z.real + z.imag * z.imag)


@kernel
def motion(velocity, roll, cloth):
    """What friction does to a ball: (phase, acceleration, for how long)."""
    slip = velocity - roll
    speed = length(slip)
    if speed > cloth.still:
        # the slip dies 7/2 times as fast as the speed: 1 from the speed, 5/2 from the spin
        return SLIDING, -cloth.slide / speed * slip, lasting(speed, 3.5 * cloth.slide)
    speed = length(velocity)
    if speed > cloth.still:
        return ROLLING, -cloth.roll / speed * velocity, lasting(speed, cloth.roll)
    return RESTING, 0j, inf


@kernel
def lasting(speed, loss):
    return speed / loss if loss > 0.0 else inf


@kernel
def faded(side, loss):
    """Spin about the vertical dies away on its own, independently of all else."""
    if side > loss:
        return side - loss
    return side + loss if side < -loss else 0.0


@kernel
def swept(x, v, a, t):
    """The interval that x + v t + a t²/2 has visited after t."""
    y = x + t * (v + 0.5 * a * t)
    low, high = (x, y) if x < y else (y, x)
    if v * (v + a * t) < 0.0:
        turn = x - 0.5 * v * v / a
        return min(low, turn), max(high, turn)
    return low, high


@kernel
def place(ball, t):
    """Where the ball is, t into its leg."""
    return ball.position + t * (ball.velocity + 0.5 * t * ball.acceleration)


@kernel
def altitude(ball, t):
    """How high it is, t into its leg."""
    return ball.height + t * (ball.climb - 0.5 * t * ball.fall)


@kernel
def carry(ball, time, cloth):
    """Move a ball along its leg to `time`."""
    t = time - ball.since
    gain = t * ball.acceleration
    ball.position = place(ball, t)
    ball.velocity += gain
    ball.roll += gain if ball.phase == ROLLING else -2.5 * gain
    if ball.phase == AIRBORNE:
        ball.height, ball.climb = altitude(ball, t), ball.climb - t * ball.fall
    else:
        ball.side = faded(ball.side, t * ball.radius * cloth.fade)
    ball.since = time


@kernel
def settle(ball):
    """Make the end of a phase exact: sliding ends in rolling, rolling in rest."""
    if ball.phase == ROLLING:
        ball.velocity = 0j
    ball.roll = ball.velocity
