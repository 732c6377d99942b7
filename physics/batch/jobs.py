"""What plays the shots of a batch: one kernel for all of them, or world after world."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from math import inf, nan
from typing import Any, NamedTuple

import numpy as np

from physics.engines.exact import EventDriven
from physics.kernel import body, calendar, elementary
from physics.kernel.away import LEFT
from physics.kernel.body import CLIMB, HEIGHT, ROLL_X, ROLL_Y, SIDE, VX, VY, Notes, Touch, Way, X, Y
from physics.kernel.leg import DOWN
from physics.laws import CustomRule
from physics.shot import Shot
from physics.simulation import simulate
from physics.world import World

from .outcomes import KIND, Outcomes, Part, contact_type, joined
from .shots import Asked, laid

WORTH = 5000  # shots: below that, loading the compiled kernel takes longer than it saves


class Job(NamedTuple):
    """What every piece of a batch needs: it can be sent to another process or machine."""

    scene: body.Scene
    before: Any  # (balls, COLUMNS): the `start` of every ball, but for the shot
    struck: int
    contacts: int  # how many are kept
    budget: int
    compiled: bool
    chunk: int

    def run(self, table: Any, places: Any = None) -> Part:
        """The outcomes of the shots in the rows, from these places, if they are given."""
        starts = self._starts(table, places)
        return self._compiled(starts) if self.compiled else self._interpreted(starts)

    def _starts(self, table: Any, places: Any) -> Any:
        """(shots, balls, COLUMNS): the `start` of every ball when the shot is struck."""
        starts = np.tile(self.before, (len(table), 1, 1))
        if places is not None:
            gone = np.isnan(places[:, :, 0])
            starts[...] = 0.0
            starts[:, :, [X, Y]] = np.where(gone[:, :, None], 0.0, places)
            starts[:, :, HEIGHT] = np.where(gone, DOWN, 0.0)
        speed, angle, follow, masse, side = table.T[:5]
        d = self._directions(angle)
        mine = starts[:, self.struck]
        mine[:, VX], mine[:, VY] = speed * d.real, speed * d.imag
        mine[:, ROLL_X] = follow * d.real + masse * d.imag
        mine[:, ROLL_Y] = follow * d.imag - masse * d.real
        mine[:, SIDE] = side
        mine[:, CLIMB] = table[:, 5] if table.shape[1] == 6 else 0.0
        return starts

    def _directions(self, angle: Any) -> Any:
        d = np.empty(len(angle), complex)
        if self.compiled:
            from .compiled import kernel

            kernel().elementary.directions(angle.copy(), d)
        else:
            elementary.directions(angle.tolist(), d)
        return d

    def _compiled(self, starts: Any) -> Part:
        from .compiled import kernel, notes, packed

        shots, balls, _ = starts.shape
        rests = np.empty((shots, balls, 2))
        times, counts = np.empty(shots), np.empty(shots, np.int64)
        kept = notes(shots, self.contacts, balls, len(self.scene.walls))
        kernel().calendar.many(starts, rests, times, counts, self.budget, packed(self.scene), kept)
        return self._part(rests, times, counts, kept.contacts, kept.found)

    def _interpreted(self, starts: Any) -> Part:
        shots, balls, _ = starts.shape
        rests = [[[0.0, 0.0] for _ in range(balls)] for _ in range(shots)]
        times, counts, found = [0.0] * shots, [0] * shots, [0] * shots
        scene = body.twin_scene(self.scene, [body.twin(ball) for ball in self.scene.balls])
        touches = np.zeros((shots, self.contacts), contact_type())
        notes = self._notes(balls)
        rows = starts.tolist()
        for s in range(shots):
            here = slice(s, s + 1)
            where, when, many = rests[here], [0.0], [0]
            calendar.many(rows[here], where, when, many, self.budget, scene, notes)
            times[s], counts[s], found[s] = when[0], many[0], notes.found[0]
            for k in range(min(found[s], self.contacts)):
                touches[s, k] = _values(notes.contacts[0][k])
        return self._part(
            np.array(rests).reshape(shots, balls, 2), np.array(times), np.array(counts, np.int64),
            touches, np.array(found, np.int64),
        )  # fmt: skip

    def _notes(self, balls: int) -> Notes:
        """Room for those of one shot."""
        most = self.contacts
        ways, near = [Way() for _ in range(balls)], [True] * (balls * len(self.scene.walls))
        return Notes(most, [[Touch() for _ in range(most)]], [0], ways, near)

    def _part(self, rests: Any, times: Any, counts: Any, contacts: Any, found: Any) -> Part:
        if not self.contacts:
            found = np.zeros(len(times), np.int64)
            contacts = np.zeros((len(times), 0), contact_type())
        return Part(rests, times, counts, contacts, np.maximum(found - self.contacts, 0))


def _values(touch: Touch) -> tuple[Any, ...]:
    return touch.kind, touch.again, touch.first, touch.second, touch.time


class OneByOne(NamedTuple):
    """The same for an engine or a law for clusters that has no batches: world after world."""

    world: World
    ball: str
    contacts: int
    budget: float = inf  # every run has its own
    chunk: int = 64

    def run(self, table: Any, places: Any = None) -> Part:
        """The outcomes of the shots in the rows, from these places, if they are given."""
        worlds = [self._after(k, row, places) for k, row in enumerate(table.tolist())]
        rests = np.array([[_rest(ball) for ball in after.balls] for after in worlds])
        kept = np.zeros((len(worlds), self.contacts), contact_type())
        dropped = [self._keep(after, line) for after, line in zip(worlds, kept, strict=True)]
        return Part(
            rests.reshape(-1, len(self.world.balls), 2),
            np.array([after.time - self.world.time for after in worlds]),
            np.array([len(after.log) for after in worlds], np.int64),
            kept,
            np.array(dropped, np.int64),
        )

    def _after(self, k: int, row: list[float], places: Any) -> World:
        world = self.world if places is None else laid(self.world, places[k])
        return simulate(world, self.ball, Shot(*row))

    def _keep(self, after: World, line: Any) -> int:
        """Write the contacts of a shot into the line; returns for how many there was no room."""
        if not self.contacts:
            return 0
        touches = list(after.log.touches())
        for k, (time, kind, i, other, away) in enumerate(touches[: self.contacts]):
            line[k] = KIND[kind.name], away <= LEFT, i, other, time - self.world.time
        return max(0, len(touches) - self.contacts)


def _rest(ball: Any) -> tuple[float, float]:
    """Where it lies, as `Outcomes` has it."""
    return (nan, nan) if ball.gone else ball.position


def start(ball: body.Body) -> tuple[float, ...]:
    """What the kernel sets a ball off with, in the order of its columns."""
    p, v, w = ball.position, ball.velocity, ball.roll
    return p.real, p.imag, v.real, v.imag, w.real, w.imag, ball.side, ball.height, ball.climb


def job_of(
    world: World, asked: Asked, contacts: int, compiled: bool | None, chunk: int
) -> Job | OneByOne:
    """What plays the shots, so many at a time."""
    if isinstance(world.engine, EventDriven) and world.cluster_law is None:
        choice = _choose(world, len(asked.table), compiled)
        copy = world.copy()
        copy.part()
        before = np.array([start(ball.disturb()) for ball in copy.balls])
        budget = world.engine.budget
        return Job(world.scene, before, asked.struck, contacts, budget, choice, chunk)
    if compiled:
        raise ValueError("this engine or cluster law runs interpreted: not with compiled=True")
    return OneByOne(world.copy(), world.balls[asked.struck].name, contacts)


def play(
    world: World, asked: Asked, job: Job | OneByOne, executor: Executor | None,
    progress: Callable[[int], object] | None,
) -> Outcomes:  # fmt: skip
    """All that was asked for, piece by piece."""
    parts, pieces = [], asked.pieces(job.chunk)
    for (rows, _), part in zip(pieces, _parts(job, pieces, executor), strict=True):
        parts.append(part)
        if progress is not None:
            progress(len(rows))
    names = tuple(ball.name for ball in world.balls)
    outcomes = joined(parts, names, tuple(wall.name for wall in world.walls))
    over = np.flatnonzero((outcomes.events > job.budget) | (outcomes.events < 0))
    if len(over):  # the same again raises, with the scene
        first = world if asked.places is None else laid(world, asked.places[over[0]])
        simulate(first, names[asked.struck], Shot(*asked.table[over[0]].tolist()))
    return outcomes


def _parts(
    job: Job | OneByOne, pieces: list[tuple[Any, Any]], executor: Executor | None
) -> Iterator[Part]:
    """The outcomes of the pieces, in their order; if one fails, those not begun are dropped."""
    if executor is None:
        yield from (job.run(*piece) for piece in pieces)
        return
    futures = [executor.submit(job.run, *piece) for piece in pieces]
    try:
        for future in futures:
            yield future.result()
    finally:
        for future in futures:
            future.cancel()


def _choose(world: World, shots: int, compiled: bool | None) -> bool:
    """Whether to use the compiled kernel; a custom law cannot be compiled."""
    rules = world.scene.ball_rule, world.scene.cushion_rule, *world.scene.rules
    custom = any(isinstance(rule, CustomRule) for rule in rules)
    if compiled and custom:
        raise ValueError("a custom law runs interpreted: not with compiled=True")
    if compiled is None:
        worth = shots >= WORTH and importlib.util.find_spec("numba") is not None
        return worth and not custom
    return compiled
