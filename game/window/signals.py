"""Signals that end a program end a game in order: settings are kept, the record gets its end."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

NAMES = ("SIGINT", "SIGTERM", "SIGHUP")
"""Ctrl+C, the end of a session, a terminal that is closed; Windows has no SIGHUP."""


class _State:
    asked = False
    """Has the window been asked to close?"""
    failing = False
    """Is leaving early a failure?"""


@contextmanager
def orderly() -> Iterator[None]:
    """Take them as a QUIT of the window; the second time leave the game as it stands.

    Before there is a window nothing has to be kept: the process ends at once, with code 0, or 130
    after Ctrl+C. What the program was started with ignoring (nohup) stays ignored. The old
    handlers are put back after.
    """
    if threading.current_thread() is not threading.main_thread():
        yield  # signals are none of its business
        return
    _State.asked = _State.failing = False
    heard = [number for number in _numbers() if signal.getsignal(number) != signal.SIG_IGN]
    before = {number: signal.signal(number, _leave) for number in heard}
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def fail() -> None:
    """From now on leaving is a failure: what was asked for will not have been done."""
    _State.failing = True


def ignore() -> None:
    """Ignore them until `orderly` ends: what is being saved shall be saved."""
    if threading.current_thread() is threading.main_thread():
        for number in _numbers():
            signal.signal(number, signal.SIG_IGN)


def _numbers() -> list[int]:
    return [getattr(signal, name) for name in NAMES if hasattr(signal, name)]


def _leave(number: int, frame: FrameType | None) -> None:
    code = 130 if number == signal.SIGINT or _State.failing else 0
    if _State.asked:
        raise SystemExit(code)
    if not _posted():
        os._exit(code)  # an exception in the middle of an import may be caught there, or lost
    _State.asked = True


def _posted() -> bool:
    """Ask the window to close; returns whether there is one."""
    pygame: Any = sys.modules.get("pygame")
    if not getattr(pygame, "display", None) or not pygame.display.get_surface():
        return False
    try:
        pygame.event.post(pygame.event.Event(pygame.QUIT, sure=True))
    except pygame.error:
        raise SystemExit(0) from None  # the queue is full
    return True
