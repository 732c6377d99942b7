"""The mouse: what it is over and what it holds.  Only the picture depends on it."""

from __future__ import annotations

from dataclasses import dataclass

import pygame

SLACK = 3
"""Pixels at s = 1 by which a hand moves the mouse though it means to click."""


@dataclass(slots=True)
class Pointer:
    """The mouse in the window.

    over      name of the panel under it
    held      name of the panel that was pressed
    pressing  is it a press that is being answered, rather than a drag?
    grip      what the held panel has kept from the press
    began     where the press was
    stirred   has the mouse moved since, by more than a hand that only clicks?
    """

    over: str = ""
    held: str = ""
    pressing: bool = False
    grip: object = None
    began: tuple[int, int] = (0, 0)
    stirred: bool = False

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
