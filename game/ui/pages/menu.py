"""The game menu: what to play, with whom and on what; keys and mouse do the same."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import replace
from random import randrange

import pygame

from game.input import editing
from game.input.key_tables import character
from game.render.parts import text_line
from game.session import saved
from game.session.action import Action
from game.session.session import Session
from game.session.terms import FREE, LONGEST_NAME, MOST_POINTS, Terms
from game.table import presets
from game.text.text_field import TextField
from game.ui.sight import Sight

from . import menu_tiles, menu_view
from .menu_rows import MenuRow, accepted, rows, stepped, text_of, written
from .menu_view import BUTTONS, CLOSE, NOTHING, OUTSIDE, MenuLook, MenuSpot

STEPS = {pygame.K_UP: -1, pygame.K_DOWN: 1}
CHANGES = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_PAGEDOWN: -10, pygame.K_PAGEUP: 10}
OTHERS = {pygame.K_PAGEDOWN: 1, pygame.K_PAGEUP: -1}
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)


class MenuPage:
    """Focus, and the terms that are being put together."""

    def __init__(self) -> None:
        self.terms = Terms()
        self.focus = 0
        self.over: MenuSpot = NOTHING
        self.field: TextField | None = None
        """The text of the row in focus, if it is one that is typed into."""
        self.touched = False
        """Has the text been edited since?  Until then arrows count a number up and down."""
        self.refused = ""
        """Why the last characters did not go into the row: "digits" or "full"."""
        self.offers: Callable[[], tuple[str, ...]] = tuple
        """Asks for the lines of the matches that can be gone on with, the newest first."""
        self.own: Callable[[], str] = str
        """Asks for the key of the player's own table, "" if there is none."""
        self._offered: tuple[str, ...] = ()
        self._which = 0
        """The one of them that is on offer."""
        self._left: MenuRow | None = None
        """The row of text that was left last: a syllable may come only then."""

    def open(self, session: Session) -> None:
        """Begin with what is being played."""
        begun = session.contest.terms if session.contest else self._free(session)
        self.terms = replace(begun, engine=session.match_engine)
        self._left, self._offered, self._which = None, self.offers(), 0
        self._focus(0)

    def offer(self) -> None:
        """Begin with the match that can be gone on with."""
        if self._offered:
            self._focus(len(self.rows) + BUTTONS.index("resume"))

    def _free(self, session: Session) -> Terms:
        table = session.table if session.table in presets.TABLES else "medium"
        return replace(self.terms, game=FREE, table=table, cloth="table", law="table")

    @property
    def rows(self) -> list[MenuRow]:
        """The rows of these terms."""
        return rows(self.terms)

    @property
    def row(self) -> MenuRow | None:
        """The row in focus, or None on a button."""
        return self.rows[self.focus] if self.focus < len(self.rows) else None

    @property
    def typing(self) -> bool:
        """Do characters go into the row in focus?"""
        return self.row is not None and self.row.kind == "text"

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        line = None if self.field is None else sight.line(self.field)
        own = self.terms, self.focus, self.over, line, self.refused, self._which
        return *own, sight.words["menu.title"]

    @property
    def _look(self) -> MenuLook:
        return MenuLook(
            self.terms, self.rows, self.focus, self.over, self.field, self.touched, self.refused,
            tuple(saved.read(text).terms for text in self._offered), self._which,
        )  # fmt: skip

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the menu; returns its rectangle."""
        return menu_view.draw(surface, sight, self._look)

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._key(event, sight)
        if event.type == pygame.TEXTINPUT:
            self._type(event.text)
        elif event.type == pygame.MOUSEMOTION:
            self.over = menu_view.spot_at(event.pos, sight, self.rows, len(self._offered))
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    def _key(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        key, self._left, self.refused = event.key, None, ""
        always = sight.preferences.keys.always.get(key)
        if key == pygame.K_ESCAPE:
            return Action("sheet", "")
        if always is not None:
            return always
        if key in STEPS or key == pygame.K_TAB:
            back = getattr(event, "mod", 0) & pygame.KMOD_SHIFT
            self._go(STEPS.get(key, -1 if back else 1))
        elif self.row is None:
            return self._button_key(key)
        elif key in ENTER:
            self._go(1)
        elif not self._edit(event, self.row):
            self._step(event, self.row)
        return None

    def _edit(self, event: pygame.event.Event, row: MenuRow) -> bool:
        """Let a key edit the row, if it does."""
        counts = row.kind == "number" and not self.touched
        if self.field is None or (counts and event.key in CHANGES):
            return False
        meant = editing.of_key(event)
        action = editing.with_clipboard(meant, self.field)
        if action is not None and action.name == "type":
            self._type(str(action.value))
        elif action is not None:
            editing.do(self.field, action)
            self.touched = True
            self._write(row)
        return meant is not None

    def _step(self, event: pygame.event.Event, row: MenuRow) -> None:
        if event.key in CHANGES:
            self.terms = stepped(self.terms, row, CHANGES[event.key], self.own())
            self._focus(self.focus)
        elif row.kind == "number" and not getattr(event, "mod", 0) & editing.COMMAND:
            char = character(event) or (chr(event.key) if 32 <= event.key < 127 else "")
            if char:
                self._type(char)

    def _button_key(self, key: int) -> Action | None:
        place = self.focus - len(self.rows)
        if place == len(BUTTONS):
            self._tile_key(key)
        elif key in OTHERS and BUTTONS[place] == "resume":
            self._offer_another(OTHERS[key])
        elif key in CHANGES:
            way = 1 if CHANGES[key] > 0 else -1
            self.focus = len(self.rows) + (place + way) % len(BUTTONS)
        elif key in ENTER or key == pygame.K_SPACE:
            return self._do(BUTTONS[place])
        return None

    def _offer_another(self, way: int) -> None:
        self._which = (self._which + way) % max(len(self._offered), 1)

    def _tile_key(self, key: int) -> None:
        if key in CHANGES:
            self._choose(menu_tiles.stepped(self.terms, 1 if CHANGES[key] > 0 else -1))
        elif key in ENTER:
            self._go(1)

    def _choose(self, terms: Terms) -> None:
        """Play another family of games; the tiles stay in focus, for there are other rows now."""
        self.terms = terms
        self._focus(len(self.rows) + len(BUTTONS))

    def _go(self, step: int) -> None:
        self._left = self.row if self.typing else None
        self._focus((self.focus + step) % (len(self.rows) + len(BUTTONS) + 1))

    def _focus(self, place: int) -> None:
        """Go to a row, or to a button; all of its text is selected."""
        self.focus, row = place, self.rows[place] if place < len(self.rows) else None
        self.field, self.touched = None, False
        if row is not None and row.kind != "choice":
            longest = LONGEST_NAME if row.kind == "text" else len(str(MOST_POINTS))
            self.field = TextField(text_of(self.terms, row), longest)

    def _type(self, text: str) -> None:
        row = self.row
        if self.field is None or row is None:
            self._late(text)
            return
        taken = accepted(row, text)
        self.refused = "digits" if row.kind == "number" and text.strip() and not taken else ""
        if taken and not self.field.type(taken):
            self.refused = "full"
        self.touched = True
        self._write(row)

    def _late(self, text: str) -> None:
        """A syllable has come after the key that ended it, and with that its row."""
        if self._left is not None:
            name = text_of(self.terms, self._left) + accepted(self._left, text)
            self.terms = written(self.terms, self._left, name[:LONGEST_NAME])

    def _write(self, row: MenuRow) -> None:
        """Bring what has been typed into the terms; a number too large is made the largest."""
        if self.field is None:
            return
        text = self.field.text
        self.terms = written(self.terms, row, text)
        if row.kind == "number" and int(text or 1) > MOST_POINTS:
            most = text_of(self.terms, row)
            self.field, self.refused = TextField(most, len(most), anchor=len(most)), "full"

    def _press(self, at: tuple[int, int], sight: Sight) -> Action | None:
        self.over = spot = menu_view.spot_at(at, sight, self.rows, len(self._offered))
        if spot in (CLOSE, OUTSIDE):
            return Action("sheet", "")
        if spot == NOTHING:
            return None
        self._left = None
        if spot.other:
            self._choose(menu_tiles.chosen(self.terms, spot.other))
            return None
        self._place_caret(spot.place, at, sight)
        row = self.row
        if row is None and spot.step:
            self._offer_another(spot.step)
            return None
        if row is None:
            return self._do(BUTTONS[spot.place - len(self.rows)])
        if spot.step:
            self.terms = stepped(self.terms, row, spot.step, self.own())
            self._focus(self.focus)
        return None

    def _place_caret(self, place: int, at: tuple[int, int], sight: Sight) -> None:
        """Go to a row; in the row of text in focus, to a place in it."""
        if place != self.focus or not self.typing or self.field is None:
            self._focus(place)
            return
        rect = menu_view.row_rect(self.rows, place, sight.layout)
        window, line = menu_view.text_window(rect, sight), sight.line(self.field)
        to = text_line.place_at(window, sight.type, line, menu_view.SIZE, at[0], "centre")
        self.field.go(to)

    def _do(self, name: str) -> Action | None:
        match name:
            case "start":
                return Action("match", _with_a_rack_of_its_own(self.terms).line())
            case "resume":
                return Action("resume", self._offered[self._which]) if self._offered else None
            case "quit" | "help" | "settings":
                return Action(name)
            case _:
                return Action("sheet", name)


def _with_a_rack_of_its_own(terms: Terms) -> Terms:
    """The terms with a seed that no match before had: what is recorded is the seed."""
    racked = terms.game != FREE and not terms.discipline.position
    return replace(terms, seed=randrange(1 << 32)) if racked else terms
