"""Work that takes seconds, done in another process and looked at once a frame."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any, NamedTuple

Tell = Callable[[object], None]
"""With which the work says how far it is."""
YIELDS = 5
"""By how much nicer than the game it is, for a machine with few cores."""


class News(NamedTuple):
    """What has come of the work: "told" "done", or "failed" with the reason in words."""

    kind: str
    value: Any = None


class Worker:
    """A function of `Tell` and values in a process of its own; both must be picklable.

    A thread would share the interpreter with the frames, and hold them up. The process is begun
    afresh, not forked: a copy of a process with a window cannot be trusted.
    """

    def __init__(self, work: Callable[..., Any], *given: object) -> None:
        context = multiprocessing.get_context("spawn")
        self._ours, theirs = context.Pipe(duplex=False)
        self._process = context.Process(target=_work, args=(theirs, work, given), daemon=True)
        begin(self._process)
        theirs.close()

    def look(self) -> News | None:
        """What is new since the last look, if anything; "done" and "failed" are the last."""
        try:
            if not self._ours.poll():
                return None
            found: News = self._ours.recv()
        except (EOFError, OSError):
            found = News("failed", "the process has ended")
        if found.kind != "told":
            self._ours.close()  # it ends by itself; waiting for that would take three frames
        return found

    def cancel(self) -> None:
        """End it, whatever it is doing; what is left of it goes with the next one that begins."""
        end(self._process)
        self._ours.close()


def begin(process: BaseProcess) -> None:
    """Start it; where the system allows no more processes, it is as one that has ended at once."""
    with suppress(OSError):
        process.start()


def end(process: BaseProcess) -> None:
    """Kill it, if it has started."""
    if process.pid is not None:
        process.kill()


def _work(theirs: Connection, work: Callable[..., Any], given: tuple[object, ...]) -> None:
    with suppress(AttributeError, OSError):
        os.nice(YIELDS)
    try:
        found = News("done", work(lambda value: theirs.send(News("told", value)), *given))
    except Exception as error:  # whatever it is, the game says so and goes on
        plain = isinstance(error, ValueError | OSError)
        found = News("failed", str(error) if plain else f"{type(error).__name__}: {error}")
    theirs.send(found)
