"""The page of kept shots: to save one under a name, to open one, and to give one to someone."""

from __future__ import annotations

import unicodedata
from collections.abc import Hashable

import pygame

from game.input import editing
from game.input.editing import COMMAND
from game.render.parts import text_line
from game.replay.last_stroke import LastStroke
from game.session.action import Action
from game.session.session import Session
from game.settings.shot_folder import LONGEST, KeptShot, ShotFolder
from game.table import lineup, shared
from game.table.lineup import LineError
from game.table.shared import SharedShot
from game.text.text_field import TextField
from game.ui.sight import Sight
from game.window import clipboard

from . import shelf_view, shots_view
from .shots_view import BUTTONS, ShotsLook, ShotsSpot

ENTER = (pygame.K_RETURN, pygame.K_KP_ENTER)
STEPS = {
    pygame.K_UP: -1, pygame.K_DOWN: 1, pygame.K_PAGEUP: -8, pygame.K_PAGEDOWN: 8,
    pygame.K_HOME: -9999, pygame.K_END: 9999,
}  # fmt: skip
CLOSE = Action("sheet", "")


class ShotsPage:
    """The shots of the folder, which of them is chosen, and the name of one to be saved.

    typing  do characters go into the name?
    said    key of the texts and a word in it: what came of the last action
    """

    def __init__(self, last: LastStroke, folder: ShotFolder, *, saving: bool) -> None:
        self.last, self.folder, self.saving = last, folder, saving
        self.typing = saving
        self.shots: list[KeptShot] = []
        self.chosen = self.first = 0
        self.over = ShotsSpot("")
        self.said: tuple[str, str] = ("", "")
        self._field = TextField("", LONGEST)

    @property
    def field(self) -> TextField | None:
        """The name while it is edited."""
        return self._field if self.typing else None

    def open(self, session: Session) -> None:
        """Read the folder; to save one, a name that is free is already written."""
        self.shots = self.folder.shots()
        self.typing, self.said = self.saving or not self.shots, ("", "")
        self.chosen = self.first = 0
        taken = {shot.name.casefold() for shot in self.shots}
        numbers = range(1, len(taken) + 2)
        free = next(f"{session.table} {n}" for n in numbers if f"{session.table} {n}" not in taken)
        self._field = TextField(free.partition("+")[0][:LONGEST], LONGEST)

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        return self._look(sight)

    def _look(self, sight: Sight) -> ShotsLook:
        line = sight.line(self._field)
        kind = "replay" if self.last.current().replay else "shot"
        return ShotsLook(
            tuple(self.shots), self.chosen, self.first, line, self.typing, self.over, self.said,
            kind, sight.session.language,
        )  # fmt: skip

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the page; returns its rectangle."""
        return shots_view.draw(surface, sight, self._look(sight))

    # -- what is done --------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._key(event, sight)
        if event.type == pygame.TEXTINPUT and self.typing:
            self._type(event.text)
        elif event.type == pygame.MOUSEMOTION:
            self.over = shots_view.spot_at(event.pos, sight)
        elif event.type == pygame.MOUSEWHEEL:
            self._scroll(-event.y, sight)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    def _key(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        key, ctrl = event.key, getattr(event, "mod", 0) & COMMAND
        always = sight.preferences.keys.always.get(key)
        if key == pygame.K_ESCAPE:
            return CLOSE
        if always is not None:
            return always
        if ctrl and key in (pygame.K_s, pygame.K_o):
            self.typing = key == pygame.K_s or not self.shots
        elif ctrl and key == pygame.K_v and clipboard.get().startswith(lineup.MARK):
            return self._do("paste")
        elif ctrl and key == pygame.K_c and not self.typing:
            return self._do("copy")
        elif key == pygame.K_TAB:
            self.typing = not self.typing or not self.shots
        elif key in ENTER:
            return self._do("save" if self.typing else "open")
        elif self.typing and self._edit(event):
            pass
        elif key in STEPS:
            self.typing = False
            self._choose(self.chosen + STEPS[key] * (self.field is None), sight)
        elif key == pygame.K_DELETE:
            return self._do("delete")
        return None

    def _edit(self, event: pygame.event.Event) -> bool:
        """Let a key edit the name, if it does."""
        if event.key in (pygame.K_UP, pygame.K_DOWN, pygame.K_PAGEUP, pygame.K_PAGEDOWN):
            return False
        action = editing.of_key(event)
        done = editing.with_clipboard(action, self._field)
        if done is not None and done.name == "type":
            self._type(str(done.value))
        elif done is not None:
            editing.do(self._field, done)
        return action is not None

    def _type(self, text: str) -> None:
        plain = unicodedata.normalize("NFC", text)
        fits = self._field.type("".join(c for c in plain if c.isprintable()))
        self.said = ("" if fits else "shots.unfit", "")

    def _choose(self, place: int, sight: Sight) -> None:
        self.chosen = min(max(place, 0), max(len(self.shots) - 1, 0))
        shown = shots_view.shown(sight.layout)
        self.first = min(max(self.first, self.chosen - shown + 1), self.chosen)
        self.said = ("", "")

    def _scroll(self, rows: int, sight: Sight) -> None:
        most = len(self.shots) - shots_view.shown(sight.layout)
        self.first = min(max(self.first + rows, 0), max(most, 0))

    def _press(self, at: tuple[int, int], sight: Sight) -> Action | None:
        self.over = spot = shots_view.spot_at(at, sight)
        match spot.kind:
            case "close" | "outside":
                return CLOSE
            case "row" if self.first + spot.place < len(self.shots):
                again = self.first + spot.place == self.chosen and not self.typing
                self.typing = False
                self._choose(self.first + spot.place, sight)
                return self._do("open") if again else None
            case "box":
                if self.typing:
                    window, line = shelf_view.text_window(sight), sight.line(self._field)
                    size = shots_view.SIZE
                    self._field.go(text_line.place_at(window, sight.type, line, size, at[0]))
                self.typing = True
            case "button":
                return self._do(BUTTONS[spot.place])
        return None

    @property
    def _shot(self) -> SharedShot | None:
        """The shot that is chosen, None if there is none or it cannot be read."""
        return self.shots[self.chosen].shot if self.shots else None

    def _do(self, name: str) -> Action | None:
        """What a button does."""
        match name:
            case "save" | "aim":
                self._save(self.last.aimed() if name == "aim" else self.last.current())
            case "open":
                return self._open()
            case "copy":
                self._copy()
            case "paste":
                return self._paste()
            case "delete" if self.shots:
                gone = self.folder.remove(self.shots[self.chosen].name)
                self.said = f"shots.{'deleted' if gone else 'kept'}", self.shots[self.chosen].name
                self.shots = self.folder.shots()
                self.chosen = max(0, min(self.chosen, len(self.shots) - 1))
        return None

    def _save(self, shot: SharedShot) -> None:
        try:
            name = self.folder.save(self._field.text, shot)
        except ValueError:
            self.typing, self.said = True, ("shots.unnamed", "")
            return
        except OSError as error:
            self.said = "shots.unsaved", error.strerror or str(error)
            return
        self.shots = self.folder.shots()
        names = [one.name for one in self.shots]
        self.chosen = names.index(name) if name in names else 0
        self.typing, self.said = False, ("shots.saved", name)

    def _open(self) -> Action | None:
        if self._shot is None:
            self.said = ("shots.broken" if self.shots else "shots.none"), ""
            return None
        return Action("open", self._shot.line())

    def _copy(self) -> None:
        shot = self.last.current() if self._shot is None else self._shot
        done = clipboard.put(shot.line())
        self.said = ("shots.copied" if done else "toast.uncopied"), ""

    def _paste(self) -> Action | None:
        text = " ".join(clipboard.get().split())
        try:
            shared.read(text)
        except LineError as error:
            self.said = (f"line.{error.reason}" if text else "toast.empty"), error.word
            return None
        return Action("open", text)
