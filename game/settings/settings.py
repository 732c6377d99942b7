"""What a player wants to find again the next time, kept in a file that may be broken."""

from __future__ import annotations

import json
import locale
import os
from collections.abc import Container, Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from danggu.players.levels import LEVELS
from game.contradictions import LAID
from game.table import presets
from game.text import LANGUAGES

from . import user_files

if TYPE_CHECKING:
    from game.options import Options

VERSION = 1
FORMAT = "danggu settings"
LOUDEST = 10
CHOICES: dict[str, tuple[str, ...]] = {
    "language": tuple(LANGUAGES),
    "table": tuple(presets.TABLES),
    "cloth": tuple(presets.CLOTHS),
    "law": ("table", *presets.LAWS),
    "engine": tuple(presets.ENGINES),
    "aids": ("off", "short", "full"),
    "colours": ("usual", "safe"),
    "level": tuple(level.key for level in LEVELS),
    "squirt": ("off", "on"),
    "diamonds": ("off", "own", "five"),
}
"""What can be chosen; "table" is the cloth, and the laws, that a table comes with."""
SIDE = 200, 16384
"""Least and most pixels of a side of the window."""


@dataclass(slots=True)
class Settings:
    """The choices, each with its usual value.

    language .. squirt  as the commands of these names take them
    aids, colours, diamonds  keys of CHOICES
    level               how well the player carries out a stroke, as the coach sees it
    volume              0 to LOUDEST
    still               reduced motion
    both                a log in two languages
    fan                 the spread of a shot
    full                does the window fill the screen?
    guided              has the guide through a first shot been shown or skipped?
    compare             a shot by other laws and the other engine, over it
    graphs              curves of a shot in place of its log
    keys                the changed ones, action to key
    size                of the window, px
    """

    language: str = "en"
    table: str = "medium"
    cloth: str = "table"
    law: str = "table"
    engine: str = "exact"
    squirt: str = "off"
    aids: str = "full"
    colours: str = "usual"
    level: str = "expert"
    diamonds: str = "off"
    volume: int = 8
    muted: bool = False
    still: bool = False
    both: bool = False
    fan: bool = False
    full: bool = False
    guided: bool = False
    graphs: bool = False
    compare: bool = False
    keys: dict[str, str] = field(default_factory=dict)
    size: tuple[int, int] = (1280, 720)

    def applied(self, options: Options) -> Options:
        """Return the options with these choices wherever the command line has said nothing."""
        law = None if self.law == "table" else self.law
        own = {
            "lang": self.language, "table": self.table, "cloth": self.cloth, "law": law,
            "engine": self.engine, "size": self.size,
        }  # fmt: skip
        # laws and cloth chosen for one table say nothing about another one
        laid = options.given & {*LAID} - ({"game"} if options.game == "free" else set())
        elsewhere = {"table", "law", "cloth"} if laid else set()
        if options.game != "free":
            elsewhere |= {"engine"}  # a match is exact unless the command line says otherwise
        free = {k: v for k, v in own.items() if k not in options.given | elsewhere}
        return replace(options, **free)  # type: ignore[arg-type]


def start() -> Settings:
    """The settings of a player that has never chosen: Korean where the system is."""
    spoken = os.environ.get("LC_ALL") or os.environ.get("LANG") or locale.getlocale()[0] or ""
    return Settings(language="ko" if spoken.lower().startswith("ko") else "en")


def read(document: object) -> tuple[Settings, list[str]]:
    """Return the settings in a document, and the names of the values that could not be used.

    Those keep their defaults; so does what is missing; unknown names are passed over.
    """
    settings = start()
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        return settings, ["format"]
    bad = [] if document.get("version") == VERSION else ["version"]
    for name in (f.name for f in fields(Settings)):
        if name in document:
            try:
                setattr(settings, name, _value(name, document[name]))
            except ValueError:
                bad.append(name)
    settings.keys, lost = _keys(settings.keys)
    return settings, bad + [f"keys.{name}" for name in lost]


