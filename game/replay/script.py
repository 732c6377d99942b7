"""Scripts: lines of time and key or text, so that the game can be played without hands."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import pygame

from game.session.ticks import TICKS
from game.settings import user_files
from game.text.quoting import shortly

MODIFIERS = {"shift": pygame.KMOD_SHIFT, "ctrl": pygame.KMOD_CTRL, "alt": pygame.KMOD_ALT}

LONGEST = 1 << 26
"""Bytes of a script at most."""


class ScriptError(ValueError):
    """A script that cannot be read: the message names file and line."""


class ScriptLine(NamedTuple):
    """Events to be handled at a tick."""

    tick: int
    events: tuple[pygame.event.Event, ...]


class Script:
    """The lines of a script that are still to come."""

    def __init__(self, lines: list[ScriptLine]) -> None:
        self._lines = lines[::-1]

    def due(self, tick: int) -> Iterator[ScriptLine]:
        """Take the lines up to and including `tick`, in their order."""
        while self._lines and self._lines[-1].tick <= tick:
            yield self._lines.pop()


def read(path: str) -> Script:
    """Read a script file; ScriptError says what is wrong and where."""
    try:
        text = user_files.stream(path, LONGEST).decode("utf-8-sig")
    except OSError as error:
        raise ScriptError(f"cannot read script {path!r}: {error.strerror or error}") from None
    except UnicodeDecodeError as error:
        raise ScriptError(f"cannot read script {path!r}: {error}") from None
    return parse(text, path)


def parse(text: str, name: str = "script") -> Script:
    """Return the script written in `text`."""
    lines: list[ScriptLine] = []
    for number, raw in enumerate(text.split("\n"), 1):
        words = raw.split("#", 1)[0].split()
        if not words:
            continue
        try:
            line = ScriptLine(_tick(words[0]), tuple(_events(words[1:])))
            if lines and line.tick < lines[-1].tick:
                raise ValueError("the time is before that of the line above")
        except ValueError as error:
            raise ScriptError(f"{name}, line {number}: {error}") from None
        lines.append(line)
    return Script(lines)


def _tick(word: str) -> int:
    try:
        tick = round(float(word) * TICKS)
    except (ValueError, OverflowError):
        raise ValueError(f"a time in seconds was expected, not {shortly(word)}") from None
    if tick < 0:
        raise ValueError(f"the time must not be negative, not {shortly(word)}")
    return tick


def _events(words: list[str]) -> list[pygame.event.Event]:
    match words:
        case ["key", name]:
            return [_key(name)]
        case ["text", *parts] if parts:
            return [pygame.event.Event(pygame.TEXTINPUT, text=c) for c in " ".join(parts)]
        case ["click", x, y] if re.fullmatch(r"\d{1,5} \d{1,5}", f"{x} {y}"):
            at = (int(x), int(y))
            kinds = (pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP)
            return [pygame.event.Event(kind, pos=at, button=1, buttons=(0, 0, 0)) for kind in kinds]
        case ["quit"]:
            return [pygame.event.Event(pygame.QUIT)]
    said = shortly(" ".join(words))
    raise ValueError(f"key NAME, text TEXT, click X Y or quit was expected, not {said}")


def _key(name: str) -> pygame.event.Event:
    *held, last = name.lower().split("+") if len(name) > 1 else [name]
    code = ord(last) if len(last) == 1 and last.isascii() else _code(last)
    if code is None or any(h not in MODIFIERS for h in held):
        raise ValueError(f"there is no key {shortly(name)}")
    mod = sum(MODIFIERS[h] for h in held)
    return pygame.event.Event(pygame.KEYDOWN, key=code, mod=mod, unicode="")


def _code(name: str) -> int | None:
    code: int | None = getattr(pygame, f"K_{name.upper()}", None)
    return code
