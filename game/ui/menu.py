"""The game menu: what to play, with whom and on what; keys and mouse do the same."""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import replace
from typing import Any, NamedTuple

import pygame

from game import setup
from game.actions import Action
from game.fixture import (
    BANKS,
    FOUR_BALL,
    FREE,
    GAMES,
    LONGEST_NAME,
    MOST_POINTS,
    PENALTIES,
    SEATS,
    SKILLS,
    TABLES,
    Fixture,
    Seat,
)
from game.match.sagu import FINISHES
from game.play import Game

from . import menuview
from .menuview import BUTTONS, CLOSE, NOTHING, OUTSIDE, Spot
from .parts import Sight

STEPS = {pygame.K_UP: -1, pygame.K_DOWN: 1}
TURNS = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_PAGEDOWN: -10, pygame.K_PAGEUP: 10}
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)


class Row(NamedTuple):
    """A row: its name, "choice" "text" or "number", and the player it is about (-1: nobody)."""

    name: str
    kind: str = "choice"
    seat: int = -1


CHOICES: dict[str, tuple[Any, ...]] = {
    "game": GAMES,
    "finish": FINISHES,
    "penalty": PENALTIES,
    "floor": (True, False),
    "bank": BANKS,
    "red_first": (True, False),
    "table": tuple(setup.TABLES),
    "cloth": tuple(setup.CLOTHS),
    "law": ("table", *setup.LAWS),
}


def rows(fixture: Fixture) -> list[Row]:
    """The rows that a fixture has: the game's at the left, the players' at the right."""
    own = {FREE: [], FOUR_BALL: ["finish", "penalty", "floor"]}
    names = ["game", *own.get(fixture.game, ["bank", "red_first"]), "table", "cloth", "law"]
    left = [Row(name) for name in names]
    if fixture.game == FREE:
        return left
    right = [Row("players")]
    for seat in range(len(fixture.seats)):
        right += [Row("name", "text", seat), Row("level", "choice", seat)]
        right += [Row("target", "number", seat)]
    return left + right


def turned(fixture: Fixture, row: Row, step: int) -> Fixture:
    """The fixture with a row `step` choices on."""
    if row.name == "players":
        two = (*fixture.seats, Seat())[:2]
        return replace(fixture, seats=two if len(fixture.seats) == 1 else two[:1])
    if row.seat >= 0:
        return _seated(fixture, row, _turned_seat(fixture.seats[row.seat], row, step))
    keys = CHOICES[row.name]
    way = (step > 0) - (step < 0)
    value = keys[(keys.index(getattr(fixture, row.name)) + way) % len(keys)]
    changed = replace(fixture, **{row.name: value})
    if row.name == "game":
        changed = replace(changed, table=TABLES[value], cloth="table", law="table")
    return changed


def _seated(fixture: Fixture, row: Row, seat: Seat) -> Fixture:
    seats = list(fixture.seats)
    seats[row.seat] = seat
    return replace(fixture, seats=tuple(seats))


def _turned_seat(seat: Seat, row: Row, step: int) -> Seat:
    if row.name == "level":
        way = (step > 0) - (step < 0)
        return replace(seat, level=SEATS[(SEATS.index(seat.level) + way) % len(SEATS)])
    if row.name == "target":
        return replace(seat, target=min(max(seat.target + step, 1), MOST_POINTS))
    return seat


def typed(fixture: Fixture, row: Row, text: str, fresh: bool) -> Fixture:
    """The fixture with characters added to a name or a number; the first ones replace it."""
    seat = fixture.seats[row.seat]
    if row.name == "name":
        kept = "" if fresh else seat.name
        clean = "".join(c for c in text if c.isprintable())
        return _seated(fixture, row, replace(seat, name=(kept + clean)[:LONGEST_NAME].lstrip()))
    digits = "".join(c for c in text if c in "0123456789")
    number = int(("" if fresh else str(seat.target)) + digits) if digits else seat.target
    return _seated(fixture, row, replace(seat, target=min(max(number, 1), MOST_POINTS)))


