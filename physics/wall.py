"""A wall: an endless straight line; the table is what lies inside them all.

The shape of an obstacle and its geometry are the kernel's (kernel/obstacle.py).
"""

from dataclasses import dataclass, field
from typing import Any, ClassVar

from .checks import finite, keep, vector
from .kernel import obstacle
from .kernel.motion import length
from .kernel.obstacle import Shape

UNIT = 1e-9  # how far the length of a normal may be from 1
ROUNDING = 4e-16  # and of one that is a unit as far as it can be


class Obstacle:
    """Anything that stands on a table. Each kind has a name and a shape, and says where a ball lies
    that is laid against it."""

    __slots__ = ()

    kind: ClassVar[str]  # in files
    name: str | None
    shape: Shape

    def distance(self, p: tuple[float, float]) -> float:
        """How far away the point (x, y) is, m; negative inside it or behind it."""
        return float(obstacle.clearance(self.shape, complex(*p), 0.0))

    def facing(self, p: tuple[float, float]) -> complex:
        """The direction, of length 1, in which it pushes a ball at the point (x, y)."""
        return complex(obstacle.facing(self.shape, complex(*p)))

    def farthest(self, p: complex, v: complex, a: complex, t: float) -> float:
        """The greatest distance, m, within t seconds, of a point that starts at p with v and
        accelerates with a."""
        return float(obstacle.farthest(self.shape, p, v, a, t))

    def lines(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        """The lines on which the centre of a ball of that radius slides along it, `gap` m away: for
        each its normal n and offset d, (conj(n) * p).real = d for the points p on it."""
        return ()

    def circles(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        """The circles on which it does: for each its centre and radius, m."""
        return ()


@dataclass(frozen=True, slots=True)
class Wall(Obstacle):
    """Balls are where (conj(normal) * p).real > offset.

    Make one with `Wall.line` or `Wall.through`.
    normal: inward unit normal, as a complex number.
    offset: m.
    name: for events, or None.
    shape: for the kernel, from normal and offset.
    """

    kind: ClassVar[str] = "line"

    normal: complex
    offset: float
    name: str | None = None
    shape: Shape = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        keep(self, finite, "offset")
        normal = _unit(self.normal)
        size = length(normal)
        if abs(size - 1.0) > ROUNDING:  # the same line, with a unit normal
            normal, offset = normal / size, self.offset / size
            object.__setattr__(self, "offset", offset)
        object.__setattr__(self, "normal", normal)
        shape = Shape(normal, self.offset, normal.conjugate())
        object.__setattr__(self, "shape", shape)

    @classmethod
    def line(cls, a: float, b: float, d: float, name: str | None = None) -> "Wall":
        """The line a x + b y + d = 0 with the balls where it is positive: the thesis's equation."""
        a, b, d = (
            finite(f"Wall.line {key}", value) for key, value in zip("abd", (a, b, d), strict=True)
        )
        size = length(complex(a, b))
        if size == 0.0:
            raise ValueError(f"Wall.line a and b must not both be zero, not {a!r}, {b!r}")
        return cls(complex(a / size, b / size), -d / size, name)

    @classmethod
    def through(
        cls, p: tuple[float, float], q: tuple[float, float], name: str | None = None
    ) -> "Wall":
        """The line from p to q, metres, with the balls on its left."""
        px, py = vector("Wall.through p", p, 2)
        qx, qy = vector("Wall.through q", q, 2)
        if (px, py) == (qx, qy):
            raise ValueError(f"Wall.through needs two points, not {p!r} twice")
        a, b = py - qy, qx - px
        return cls.line(a, b, -(a * px + b * py), name)

    def lines(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        return ((self.normal, self.offset + radius + gap),)


OBSTACLES: dict[str, Any] = {thing.kind: thing for thing in (Wall,)}


def _unit(normal: complex) -> complex:
    """The normal as a plain complex number, or ValueError."""
    try:
        plain = complex(normal.real, normal.imag)
    except (AttributeError, TypeError):
        raise ValueError(f"Wall.normal must be a complex number, not {normal!r}") from None
    if not abs(length(plain) - 1.0) < UNIT:
        raise ValueError(f"Wall.normal must be of length 1, not {normal!r}")
    return plain
