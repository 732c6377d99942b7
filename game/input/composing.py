"""What an input method is composing, and the order of events around the moment it is written.

A Korean syllable is shown before it is written.  What ends it, Return or a digit, may reach the
game before the syllable does, and the field that it belongs to may have been left by then.  So a
syllable counts as written when something else is done; when it comes after all, it is passed over.
"""

from __future__ import annotations

import unicodedata

import pygame

from .editing import COMMAND

OWN = (pygame.K_BACKSPACE, pygame.K_DELETE, pygame.K_ESCAPE)
"""Keys with which the input method changes what it composes, whatever else gets them too."""
HELD = frozenset(
    getattr(pygame, f"K_{name}") for name in (
        "LSHIFT", "RSHIFT", "LCTRL", "RCTRL", "LALT", "RALT", "LMETA", "RMETA", "CAPSLOCK",
        "NUMLOCKCLEAR", "MODE", "UNKNOWN",
    )
)  # fmt: skip


class Composition:
    """`text` is what is being composed, to be shown at the caret of the field in use."""

    def __init__(self) -> None:
        self.text = ""
        self._due = ""
        """What counts as written although its event is still to come."""

    def take(self, event: pygame.event.Event) -> list[pygame.event.Event]:
        """Return the events that a field in use should see in place of one."""
        match event.type:
            case pygame.TEXTEDITING:
                self._show(event.text)
                return []
            case pygame.TEXTINPUT:
                return self._write(_composed(event.text))
            case pygame.KEYDOWN if self.text:
                return self._key(event)
            case pygame.MOUSEBUTTONDOWN if self.text:
                pygame.key.stop_text_input()  # the input method does not notice the mouse
                pygame.key.start_text_input()
                return [*self._settle(), event]
        return [event]

    def _show(self, text: str) -> None:
        self.text = _composed(text)
        if self.text:
            self._due = ""

    def _write(self, text: str) -> list[pygame.event.Event]:
        if self._due and text == self._due:
            self._due = ""
            return []
        # what was typed to end a syllable is plain; what ends as something else was converted
        before = self._settle() if text.isascii() and not self.text.isascii() else []
        self.text = ""
        return [*before, _event(text)]

    def _key(self, event: pygame.event.Event) -> list[pygame.event.Event]:
        types = 32 <= event.key < 127 and not getattr(event, "mod", 0) & COMMAND
        if event.key in OWN:
            return []
        return [event] if types or event.key in HELD else [*self._settle(), event]

    def _settle(self) -> list[pygame.event.Event]:
        """What is being composed counts as written now."""
        self._due, self.text = self.text, ""
        return [_event(self._due)] if self._due else []


def _composed(text: str) -> str:
    return unicodedata.normalize("NFC", text)


def _event(text: str) -> pygame.event.Event:
    return pygame.event.Event(pygame.TEXTINPUT, text=text)
