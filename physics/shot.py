"""A shot: the five numbers that the thesis's boxes ask for, and one for balls that jump."""

from cmath import rect
from dataclasses import dataclass
from math import radians

from .checks import finite, keep, positive

QUARTERS = (1 + 0j, 1j, -1 + 0j, -1j)


def direction(degrees: float) -> complex:
    """The unit vector at an angle; exact at whole quarters of a turn."""
    quarters, rest = divmod(degrees, 90.0)
    return QUARTERS[int(quarters) % 4] * rect(1.0, radians(rest))


@dataclass(frozen=True, slots=True)
class Shot:
    """What the cue gives the ball: speed V in m/s, angle in degrees, and three surface speeds in
    m/s.

    angle: anticlockwise from +x. follow (Wx·R) spins about the horizontal axis left of the
    direction of travel: + runs on after a hit, - draws back. masse (Wy·R) spins about the direction
    of travel: + curves to the right, - to the left. side (Wz·R) spins about the vertical: +
    anticlockwise from above, which players call right english (the tip right of the centre, the
    ball leaves the far cushion to the right), - left english. climb: velocity upward, m/s;
    downward, the ball bounces off the cloth. ValueError unless all are finite and the speed is
    above zero.
    """

    speed: float
    angle: float = 0.0
    follow: float = 0.0
    masse: float = 0.0
    side: float = 0.0
    climb: float = 0.0

    def __post_init__(self) -> None:
        keep(self, positive, "speed")
        keep(self, finite, "angle", "follow", "masse", "side", "climb")

    def velocity(self) -> complex:
        """m/s, in the plane of the table."""
        return self.speed * direction(self.angle)

    def roll(self) -> complex:
        """The velocity at which the ball would roll with this spin, -i R ω, m/s."""
        return complex(self.follow, -self.masse) * direction(self.angle)