def erased(fixture: Fixture, row: Row) -> Fixture:
    """The fixture with the last character of a name or a number gone."""
    seat = fixture.seats[row.seat]
    if row.name == "name":
        return _seated(fixture, row, replace(seat, name=seat.name[:-1]))
    return _seated(fixture, row, replace(seat, target=max(seat.target // 10, 1)))


class Menu:
    """Focus, and the fixture that is being put together."""

    def __init__(self) -> None:
        self.fixture = Fixture()
        self.focus = 0
        self.over: Spot = NOTHING
        self._fresh = True
        """Will the next character replace what is in the row?"""

    def open(self, game: Game) -> None:
        """Begin with what is being played."""
        begun = game.contest.fixture if game.contest else self._free(game)
        self.fixture = replace(begun, engine=game.match_engine)
        self.focus, self._fresh = 0, True

    def _free(self, game: Game) -> Fixture:
        table = game.table if game.table in setup.TABLES else "medium"
        return replace(self.fixture, game=FREE, table=table, cloth="table", law="table")

    @property
    def rows(self) -> list[Row]:
        """The rows of this fixture."""
        return rows(self.fixture)

    @property
    def row(self) -> Row | None:
        """The row in focus, or None on a button."""
        return self.rows[self.focus] if self.focus < len(self.rows) else None

    @property
    def typing(self) -> bool:
        """Do characters go into the row in focus?"""
        return self.row is not None and self.row.kind == "text"

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        return self.fixture, self.focus, self.over, self._fresh, sight.game.language

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the menu; returns its rectangle."""
        caret = not self._fresh
        return menuview.draw(surface, sight, self.fixture, self.rows, self.focus, self.over, caret)

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._key(event, sight)
        if event.type == pygame.TEXTINPUT:
            self._type(event.text)
        elif event.type == pygame.MOUSEMOTION:
            self.over = menuview.spot_at(event.pos, sight, self.rows)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    def _key(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        key, row = event.key, self.row
        always = sight.preferences.keys.always.get(key)
        if key == pygame.K_ESCAPE or always == Action("sheet", "menu"):
            return Action("sheet", "")
        if always is not None and always.name in ("language", "help"):
            return always
        if key in STEPS or key == pygame.K_TAB:
            back = getattr(event, "mod", 0) & pygame.KMOD_SHIFT
            self._go(STEPS.get(key, -1 if back else 1))
        elif row is None:
            return self._button_key(key)
        elif key in ENTER:
            self._go(1)
        elif key == pygame.K_BACKSPACE and row.kind != "choice":
            self.fixture, self._fresh = erased(self.fixture, row), False
        elif key in TURNS:
            self.fixture, self._fresh = turned(self.fixture, row, TURNS[key]), True
        elif row.kind == "number":
            self._type(chr(key) if key < 128 else "")
        return None

    def _button_key(self, key: int) -> Action | None:
        place = self.focus - len(self.rows)
        if key in TURNS:
            way = 1 if TURNS[key] > 0 else -1
            self.focus = len(self.rows) + (place + way) % len(BUTTONS)
        elif key in ENTER or key == pygame.K_SPACE:
            return self._do(BUTTONS[place])
        return None

    def _go(self, step: int) -> None:
        self.focus = (self.focus + step) % (len(self.rows) + len(BUTTONS))
        self._fresh = True

    def _type(self, text: str) -> None:
        row = self.row
        if row is not None and row.kind != "choice" and text:
            self.fixture = typed(self.fixture, row, text, self._fresh)
            self._fresh = False

    def _press(self, at: tuple[int, int], sight: Sight) -> Action | None:
        self.over = spot = menuview.spot_at(at, sight, self.rows)
        if spot in (CLOSE, OUTSIDE):
            return Action("sheet", "")
        if spot == NOTHING:
            return None
        self.focus, self._fresh = spot.place, True
        row = self.row
        if row is None:
            return self._do(BUTTONS[spot.place - len(self.rows)])
        if spot.step:
            self.fixture = turned(self.fixture, row, spot.step)
        return None

    def _do(self, name: str) -> Action:
        match name:
            case "start":
                return Action("match", self.fixture.line())
            case "quit" | "help" | "settings":
                return Action(name)
            case _:
                return Action("sheet", name)


def level_words(level: str, w: dict[str, str]) -> str:
    """Say how much a level errs; "" for a person."""
    skill = SKILLS.get(level)
    if skill is None:
        return ""
    numbers = {"angle": f"{skill.angle:g}", "speed": f"{100 * skill.speed:g}"}
    return w["level.error"].format(**numbers, tip=f"{skill.tip:g}")
