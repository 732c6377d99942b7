"""Fixed steps: contacts are noticed on a grid of times, when things overlap already."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from math import inf
from typing import NamedTuple

from physics.checks import keep, nonnegative, positive
from physics.engines.engine import Movable
from physics.engines.exact import EventBudgetError
from physics.files.record import planned_data
from physics.kernel.kinds import PHASES
from physics.kernel.leg import carry

from . import literal, naive
from .overlap import contacts, end_phase, launch, mark

# (world, time, seconds to the next grid time, number of the grid time)
Substep = Callable[[Movable, float, float, int], None]


class Scheme(NamedTuple):
    """What to do with disturbed balls, at a grid time, and when a phase ends before one."""

    start: Callable[[Movable, list[int]], None]
    substep: Substep
    between: Substep | None = None


def start(world: Movable, disturbed: list[int]) -> None:
    """New legs for these balls; the others stay on theirs, which are exact."""
    for i in disturbed:
        launch(world.scene.balls[i], world.scene.cloth)
        mark(world, i)


def notice(world: Movable, time: float, ahead: float, k: int) -> None:
    """The thesis's substep: legs are exact, so only contacts have to be looked for."""
    contacts(world, time)


def change_phase(world: Movable, time: float, ahead: float, k: int) -> None:
    """Sliding ends in rolling, and rolling in rest, within a substep."""
    for i, ball in enumerate(world.scene.balls):
        if ball.leg_end <= time and not PHASES[ball.phase].lies:
            carry(ball, time, world.scene.cloth)
            end_phase(world, time, i)


SCHEMES = {
    "thesis": Scheme(start, notice, change_phase),
    "literal": Scheme(literal.start, literal.substep),
    "euler": Scheme(naive.start, partial(naive.substep, integrator=naive.euler)),
    "rk4": Scheme(naive.start, partial(naive.substep, integrator=naive.rk4)),
    "rk4-located": Scheme(naive.start, naive.located, naive.located),
}


@dataclass(frozen=True, slots=True)
class TimeStepping:
    """Steps of dt seconds, counted from the moment a ball was last placed or pushed.

    dt: s.
    scheme: "thesis" moves balls exactly and is only late in noticing contacts; "euler" and "rk4"
    integrate the motion as well; "rk4-located" finds the time of contacts within a step; "literal"
    is the thesis's printed program, with its own constants and laws (see `engines.literal`).
    vmin, budget: as in EventDriven.
    However time is divided by `World.step`, the grid and
    all that happens on it are the same, bit for bit; between grid times balls are read off their
    legs. ValueError for dt not above zero or an unknown scheme, and for a run to rest that has no
    end: "literal" never rests, and nothing does on a cloth without friction.
    """

    dt: float
    scheme: str = "thesis"
    vmin: float = 1e-3
    budget: int = 100_000

    def __post_init__(self) -> None:
        keep(self, positive, "dt")
        keep(self, nonnegative, "vmin")
        positive("TimeStepping.budget", self.budget)
        if self.scheme not in SCHEMES:
            names = ", ".join(SCHEMES)
            raise ValueError(f"unknown TimeStepping.scheme {self.scheme!r}: one of {names}")

    def plan(self, world: Movable, disturbed: list[int]) -> None:
        for ball in world.balls:
            if not (ball.on_cloth or ball.gone):
                raise ValueError(f"{ball!r}: fixed steps know only balls on the table")
        if world.cloth.bands:
            raise ValueError("fixed steps know one rolling resistance for all speeds: no bands")
        SCHEMES[self.scheme].start(world, disturbed)
        world.due = self._grid(world, 0) if _moving(world) else inf
        world.allowed = len(world.log) + self.budget

    def advance(self, world: Movable, until: float) -> float:
        scheme, time = SCHEMES[self.scheme], world.now
        if until == inf and _moving(world):
            self._insist_on_an_end(world)
        k = self._next(world)
        while world.due < inf and world.epoch + world.due <= until:
            time, grid = world.due, self._grid(world, k)
            if scheme.between is not None and time < grid:
                scheme.between(world, time, grid - time, k)
            else:
                scheme.substep(world, time, self.dt, k)
                k += 1
            world.due = self._grid(world, k) if _moving(world) else inf
            if scheme.between is not None:
                world.due = min([world.due, *(ball.next for ball in world.scene.balls)])
            if len(world.log) > world.allowed:
                raise EventBudgetError(
                    self.budget, world.epoch + time, planned_data(world, self.budget)
                )
        return time

    def _grid(self, world: Movable, k: int) -> float:
        """The k-th grid time, seconds from the epoch: a product, not a sum of steps."""
        return world.planned - world.epoch + k * self.dt

    def _next(self, world: Movable) -> int:
        """The number of the first grid time that is not before what is due."""
        if world.due == inf:
            return 0
        k = max(0, round((world.due - self._grid(world, 0)) / self.dt))
        return k if self._grid(world, k) >= world.due else k + 1

    def _insist_on_an_end(self, world: Movable) -> None:
        if self.scheme == "literal":
            raise ValueError("the thesis's program never rests: run it until a time")
        if world.cloth.slide * world.cloth.roll * world.cloth.gravity == 0.0:
            raise ValueError(f"nothing rests on {world.cloth!r}: run it until a time")


def _moving(world: Movable) -> bool:
    return any(not PHASES[ball.phase].lies for ball in world.scene.balls)
