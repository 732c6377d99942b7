"""The cloth: what it does to a ball that lies on it."""

from dataclasses import dataclass

from .checks import keep, nonnegative
from .kernel.body import Felt


@dataclass(frozen=True, slots=True)
class Cloth:
    """Coefficients of a cloth (docs/physics.md, "Cloth").

    slide: friction μ_s of a sliding ball.
    roll: resistance μ_r to a rolling one.
    spin_decay: loss of the spin about the vertical, α_z, rad/s².
    gravity: m/s².
    bounce: restitution of a ball that comes down on it, below 1.
    ValueError unless each is finite and not negative.
    """

    slide: float = 0.2
    roll: float = 0.01
    spin_decay: float = 10.0
    gravity: float = 9.8
    bounce: float = 0.5

    def __post_init__(self) -> None:
        keep(self, nonnegative, "slide", "roll", "spin_decay", "gravity", "bounce")
        if self.bounce >= 1.0:
            raise ValueError(f"Cloth.bounce must be below 1, not {self.bounce!r}")

    def felt(self) -> Felt:
        """The decelerations that the kernel works with."""
        slide, roll = self.slide * self.gravity, self.roll * self.gravity
        return Felt(slide, roll, self.spin_decay, self.gravity, self.bounce, self.slide)


def a_cloth(thing: Cloth) -> Cloth:
    """The cloth, or ValueError if the thing is not one."""
    if not isinstance(thing, Cloth):
        raise ValueError(f"a world's cloth is a Cloth, not {thing!r}")
    return thing
