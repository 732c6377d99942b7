"""Records of a game: its actions with their ticks, and a digest of the balls after every shot.

A record is a text file, one JSON value a line: a header that says how the game began, and with
which edition of the presets (1 if it does not say so); `{"tick", "do"}` for an action, its name and
perhaps its value; `{"tick", "shot", "digest"}` for a shot that is over; `{"tick", "end"}` with a
digest once the game was left. Ticks are those of `clock`.
"""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field, replace
from hashlib import blake2b
from platform import machine, python_version, system
from typing import IO, Any

from .actions import Action
from .clock import TICKS
from .options import VIEW, Options, of_setup
from .play import Game
from .setup import EDITIONS

FORMAT = "danggu record"
VERSION = 1


class RecordError(ValueError):
    """A record that cannot be read or played: the message names the file and the line."""


def digest(game: Game) -> str:
    """Return a hash of where all balls are and how they move, to the last bit."""
    found = blake2b(digest_size=16)
    for ball in game.world.balls:
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
    """Sees every shot of a game end, and tells it: `tell(tick, digest)`.

    A shot is over when the balls rest; when an action strikes anew, which tells how they were just
    before; or when one stops them or puts them elsewhere, which tells how they were and are.
    """

    def __init__(self, game: Game, tell: Callable[[int, str], None]) -> None:
        self.game, self.tell = game, tell
        self._moving = game.moving
        self._before: tuple[str, object] | None = None

    def before(self) -> None:
        """An action is about to be done."""
        self._before = (digest(self.game), self._shot) if self.game.moving else None

    def after(self) -> None:
        """The action has been done."""
        game = self.game
        if self._before is not None:
            found, shot = self._before
            if not game.moving:
                both = (found + digest(game)).encode()
                self.tell(game.tick, blake2b(both, digest_size=16).hexdigest())
            elif shot != self._shot:
                self.tell(game.tick, found)
        self._moving = game.moving

    def passed(self) -> None:
        """Time has passed."""
        if self._moving and not self.game.moving:
            self.tell(self.game.tick, digest(self.game))
        self._moving = self.game.moving

    @property
    def _shot(self) -> object:
        return self.game.shots, self.game.began


class Recorder:
    """Writes a game down as it is played: each line at once, so that a crash loses none."""

    def __init__(self, path: str, options: Options, game: Game) -> None:
        try:
            self._file: IO[str] = open(path, "w", encoding="utf-8")  # noqa: SIM115 closed by `close`
        except OSError as error:
            raise RecordError(f"cannot write record {path!r}: {error.strerror}") from None
        self.game, self.shots = game, 0
        self.witness = Witness(game, self._shot)
        begun = {k: v for k, v in asdict(options).items() if k not in VIEW}
        head = {"format": FORMAT, "version": VERSION, "with": built_with(), "ticks": TICKS}
        self._write({**head, "edition": game.edition, "setup": begun})

    def before(self, action: Action) -> None:
        """An action is about to be done."""
        if action.name != "quit":
            said = [action.name] if action.value is None else [action.name, action.value]
            self._write({"tick": self.game.tick, "do": said})
        self.witness.before()

    def after(self) -> None:
        """The action has been done."""
        self.witness.after()

    def passed(self) -> None:
        """Time has passed."""
        self.witness.passed()

    def close(self) -> None:
        """Write the end; nothing can be noted after it."""
        if not self._file.closed:
            self._write({"tick": self.game.tick, "end": digest(self.game)})
            self._file.close()

    def _shot(self, tick: int, found: str) -> None:
        self.shots += 1
        self._write({"tick": tick, "shot": self.shots, "digest": found})

    def _write(self, line: dict[str, object]) -> None:
        self._file.write(json.dumps(line, ensure_ascii=False) + "\n")
        self._file.flush()


@dataclass(slots=True)
class Record:
    """What a file holds; `end` is (tick, digest), or None if the game was cut off."""

    name: str
    setup: Options
    built: str
    actions: list[tuple[int, Action]] = field(default_factory=list)
    shots: list[str] = field(default_factory=list)
    end: tuple[int, str] | None = None
    last: int = 0
    """Tick of the last line."""


def read(path: str, options: Options) -> Record:
    """Read a record; what it does not say is taken from `options`. RecordError if it is broken."""
    try:
        with open(path, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as error:
        raise RecordError(f"cannot read record {path!r}: {error}") from None
    lines = _lines(text, path)
    head = next(lines, (0, None))[1]
    record = _begun(head, path, options)
    for number, line in lines:
        try:
            _take(record, line)
        except (KeyError, TypeError, ValueError) as error:
            raise RecordError(f"{path}, line {number}: not a line of a record ({error})") from None
    return record


def _lines(text: str, path: str) -> Iterator[tuple[int, Any]]:
    """Every line and its number; a last one that was cut off is left out."""
    whole = text.endswith("\n")
    raw = text.splitlines()
    for number, line in enumerate(raw, 1):
        try:
            yield number, json.loads(line)
        except (ValueError, RecursionError):
            if 1 < number == len(raw) and not whole:
                return
            raise RecordError(f"{path}, line {number}: not a record of this game") from None


def _begun(head: Any, path: str, options: Options) -> Record:
    if not isinstance(head, dict) or head.get("format") != FORMAT:
        raise RecordError(f"{path}: not a record of this game")
    if head.get("version") != VERSION or head.get("ticks") != TICKS:
        said = f"version {head.get('version')!r}, this is version {VERSION}"
        raise RecordError(f"{path}: a record of another kind ({said})")
    edition = head.get("edition", 1)
    if edition not in EDITIONS:
        raise RecordError(f"{path}: presets of edition {edition!r}, this has {EDITIONS}")
    try:
        setup = replace(of_setup(head["setup"], options), edition=edition)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise RecordError(f"{path}, line 1: {error}") from None
    return Record(path, setup, str(head.get("with", "")))


def _take(record: Record, line: dict[str, Any]) -> None:
    """Add a line; raises what tells that it is none."""
    tick = line["tick"]
    if type(tick) is not int or tick < record.last:
        raise ValueError(f"tick {tick!r} after {record.last}")
    if record.end is not None:
        raise ValueError("something after the end")
    record.last = tick
    if "do" in line:
        name, *value = line["do"]
        if type(name) is not str or len(value) > 1:
            raise ValueError(f"action {line['do']!r}")
        record.actions.append((tick, Action(name, *value)))
    elif "shot" in line:
        record.shots.append(str(line["digest"]))
    else:
        record.end = tick, str(line["end"])
