"""What a player wants to find again the next time, kept in a file that may be broken."""

from __future__ import annotations

import json
import locale
import os
import shutil
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field, fields, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import files, setup
from .text import LANGUAGES

if TYPE_CHECKING:
    from .options import Options

VERSION = 1
FORMAT = "danggu settings"
LOUDEST = 10
CHOICES: dict[str, tuple[str, ...]] = {
    "language": tuple(LANGUAGES),
    "table": tuple(setup.TABLES),
    "cloth": tuple(setup.CLOTHS),
    "law": ("table", *setup.LAWS),
    "engine": tuple(setup.ENGINES),
    "aids": ("off", "short", "full"),
    "colours": ("usual", "safe"),
}
"""What can be chosen; "table" is the cloth, and the laws, that a table comes with."""
SIDE = 200, 16384
"""Least and most pixels of a side of the window."""


@dataclass(slots=True)
class Settings:
    """The choices, each with its usual value.

    `volume` is 0 to 10, `still` reduced motion, `fan` the spread of a shot, `both` a log in two
    languages, `keys` the changed ones.
    """

    language: str = "en"
    table: str = "medium"
    cloth: str = "table"
    law: str = "table"
    engine: str = "exact"
    aids: str = "full"
    colours: str = "usual"
    volume: int = 8
    muted: bool = False
    still: bool = False
    both: bool = False
    fan: bool = False
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
        elsewhere = {"law", "cloth"} if {"table", "scene"} & options.given else set()
        if options.game != "free":
            elsewhere |= {"engine"}  # a match is exact unless the command line says otherwise
        free = {k: v for k, v in own.items() if k not in options.given | elsewhere}
        return replace(options, **free)  # type: ignore[arg-type]


def start() -> Settings:
    """The settings of somebody who has never chosen: Korean where the system is."""
    spoken = os.environ.get("LC_ALL") or os.environ.get("LANG") or locale.getlocale()[0] or ""
    return Settings(language="ko" if spoken.lower().startswith("ko") else "en")


def read(document: object) -> tuple[Settings, list[str]]:
    """Return the settings in a document, and the names of the values that could not be used.

    Those keep their defaults; what is not there does too; what nobody knows is passed over.
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
        good = kind is str and value in CHOICES[name]
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
    from . import keys  # which needs pygame: not to print --help

    return keys.sound(wanted)


def folder() -> Path:
    """The platform's folder for a user's settings."""
    from platformdirs import user_config_path

    return user_config_path("danggu", appauthor=False)


class Store:
    """The file in which the settings are kept."""

    def __init__(self, path: Path | None = None) -> None:
        self.path = path or folder() / "settings.json"
        self.faults: list[str] = []
        """The values that could not be used when the file was read."""
        self._text = ""

    def load(self) -> Settings:
        """Read the file.  A broken one is kept beside as .broken and replaced by a good one."""
        try:
            text = self.path.read_text(encoding="utf-8")
        except FileNotFoundError:
            return start()
        except (OSError, UnicodeDecodeError):
            text = ""
        try:
            document = json.loads(text)
        except (ValueError, RecursionError):
            document = None
        settings, self.faults = read(document)
        self._text = _text(settings)
        if self.faults:
            self._set_aside()
            self.save(settings, anyway=True)
        return settings

    def save(self, settings: Settings, *, anyway: bool = False) -> bool:
        """Write the file at once or not at all, if anything changed; returns whether it is good."""
        text = _text(settings)
        if text == self._text and not anyway:
            return True
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            files.write(self.path, text)
        except OSError:
            return False
        self._text = text
        return True

    def _set_aside(self) -> None:
        try:
            shutil.copyfile(self.path, self.path.with_name(self.path.name + ".broken"))
        except OSError:
            return  # a folder, or a file nobody may read: it stays as it is


def _text(settings: Settings) -> str:
    document = {"format": FORMAT, "version": VERSION, **asdict(settings)}
    return json.dumps(document, indent=1, ensure_ascii=False) + "\n"
