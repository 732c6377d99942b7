"""The exact engine: from event to event, and between them only polynomials."""

from dataclasses import dataclass
from math import inf
from typing import Any, ClassVar

from physics.checks import keep, nonnegative, positive
from physics.engines.engine import Movable
from physics.kernel.calendar import earliest, happen, plan_all, plan_meetings, soonest, start_leg
from physics.kernel.grid import locate
from physics.kernel.impulses import WALL
from physics.kernel.kinds import CLUSTER, LASTING, PAIR, UNSOLVED


class EventBudgetError(RuntimeError):
    """The event budget was exceeded.

    `.scene` is the world when a ball was last placed or pushed, as plain data that JSON can hold
    and that `physics.store.restore` makes a world of.
    """

    def __init__(self, budget: int, time: float, scene: dict[str, Any]) -> None:
        super().__init__(f"more than {budget} events by t = {time!r} s; the scene is in .scene")
        self.scene = scene
        self._given = budget, time, scene

    def __reduce__(self) -> Any:
        """It may come from another process."""
        return type(self), self._given


class ContactError(RuntimeError):
    """No impulses were found that make all balls touching at one instant part.

    `.scene` is as in EventBudgetError; nothing of that instant has been applied to the log.
    """

    def __init__(self, time: float, scene: dict[str, Any]) -> None:
        super().__init__(f"no impulses make all contacts part at t = {time!r} s; see .scene")
        self.scene = scene
        self._given = time, scene

    def __reduce__(self) -> Any:
        """It may come from another process."""
        return type(self), self._given


@dataclass(frozen=True, slots=True)
class EventDriven:
    """Exact in time and place.

    vmin: the least speed at which touching bodies separate, m/s.
    budget: how many events there may be after a ball was last placed or pushed; one more raises
    EventBudgetError.
    """

    foresees: ClassVar[bool] = True  # all that it plans follows from the legs

    vmin: float = 1e-3
    budget: int = 100_000

    def __post_init__(self) -> None:
        keep(self, nonnegative, "vmin")
        positive("EventDriven.budget", self.budget)

    def plan(self, world: Movable, disturbed: list[int]) -> None:
        scene, balls = world.scene, world.scene.balls
        if len(disturbed) == len(balls):
            plan_all(scene)
        else:
            for i in disturbed:
                if scene.celled:
                    locate(i, balls[i], scene.grid)
                start_leg(i, scene)
            for i in disturbed:
                plan_meetings(i, scene)
        for i in disturbed:
            world.log.begin(i, world.epoch, balls[i], scene.cloth.fade)
        world.due = balls[soonest(scene)].next if balls else inf
        world.allowed = len(world.log) + self.budget

    def advance(self, world: Movable, until: float) -> float:
        scene, log, epoch = world.scene, world.log, world.epoch
        balls, fade, celled = scene.balls, scene.cloth.fade, scene.celled
        time, law, left = world.now, world.cluster_law, world.allowed - len(log)
        while balls:
            i = soonest(scene) if celled else earliest(balls)
            due = balls[i].next
            if epoch + due > until or due == inf:
                world.due = due
                break
            time = due
            kind, other = happen(i, scene) if law is None else _springs(i, scene, law)
            if kind < CLUSTER:
                log.begin(i, epoch, balls[i], fade)
                if kind == PAIR:
                    log.begin(other, epoch, balls[other], fade)
                log.note(epoch, time, kind, i, other)
                left -= 1
            elif kind <= LASTING:
                left -= _note_cluster(world, time, other, kind == LASTING)
            elif kind == UNSOLVED:
                world.reached(time)
                raise ContactError(epoch + time, _scene(world, self.budget))
            if left < 0:
                world.reached(time)
                raise EventBudgetError(self.budget, epoch + time, _scene(world, self.budget))
        return time


def _springs(i: int, scene: Any, law: Any) -> Any:
    from .hertz import happen  # imported on first use: only Hertz worlds need it

    return happen(i, scene, law)


def _scene(world: Movable, budget: int) -> Any:
    from physics.files.record import planned_data

    return planned_data(world, budget)


def _note_cluster(world: Movable, time: float, contacts: int, lasting: bool) -> int:
    """Enter it in the log; returns how many events it counts as, at least one."""
    ties = world.scene.ties.contacts[:contacts]
    asked = [(tie.first, tie.second, tie.target) for tie in ties] if lasting else []
    pairs = [(tie.first, tie.second, tie.total) for tie in ties if tie.total > 0.0]
    members = sorted({ball for tie in ties for ball in (tie.first, tie.second) if ball > WALL})
    for i in members:
        world.log.begin(i, world.epoch, world.scene.balls[i], world.scene.cloth.fade)
    world.log.note_cluster(world.epoch, time, pairs, members, asked)
    return max(1, len(pairs))
