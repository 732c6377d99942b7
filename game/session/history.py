"""Undo and redo without limit: what lay on the table before everything that moved a ball."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from physics import Placed, World

from .timeline import skip

if TYPE_CHECKING:
    from .session import Game


class Moment(NamedTuple):
    """A table with what its player was about to do."""

    world: World
    layout: tuple[Placed, ...]
    texts: tuple[str, ...]
    complete: bool
    moving: bool
    shown: bool
    """Was the last shot on show, with its numbers in the boxes?"""
    shots: int
    cue: str
    kept: tuple[object, ...]
    """What the `keepers` of the history have given."""

    def same_table(self, other: Moment) -> bool:
        """Do the balls lie, or move, alike?"""
        return self.world is other.world and self.layout == other.layout


def moment(game: Game) -> Moment:
    """The game as it is now."""
    aim, world = game.aim, game.world
    kept = tuple(take() for take, _ in game.history.keepers)
    shown = game.shown_shot and not game.moving
    table = world, world.layout(), (*aim.texts,), aim.complete, game.moving, shown
    return Moment(*table, game.shots, game.cue, kept)


class History:
    """The moments before (`past`), and those that were undone with what had come of them."""

    def __init__(self) -> None:
        self.past: list[Moment] = []
        self.future: list[tuple[Moment, Moment]] = []
        self.keepers: list[tuple[Callable[[], object], Callable[[object], None]]] = []
        """Pairs (take, give) for what else belongs to a moment, as the score of a match does."""

    def note(self, before: Moment, game: Game) -> None:
        """An action has been done: keep what was before it, if it moved a ball."""
        if game.world is not before.world:
            return  # the world it was in has gone, and with it all that was before
        if game.shots != before.shots or not moment(game).same_table(before):
            self.past.append(before)
            self.future.clear()

    def clear(self) -> None:
        """Forget everything: there are other balls on the table now."""
        self.past.clear()
        self.future.clear()

    def undo(self, game: Game) -> bool:
        """Go back to before the last action that moved a ball; returns whether there was one."""
        if not self.past:
            return False
        now, before = moment(game), self.past.pop()
        self.future.append((before, now))
        _restore(game, before)
        return True

    def redo(self, game: Game) -> bool:
        """Do again what was undone; returns whether there was anything."""
        if not self.future:
            return False
        before, after = self.future.pop()
        self.past.append(before)
        if after.shots > before.shots:
            _restore(game, before)
            game.strike()
            skip(game)
            if game.shots == after.shots and (after.moving or game.world.layout() == after.layout):
                return True
        _restore(game, after)
        return True


def _restore(game: Game, kept: Moment) -> None:
    game.put(kept.layout)
    game.shots = kept.shots
    for (_, give), own in zip(game.history.keepers, kept.kept, strict=True):
        give(own)
    game.cue = kept.cue
    game.aim.texts = list(kept.texts)
    game.aim.leave()
    game.aim.complete = kept.complete and not game.aim.faults
    game.aim.wrong = False
    if game.contest is not None and kept.shown:
        game.contest.given = False
        game.contest.give_boxes(game)
