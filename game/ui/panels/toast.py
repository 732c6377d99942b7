"""A word over the table: what a key has done and how to take it back, or what could not be."""

from __future__ import annotations

from game.render.theme import ACCENT, ERROR, TEXT
from game.session.action import Action
from game.ui.sight import Sight
from game.ui.table.over import Card, written

LASTS = 4.0
"""Seconds for which it is shown."""
SIZE = 13
TAKEN_BACK = ("place", "retry", "stop", "line", "open", "drill")
"""Actions of a single key or click that move balls."""
ENDS = ("undo", "redo", "shoot", "fire")
"""Actions after which nothing is left to be said of the one before."""


class Toast:
    """What is on show.

    key   of its text, "" for none
    word  in it
    bad   does it say what could not be?
    left  for how many seconds more
    """

    def __init__(self) -> None:
        self.key = self.word = ""
        self.bad, self.left = False, 0.0

    def say(self, key: str, word: str = "", *, bad: bool = False) -> None:
        """Show a text."""
        self.key, self.word, self.bad, self.left = key, word, bad, LASTS

    def note(self, action: Action, *, step: bool) -> None:
        """An action has been done; was it a step that can be taken back?"""
        if step and action.name in TAKEN_BACK:
            self.say(f"toast.{action.name}")
        elif step or action.name in ENDS:
            self.key = ""

    def passed(self, seconds: float) -> bool:
        """Let time pass; returns whether it has gone."""
        self.left -= seconds
        gone = bool(self.key) and self.left <= 0.0
        self.key = "" if gone else self.key
        return gone

    def cards(self, sight: Sight) -> list[Card]:
        """The card, at the bottom of the table."""
        if not self.key:
            return []
        bed, words = sight.layout.bed, sight.words[self.key].format(word=self.word)
        edge = ERROR if self.bad else ACCENT
        picture = written(sight.type, [(words, SIZE, TEXT)], edge, 0.9 * bed.w)
        rect = picture.get_rect(midbottom=(bed.centerx, bed.bottom - sight.layout.px(14)))
        return [Card(("toast", words), rect, picture)]
