"""The cue: where and how fast the tip meets the ball, and the shot that results."""

from dataclasses import dataclass, replace
from math import fsum, sqrt
from typing import Protocol

from .checks import finite, keep, nonnegative, positive
from .shot import Shot, direction, heading


class Heavy(Protocol):
    """Anything with a mass: a ball, or a table of presets."""

    @property
    def mass(self) -> float: ...


@dataclass(frozen=True, slots=True)
class CueStroke:
    """A stroke of the cue; `.shot(ball)` is what it does to a ball (docs/physics.md, "Cue").

    speed: of the cue, m/s.
    angle: that it points to, degrees.
    side: where the tip meets the ball, in radii from the centre, seen from behind; + to the right,
    which is right english and, like `Shot.side`, anticlockwise spin. With elevation, side curves
    the path to its own side.
    height: the same upward; + is follow.
    elevation: of its butt, degrees.
    cue_mass: kg.
    restitution: of the tip.
    end_ratio: the ball's mass over the mass of the cue's end that moves sideways, which makes the
    squirt.
    friction: of the tip.
    ValueError for what is not finite or out of range, and for a miscue: a tip so far out that it
    slips.
    """

    speed: float
    angle: float = 0.0
    side: float = 0.0
    height: float = 0.0
    elevation: float = 0.0
    cue_mass: float = 0.5
    restitution: float = 0.73
    end_ratio: float = 25.0
    friction: float = 0.6

    def __post_init__(self) -> None:
        keep(self, positive, "speed", "cue_mass", "end_ratio")
        keep(self, finite, "angle", "side", "height")
        keep(self, nonnegative, "elevation", "friction", "restitution")
        if self.elevation >= 90.0:
            raise ValueError(f"CueStroke.elevation must be below 90°, not {self.elevation!r}")
        if self.restitution > 1.0:
            raise ValueError(f"CueStroke.restitution must be at most 1, not {self.restitution!r}")
        if 1.0 - self.side * self.side - self.height * self.height <= 0.0:
            raise ValueError(
                f"CueStroke.side and height, {self.side!r} and {self.height!r}, miss the ball"
            )
        if self.offset > self.limit:
            raise ValueError(
                f"miscue: CueStroke.side {self.side!r} and height {self.height!r} put the cue's"
                f" line {self.offset:.4f} radii from the centre; this tip slips beyond"
                f" {self.limit:.4f}"
            )

    @property
    def lever(self) -> tuple[float, float, float]:
        """The impulse's lever arm, in radii: about the cue's course, its left and the vertical."""
        a, b = self.side, self.height
        back = sqrt(1.0 - a * a - b * b)
        cue = direction(self.elevation)
        return a * cue.imag, b * cue.real - back * cue.imag, a * cue.real

    @property
    def _square(self) -> float:
        # from Python 3.12 on, `sum` rounds otherwise
        return fsum(arm * arm for arm in self.lever)

    @property
    def offset(self) -> float:
        """How far from the ball's centre the cue's line passes, in radii."""
        return sqrt(self._square)

    @property
    def limit(self) -> float:
        """The offset, in radii, beyond which the tip slips: μ / √(1 + μ²)."""
        return self.friction / sqrt(1.0 + self.friction * self.friction)

    @property
    def squirt(self) -> float:
        """By how much the ball leaves the cue's line, degrees; positive to the left.

        It goes away from the side on which the tip meets it: tip right of the centre, ball left.
        """
        x = self.side
        inner = 1.0 - x * x
        return heading(complex(1.0 + self.end_ratio + 2.5 * inner, 2.5 * x * sqrt(inner)))

    def jump(self, ball: Heavy) -> Shot:
        """The same shot with what `shot` leaves out: the cue drives the ball into the cloth.

        The ball bounces off at once, by the cloth's `bounce`, and flies.
        """
        return replace(self.shot(ball), climb=-self._kick(ball) * direction(self.elevation).imag)

    def _kick(self, ball: Heavy) -> float:
        """The speed along the cue that the ball gets, m/s."""
        return (1.0 + self.restitution) * self.speed / (
            1.0 + ball.mass / self.cue_mass + 2.5 * self._square
        )

    def shot(self, ball: Heavy) -> Shot:
        """The speed, course and spin that the stroke gives a resting ball of that mass."""
        course, left, vertical = self.lever
        kick = self._kick(ball)
        # the spin is about the cue's axes, a Shot's about the ball's own course
        turned = complex(left, -course) * direction(self.squirt).conjugate()
        return Shot(
            speed=kick * direction(self.elevation).real,
            angle=self.angle + self.squirt,
            follow=2.5 * kick * turned.real,
            masse=0.0 - 2.5 * kick * turned.imag,  # no zero shows a sign
            side=0.0 + 2.5 * kick * vertical,
        )
