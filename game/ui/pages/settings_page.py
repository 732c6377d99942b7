"""The settings page: which row is in focus, and what keys and mouse mean while it is open."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from game.input.key_tables import NAMES
from game.session.action import Action
from game.session.session import Session
from game.ui.sight import Sight

from . import settings_view
from .settings_rows import CHOSEN, ROWS, SettingsRow, beside, chosen, current

CLOSE = Action("settings")
Place = tuple[int, int]
STEPS = {pygame.K_UP: -1, pygame.K_DOWN: 1}
CHANGES = {pygame.K_LEFT: -1, pygame.K_RIGHT: 1, pygame.K_RETURN: 1, pygame.K_SPACE: 1}


class SettingsPage:
    """Focus, and the action that waits for a new key."""

    def __init__(self) -> None:
        self.focus = 0
        self.waiting = False
        """Will the next key be the focused action's?"""
        self.first = 0
        """The first of the rows of keys that is shown."""
        self.over = settings_view.NOTHING
        """The part under the mouse."""

    typing = False
    """Characters are never typed here."""

    def open(self, session: Session) -> None:
        """Stand where it stood when it was closed."""
        self.waiting = False

    def look(self, sight: Sight) -> Hashable:
        """Return what its picture depends on."""
        state = self.focus, self.waiting, self.first, self.over
        now = tuple(current(row, sight.session, sight.settings) for row in CHOSEN)
        keys = tuple(sight.preferences.keys.names.values())
        return state, now, keys, sight.preferences.refused

    def draw(self, surface: pygame.Surface, sight: Sight) -> pygame.Rect:
        """Draw the page; returns its rectangle."""
        state = settings_view.SettingsLook(self.focus, self.waiting, self.first, self.over)
        return settings_view.draw(surface, sight, state)

    def handle(self, event: pygame.event.Event, sight: Sight) -> Action | None:
        """Return what an event means."""
        if event.type == pygame.KEYDOWN:
            return self._key(event.key, sight)
        if event.type == pygame.MOUSEWHEEL:
            self._scroll(-event.y, sight)
        elif event.type == pygame.MOUSEMOTION:
            self.over = settings_view.part_at(event.pos, sight, self.first)
            if sight.pointer.grip == self.row.name:  # which a key may have left
                return self._slide(event.pos, sight)
        elif event.type == pygame.MOUSEBUTTONDOWN and event.button == 1:
            return self._press(event.pos, sight)
        return None

    @property
    def row(self) -> SettingsRow:
        """The row in focus."""
        return ROWS[self.focus]

    def _key(self, key: int, sight: Sight) -> Action | None:
        keys = sight.preferences.keys
        if self.waiting:
            self.waiting = False
            if key == pygame.K_ESCAPE:
                return None
            return Action("bind", f"{self.row.name} {NAMES.get(key, 'unknown')}")
        if key == pygame.K_ESCAPE:
            return CLOSE
        if key in keys.always:
            return keys.always[key]
        if key in STEPS:
            self._go(self.focus + STEPS[key], sight)
        elif key == pygame.K_TAB:
            self._go(len(CHOSEN) if self.focus < len(CHOSEN) else 0, sight)
        elif self.row.kind != "key":
            return self._step(CHANGES.get(key, 0), sight)
        elif key in (pygame.K_RETURN, pygame.K_SPACE):
            self.waiting = True
        elif key in (pygame.K_BACKSPACE, pygame.K_DELETE):
            return Action("unbind", self.row.name)
        return None

    def _step(self, step: int, sight: Sight) -> Action | None:
        now = current(self.row, sight.session, sight.settings)
        return chosen(self.row, beside(self.row, now, step), now) if step else None

    def _go(self, focus: int, sight: Sight) -> None:
        self.focus = focus % len(ROWS)
        place, shown = self.focus - len(CHOSEN), settings_view.keys_shown(sight.layout)
        if place >= 0:
            self.first = min(max(self.first, place - shown + 1), place)

    def _scroll(self, rows: int, sight: Sight) -> None:
        most = len(ROWS) - len(CHOSEN) - settings_view.keys_shown(sight.layout)
        self.first = min(max(self.first + rows, 0), max(most, 0))

    def _press(self, at: Place, sight: Sight) -> Action | None:
        self.waiting = False
        self.over = index, key = settings_view.part_at(at, sight, self.first)
        if index < 0:
            return CLOSE if key in ("outside", "close") else None
        self.focus = index
        if self.row.kind == "key":
            self.waiting = True
            return None
        if self.row.kind == "slider":
            sight.pointer.grip = self.row.name
            return self._slide(at, sight)
        return (
            chosen(self.row, key, current(self.row, sight.session, sight.settings)) if key else None
        )

    def _slide(self, at: Place, sight: Sight) -> Action | None:
        key = settings_view.slid(at, sight, self.focus)
        return chosen(self.row, key, current(self.row, sight.session, sight.settings))
