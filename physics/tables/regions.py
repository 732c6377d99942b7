"""Where on a table a ball may be put: simple shapes that know what they contain."""

from dataclasses import dataclass
from math import sqrt

EDGE = 1e-9  # m: how far beyond an edge a point on it may be, by rounding


@dataclass(frozen=True, slots=True)
class Box:
    """A rectangle, metres, with its edges; `open_east`: without its eastern one."""

    west: float
    east: float
    south: float
    north: float
    open_east: bool = False

    def contains(self, p: tuple[float, float]) -> bool:
        """Is the point (x, y) in it?"""
        x, y = p
        short = x < self.east if self.open_east else x <= self.east + EDGE
        return self.west - EDGE <= x and short and self.south - EDGE <= y <= self.north + EDGE


@dataclass(frozen=True, slots=True)
class HalfDisc:
    """The half of a disc that lies west of its centre, metres, with its edges: snooker's D."""

    centre: tuple[float, float]
    radius: float

    def contains(self, p: tuple[float, float]) -> bool:
        """Is the point (x, y) in it?"""
        x, y = p[0] - self.centre[0], p[1] - self.centre[1]
        return x <= EDGE and sqrt(x * x + y * y) <= self.radius + EDGE


Region = Box | HalfDisc
