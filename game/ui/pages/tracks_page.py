"""The page "my table": a file of tracks is fitted, and what is found becomes a table to play on."""

from __future__ import annotations

import unicodedata
from collections.abc import Hashable
from pathlib import Path

import pygame

from game.computer.worker import Worker
from game.input import editing
from game.render.parts import text_line
from game.session.action import Action
from game.session.session import Session
from game.settings import own_table_file
from game.settings.own_table_file import OwnTableFile
from game.table import own_table, presets
from game.table.table_fit import FitReport, fitted
from game.text.text_field import TextField
from game.ui.sight import Sight

from . import tracks_view
from .tracks_view import FILES, TracksLook, TracksSpot

LONGEST = 1000
"""Characters of a path."""
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)
STEPS = {pygame.K_UP: -1, pygame.K_DOWN: 1}
BASES = {pygame.K_PAGEUP: -1, pygame.K_PAGEDOWN: 1}


class TracksPage:
    """The path of a file, the table to begin with, and what has come of it.

    trouble  why nothing has come of it, in the words of what failed; or ""
    said     key of the texts: what was done last
    """

    typing = True

    def __init__(self, file: OwnTableFile | None = None) -> None:
        self.file = file or OwnTableFile()
        self.field = TextField("", LONGEST)
        self.base, self.first = 0, 0
        self.over = TracksSpot("")
        self.said = self.trouble = ""
        self.key = ""
        """Of a table that has been found and not been saved."""
        self.report: FitReport | None = None
        self.looking_for: tuple[int, tuple[str, ...]] | None = None
        """While it is fitted: how many tracks, and what for."""
        self.seconds = 0.0
        self.files: list[Path] = []
        self._worker: Worker | None = None

    @property
    def running(self) -> bool:
        """Is a table being fitted?"""
        return self._worker is not None

    @property
    def bases(self) -> list[str]:
        """The tables to begin with."""
        return [*presets.TABLES]

    def open(self, session: Session) -> None:
        """Begin with the table that is played on."""
        self.files, self.said = self.file.tracks, ""
        name = own_table.base(session.table)
        if not self.running and self.report is None and name in self.bases:
            self.base = self.bases.index(name)
        if not self.file.key and self.file.fault:
            self.trouble, self.said = self.file.fault, "tracks.broken"

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        return self._look(sight)

    def _look(self, sight: Sight) -> TracksLook:
        names = tuple(path.name for path in self.files)
        line = sight.line(self.field)
        own = self.file.key if not self.trouble else ""
        return TracksLook(
            names, self.first, line, self.bases[self.base], self.primary, self.over, self.report,
            self.looking_for, int(self.seconds), self.running, self.said, self.trouble,
            bool(own), self.key, self.file.tracks_folder, sight.session.language,
        )  # fmt: skip

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the page; returns its rectangle."""
        return tracks_view.draw(surface, sight, self._look(sight))

    @property
    def primary(self) -> str:
        """What RETURN does: "fit" "stop" "save" or "play"."""
        if self.running:
            return "stop"
        if self.key:
            return "save"
        return "play" if self.said == "tracks.saved" else "fit"

    # -- what is done --------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._key(event, sight)
        if event.type == pygame.TEXTINPUT:
            self._type(event.text)
        elif event.type == pygame.MOUSEMOTION:
            self.over = tracks_view.spot_at(event.pos, sight)
        elif event.type == pygame.MOUSEWHEEL:
            self._scroll(-event.y)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    def _key(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        always = sight.preferences.keys.always.get(event.key)
        if event.key == pygame.K_ESCAPE:
            return self.do("stop" if self.running else "close")
        if always is not None:
            return always
        if event.key in ENTER:
            return self.do(self.primary)
        if self.running:
            return None
        if event.key in BASES:
            self._step(BASES[event.key])
        elif event.key in STEPS:
            self._choose(STEPS[event.key])
        else:
            self._edit(event)
        return None

    def _edit(self, event: pygame.event.Event) -> None:
        done = editing.with_clipboard(editing.of_key(event), self.field)
        if done is not None and done.name == "type":
            self._type(str(done.value))
        elif done is not None and editing.do(self.field, done):
            self._changed()

    def _type(self, text: str) -> None:
        if self.running:
            return
        plain = unicodedata.normalize("NFC", text)
        fits = self.field.type("".join(c for c in plain if c.isprintable()))
        self._changed()
        self.said = "" if fits else "tracks.unfit"

    def _changed(self) -> None:
        """There is another file, or another table to begin with: what was found is not of it."""
        if not self.running:
            self.report, self.said, self.trouble, self.key = None, "", "", ""

    def _step(self, step: int) -> None:
        if not self.running:
            self.base = (self.base + step) % len(self.bases)
            self._changed()

    def _choose(self, step: int) -> None:
        """Take the next file of the folder."""
        names = [str(path) for path in self.files]
        if names:
            now = names.index(self.field.text) if self.field.text in names else -(step > 0)
            self._take((now + step) % len(names))

    def _take(self, place: int) -> None:
        if place < len(self.files) and not self.running:
            path = str(self.files[place])
            self.field = TextField(path, LONGEST, anchor=len(path))
            self.first = min(max(self.first, place - FILES + 1), place)
            self._changed()

    def _scroll(self, rows: int) -> None:
        self.first = min(max(self.first + rows, 0), max(len(self.files) - FILES, 0))

    def _press(self, at: tuple[int, int], sight: Sight) -> Action | None:
        self.over = spot = tracks_view.spot_at(at, sight)
        match spot.kind:
            case "file":
                self._take(self.first + spot.place)
            case "box":
                window, line = tracks_view.text_window(sight), sight.line(self.field)
                size = tracks_view.SIZE
                self.field.go(text_line.place_at(window, sight.type, line, size, at[0]))
            case "base":
                self._step(1)
            case "outside" | "close":
                return self.do("close")
            case "fit" if self.running:
                return self.do("stop")
            case _:
                return self.do(spot.kind)
        return None

    def do(self, name: str) -> Action | None:
        """What a button does: "fit" "stop" "save" "play" "close", or nothing."""
        match name:
            case "fit":
                self._fit(self.field.text.strip().strip("'\""))
            case "stop":
                self.stop()
                self.said = "tracks.stopped"
            case "save" if self.key:
                self._save()
            case "play" if self.file.key:
                return Action("table", self.file.key)
            case "close":
                return Action("sheet", "")
        return None

    def _fit(self, path: str) -> None:
        self._changed()
        if not path:
            self.said = "tracks.none"
        elif path.lower().endswith(".json"):
            self._load(Path(path).expanduser())
        else:
            self.looking_for, self.seconds = None, 0.0
            where = str(Path(path).expanduser())
            self._worker = Worker(fitted, where, self.bases[self.base])

    def _load(self, path: Path) -> None:
        """Take a table from a file that `python -m physics fit --preset` has written."""
        try:
            self.key = own_table_file.read(path)
        except (ValueError, OSError) as error:
            self.trouble, self.said = str(error), "tracks.failed"
        else:
            self.base, self.said = self.bases.index(own_table.base(self.key)), "tracks.loaded"

    def _save(self) -> None:
        self.trouble = self.file.save(self.key)
        self.said = "tracks.unsaved" if self.trouble else "tracks.saved"
        self.key = self.key if self.trouble else ""

    def stop(self) -> None:
        """End the fit, if there is one."""
        if self._worker is not None:
            self._worker.cancel()
        self._worker = self.looking_for = None

    def think(self, seconds: float) -> bool:
        """See how far the fit is; returns whether anything has changed on the page."""
        before = int(self.seconds)
        self.seconds += seconds
        news = self._worker.look() if self._worker is not None else None
        if news is None:
            return int(self.seconds) != before
        if news.kind == "told":
            self.looking_for = news.value
            return True
        self._worker = self.looking_for = None
        if news.kind == "done":
            self.report, self.key, self.said = news.value, news.value.key, "tracks.fitted"
        else:
            self.trouble, self.said = str(news.value), "tracks.failed"
        return True
