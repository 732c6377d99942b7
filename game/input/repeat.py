"""A key that is held goes on doing what it does, where that is a step."""

from __future__ import annotations

import pygame

from game.session.action import Action
from game.session.commands import COMMANDS
from game.session.ticks import TICKS

FIRST, NEXT = TICKS * 3 // 10, TICKS // 25
"""Ticks until a held key does it again, and then every time."""


class Repeat:
    """The key that was pressed last, if it is one that goes on."""

    def __init__(self) -> None:
        self._key: int | None = None
        self._action: Action | None = None
        self._left = 0
        self.event = pygame.event.Event(pygame.NOEVENT)
        """The KEYDOWN, to be handled again."""

    def press(
        self, key: int, action: Action | None, event: pygame.event.Event | None = None
    ) -> None:
        """A key has been pressed that means an action."""
        command = COMMANDS.get(action.name) if action is not None else None
        held = command is not None and command.repeats
        self._key, self._action, self._left = (key if held else None), action, FIRST
        self.event = event or self.event

    def due(self, ticks: int) -> int:
        """How often it is to be done again now that `ticks` have passed."""
        if self._key is None:
            return 0
        if not pygame.key.get_pressed()[self._key]:
            self._key = None
            return 0
        self._left -= ticks
        times = max(0, -(self._left // NEXT))
        self._left += times * NEXT
        return times

    @property
    def action(self) -> Action | None:
        """What is done again."""
        return self._action
