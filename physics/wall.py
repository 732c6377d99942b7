"""Walls: lines without end, of which the table is what lies inside them all; segments and arcs.

The shape of an obstacle and its geometry are the kernel's (kernel/obstacle.py).
"""

from dataclasses import dataclass, field
from typing import Any, ClassVar

from .checks import finite, keep, positive, vector
from .farthest import known_farthest
from .kernel import obstacle
from .kernel.elementary import direction
from .kernel.gap import greatest
from .kernel.motion import length
from .kernel.obstacle import ARC, SEGMENT, Shape
from .laws import CushionLaw, cushion_law

Point = tuple[float, float]
Law = str | CushionLaw | None

UNIT = 1e-9  # how far the length of a normal may be from 1
ROUNDING = 4e-16  # and of one that is a unit as far as it can be
CHORDS = 96  # of a whole circle, as it is drawn


class Obstacle:
    """Anything that stands on a table. Each kind has a name and a shape, and says where a ball lies
    that is laid against it."""

    __slots__ = ()

    kind: ClassVar[str]  # in files
    pushes: ClassVar[bool] = True  # or do balls fall into it?
    noun: ClassVar[str] = "wall"
    name: str | None
    shape: Shape

    @property
    def own_law(self) -> CushionLaw | None:
        """The law of its cushion, if it is not the world's."""
        law: CushionLaw | None = getattr(self, "law", None)
        return law

    def distance(self, p: tuple[float, float]) -> float:
        """How far away the point (x, y) is, m; negative inside it or behind it."""
        return float(obstacle.clearance(self.shape, complex(*p), 0.0))

    def at_least(self, spots: Any) -> Any:
        """No more than how far away these points are, complex numbers in an array, m: exact where
        it matters, in front of a long wall."""
        import numpy as np

        shape, x, y = self.shape, spots.real, spots.imag
        beside = np.maximum(
            np.maximum(shape.west - x, x - shape.east), np.maximum(shape.south - y, y - shape.north)
        )
        return np.maximum(beside, self._across(spots))

    def _across(self, spots: Any) -> Any:
        """How far away the whole line or circle is."""
        return abs(abs(spots - self.shape.centre) - self.shape.size)

    def facing(self, p: tuple[float, float]) -> complex:
        """The direction, of length 1, in which it pushes a ball at the point (x, y)."""
        return complex(obstacle.facing(self.shape, complex(*p)))

    def farthest(self, p: complex, v: complex, a: complex, t: float) -> float:
        """The greatest distance, m, of a point that starts at p with v and accelerates with a,
        within t seconds.  To 1e-9 of the path, where it takes a search."""
        known = known_farthest(self.shape, p, v, a, t)
        return float(greatest(self.shape, p, v, a, t)) if known is None else known

    def curve(self) -> tuple[complex, ...]:
        """Points along it, as many as it takes to look round; of a line, none."""
        return ()

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
    law: its cushion law, if it is not the world's.
    shape: for the kernel, from normal and offset.
    """

    kind: ClassVar[str] = "line"

    normal: complex
    offset: float
    name: str | None = None
    law: Law = None
    shape: Shape = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        keep_law(self)
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
    def line(cls, a: float, b: float, d: float, name: str | None = None, law: Law = None) -> "Wall":
        """The line a x + b y + d = 0 with the balls where it is positive: the thesis's equation."""
        a, b, d = (
            finite(f"Wall.line {key}", value) for key, value in zip("abd", (a, b, d), strict=True)
        )
        size = length(complex(a, b))
        if size == 0.0:
            raise ValueError(f"Wall.line a and b must not both be zero, not {a!r}, {b!r}")
        return cls(complex(a / size, b / size), -d / size, name, law)

    @classmethod
    def through(cls, p: Point, q: Point, name: str | None = None, law: Law = None) -> "Wall":
        """The line from p to q, metres, with the balls on its left."""
        px, py = vector("Wall.through p", p, 2)
        qx, qy = vector("Wall.through q", q, 2)
        if (px, py) == (qx, qy):
            raise ValueError(f"Wall.through needs two points, not {p!r} twice")
        a, b = py - qy, qx - px
        return cls.line(a, b, -(a * px + b * py), name, law)

    @property
    def numbers(self) -> tuple[complex, float]:
        """Its normal and its offset: what makes it this line."""
        return self.normal, self.offset

    @staticmethod
    def segment(p: Point, q: Point, name: str | None = None, law: Law = None) -> "Segment":
        """The straight wall from p to q, metres, with the table on its left."""
        return Segment(p, q, name, law)

    @staticmethod
    def arc(
        centre: Point, radius: float, start: float, end: float, name: str | None = None,
        law: Law = None,
    ) -> "Arc":  # fmt: skip
        """The part of a circle, metres, from the direction `start` anticlockwise to `end`, degrees
        from the x axis, with the table on its inside."""
        return Arc(centre, radius, start, end, name, law)

    def at_least(self, spots: Any) -> Any:
        return (self.shape.inward * spots).real - self.shape.offset

    def farthest(self, p: complex, v: complex, a: complex, t: float) -> float:
        return float(obstacle.farthest(self.shape, p, v, a, t))

    def lines(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        return ((self.normal, self.offset + radius + gap),)


@dataclass(frozen=True, slots=True)
class Segment(Obstacle):
    """A straight wall that ends; make one with `Wall.segment`.

    Balls on the cloth meet both of its sides, and its ends.
    p, q: its ends, (x, y) m; the table is on the left of the way from p to q.
    name: for events, or None.
    law: its cushion law, if it is not the world's.
    shape: what the kernel knows it by.
    """

    kind: ClassVar[str] = "segment"

    p: Point
    q: Point
    name: str | None = None
    law: Law = None
    shape: Shape = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        keep_law(self)
        for key in "pq":
            object.__setattr__(self, key, vector(f"Wall.segment {key}", getattr(self, key), 2))
        first, last = complex(*self.p), complex(*self.q)
        size = length(last - first)
        if not size > 0.0:
            raise ValueError(f"Wall.segment needs two points, not {self.p!r} twice")
        normal = 1j * ((last - first) / size)
        normal /= length(normal)
        offset = 0.5 * (normal.conjugate() * (first + last)).real
        shape = Shape(
            normal, offset, normal.conjugate(), SEGMENT, size, first=first, last=last,
            west=min(first.real, last.real), east=max(first.real, last.real),
            south=min(first.imag, last.imag), north=max(first.imag, last.imag),
        )  # fmt: skip
        object.__setattr__(self, "shape", shape)

    def _across(self, spots: Any) -> Any:
        return abs((self.shape.inward * spots).real - self.shape.offset)

    def curve(self) -> tuple[complex, ...]:
        return self.shape.first, self.shape.last

    def lines(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        return ((self.shape.normal, self.shape.offset + radius + gap),)

    def circles(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        return (self.shape.first, radius + gap), (self.shape.last, radius + gap)


@dataclass(frozen=True, slots=True)
class Arc(Obstacle):
    """A wall that is a part of a circle, or a whole one; make one with `Wall.arc`.

    Balls on the cloth meet both of its sides, and its ends.
    centre: (x, y), m.
    radius: m.
    start, end: degrees from the x axis; it goes from the one anticlockwise to the other.
    name: for events, or None.
    law: its cushion law, if it is not the world's.
    shape: what the kernel knows it by.
    """

    kind: ClassVar[str] = "arc"

    centre: Point
    radius: float
    start: float
    end: float
    name: str | None = None
    law: Law = None
    shape: Shape = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        keep_law(self)
        object.__setattr__(self, "centre", vector("Wall.arc centre", self.centre, 2))
        keep(self, positive, "radius")
        keep(self, finite, "start", "end")
        angle = self.end - self.start
        if not 0.0 < angle <= 360.0:
            raise ValueError(
                f"Wall.arc must end 0 to 360 degrees after its start, {self.start!r}, not at"
                f" {self.end!r}"
            )
        centre = complex(*self.centre)
        first, last = (centre + self.radius * direction(x) for x in (self.start, self.end))
        span = direction(0.5 * angle).real if angle < 360.0 else -2.0  # all around, by rounding too
        shape = Shape(
            kind=ARC, size=self.radius, centre=centre, first=first, last=last,
            middle=direction(self.start + 0.5 * angle), span=span, **around(centre, self.radius),
        )  # fmt: skip
        object.__setattr__(self, "shape", shape)

    def curve(self) -> tuple[complex, ...]:
        return rounded(self.shape.centre, self.radius, self.start, self.end)

    def circles(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        return ((self.shape.centre, self.radius - radius - gap),)


def around(centre: complex, radius: float) -> dict[str, float]:
    """The box around a circle."""
    return {
        "west": centre.real - radius, "east": centre.real + radius,
        "south": centre.imag - radius, "north": centre.imag + radius,
    }  # fmt: skip


def rounded(
    centre: complex, radius: float, start: float = 0.0, end: float = 360.0
) -> tuple[complex, ...]:
    """Points along a part of a circle, between these angles, degrees."""
    parts = int(CHORDS * (end - start) / 360.0) + 1
    step = (end - start) / parts
    return tuple(centre + radius * direction(start + k * step) for k in range(parts + 1))


def keep_law(thing: Obstacle) -> None:
    """Its law by itself, also if it was named; ValueError for a name that is no text."""
    if not isinstance(thing.name, str | None):
        raise ValueError(f"the name of a {thing.noun} must be text or None, not {thing.name!r}")
    if thing.own_law is not None:
        object.__setattr__(thing, "law", cushion_law(thing.own_law))


def _unit(normal: complex) -> complex:
    """The normal as a plain complex number, or ValueError."""
    try:
        plain = complex(normal.real, normal.imag)
    except (AttributeError, TypeError):
        raise ValueError(f"Wall.normal must be a complex number, not {normal!r}") from None
    if not abs(length(plain) - 1.0) < UNIT:
        raise ValueError(f"Wall.normal must be of length 1, not {normal!r}")
    return plain
