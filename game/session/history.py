"""Undo and redo without limit: what lay on the table before everything that moved a ball."""

from __future__ import annotations

from typing import NamedTuple

from physics import Placed, World

from .running_match import Standing


class Moment(NamedTuple):
    """A table with what its player was about to do.

    shown     was the last shot on show, with its numbers in the boxes?
    standing  of the match, None at the free table
    """

    world: World
    layout: tuple[Placed, ...]
    texts: tuple[str, ...]
    complete: bool
    moving: bool
    shown: bool
    shots: int
    cue: str
    standing: Standing | None

    def same_table(self, other: Moment) -> bool:
        """Do the balls lie, or move, alike?"""
        return self.world is other.world and self.layout == other.layout


class History:
    """The moments before (`past`), and those that were undone with what had come of them."""

    def __init__(self) -> None:
        self.past: list[Moment] = []
        self.future: list[tuple[Moment, Moment]] = []

    def note(self, before: Moment, now: Moment, *, writes: bool = False) -> None:
        """An action has been done: keep what was before it, if it moved a ball.

        writes: it counts too if it has changed the boxes.
        """
        if now.world is not before.world:
            return  # the world it was in has gone, and with it all that was before
        wrote = writes and now.texts != before.texts
        if wrote or now.shots != before.shots or not now.same_table(before):
            self.past.append(before)
            self.future.clear()

    def clear(self) -> None:
        """Forget everything: there are other balls on the table now."""
        self.past.clear()
        self.future.clear()

    def undo(self, now: Moment) -> Moment | None:
        """Go back to before the last action that moved a ball: returns that, None if none did."""
        if not self.past:
            return None
        self.future.append((self.past.pop(), now))
        return self.future[-1][0]

    def redo(self) -> tuple[Moment, Moment] | None:
        """Go on to after what was undone last: returns before and after it, None if nothing was."""
        if not self.future:
            return None
        before, after = self.future.pop()
        self.past.append(before)
        return before, after
