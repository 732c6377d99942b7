"""The cue: where and how fast the tip meets the ball, and the shot that results."""

from dataclasses import astuple, dataclass, fields, replace
from math import fsum, sqrt
from typing import Protocol

from .checks import finite, keep, nonnegative, positive
from .shot import Shot, direction, heading


class Heavy(Protocol):
    """Anything with a mass: a ball, or a table of presets."""

    @property
    def mass(self) -> float: ...


ALIKE = 1e-9  # of a shot's speed: a stroke that is no farther from a shot gives it


def _alike(one: Shot, other: Shot) -> bool:
    apart = [abs(a - b) for a, b in zip(astuple(one), astuple(other), strict=True)]
    return bool(max(apart) <= ALIKE * (other.speed + abs(other.angle)))


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

    def __repr__(self) -> str:
        values = [(field, getattr(self, field.name)) for field in fields(self)]
        given = [f"{field.name}={x!r}" for field, x in values if x != field.default]
        return f"CueStroke({', '.join(given)})"

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

    @classmethod
    def along(
        cls, speed: float, angle: float = 0.0, right: float = 0.0, up: float = 0.0,
        elevation: float = 0.0, **cue: float,
    ) -> "CueStroke":  # fmt: skip
        """The stroke whose tip meets the ball there as one sees it along the raised cue.

        right, up: of the centre of the disc that the ball then is, in radii. `side`, `height` are
        as seen level, from behind: with elevation, the same tip is higher there.
        cue: cue_mass, restitution, end_ratio and friction. ValueError as for a CueStroke, and for a
        tip so far up that it meets the ball beyond its top.

        >>> stroke = CueStroke.along(3.0, right=0.3, up=0.1, elevation=60.0)
        >>> f"{stroke.side:.3f} {stroke.height:.3f}"
        '0.300 0.872'
        """
        a, b = finite("CueStroke.along right", right), finite("CueStroke.along up", up)
        if (square := 1.0 - a * a - b * b) <= 0.0:
            raise ValueError(f"CueStroke.along right and up, {right!r} and {up!r}, miss the ball")
        raised = direction(finite("CueStroke.elevation", elevation))
        if b * raised.imag >= sqrt(square) * raised.real:
            raise ValueError(
                f"CueStroke.along up {up!r}: a cue raised by {elevation!r}° meets the ball beyond"
                " its top there"
            )
        height = b * raised.real + sqrt(square) * raised.imag
        return cls(speed, angle, a, height, elevation, **cue)

    @property
    def seen(self) -> tuple[float, float]:
        """Where the tip meets the ball as one sees it along the cue: right and up of the centre, in
        radii."""
        return self.side, self.lever[1]

    @classmethod
    def of(cls, shot: Shot, ball: Heavy, **cue: float) -> "CueStroke":
        """The stroke that gives this shot to a ball of that mass: the inverse of `shot`, or, for a
        shot with a climb below zero, of `jump`.

        A shot without massé and climb is played with a level cue, which with side and follow leaves
        some: follow times the tangent of the squirt. Without side, elevation shows only in a climb.
        cue: cue_mass, restitution, end_ratio and friction. ValueError for a shot that no stroke
        gives, such as a massé without side, and for a miscue.

        >>> from physics import tables
        >>> found = CueStroke.of(Shot(3.0, 30.0, follow=1.5, side=0.75), tables.MATCH_CAROM)
        >>> f"{found.speed:.2f} m/s, right {found.side:.2f}, up {found.height:.2f}"
        '2.68 m/s, right 0.10, up 0.20'
        """
        side, ask = shot.side / (2.5 * shot.speed), shot
        straight = cls(1.0, side=side, **cue)
        if shot.masse == shot.climb == 0.0:
            turned = direction(straight.squirt)
            ask = replace(shot, masse=shot.follow * turned.imag / turned.real)
        spin = complex(ask.follow, -ask.masse) * direction(straight.squirt) / (2.5 * shot.speed)
        steep = -shot.climb / shot.speed if shot.climb else -spin.imag / side if side else 0.0
        square, high = 1.0 + steep * steep, spin.real
        # height - back * steep is that spin, and back the rest of the sphere
        root = square * (1.0 - side * side) - high * high
        if steep < -ALIKE or root < 0.0:
            raise ValueError(f"no stroke of a cue gives {shot!r}")
        height, elevation = (high + steep * sqrt(root)) / square, heading(complex(1.0, steep))
        stroke = cls(1.0, shot.angle - straight.squirt, side, height, max(0.0, elevation), **cue)
        stroke = replace(stroke, speed=shot.speed / stroke.shot(ball).speed)
        if not _alike(stroke.jump(ball) if shot.climb else stroke.shot(ball), ask):
            raise ValueError(f"no stroke of a cue gives {shot!r}")
        return stroke

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
