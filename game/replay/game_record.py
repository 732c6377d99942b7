"""Records of a game: its actions with their ticks, and a digest of the balls after every shot.

A record is a text file, one JSON value a line: a header that says how the game began, and with
which edition of the presets (1 if it does not say so); `{"tick", "do"}` for an action, its name and
perhaps its value; `{"tick", "shot", "digest"}` for a shot that is over; `{"tick", "end"}` with a
digest once the game was left. Ticks are those of `session.ticks`.
"""

from __future__ import annotations

import json
import struct
from codecs import BOM_UTF8
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from hashlib import blake2b
from platform import machine, python_version, system
from typing import Any

from game.options import Options, of_setup
from game.session.action import Action
from game.session.commands import fault
from game.session.session import Session
from game.session.ticks import TICKS
from game.settings import user_files
from game.table.presets import EDITIONS
from game.text.quoting import in_a_line, shortly

FORMAT = "danggu record"
VERSION = 1
LATEST = 1 << 40
"""Tick of the last line at most: half a year."""
LONGEST = 1 << 28
"""Bytes of a record at most: days of aiming with the mouse without a pause."""


class RecordError(ValueError):
    """A record that cannot be read or played: the message names the file and the line."""


def digest(session: Session) -> str:
    """Return a hash of where all balls are and how they move, to the last bit."""
    found = blake2b(digest_size=16)
    for ball in session.world.balls:
        found.update(ball.name.encode())
        # adding 0.0 makes one zero of both
        found.update(struct.pack("<7d", *(n + 0.0 for n in _state(ball))))
    return found.hexdigest()


def _state(ball: Any) -> tuple[float, ...]:
    return (*ball.position, *ball.velocity, *ball.spin)


def built_with() -> str:
    """Say what has computed this: where digests differ, it is the first thing to compare."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        own = version("danggu")
    except PackageNotFoundError:
        own = "(not installed)"
    return f"danggu {own}, Python {python_version()}, {system()} {machine()}"


class Witness:
    """Sees every shot of a game end, and reports it: `report(tick, digest)`.

    A shot is over when the balls rest, when an action strikes again (its digest is that of the
    balls just before), or when one stops them or puts them elsewhere (before and after).
    """

    def __init__(self, session: Session, report: Callable[[int, str], None]) -> None:
        self.session, self.report = session, report
        self._moving = session.moving
        self._before: tuple[str, object] | None = None

    def before(self) -> None:
        """An action is about to be done."""
        self._before = (digest(self.session), self._shot) if self.session.moving else None

    def after(self) -> None:
        """The action has been done."""
        session = self.session
        if self._before is not None:
            found, shot = self._before
            if not session.moving:
                both = (found + digest(session)).encode()
                self.report(session.tick, blake2b(both, digest_size=16).hexdigest())
            elif shot != self._shot:
                self.report(session.tick, found)
        self._moving = session.moving

    def passed(self) -> None:
        """Time has passed."""
        if self._moving and not self.session.moving:
            self.report(self.session.tick, digest(self.session))
        self._moving = self.session.moving

    @property
    def _shot(self) -> object:
        return self.session.shots, self.session.began


@dataclass(slots=True)
class Record:
    """What the file of a record holds.

    name     of the file
    setup    how the game began
    built    what it was recorded with
    actions  with their ticks
    shots    the digest after each
    end      (tick, digest), None if the game was cut off
    last     tick of the last line
    """

    name: str
    setup: Options
    built: str
    actions: list[tuple[int, Action]] = field(default_factory=list)
    shots: list[str] = field(default_factory=list)
    end: tuple[int, str] | None = None
    last: int = 0


def read(path: str, options: Options) -> Record:
    """Read a record; what it does not say is taken from `options`. RecordError if it is broken."""
    lines = _lines(_content(path), path)
    head = next(lines, (0, None))[1]
    record = _begun(head, path, options)
    for number, line in lines:
        try:
            _take(record, line)
        except ValueError as error:
            raise RecordError(f"{path}, line {number}: {error}") from None
    return record


def _content(path: str) -> bytes:
    try:
        return user_files.stream(path, LONGEST).removeprefix(BOM_UTF8)
    except OSError as error:
        why = error.strerror or error
        raise RecordError(f"cannot read record {path!r}: {why}") from None


def _lines(content: bytes, path: str) -> Iterator[tuple[int, Any]]:
    """Every line and its number; a last one that was cut off is left out."""
    # not splitlines: names may hold the line separators of Unicode
    raw = content.split(b"\n")
    for number, line in enumerate(raw, 1):
        if not line.strip():
            continue
        try:
            yield number, json.loads(line.decode())
        except (ValueError, RecursionError):
            if 1 < number == len(raw):
                return
            raise RecordError(f"{path}, line {number}: not a record of this game") from None


def _begun(head: Any, path: str, options: Options) -> Record:
    if not isinstance(head, dict) or head.get("format") != FORMAT:
        raise RecordError(f"{path}: not a record of this game")
    if head.get("version") != VERSION or head.get("ticks") != TICKS:
        kind = f"version {shortly(head.get('version'))} with {shortly(head.get('ticks'))} ticks"
        this = f"this is version {VERSION} with {TICKS}"
        raise RecordError(f"{path}: a record of another kind ({kind}, {this})")
    edition = head.get("edition", 1)
    if type(edition) is not int or edition not in EDITIONS:
        raise RecordError(
            f"{path}: presets of edition {shortly(edition)}; this program has {EDITIONS}"
        )
    if not isinstance(head.get("setup"), dict):
        raise RecordError(f"{path}, line 1: setup is {_said(head, 'setup')}, no object")
    try:
        setup = replace(of_setup(head["setup"], options), edition=edition)
    except ValueError as error:
        raise RecordError(f"{path}, line 1: {error}") from None
    built = head.get("with", "")
    return Record(path, setup, in_a_line(built) if isinstance(built, str) else shortly(built))


def _take(record: Record, line: Any) -> None:
    """Add a line; ValueError says what is wrong with it."""
    if not isinstance(line, dict):
        raise ValueError(f"an object was expected, not {shortly(line)}")
    kinds = [kind for kind in ("do", "shot", "end") if kind in line]
    if len(kinds) != 1:
        raise ValueError('one of "do", "shot" and "end" was expected')
    tick = line.get("tick")
    if type(tick) is not int or not record.last <= tick <= LATEST:
        expected = f"a whole number from {record.last} to {LATEST} was expected"
        raise ValueError(f"tick is {_said(line, 'tick')}: {expected}")
    if record.end is not None:
        raise ValueError("something after the end")
    record.last = tick
    if "do" in line:
        record.actions.append((tick, _action(line["do"])))
    elif "shot" in line:
        record.shots.append(_digest(line, "digest"))
    else:
        record.end = tick, _digest(line, "end")


def _action(said: Any) -> Action:
    if not isinstance(said, list) or len(said) not in (1, 2):
        raise ValueError(f"do must be an action and perhaps its value, not {shortly(said)}")
    action = Action(*said)
    if wrong := fault(action):
        raise ValueError(wrong)
    return action


def _digest(line: dict[str, Any], name: str) -> str:
    if not isinstance(line.get(name), str):
        raise ValueError(f"{name} must be text, not {_said(line, name)}")
    return str(line[name])


def _said(line: dict[str, Any], name: str) -> str:
    return shortly(line[name]) if name in line else "missing"
