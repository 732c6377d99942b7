"""What an engine does, and what it may use of the world that it moves.

Engines, files and the watch of custom laws work on a world and are used by it: so they name these
protocols, and no module needs another one that needs it.
"""

from typing import Any, Protocol

from physics.ball import Ball, Clock
from physics.cloth import Cloth
from physics.kernel.body import Scene
from physics.log import Log
from physics.wall import Obstacle


class Engine(Protocol):
    """What moves a world forward in time."""

    @property
    def vmin(self) -> float:
        """m/s: the least speed at which touching bodies separate."""

    def plan(self, world: "Movable", disturbed: list[int]) -> None:
        """Plan these balls, which have just been placed or pushed."""

    def advance(self, world: "Movable", until: float) -> float:
        """Let all happen up to world time `until`; returns the time reached, s since the epoch."""


class Movable(Protocol):
    """A world as its engine sees it; see `physics.World`."""

    scene: Scene
    log: Log
    due: float
    planned: float
    allowed: int

    @property
    def balls(self) -> tuple[Ball, ...]: ...
    @property
    def walls(self) -> tuple[Obstacle, ...]: ...
    @property
    def discs(self) -> bool: ...
    @property
    def table(self) -> Any: ...
    @property
    def cloth(self) -> Cloth: ...
    @property
    def ball_law(self) -> Any: ...
    @property
    def cushion_law(self) -> Any: ...
    @property
    def cluster_law(self) -> Any: ...
    @property
    def engine(self) -> Engine: ...
    @property
    def clock(self) -> Clock: ...
    @property
    def time(self) -> float: ...
    @property
    def epoch(self) -> float: ...
    @property
    def now(self) -> float: ...

    def plan(self) -> None: ...
    def reached(self, now: float) -> None: ...


def an_engine(thing: Engine) -> Engine:
    """The engine, or ValueError if the thing is not one."""
    if isinstance(thing, type) or not all(hasattr(thing, a) for a in ("vmin", "plan", "advance")):
        raise ValueError(f"an engine is an EventDriven(...) or TimeStepping(...), not {thing!r}")
    return thing
