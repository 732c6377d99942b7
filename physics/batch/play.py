"""A batch is played piece by piece, by the kernel that it is worth, in this thread or by others."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from typing import Any

import numpy as np

from physics.shot import Shot
from physics.simulation import simulate
from physics.world import World

from .jobs import Job, OneByOne, job_of
from .outcomes import Outcomes, Part
from .shots import Asked, asked_of, laid, wanted

__all__ = ["asked_of", "job_of", "play", "wanted"]

PILOT = 16  # shots that are played before it is decided: 3 ms
LOADING = 1.0  # s, of the compiled kernel
EVENT, BALL = 12e-6, 0.7e-6  # s: what an event takes interpreted, and more for each ball


def play(
    world: World, asked: Asked, job: Job | OneByOne, executor: Executor | None,
    progress: Callable[[int], object] | None,
) -> Outcomes:  # fmt: skip
    """All that was asked for."""
    whole = Part.room(len(asked.table), len(asked.names), job.contacts)
    if job.compiled and executor is None and progress is None and len(whole.times) <= job.chunk:
        job.run(asked.table, asked.places, whole)  # at once, and quicker for a single shot
    else:
        for count in _pieces(job, asked, whole, executor):
            if progress is not None:
                progress(count)
    least, most = _extremes(whole.events)
    if least < 0 or most > job.budget:
        over = (whole.events < 0) | (whole.events > job.budget)
        _fail(world, asked, int(np.flatnonzero(over)[0]))
    return whole.whole(asked.names, tuple([wall.name for wall in world.walls]))


def _extremes(counts: Any) -> tuple[int, int]:
    if len(counts) == 1:  # quicker
        return (counts.item(),) * 2
    return counts.min(initial=0), counts.max(initial=0)


def _fail(world: World, asked: Asked, shot: int) -> None:
    """Play that shot again: it raises, with the scene."""
    first = laid(world, asked.places[shot]) if len(asked.places) else world
    simulate(first, asked.names[asked.struck], Shot(*asked.table[shot].tolist()))


def _pieces(
    job: Job | OneByOne, asked: Asked, whole: Part, executor: Executor | None
) -> Iterator[int]:
    """Play it, piece by piece: how many shots each was."""
    done, shots = 0, len(asked.table)
    if job.compiled is None:
        job, done = _decided(job, asked, whole)
        if done:
            yield done
    cuts = [slice(k, min(k + job.chunk, shots)) for k in range(done, shots, job.chunk)]
    if executor is None:
        for cut in cuts:
            job.run(*asked.cut(cut), whole.cut(cut))
            yield cut.stop - cut.start
    else:
        yield from _shared(job, asked, whole, executor, cuts)


def _shared(
    job: Job | OneByOne, asked: Asked, whole: Part, executor: Executor, cuts: list[slice]
) -> Iterator[int]:
    """The pieces, in their order; if one fails, those not begun are dropped."""
    futures = [executor.submit(job.run, *asked.cut(cut)) for cut in cuts]
    try:
        for cut, future in zip(cuts, futures, strict=True):
            whole.cut(cut).take(future.result())
            yield cut.stop - cut.start
    finally:
        for future in futures:
            future.cancel()


def _decided(job: Any, asked: Asked, whole: Part) -> tuple[Job, int]:
    """The job with a kernel chosen for it, and how many shots have been played for that.

    The compiled kernel is loaded where the first shots say that this saves more than it takes.
    """
    plain = job._replace(compiled=False)
    if importlib.util.find_spec("numba") is None:
        return plain, 0
    cut = slice(0, min(PILOT, len(asked.table)))
    plain.run(*asked.cut(cut), whole.cut(cut))
    left = len(asked.table) - cut.stop
    events = float(whole.events[cut].mean()) * left if left else 0.0
    worth = events * (EVENT + BALL * len(asked.names)) > LOADING
    return job._replace(compiled=worth), cut.stop
