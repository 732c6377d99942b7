"""A process that stays, and answers one question after the other; looked at once a frame."""

from __future__ import annotations

import multiprocessing
import os
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from typing import Any

from .worker import YIELDS, News, begin, end

Question = tuple[object, ...]


class Aide:
    """A function in a process of its own, which keeps what it has loaded from call to call.

    What it is asked last is what counts: an answer to anything else is thrown away. The process
    begins with the first question; like a `Worker` it is begun afresh, not forked.
    """

    def __init__(self, work: Callable[..., Any]) -> None:
        self._work = work
        self._process: Any = None
        self._ours: Connection | None = None
        self._ticket = 0
        self._busy: int | None = None
        """The ticket of what it is working on."""
        self._next: Question | None = None
        """What it gets when it has done that: a full pipe would hold up a frame."""

    def ask(self, *given: object) -> int:
        """Ask for the function of these values; the ticket with which to look for the answer."""
        self._ticket += 1
        self._next = given
        if self._busy is None:
            self._send()
        return self._ticket

    def look(self, ticket: int) -> News | None:
        """The answer, once it is there; "failed" too if something else has been asked since."""
        if ticket != self._ticket:
            return News("failed", "something else has been asked")
        news = self._received() if self._busy is not None else None
        if news is None:
            return None
        mine, self._busy = self._busy == ticket, None
        if self._next is not None:
            self._send()
        return news if mine else None

    def forget(self) -> None:
        """What has been asked is not wanted any more."""
        self._ticket += 1
        self._next = None

    def close(self) -> None:
        """End the process, whatever it is doing."""
        if self._process is not None and self._ours is not None:
            end(self._process)
            self._ours.close()
        self._process = self._ours = self._busy = self._next = None

    def _send(self) -> None:
        given, self._next = self._next, None
        if self._ours is None:
            self._begin()
        assert self._ours is not None
        self._busy = self._ticket
        with suppress(OSError):  # it has ended: that is what is received then
            self._ours.send(given)

    def _begin(self) -> None:
        context = multiprocessing.get_context("spawn")
        self._ours, theirs = context.Pipe()
        self._process = context.Process(target=_answers, args=(theirs, self._work), daemon=True)
        begin(self._process)
        theirs.close()

    def _received(self) -> News | None:
        assert self._ours is not None
        try:
            return self._ours.recv() if self._ours.poll() else None
        except (EOFError, OSError):
            waiting, busy = self._next, self._busy
            self.close()
            self._next, self._busy = waiting, busy
            return News("failed", "the process has ended")


def _answers(theirs: Connection, work: Callable[..., Any]) -> None:
    """Answer until the other end is closed."""
    with suppress(AttributeError, OSError):
        os.nice(YIELDS)
    with suppress(EOFError, OSError, KeyboardInterrupt):
        while True:
            given = theirs.recv()
            try:
                found = News("done", work(*given))
            except Exception as error:  # whatever it is, the game says so and goes on
                found = News("failed", f"{type(error).__name__}: {error}")
            theirs.send(found)
