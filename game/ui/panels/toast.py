"""A word over the table: what a key has done and how to take it back, or what could not be."""

from __future__ import annotations

from game.render.parts import stars
from game.render.theme import ACCENT, ERROR, TEXT
from game.session.action import Action
from game.ui.sight import Sight
from game.ui.table.over import PAD, LaidCard, written

LASTS = 4.0
"""Seconds for which it is shown."""
SIZE, STAR = 13, 14
"""Of the words and of a star, px at s = 1."""
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
    stars  shown before the words, -1 for none
    """

    def __init__(self) -> None:
        self.key = self.word = ""
        self.bad, self.left, self.stars = False, 0.0, -1

    def say(self, key: str, word: str = "", *, bad: bool = False) -> None:
        """Show a text."""
        self.key, self.word, self.bad, self.left, self.stars = key, word, bad, LASTS, -1

    def show(self, words: str, stars: int) -> None:
        """Show words that are no text of their own, after so many stars."""
        self.say("toast.words", words)
        self.stars = stars

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

    def cards(self, sight: Sight) -> list[LaidCard]:
        """The card, on the rail at the bottom, where it hides no ball that lies away from it."""
        if not self.key:
            return []
        bed, words = sight.layout.bed, sight.words[self.key].format(word=self.word)
        edge = ERROR if self.bad else ACCENT
        row = [(words, SIZE, TEXT)]
        before = round(3.9 * STAR * sight.layout.s) if self.stars >= 0 else 0
        picture = written(sight.type, row, edge, 0.9 * bed.w, before=before)
        if before:
            at = PAD * sight.layout.s, picture.get_height() / 2
            stars.draw(picture, at, STAR * sight.layout.s, self.stars)
        rect = picture.get_rect(midbottom=(bed.centerx, sight.layout.table.bottom - 2))
        return [LaidCard(("toast", words, self.stars), rect, picture)]
