"""What button and hint say in a match, on the computer's turn and while balls are placed."""

from __future__ import annotations

from game.actions import Action
from game.play import Game

Button = tuple[str, str, Action]
"""Keys of the texts for the label and the key cap, and what a press means."""


def button(game: Game) -> Button | None:
    """The primary button where a match or placing makes it another one, else None."""
    contest = game.contest
    if game.arranging:
        return "place.done", "key.b", Action("arrange")
    if contest is None:
        return None
    if game.moving:
        return "skip", "key.end", Action("skip")
    if contest.match.finished:
        return "again", "key.f10", Action("sheet", "menu")
    if contest.level is not None:
        return "hurry", "key.enter", Action("fire")
    return ("next", "key.enter", Action("next")) if game.shown_shot else None


def hint(game: Game) -> str | None:
    """The key of the hint where a match or placing makes it another one, else None."""
    contest = game.contest
    if game.arranging:
        return "hint.arrange"
    if contest is None or game.paused or game.aim.box is not None:
        return None
    if game.moving:
        return "hint.rolling"
    if contest.match.finished:
        return "hint.over"
    if contest.level is not None:
        return "hint.thinks"
    return "hint.next" if game.shown_shot else "hint.match"
