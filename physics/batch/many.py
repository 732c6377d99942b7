"""Many shots of one scene: shots in, arrays out; compiled where the extra `fast` is there."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from math import inf, nan
from operator import attrgetter
from typing import TYPE_CHECKING, Any, NamedTuple

from physics.ball import Ball
from physics.checks import LARGEST, array
from physics.engines.exact import EventDriven
from physics.kernel import body, calendar, elementary
from physics.kernel.body import CLIMB, ROLL_X, ROLL_Y, SIDE, VX, VY
from physics.laws import CustomRule
from physics.shot import Shot
from physics.simulation import simulate
from physics.world import World

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

CHUNK = 4096  # shots that an executor is handed at once: 10 ms compiled, 0.5 s interpreted
WORTH = 5000  # shots: below that, loading the compiled kernel takes longer than it saves


NUMBERS = ("speed", "angle", "follow", "masse", "side", "climb")
_numbers = attrgetter(*NUMBERS)


class Outcomes(NamedTuple):
    """What `simulate_many` returns, as arrays.

    positions: (shots, balls, 2) at rest, m; NaN for a ball in a pocket.
    times: (shots,) until rest, s.
    events: (shots,), how many there were.
    """

    positions: npt.NDArray[np.float64]
    times: npt.NDArray[np.float64]
    events: npt.NDArray[np.int64]


def simulate_many(
    world: World,
    ball: Ball | str,
    shots: Sequence[Shot] | npt.ArrayLike,
    executor: Executor | None = None,
    compiled: bool | None = None,
    progress: Callable[[int], object] | None = None,
) -> Outcomes:
    """The outcome of each shot at `ball`, all from the state the world is in, which stays as it is.

    shots: `Shot`s, or an array (shots, 5) of speed, angle, follow, masse, side, or (shots, 6) with
    climb.
    executor: any of concurrent.futures' kind shares the work: threads (the compiled kernel lets
    them run at once), processes, a cluster's.
    compiled: True asks for numba (ImportError without it), False for the interpreter; None takes
    numba where it is installed and worth it. The digits are the same, and those of `simulate` if
    all balls lie still before the shot.
    progress: called with the number of shots done since it was last called.
    ValueError names a bad shot, executor or progress; other errors are those of a run.
    """
    import numpy as np

    if executor is not None and not hasattr(executor, "submit"):
        raise ValueError(f"simulate_many executor must have a submit, not be {executor!r}")
    if progress is not None and not callable(progress):
        raise ValueError(f"simulate_many progress must be callable, not {progress!r}")
    world.plan()
    table = _table(shots, np)
    job = _job(world, world.ball(ball).on_table().name, len(table), compiled, np)
    pieces = [table[k : k + job.chunk] for k in range(0, len(table), job.chunk)] or [table]
    parts = []
    for piece, part in zip(pieces, _parts(job, pieces, executor), strict=True):
        parts.append(part)
        if progress is not None:
            progress(len(piece))
    outcomes = Outcomes(*(np.concatenate(column) for column in zip(*parts, strict=True)))
    over = np.flatnonzero((outcomes.events > job.budget) | (outcomes.events < 0))
    if len(over):
        simulate(world, ball, Shot(*table[over[0]].tolist()))  # raises, with the scene
    return outcomes


def _job(
    world: World, name: str, shots: int, compiled: bool | None, np: Any
) -> Job | OneByOne:
    """What plays the shots."""
    if isinstance(world.engine, EventDriven) and world.cluster_law is None:
        choice = _choose(world, shots, compiled)
        copy = world.copy()
        copy.part()
        struck = next(k for k, ball in enumerate(copy.balls) if ball.name == name)
        before = np.array([start(ball.disturb()) for ball in copy.balls])
        return Job(world.scene, before, struck, world.engine.budget, choice, CHUNK)
    if compiled:
        raise ValueError("this engine or cluster law runs interpreted: not with compiled=True")
    return OneByOne(world.copy(), name)


def _parts(job: Job | OneByOne, pieces: list[Any], executor: Executor | None) -> Iterator[Any]:
    """The outcomes of the pieces, in their order; if one fails, those not begun are dropped."""
    if executor is None:
        yield from map(job.run, pieces)
        return
    futures = [executor.submit(job.run, piece) for piece in pieces]
    try:
        for future in futures:
            yield future.result()
    finally:
        for future in futures:
            future.cancel()


def _table(shots: Any, np: Any) -> Any:
    """The shots as an array (shots, 5 or 6); ValueError if one of them cannot be played."""
    try:
        if not isinstance(shots, np.ndarray):
            shots = [_numbers(shot) if isinstance(shot, Shot) else shot for shot in shots]
        table = array("shots", shots) if len(shots) else np.empty((0, 6))
    except (TypeError, ValueError):
        raise ValueError(
            f"shots must be Shots or rows of 5 or 6 numbers, not {shots!r:.80}"
        ) from None
    if table.ndim != 2 or table.shape[1] not in (5, 6):
        raise ValueError(f"shots must be Shots or an array (shots, 5 or 6), not {table.shape}")
    for bad in np.flatnonzero(~((abs(table) <= LARGEST).all(axis=1) & (table[:, 0] > 0.0))):
        try:
            Shot(*table[bad].tolist())
        except ValueError as error:
            raise ValueError(f"shot {bad}: {error}") from None
    return table


def start(ball: body.Body) -> tuple[float, ...]:
    """What the kernel sets a ball off with, in the order of its columns."""
    p, v, w = ball.position, ball.velocity, ball.roll
    return p.real, p.imag, v.real, v.imag, w.real, w.imag, ball.side, ball.height, ball.climb


def _choose(world: World, shots: int, compiled: bool | None) -> bool:
    """Whether to use the compiled kernel; custom laws must be marked for it."""
    rules = world.scene.ball_rule, world.scene.cushion_rule, *world.scene.rules
    custom = any(isinstance(rule, CustomRule) and rule.interpreted for rule in rules)
    if compiled and custom:
        raise ValueError(
            "a custom law runs interpreted: not with compiled=True, unless it is marked as"
            " @laws.compiled"
        )
    if compiled is None:
        worth = shots >= WORTH and importlib.util.find_spec("numba") is not None
        return worth and not custom
    return compiled


class Job(NamedTuple):
    """What every piece of a batch needs: it can be sent to another process or machine."""

    scene: body.Scene
    before: Any  # (balls, COLUMNS): the `start` of every ball, but for the shot
    struck: int
    budget: int
    compiled: bool
    chunk: int

    def run(self, table: Any) -> tuple[Any, Any, Any]:
        """(positions, times, events) of the shots in the rows."""
        starts = self._starts(table)
        return self._compiled(starts) if self.compiled else self._interpreted(starts)

    def _starts(self, table: Any) -> Any:
        """(shots, balls, COLUMNS): the `start` of every ball when the shot is struck."""
        import numpy as np

        starts = np.tile(self.before, (len(table), 1, 1))
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
        import numpy as np

        d = np.empty(len(angle), complex)
        if self.compiled:
            from .compiled import kernel

            kernel().elementary.directions(angle.copy(), d)
        else:
            elementary.directions(angle.tolist(), d)
        return d

    def _compiled(self, starts: Any) -> tuple[Any, Any, Any]:
        import numpy as np

        from .compiled import kernel, packed

        shots, balls, _ = starts.shape
        rests = np.empty((shots, balls, 2))
        times, counts = np.empty(shots), np.empty(shots, np.int64)
        kernel().calendar.many(starts, rests, times, counts, self.budget, packed(self.scene))
        return rests, times, counts

    def _interpreted(self, starts: Any) -> tuple[Any, Any, Any]:
        import numpy as np

        shots, balls, _ = starts.shape
        rests = [[[0.0, 0.0] for _ in range(balls)] for _ in range(shots)]
        times, counts = [0.0] * shots, [0] * shots
        scene = body.twin_scene(self.scene, [body.twin(ball) for ball in self.scene.balls])
        calendar.many(starts.tolist(), rests, times, counts, self.budget, scene)
        return np.array(rests).reshape(shots, balls, 2), np.array(times), np.array(counts, np.int64)


def _rest(ball: Ball) -> tuple[float, float]:
    """Where it lies, as `Outcomes` has it."""
    return (nan, nan) if ball.phase == "pocketed" else ball.position


class OneByOne(NamedTuple):
    """The same for an engine or a law for clusters that has no batches: world after world."""

    world: World
    ball: str
    budget: float = inf  # every run has its own
    chunk: int = 64

    def run(self, table: Any) -> tuple[Any, Any, Any]:
        """(positions, times, events) of the shots in the rows."""
        import numpy as np

        worlds = [simulate(self.world, self.ball, Shot(*row)) for row in table.tolist()]
        rests = np.array([[_rest(ball) for ball in after.balls] for after in worlds])
        return (
            rests.reshape(-1, len(self.world.balls), 2),
            np.array([after.time - self.world.time for after in worlds]),
            np.array([len(after.log) for after in worlds], np.int64),
        )
