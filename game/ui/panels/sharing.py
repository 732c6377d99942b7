"""A shot as a line of text: into the clipboard, and out of it."""

from __future__ import annotations

from game.replay.last_stroke import LastStroke
from game.session.action import Action
from game.table import lineup, shared
from game.table.lineup import LineError
from game.window import clipboard

from .toast import Toast


def copy(last: LastStroke, toast: Toast) -> None:
    """Copy what is on show: the last stroke as a replay, or the shot that is aimed."""
    shot = last.current()
    done = clipboard.put(shot.line())
    said = "toast.copied.replay" if shot.replay else "toast.copied"
    toast.say(said if done else "toast.uncopied", bad=not done)


def offered() -> bool:
    """Is there a shot in the clipboard, rather than a number for a box?"""
    return clipboard.get().startswith(lineup.MARK)


def paste(toast: Toast) -> Action | None:
    """Open the shot in the clipboard; what is none says why."""
    text = " ".join(clipboard.get().split())
    try:
        shared.read(text)
    except LineError as error:
        reason = f"line.{error.reason}" if text else "toast.empty"
        toast.say(reason, error.word, bad=True)
        return None
    return Action("open", text)
