"""What plays the shots of a batch: one kernel for all of them, or world after world."""

from __future__ import annotations

import sys
from functools import cache
from math import inf, nan
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np

from physics.ball import Ball
from physics.engines.exact import EventDriven
from physics.kernel import body, calendar
from physics.kernel.body import Kept, Notes, Way
from physics.laws import CustomRule
from physics.shot import Shot
from physics.simulation import simulate
from physics.world import World

from .outcomes import KIND, Part
from .shots import Asked, laid

ENDLESS = 2**62  # events

_values = attrgetter("kind", "again", "first", "second", "time")


class Job(NamedTuple):
    """What every piece of a batch needs: it can be sent to another process or machine.

    scene: of the world, as plain records.
    before: (balls, COLUMNS), how the balls lie or move before each shot.
    struck: the number of the ball.
    contacts: how many of each shot are kept.
    budget: how many events a shot may have.
    until: the balls that it is played until they have been met, as body.Notes has them.
    compiled: by the compiled kernel?  None: not decided yet.
    chunk: how many shots are played at once.
    """

    scene: body.Scene
    before: Any
    struck: int
    contacts: int
    budget: int
    until: int
    compiled: bool | None
    chunk: int

    def run(self, table: Any, places: Any, into: Part | None = None) -> Part:
        """The outcomes of the shots in the rows, from these places, if there are any."""
        part = into or Part.room(len(table), len(self.before), self.contacts)
        if self.compiled:
            self._compiled(table, places, part)
        else:
            self._interpreted(table, places, part)
        if self.contacts:  # what was found, less what was kept
            np.maximum(part.dropped - self.contacts, 0, out=part.dropped)
        return part

    def _compiled(self, table: Any, places: Any, part: Part) -> None:
        mine, back = _take()(self.scene)
        notes = mine.notes(self.contacts, part.contacts, part.dropped, *mine.near, self.until)
        mine.many(
            self.before, places, table, self.struck, *part[:3], self.budget, mine.scene, notes
        )
        back.append(mine)

    def _interpreted(self, table: Any, places: Any, part: Part) -> None:
        """Shot by shot, with room for the notes of one."""
        scene = body.twin_scene(self.scene, [body.twin(ball) for ball in self.scene.balls])
        before, rows, spots = self.before.tolist(), table.tolist(), places.tolist()
        notes = self._notes()
        rest, time, count = [[[0.0, 0.0] for _ in before]], [0.0], [0]
        for s in range(len(rows)):
            here = slice(s, s + 1)
            calendar.many(
                before, spots[here], rows[here], self.struck, rest, time, count, self.budget,
                scene, notes,
            )  # fmt: skip
            part.positions[s], part.times[s], part.events[s] = rest[0], time[0], count[0]
            part.dropped[s] = notes.found[0]
            for k in range(min(notes.found[0], self.contacts)):
                part.contacts[s, k] = _values(notes.contacts[0][k])

    def _notes(self) -> Notes:
        balls, walls, most = len(self.before), len(self.scene.walls), self.contacts
        ways, near = [Way() for _ in range(balls)], [True] * (balls * walls)
        return Notes(most, [[Kept() for _ in range(most)]], [0], ways, near, self.until)


@cache
def _take() -> Any:
    """Where compiled scenes are had; once, since to import costs as much as a third of a shot."""
    from physics.batch.ready import take

    return take


class OneByOne(NamedTuple):
    """The same for an engine or a law for clusters that has no batches: world after world."""

    world: World
    ball: str
    contacts: int
    budget: float = inf  # every run has its own
    chunk: int = 64
    compiled: bool = False

    def run(self, table: Any, places: Any, into: Part | None = None) -> Part:
        """The outcomes of the shots in the rows, from these places, if there are any."""
        part = into or Part.room(len(table), len(self.world.balls), self.contacts)
        for s, row in enumerate(table.tolist()):
            world = laid(self.world, places[s]) if len(places) else self.world
            after = simulate(world, self.ball, Shot(*row))
            part.positions[s] = [_rest(ball) for ball in after.balls]
            part.times[s], part.events[s] = after.time - self.world.time, len(after.log)
            if self.contacts:
                part.dropped[s] = self._keep(after, part.contacts[s])
        return part

    def _keep(self, after: World, line: Any) -> int:
        """Write the contacts of a shot into the line; returns for how many there was no room."""
        touches = list(after.log.touches())
        for k, (time, kind, i, other, left) in enumerate(touches[: self.contacts]):
            line[k] = KIND[kind.name], not left, i, other, time - self.world.time
        return max(0, len(touches) - self.contacts)


def _rest(ball: Ball) -> tuple[float, float]:
    """Where it lies, as `Outcomes` has it."""
    return (nan, nan) if ball.gone else ball.position


def job_of(
    world: World, asked: Asked, contacts: int, until: int, compiled: bool | None, chunk: int
) -> Job | OneByOne:
    """What plays the shots, so many at a time; ValueError if it cannot be compiled and must be."""
    if isinstance(world.engine, EventDriven) and world.cluster_law is None:
        custom = _interpreted(world.scene)
        if compiled and custom:
            raise ValueError(
                "a custom law runs interpreted: not with compiled=True, unless it is marked as"
                " @laws.compiled"
            )
        choice = False if custom else compiled
        if choice is None and loaded():
            choice = True
        budget = int(min(world.engine.budget, ENDLESS))
        how = contacts, budget, until, choice, chunk
        return Job(world.scene, asked.before, asked.struck, *how)
    if until:
        raise ValueError("simulate_many until= needs the engine EventDriven, and no cluster law")
    if compiled:
        raise ValueError("this engine or cluster law runs interpreted: not with compiled=True")
    return OneByOne(world.copy(), asked.names[asked.struck], contacts)


def _interpreted(scene: body.Scene) -> bool:
    """Has it a custom law that no kernel compiles?"""
    for rule in (scene.ball_rule, scene.cushion_rule, *scene.rules):
        if isinstance(rule, CustomRule) and rule.interpreted:
            return True
    return False


def loaded() -> bool:
    """Is the compiled kernel here already?"""
    module = sys.modules.get("physics.batch.compiled")
    return module is not None and module.loaded()
