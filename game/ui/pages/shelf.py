"""The shelf: set-ups to choose by their pictures, to save by name, to copy and paste as a line."""

from __future__ import annotations

import unicodedata
from collections.abc import Hashable

import pygame

from game.input import editing
from game.practice.trainer import Trainer
from game.render.parts import text_line
from game.session.action import Action
from game.session.session import Session
from game.table import drill_lies, lineup, shared
from game.table.library import LONGEST_NAME, Library
from game.table.lineup import MARK, LineError, Lineup
from game.table.own_table import base
from game.text.text_field import TextField
from game.ui.sight import Sight
from game.window import clipboard

from . import shelf_view
from .shelf_view import BUTTONS, COLUMNS, GROUPS, Card, ShelfLook, ShelfSpot

STEPS = {
    pygame.K_LEFT: -1,
    pygame.K_RIGHT: 1,
    pygame.K_UP: -COLUMNS,
    pygame.K_DOWN: COLUMNS,
}
ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)
LONGEST = lineup.LONGEST_LINE


class ShelfPage:
    """Which group is on show, what is in focus, and the text in the box below.

    `focus` counts the cards, then comes the box, then the buttons.
    """

    def __init__(self, trainer: Trainer | None = None, library: Library | None = None) -> None:
        self.trainer, self.library = trainer, library or Library()
        self.group, self.focus = 0, 0
        self.over = ShelfSpot("")
        self._field = TextField("", LONGEST)
        self.said: tuple[str, str] = ("", "")
        """Key of the texts and a word in it: what came of the last action."""
        self._ready: list[lineup.Ready] = []
        self._session: Session | None = None

    @property
    def cards(self) -> list[Card]:
        """The set-ups of the group."""
        group = GROUPS[self.group]
        if group == "own":
            return [Card(name, True, found) for name, found in self.library.items.items()]
        self._ready = self._ready or list(lineup.shelf())
        return [self._card(ready) for ready in self._ready if ready.group == group]

    def _card(self, ready: lineup.Ready) -> Card:
        """A set-up that comes with the program; most of them are drills."""
        drill = f"{ready.group}.{ready.key}"
        if self.trainer is None or drill not in drill_lies.NAMES:
            return Card(f"position.{ready.key}", False, ready.lineup)
        stars = self.trainer.book.of(drill).stars
        return Card(f"position.{ready.key}", False, ready.lineup, drill, stars)

    @property
    def typing(self) -> bool:
        """Do characters go into the box?"""
        return self.focus == len(self.cards)

    @property
    def text(self) -> str:
        """What is in the box."""
        return self._field.text

    @text.setter
    def text(self, text: str) -> None:
        self._field = TextField(text[:LONGEST], LONGEST, anchor=len(text[:LONGEST]))

    @property
    def field(self) -> TextField | None:
        """The text in the box while it has the focus."""
        return self._field if self.typing else None

    def open(self, session: Session) -> None:
        """Begin with the group of the game that is played, and with the drill that is."""
        self._session = session
        if self.group == 0:
            self.group = self._usual(session)
        now = [card.drill for card in self.cards]
        drill = self.trainer.drill if self.trainer is not None else ""
        self.focus, self.said = now.index(drill) if drill in now else 0, ("", "")
        if self.library.faulty:
            self.said = "shelf.broken", ""

    @staticmethod
    def _usual(session: Session) -> int:
        """The group of the game that is played, or of the table."""
        own = base(session.table) if session.contest is None else session.contest.terms.game
        kind = getattr(session.world.table, "kind", "carom")
        if kind != "carom":
            return GROUPS.index(kind)
        return int(own in ("match", "three-cushion"))

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        line = sight.line(self._field)
        names = tuple((card.name, card.stars) for card in self.cards)
        return self.group, self.focus, self.over, line, self.said, names, sight.words["shelf.title"]

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the shelf; returns its rectangle."""
        look = ShelfLook(
            self.cards, self.group, self.focus, self.over, self.field, self.text, self.said
        )
        return shelf_view.draw(surface, sight, look)

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        self._session = sight.session
        if event.type == pygame.KEYDOWN:
            return self._key(event, sight)
        if event.type == pygame.TEXTINPUT and self.typing:
            self._type(event.text)
        elif event.type == pygame.MOUSEMOTION:
            self.over = shelf_view.spot_at(event.pos, sight, len(self.cards))
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    def _type(self, text: str) -> None:
        plain = unicodedata.normalize("NFC", text)
        fits = self._field.type("".join(c for c in plain if c.isprintable()))
        self.said = ("" if fits else "shelf.unfit", "")

    def _key(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        key, mod = event.key, getattr(event, "mod", 0)
        always = sight.preferences.keys.always.get(key)
        if key == pygame.K_ESCAPE:
            return Action("sheet", "")
        if always is not None:
            return always
        if self.typing and self._edit(event):
            return None
        if mod & pygame.KMOD_CTRL and key in (pygame.K_c, pygame.K_v):
            return self._do("copy" if key == pygame.K_c else "paste")
        if key == pygame.K_TAB:
            self._tab(bool(mod & pygame.KMOD_SHIFT))
        elif key in (pygame.K_PAGEUP, pygame.K_PAGEDOWN):
            self._show(self.group + (1 if key == pygame.K_PAGEDOWN else -1))
        elif key in STEPS:
            self._go(STEPS[key])
        elif key in ENTER:
            return self._enter()
        elif key == pygame.K_DELETE:
            return self._do("delete")
        return None

    def _edit(self, event: pygame.event.Event) -> bool:
        """Let a key edit the box, if it does; a whole set-up is still copied and pasted there."""
        action = editing.of_key(event)
        if action is None or (action.name == "copy" and not self._field.selected):
            return False
        if action.name == "paste" and clipboard.get().startswith(MARK):
            return False
        done = editing.with_clipboard(action, self._field)
        self.said = ("", "")
        if done is not None and done.name == "type":
            self._type(str(done.value))
        elif done is not None:
            editing.do(self._field, done)
        return True

    def _show(self, group: int) -> None:
        self.group, self.focus = group % len(GROUPS), 0
        broken = self.library.faulty and GROUPS[self.group] == "own"
        self.said = ("shelf.broken" if broken else "", "")

    def _tab(self, back: bool) -> None:
        """To the cards, the box, the first button, the next group."""
        count = len(self.cards)
        stops = [0, count, count + 1]
        place = sum(self.focus >= stop for stop in stops[1:]) + (-1 if back else 1)
        if 0 <= place < len(stops):
            self.focus = stops[place]
        else:
            self._show(self.group + (-1 if back else 1))

    def _go(self, step: int) -> None:
        count = len(self.cards)
        if self.focus < count:
            to = self.focus + step
            self.focus = min(max(to, 0), count)
        elif self.typing:
            self.focus = max(count - 1, 0) if step == -COLUMNS else count + (step == COLUMNS)
        else:
            place = self.focus - count - 1
            way = (step > 0) - (step < 0)
            self.focus = count + 1 + min(max(place + way, -1), len(BUTTONS) - 1)

    def _enter(self) -> Action | None:
        count = len(self.cards)
        if self.focus < count:
            return self._take(self.cards[self.focus])
        if self.typing:
            return self._do("paste" if self.text.startswith(MARK) else "save")
        return self._do(BUTTONS[self.focus - count - 1])

    def _take(self, card: Card) -> Action:
        if GROUPS[self.group] == "scenes":
            return Action("scene", card.lineup.table)
        if card.drill:
            return Action("drill", card.drill)
        return Action("line", card.lineup.line())

    def _press(self, at: tuple[int, int], sight: Sight) -> Action | None:
        self.over = spot = shelf_view.spot_at(at, sight, len(self.cards))
        match spot.kind:
            case "close" | "outside":
                return Action("sheet", "")
            case "tab":
                self._show(spot.place)
            case "card":
                self.focus = shelf_view.first_shown(self.focus, len(self.cards)) + spot.place
                return self._enter() if self.focus < len(self.cards) else None
            case "box":
                self._place_caret(at, sight)
            case "button":
                self.focus = len(self.cards) + 1 + spot.place
                return self._do(BUTTONS[spot.place])
        return None

    def _place_caret(self, at: tuple[int, int], sight: Sight) -> None:
        """Go to the box; in it, to a place in its text."""
        if self.typing:
            window, line = shelf_view.text_window(sight), sight.line(self._field)
            self._field.go(text_line.place_at(window, sight.type, line, shelf_view.SIZE, at[0]))
        self.focus = len(self.cards)

    def _do(self, name: str) -> Action | None:
        """What a button does."""
        assert self._session is not None
        match name:
            case "save":
                self._save(self._session)
            case "copy" | "shot":
                self.text = laid(self._session, shot=name == "shot").line()
                self.said = ("shelf.copied" if clipboard.put(self.text) else "shelf.written"), ""
            case "paste":
                return self._paste()
            case "delete":
                self._delete()
        return None

    def _save(self, session: Session) -> None:
        name = " ".join(self.text.split())
        if not name or name.startswith(MARK):
            self.focus, self.said = len(self.cards), ("shelf.unnamed", "")
        elif self.library.put(name, laid(session, shot=True)):
            self._show(GROUPS.index("own"))
            self.focus, self.text = len(self.cards) - 1, ""
            self.said = "shelf.saved", name[:LONGEST_NAME]
        else:
            self.said = "shelf.unsaved", name[:LONGEST_NAME]

    def _paste(self) -> Action | None:
        """Take the line in the box, or else the one in the clipboard; a broken one says why."""
        text = self.text if self.text.startswith(MARK) else clipboard.get() or self.text
        try:
            shot = text.startswith(shared.MARK)
            (shared if shot else lineup).read(text)
        except LineError as error:
            self.text, self.said = text, (f"line.{error.reason}", error.word)
            return None
        self.text, self.said = "", ("", "")
        return Action("open" if shot else "line", text)

    def _delete(self) -> None:
        cards = self.cards
        if self.focus < len(cards) and cards[self.focus].own:
            self.library.remove(cards[self.focus].name)
            self.said = "shelf.deleted", cards[self.focus].name
            self.focus = max(0, min(self.focus, len(cards) - 2))
        else:
            self.said = "shelf.kept", ""


def laid(session: Session, *, shot: bool) -> Lineup:
    """How the balls lie, with the numbers in the boxes if they are asked for and are a shot."""
    texts = session.aim.texts if shot and session.aim.shot else ()
    return lineup.of(session.world, session.table, texts)
