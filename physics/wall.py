"""A wall: an endless straight line; the table is what lies inside all of them."""

from dataclasses import dataclass

from .checks import finite, keep, vector
from .kernel.body import Line
from .kernel.motion import length

UNIT = 1e-9  # how far the length of a normal may be from 1
ROUNDING = 4e-16  # and of one that is a unit as far as it can be


@dataclass(frozen=True, slots=True)
class Wall:
    """Balls are where (conj(normal) * p).real > offset.

    Make one with `Wall.line` or `Wall.through`.
    normal: inward unit normal, as a complex number.
    offset: m.
    name: for events, or None.
    """

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

    def distance(self, p: tuple[float, float]) -> float:
        """How far inside the point (x, y) is, metres; negative outside."""
        return (self.normal.conjugate() * complex(*p)).real - self.offset

    def record(self) -> Line:
        """The wall as the kernel sees it."""
        return Line(self.normal, self.offset, self.normal.conjugate())


def _unit(normal: complex) -> complex:
    """The normal as a plain complex number, or ValueError."""
    try:
        plain = complex(normal.real, normal.imag)
    except (AttributeError, TypeError):
        raise ValueError(f"Wall.normal must be a complex number, not {normal!r}") from None
    if not abs(length(plain) - 1.0) < UNIT:
        raise ValueError(f"Wall.normal must be of length 1, not {normal!r}")
    return plain
