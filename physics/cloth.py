"""The cloth: what it does to a ball that lies on it."""

from dataclasses import dataclass

from .checks import keep, nonnegative
from .kernel.body import Felt


@dataclass(frozen=True, slots=True)
class Cloth:
    """Coefficients of a cloth (docs/physics.md, "Cloth").

    slide: friction μ_s of a sliding ball; roll: resistance μ_r of a rolling one; spin_decay: loss
    of the spin about the vertical, α_z in rad/s²; gravity in m/s². Each finite and not negative, or
    ValueError.
    """

    slide: float = 0.2
    roll: float = 0.01
    spin_decay: float = 10.0
    gravity: float = 9.8

    def __post_init__(self) -> None:
        keep(self, nonnegative, "slide", "roll", "spin_decay", "gravity")

    def felt(self) -> Felt:
        """The decelerations that the kernel works with."""
        return Felt(self.slide * self.gravity, self.roll * self.gravity, self.spin_decay)
