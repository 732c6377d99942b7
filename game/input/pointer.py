"""The mouse: what it is over and what it holds.  Only the picture depends on it."""

from __future__ import annotations

from dataclasses import dataclass

import pygame

SLACK = 3
"""Pixels at s = 1 by which a hand moves the mouse though it means to click."""


@dataclass(slots=True)
class Pointer:
    """`over` is the name of the part under the mouse; `held` the part that was pressed."""

    over: str = ""
    held: str = ""
    pressing: bool = False
    """Is it a press that is being answered, rather than a drag?"""
    grip: object = None
    """What the held part has kept from the press."""
    began: tuple[int, int] = (0, 0)
    """Where the press was."""
    stirred: bool = False
    """Has the mouse moved since, by more than a hand that only clicks?"""

    @property
    def down(self) -> bool:
        """Is the button held on the part where it went down?"""
        return bool(self.held) and self.held == self.over


def lets_go(event: pygame.event.Event) -> bool:
    """Does an event say that the mouse holds nothing any more, wherever its button went up?"""
    if event.type == pygame.MOUSEMOTION:
        return not any(event.buttons[:1])
    up = event.type == pygame.MOUSEBUTTONUP and event.button == 1
    return up or event.type == pygame.WINDOWFOCUSLOST
