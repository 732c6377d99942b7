"""How friction moves a ball on the cloth.

`roll` is the velocity at which the ball would roll with the spin it has, -i R ω; so the slip at the
cloth is velocity - roll, and neither radius nor moment of inertia appears again. `side` is R ω_z.
"""

from .kinds import RESTING, ROLLING, SLIDING
from .subset import inf, kernel, sqrt

STILL = 3e-11  # radii/s: what is slower does not move; 1e-12 m/s on a carom table


@kernel
def length(z):
    x, y = z.real, z.imag  # CPython takes longer to read one of them than to square it
    return sqrt(x * x + y * y)


@kernel
def motion(velocity, roll, cloth):
    """What friction does to a ball: (phase, acceleration, for how long)."""
    slip = velocity - roll
    x, y = slip.real, slip.imag  # `length`, twice, which every leg would call
    speed = sqrt(x * x + y * y)
    if speed > cloth.still:
        # the slip dies 7/2 times as fast as the speed: 1 from the speed, 5/2 from the spin
        loss = 3.5 * cloth.slide
        return SLIDING, -cloth.slide / speed * slip, speed / loss if loss > 0.0 else inf
    x, y = velocity.real, velocity.imag
    speed = sqrt(x * x + y * y)
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
