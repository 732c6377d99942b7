"""Posts, which stand in the way, and pockets, into which balls fall: what is round."""

from dataclasses import dataclass, field
from typing import Any, ClassVar

from .checks import keep, nonnegative, positive, vector
from .kernel.obstacle import POCKET, POST, Shape
from .wall import Arc, Law, Obstacle, Point, Segment, Wall, around, keep_law, rounded


@dataclass(frozen=True, slots=True)
class Post(Obstacle):
    """A disc that stands on the table.

    at: (x, y) of its middle, m.
    radius: m; 0 for a point.
    name: for events, or None.
    law: its cushion law, if it is not the world's.
    shape: what the kernel knows it by.
    """

    kind: ClassVar[str] = "post"
    noun: ClassVar[str] = "post"

    at: Point
    radius: float
    name: str | None = None
    law: Law = None
    shape: Shape = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        keep_law(self)
        object.__setattr__(self, "at", vector("Post.at", self.at, 2))
        keep(self, nonnegative, "radius")
        centre = complex(*self.at)
        shape = Shape(kind=POST, size=self.radius, centre=centre, **around(centre, self.radius))
        object.__setattr__(self, "shape", shape)

    def _across(self, spots: Any) -> Any:
        return abs(spots - self.shape.centre) - self.shape.size

    def curve(self) -> tuple[complex, ...]:
        return rounded(self.shape.centre, self.radius)

    def circles(self, radius: float, gap: float) -> tuple[tuple[complex, float], ...]:
        return ((self.shape.centre, self.radius + radius + gap),)


@dataclass(frozen=True, slots=True)
class Pocket(Obstacle):
    """A hole: a ball whose centre comes over it falls in, and stays there.

    at: (x, y) of its middle, m.
    radius: m.
    name: for events, or None.
    shape: what the kernel knows it by.
    """

    kind: ClassVar[str] = "pocket"
    pushes: ClassVar[bool] = False
    noun: ClassVar[str] = "pocket"

    at: Point
    radius: float
    name: str | None = None
    shape: Shape = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        keep_law(self)
        object.__setattr__(self, "at", vector("Pocket.at", self.at, 2))
        keep(self, positive, "radius")
        centre = complex(*self.at)
        shape = Shape(kind=POCKET, size=self.radius, centre=centre, **around(centre, self.radius))
        object.__setattr__(self, "shape", shape)

    def _across(self, spots: Any) -> Any:
        return abs(spots - self.shape.centre) - self.shape.size

    def curve(self) -> tuple[complex, ...]:
        return rounded(self.shape.centre, self.radius)


OBSTACLES: dict[str, Any] = {thing.kind: thing for thing in (Wall, Segment, Arc, Post, Pocket)}
