"""What the primary button does in every state, and the key that does the same; and the hint.

A button that names a key does what that key does: `entered` is what RETURN means, so that neither
can say one thing and do another.  Where the key has another meaning just then, none is named.
"""

from __future__ import annotations

from game.session.action import Action
from game.session.session import Game

Button = tuple[str, str, Action]
"""Keys of the texts for the label and the key cap, and what a press means."""
ENTER = "key.enter"
SHOOT, FINISH = ("shoot", ENTER, Action("shoot")), ("shoot", "key.fire", Action("fire"))
"""To shoot what is in the boxes; while they are edited RETURN goes on to the next one."""
COMPLETE = "complete", ENTER, Action("next")
"""For an entry that was left half way: as RETURN in the last box does."""
STOP = "stop", "key.space", Action("stop")
NEXT = "next", ENTER, Action("edit", 0)
RESUME = "resume", "key.p", Action("pause")
WATCHED: dict[str, Button] = {
    "replay.playing": ("hold", "key.p", Action("pause")),
    "replay.paused": RESUME,
    "replay.same": ("leave", "key.esc", Action("quit")),
    "replay.differs": ("leave", "key.esc", Action("quit")),
}
"""While a record is watched, by what the notice says of it."""


def button(game: Game) -> Button:
    """The primary button as the game stands."""
    if game.notice is not None and game.notice.key in WATCHED:
        return WATCHED[game.notice.key]
    if game.arranging:
        return "place.done", "key.b", Action("arrange")
    editing = game.aim.box is not None
    return _of_match(game, editing) or (FINISH if editing else _of_table(game))


def _of_table(game: Game) -> Button:
    if game.moving:
        return STOP
    if game.shown_shot:
        return NEXT
    return SHOOT if game.aim.complete else COMPLETE


def _of_match(game: Game, editing: bool) -> Button | None:
    """The button where a match makes it another one, else None."""
    contest = game.contest
    if contest is None:
        return None
    if game.moving:
        return "skip", "" if editing else "key.end", Action("skip")
    if contest.match.finished:
        return "again", "key.f10", Action("sheet", "menu")
    if contest.level is not None:
        return RESUME if game.paused else ("hurry", ENTER, Action("fire"))
    return ("next", ENTER, Action("next")) if game.shown_shot else None


def entered(game: Game) -> Action:
    """What RETURN means in play: what the button does, if it names that key."""
    _, cap, action = button(game)
    return action if cap == ENTER else Action("shoot")


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
    if game.shown_shot:
        return "hint.next"
    return "hint.match" if game.aim.complete else None
