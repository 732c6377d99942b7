"""A wall: a straight line without end; the table is what lies inside them all.

What it looks like is the kernel's to say (kernel/obstacle.py); a wall answers with its words.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar, TypeAlias

from .checks import finite, keep, vector
from .kernel import obstacle
from .kernel.motion import length
from .kernel.obstacle import Shape

PARALLEL = 1e-9  # the sine of the angle between two walls that are taken to be so
UNIT = 1e-9  # how far the length of a normal may be from 1
ROUNDING = 4e-16  # and of one that is a unit as far as it can be


@dataclass(frozen=True, slots=True)
class Wall:
    """Balls are where (conj(normal) * p).real > offset; make one with `Wall.line` or
    `Wall.through`.

    normal: inward unit normal as a complex number; offset in metres.
    """

    kind: ClassVar[str] = "line"  # in files; every obstacle has one

    normal: complex
    offset: float
    name: str | None = None

    def __post_init__(self) -> None:
        keep(self, finite, "offset")
        normal = _unit(self.normal)
        size = length(normal)
        if abs(size - 1.0) > ROUNDING:  # the same line, of which the normal is a unit
            normal, offset = normal / size, self.offset / size
            object.__setattr__(self, "offset", offset)
        object.__setattr__(self, "normal", normal)

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

    @property
    def inward(self) -> complex:
        """The conjugate normal."""
        return self.normal.conjugate()

    def distance(self, p: tuple[float, float]) -> float:
        """How far inside the point (x, y) is, metres; negative outside."""
        return float(obstacle.clearance(self, complex(*p), 0.0))

    def facing(self, p: tuple[float, float]) -> complex:
        """The direction, of length 1, in which it pushes what is at the point (x, y)."""
        return complex(obstacle.facing(self, complex(*p)))

    def farthest(self, p: complex, v: complex, a: complex, t: float) -> float:
        """The greatest distance, m, of a point that begins at p with v and accelerates with a,
        within t seconds."""
        return float(obstacle.farthest(self, p, v, a, t))

    def moved(self, out: float) -> "Wall":
        """The same wall, so many metres further out."""
        return replace(self, offset=self.offset - out)

    def nearest(self, p: complex) -> complex:
        """The point on it that is nearest to p."""
        spot = p.real, p.imag
        return p - self.distance(spot) * self.facing(spot)

    def corner(self, other: "Wall") -> Iterator[complex]:
        """Where it meets another wall; nowhere, if they are parallel."""
        m, n = self.normal, other.normal
        cross = (m.conjugate() * n).imag
        if abs(cross) > PARALLEL:
            yield (self.offset * n - other.offset * m) * -1j / cross

    def crossings(self, centre: complex, radius: float) -> Iterator[complex]:
        """Where a circle crosses it."""
        foot = self.nearest(centre)
        rest = radius * radius - abs(foot - centre) ** 2
        if rest >= 0.0:
            aside = 1j * self.normal
            yield foot + aside * rest**0.5
            yield foot - aside * rest**0.5

    def record(self) -> Shape:
        """The wall as the kernel sees it."""
        return Shape(self.normal, self.offset, self.inward)


Obstacle: TypeAlias = Wall  # or any other that answers alike
OBSTACLES: dict[str, type[Obstacle]] = {thing.kind: thing for thing in (Wall,)}


def _unit(normal: complex) -> complex:
    """The normal as a plain complex number, or ValueError."""
    try:
        plain = complex(normal.real, normal.imag)
    except (AttributeError, TypeError):
        raise ValueError(f"Wall.normal must be a complex number, not {normal!r}") from None
    if not abs(length(plain) - 1.0) < UNIT:
        raise ValueError(f"Wall.normal must be of length 1, not {normal!r}")
    return plain
