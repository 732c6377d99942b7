"""How friction moves a ball on the cloth.

`roll` is the velocity at which the ball would roll with the spin it has, -i R ω; so the slip at the
cloth is velocity - roll, and neither radius nor moment of inertia appears again. `side` is R ω_z.
"""

from .kinds import RESTING, ROLLING, SLIDING
from .subset import inf, kernel, sqrt

STILL = 3e-11  # radii/s: what is slower does not move; 1e-12 m/s on a carom table


@kernel
def length(z):
    return sqrt(z.real * z.real + z.imag * z.imag)


@kernel
def motion(velocity, roll, cloth):
    """What friction does to a ball: (phase, acceleration, for how long)."""
    slip = velocity - roll
    speed = sqrt(slip.real * slip.real + slip.imag * slip.imag)  # asked for every leg
    if speed > cloth.still:
        # the slip dies 7/2 times as fast as the speed: 1 from the speed, 5/2 from the spin
        loss = 3.5 * cloth.slide
        return SLIDING, -cloth.slide / speed * slip, speed / loss if loss > 0.0 else inf
    speed = length(velocity)
    if speed > cloth.still:
        loss = cloth.roll
        return ROLLING, -loss / speed * velocity, speed / loss if loss > 0.0 else inf
    return RESTING, 0j, inf


@kernel
def faded(side, loss):
    """Spin about the vertical dies away on its own, independently of all else."""
    if side > loss:
        return side - loss
    return side + loss if side < -loss else 0.0