def _value(name: str, value: Any) -> object:
    """The value as it is used; ValueError if it cannot be."""
    kind = type(value)
    if name in CHOICES:
        known: Container[str] = presets.TABLES if name == "table" else CHOICES[name]
        good = kind is str and value in known
    elif name == "volume":
        good = kind is int and 0 <= value <= LOUDEST
    elif type(getattr(Settings(), name)) is bool:
        good = kind is bool
    elif name == "keys":
        good = kind is dict
    else:
        good = kind is list and len(value) == 2 and all(type(n) is int for n in value)
        good = good and all(SIDE[0] <= n <= SIDE[1] for n in value)
        value = tuple(value) if good else value
    if not good:
        raise ValueError(name)
    return value


def _keys(wanted: Mapping[str, object]) -> tuple[dict[str, str], list[str]]:
    if not wanted:
        return {}, []
    from game.input import bindings  # which needs pygame: not to print --help

    return bindings.sound(wanted)


def folder() -> Path | None:
    """The platform's folder for a user's settings; None for a user without a home."""
    from platformdirs import user_config_path

    return user_files.folder(user_config_path)


class Store:
    """The file in which the settings are kept; other games may be using it too."""

    def __init__(self, path: Path | None = None) -> None:
        home = folder() if path is None else None
        self.path = path or (home / "settings.json" if home else None)
        """None where there is no place for it: then nothing is kept."""
        self.faults: list[str] = []
        """The values that could not be used when the file was read."""
        self.trouble = ""
        """Why the settings could not be saved, or ""."""
        self._known: Settings | None = None
        """What the file held for all this game knows; None before it has seen any."""
        self._there = False

    def read(self) -> Settings:
        """Read the file, and write nothing: a broken one stays as it is."""
        try:
            settings, self.faults = self._found()
            self._there = True
        except FileNotFoundError:
            settings = start()
        except OSError:
            settings, self.faults = start(), ["format"]
        self._known = _copy(settings)
        return settings

    def load(self) -> Settings:
        """Read the file.  A broken one is kept beside as .broken and replaced by a good one."""
        settings = self.read()
        if self.faults:
            self.save(settings, anyway=True)
        return settings

    def save(self, settings: Settings, *, anyway: bool = False) -> bool:
        """Write what has changed since it was read, if anything; returns whether it is in the file.

        All of it is written or nothing.  What another game has changed meanwhile stays.
        """
        if settings == self._known and self._there and not anyway:
            return True
        try:
            if self.path is None:
                raise OSError("there is no home folder")
            with user_files.alone(self.path):
                user_files.write(self.path, _text(self._merged(settings)))
        except OSError as error:
            self.trouble = error.strerror or str(error)
            return False
        self._known, self._there, self.trouble = _copy(settings), True, ""
        return True

    def _found(self) -> tuple[Settings, list[str]]:
        """The settings in the file and their faults; OSError if there is none to be read."""
        if self.path is None:
            raise FileNotFoundError
        try:
            return read(json.loads(user_files.read(self.path)))
        except (ValueError, RecursionError):
            return read(None)

    def _merged(self, mine: Settings) -> Settings:
        """These settings where this game has changed them, and the file's elsewhere."""
        assert self.path is not None, "there is a file to merge with"
        try:
            theirs, faults = self._found()
        except FileNotFoundError:
            return mine
        if faults:
            user_files.set_aside(self.path)
        if "format" in faults or self._known is None:
            return mine
        for name in (f.name for f in fields(Settings)):
            value = getattr(mine, name)
            if name != "keys" and (name in faults or value != getattr(self._known, name)):
                setattr(theirs, name, value)
        theirs.keys = _merged_keys(mine.keys, theirs.keys, self._known.keys)
        return theirs


def _merged_keys(
    mine: dict[str, str], theirs: dict[str, str], known: dict[str, str]
) -> dict[str, str]:
    """Their changed keys with those of mine that are not as they were known."""
    kept = {name: key for name, key in theirs.items() if name in mine or name not in known}
    own = {name: key for name, key in mine.items() if known.get(name) != key}
    return _keys({**kept, **own})[0]


def _copy(settings: Settings) -> Settings:
    return replace(settings, keys=dict(settings.keys))


def _text(settings: Settings) -> str:
    document = {"format": FORMAT, "version": VERSION, **asdict(settings)}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
