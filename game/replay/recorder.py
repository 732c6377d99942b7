"""Writing a record while a game is played; an old one stays until the new one has begun."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from dataclasses import asdict
from io import FileIO

from game.contradictions import VIEW
from game.options import Options
from game.session.action import Action
from game.session.session import Session
from game.session.ticks import TICKS, seconds
from game.settings import user_files

from .game_record import FORMAT, VERSION, RecordError, Witness, built_with, digest


class Recorder:
    """Writes a game down as it is played: each line at once, so that a crash loses none.

    The file is begun with the first line, all at once: a game that cannot begin leaves an old
    record as it is. When no more can be written, on a full disk for example, the game goes on and
    what has been written stays a record that was cut off; `fault` says why.
    """

    def __init__(self, path: str, options: Options, session: Session) -> None:
        self.path, self.session, self.shots = path, session, 0
        self.fault = ""
        self.closed = self._noticed = False
        self._file: FileIO | None = None
        self.witness = Witness(session, self._shot)
        begun = {k: v for k, v in asdict(options).items() if k not in VIEW}
        head = {"format": FORMAT, "version": VERSION, "with": built_with(), "ticks": TICKS}
        self._head = _data({**head, "edition": session.edition, "setup": begun})
        try:
            user_files.insist_on_room(path)
        except OSError as error:
            raise RecordError(f"cannot write record {path!r}: {error.strerror}") from None

    def before(self, action: Action) -> None:
        """An action is about to be done."""
        if action.name != "quit":
            said = [action.name] if action.value is None else [action.name, action.value]
            self._write({"tick": self.session.tick, "do": said})
        self.witness.before()

    def after(self) -> None:
        """The action has been done."""
        self.witness.after()
        self._notice()

    def passed(self) -> None:
        """Time has passed."""
        self.witness.passed()
        self._notice()

    def close(self) -> None:
        """Write the end; nothing can be noted after it."""
        if not self.closed:
            self._write({"tick": self.session.tick, "end": digest(self.session)})
            self._close()

    def _shot(self, tick: int, found: str) -> None:
        self.shots += 1
        self._write({"tick": tick, "shot": self.shots, "digest": found})

    def _write(self, line: dict[str, object]) -> None:
        if self.closed:
            return
        try:
            self._file = self._file or user_files.begun(self.path, self._head)
            _append(self._file, _data(line))
        except OSError as error:
            when = f"at {seconds(self.session.tick):.1f} s"
            self.fault = f"record {self.path!r} was cut off {when}: {error.strerror or error}"
            self._close()

    def _close(self) -> None:
        self.closed = True
        if self._file is not None:
            with suppress(OSError):
                self._file.close()

    def _notice(self) -> None:
        """Say once in the window that the game is not recorded any more."""
        if self.fault and not self._noticed:
            self._noticed = True
            self.session.say("record.cut", error=True)


def _data(line: dict[str, object]) -> bytes:
    """A line; a lone surrogate, which UTF-8 has not, is written as JSON escapes it."""
    return (json.dumps(line, ensure_ascii=False) + "\n").encode("utf-8", "backslashreplace")


def _append(file: FileIO, data: bytes) -> None:
    """Write all of the bytes, or none of them where that cannot be: OSError."""
    start = file.seek(0, os.SEEK_END)
    try:
        rest = data
        while rest:
            rest = rest[file.write(rest) :]
    except OSError:
        with suppress(OSError):
            file.truncate(start)
        raise
