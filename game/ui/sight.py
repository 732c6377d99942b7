"""What is seen: the session and everything else that the table, the panels and the pages draw."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import pygame

from game.aim.spread import Spread
from game.input.captions import words
from game.input.composing import Composition
from game.input.pointer import Pointer
from game.practice.trainer import Trainer
from game.render.font import Type
from game.render.layout import Layout
from game.render.parts.text_line import TextLine
from game.render.theme import BallLook
from game.session.session import Session
from game.settings.preferences import Preferences
from game.settings.settings import Settings
from game.text.text_field import TextField

Place = tuple[float, float]
"""A point of the window, px."""


@dataclass(slots=True)
class Sight:
    """Everything that a picture is drawn from.

    mode         of the right column: "aim" shows the next shot, "after" the last one
    portrait     the picture of a ball, by its place among the balls, for lists and plates
    composition  what an input method is composing
    looks        of the balls, in their order
    choice       the answer in focus while a match asks something, from 0; -1 for none
    trainer      of the drill that is practised, if the window has one
    """

    session: Session
    layout: Layout
    type: Type
    pointer: Pointer
    preferences: Preferences
    spread: Spread
    mode: str = "aim"
    portrait: Callable[[int], pygame.Surface] | None = None
    composition: Composition = field(default_factory=Composition)
    looks: Sequence[BallLook] = ()
    choice: int = -1
    trainer: Trainer | None = None

    @property
    def words(self) -> dict[str, str]:
        return words(self.session.language, self.preferences.keys.changed)

    @property
    def settings(self) -> Settings:
        return self.preferences.settings

    def look(self, name: str) -> BallLook:
        """How the ball of that name looks."""
        return self.looks[[ball.name for ball in self.session.world.balls].index(name)]

    def line(self, edited: TextField) -> TextLine:
        """How a text that is being edited looks."""
        return TextLine(edited.text, edited.caret, edited.selection, self.composition.text)
