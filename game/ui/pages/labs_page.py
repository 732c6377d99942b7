"""The page of labs: choose one, open its scene, type answers, and see them checked."""

from __future__ import annotations

import unicodedata
from collections.abc import Hashable
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING

import pygame

import danggu
from game.input import editing
from game.render.parts import text_line
from game.session.action import Action
from game.session.session import Session
from game.settings import user_files
from game.table.lab_scenes import key_of
from game.table.library import folder as data_folder
from game.text.text_field import TextField
from game.ui.sight import Sight

from . import labs_view
from .labs_view import LabsLook, LabsSpot

if TYPE_CHECKING:
    from danggu.labs import Worksheet

LONGEST = 12
"""Characters of an answer."""
HIGHEST = 9999
"""Seed."""
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)
UP_DOWN = {pygame.K_UP: -1, pygame.K_DOWN: 1}
SEEDS = {pygame.K_PAGEUP: 1, pygame.K_PAGEDOWN: -1}
SHEETS = "labs"
"""The folder, in that of the user's own things, for pages to print."""


@lru_cache(maxsize=64)
def worksheet(name: str, seed: int | None) -> Worksheet:
    """The worksheet, played once at most."""
    return danggu.labs.lab(name, seed)  # which are loaded when the page is first opened


class LabsPage:
    """Which lab is on show with which numbers, and what has been typed.

    place   of the lab in the list
    seed    0: the usual numbers
    focus   the field that is typed into, from 0; -1: the list
    said    key of the texts and a word in it: what came of the last action
    folder  for pages to print, None where there is no place for any
    """

    def __init__(self, folder: Path | None = None) -> None:
        self.place = self.seed = 0
        self.focus = -1
        self.over = LabsSpot("")
        self.said: tuple[str, str] = ("", "")
        self.folder = folder
        self._typed: dict[tuple[str, int], list[TextField]] = {}
        self._ways: dict[tuple[str, int], dict[str, int]] = {}
        """Of each answer that has been checked: 0 right, +1 too large, -1 too small."""

    @property
    def names(self) -> list[str]:
        """Of the labs, in the order of the list."""
        return [*danggu.labs.LABS]

    @property
    def sheet(self) -> Worksheet:
        """The worksheet on show."""
        return worksheet(self.names[self.place], self.seed or None)

    @property
    def _key(self) -> tuple[str, int]:
        return self.names[self.place], self.seed

    @property
    def fields(self) -> list[TextField]:
        """The answers that have been typed."""
        blank = [TextField("", LONGEST) for _ in self.sheet.fields]
        return self._typed.setdefault(self._key, blank)

    @property
    def typing(self) -> bool:
        """Do characters go into a field?"""
        return self.focus >= 0

    @property
    def field(self) -> TextField | None:
        """The one that is typed into."""
        return self.fields[self.focus] if self.typing else None

    def open(self, session: Session) -> None:
        """Begin with what was on show."""
        self.said = "", ""

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        return self._look(sight)

    def _look(self, sight: Sight) -> LabsLook:
        lines = tuple(
            sight.line(field) if k == self.focus else labs_view.plain(field.text)
            for k, field in enumerate(self.fields)
        )
        ways = self._ways.get(self._key, {})
        known = tuple(ways.get(field.name) for field in self.sheet.fields)
        return LabsLook(
            self.place, self.seed, self.focus, lines, known, self.over, self.said,
            sight.session.language,
        )  # fmt: skip

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the page; returns its rectangle."""
        return labs_view.draw(surface, sight, self._look(sight), self.names, self.sheet)

    # -- what is done --------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._press_key(event, sight)
        if event.type == pygame.TEXTINPUT and self.typing:
            self._type(event.text)
        elif event.type == pygame.MOUSEMOTION:
            self.over = labs_view.spot_at(event.pos, sight, len(self.names), self.sheet)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    def _press_key(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        always = sight.preferences.keys.always.get(event.key)
        if event.key == pygame.K_ESCAPE:
            return Action("sheet", "")
        if always is not None:
            return always
        if event.key == pygame.K_TAB:
            back = getattr(event, "mod", 0) & pygame.KMOD_SHIFT
            self._focus(self.focus + (-1 if back else 1))
        elif event.key in SEEDS:
            self._number(self.seed + SEEDS[event.key])
        elif event.key in UP_DOWN:
            self._step(UP_DOWN[event.key])
        elif event.key in ENTER:
            return self._enter(sight)
        elif self.typing:
            self._edit(event)
        elif event.key == pygame.K_p:
            return self.do("print", sight)
        return None

    def _step(self, way: int) -> None:
        if self.typing:
            self._focus(self.focus + way)
        else:
            self._choose(min(max(self.place + way, 0), len(self.names) - 1))

    def _focus(self, to: int) -> None:
        """Go to a field, or beyond them to the list."""
        self.focus = (to + 1) % (len(self.sheet.fields) + 1) - 1

    def _choose(self, place: int) -> None:
        self.place, self.focus, self.said = place, -1, ("", "")

    def _number(self, seed: int) -> None:
        self.seed, self.said = min(max(seed, 0), HIGHEST), ("", "")

    def _enter(self, sight: Sight) -> Action | None:
        if not self.typing:
            return self.do("open", sight)
        self._check()
        self._focus(self.focus + 1)
        return None

    def _edit(self, event: pygame.event.Event) -> None:
        field = self.fields[self.focus]
        done = editing.with_clipboard(editing.of_key(event), field)
        if done is not None and done.name == "type":
            self._type(str(done.value))
        elif done is not None and editing.do(field, done):
            self._forget()

    def _type(self, text: str) -> None:
        plain = unicodedata.normalize("NFKC", text)
        self.fields[self.focus].type("".join(c for c in plain if c.isprintable()))
        self._forget()

    def _forget(self) -> None:
        """The answer has changed: what was said of it is no longer so."""
        self._ways.get(self._key, {}).pop(self.sheet.fields[self.focus].name, None)
        self.said = "", ""

    def _check(self) -> None:
        """Check all that has been typed."""
        given = {
            field.name: typed.text
            for field, typed in zip(self.sheet.fields, self.fields, strict=True)
            if typed.text.strip()
        }
        found: dict[str, int] = {}
        for name, answer in given.items():
            try:
                found[name] = self.sheet.check({name: answer})[name].way
            except ValueError:
                self._ways[self._key] = found
                self.said = "labs.unread", answer
                return
        self._ways[self._key] = found
        right = sum(way == 0 for way in found.values())
        self.said = "labs.checked" if found else "labs.unanswered", f"{right} {len(found)}"

    def _press(self, at: tuple[int, int], sight: Sight) -> Action | None:
        self.over = spot = labs_view.spot_at(at, sight, len(self.names), self.sheet)
        match spot.kind:
            case "close" | "outside":
                return Action("sheet", "")
            case "lab":
                self._choose(spot.place)
            case "field":
                if spot.place == self.focus:
                    window = labs_view.text_window(sight, spot.place, len(self.fields))
                    line, size = sight.line(self.fields[self.focus]), labs_view.SIZE
                    to = text_line.place_at(window, sight.type, line, size, at[0])
                    self.fields[self.focus].go(to)
                self.focus = spot.place
            case _:
                return self.do(spot.kind, sight)
        return None

    def do(self, name: str, sight: Sight) -> Action | None:
        """What a button does: "open" "check" "print" "fewer" "more", or nothing."""
        match name:
            case "open":
                return Action("scene", key_of(self.names[self.place], self.seed or None))
            case "check":
                self._check()
            case "print":
                self._print(sight.session.language)
            case "fewer" | "more":
                self._number(self.seed + (1 if name == "more" else -1))
        return None

    def _print(self, language: str) -> None:
        """Write the page to print into the user's folder, and say where it is."""
        home = self.folder or data_folder()
        number = f"-{self.seed}" if self.seed else ""
        name = f"{self.names[self.place]}{number}.{language}.html"
        try:
            if home is None:
                raise OSError("there is no home folder")
            path = home / SHEETS / name
            path.parent.mkdir(parents=True, exist_ok=True)
            user_files.write(path, danggu.labs.page(self.sheet, language))
        except OSError as error:
            self.said = "labs.unprinted", error.strerror or str(error)
        else:
            self.said = "labs.printed", str(path)
