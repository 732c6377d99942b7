"""What the primary button does in every state, and the key that does the same; and the hint.

A button that names a key does what that key does: `entered` is what RETURN means, so that neither
can say one thing and do another.  Where the key has another meaning just then, none is named.
"""

from __future__ import annotations

from game.session.action import Action
from game.session.running_match import Contest
from game.session.session import Session

Button = tuple[str, str, Action | None]
"""Keys of the texts for the label and the key cap, and what a press means, None for nothing."""
ENTER = "key.enter"
ASKED: Button = "asked.first", "asked.keys", None
"""While a match asks something: a second press of what ended the stroke must not answer."""
SHOOT: Button = "shoot", ENTER, Action("shoot")
FINISH: Button = "shoot", "key.fire", Action("fire")
"""To shoot what is in the boxes; while they are edited RETURN goes on to the next one."""
COMPLETE: Button = "complete", ENTER, Action("next")
"""For an entry that was left half way: as RETURN in the last box does."""
STOP: Button = "stop", "key.space", Action("stop")
NEXT: Button = "next", ENTER, Action("edit", 0)
RESUME: Button = "resume", "key.p", Action("pause")
WATCHED: dict[str, Button] = {
    "replay.playing": ("hold", "key.p", Action("pause")),
    "replay.paused": RESUME,
    "replay.same": ("leave", "key.esc", Action("quit")),
    "replay.differs": ("leave", "key.esc", Action("quit")),
}
"""While a record is watched, by what the notice says of it."""


def button(session: Session) -> Button:
    """The primary button as the game stands."""
    if session.notice is not None and session.notice.key in WATCHED:
        return WATCHED[session.notice.key]
    contest = session.contest
    if asking(session):
        return ASKED
    if session.arranging:
        if contest is not None and not contest.match.finished:
            return "hand.done", ENTER, Action("arrange")
        return "place.done", "key.b", Action("arrange")
    editing = session.aim.box is not None
    return _of_match(session, editing) or (FINISH if editing else _of_table(session))


def asking(session: Session) -> bool:
    """Is a person to answer a question of the match now?"""
    contest = session.contest
    if contest is None or session.moving or contest.level is not None:
        return False
    return contest.match.asked is not None


def _of_table(session: Session) -> Button:
    if session.moving:
        return STOP
    if session.shown_shot:
        return NEXT
    return SHOOT if session.aim.complete else COMPLETE


def _of_match(session: Session, editing: bool) -> Button | None:
    """The button where a match makes it another one, else None."""
    contest = session.contest
    if contest is None:
        return None
    if session.moving:
        return "skip", "" if editing else "key.end", Action("skip")
    if contest.between:
        return "rack.next", ENTER, Action("next")
    if contest.match.finished:
        return "again", "key.f10", Action("sheet", "menu")
    if contest.level is not None:
        return RESUME if session.paused else ("hurry", ENTER, Action("fire"))
    return ("next", ENTER, Action("next")) if session.shown_shot else None


def entered(session: Session) -> Action:
    """What RETURN means in play: what the button does, if it names that key."""
    _, cap, action = button(session)
    return action if cap == ENTER and action is not None else Action("shoot")


def hint(session: Session) -> str | None:
    """The key of the hint where a match or placing makes it another one, else None."""
    contest = session.contest
    if asking(session):
        return "asked.hint"
    if session.sketching and not session.moving:
        return "hint.sketch"
    if session.arranging and contest is not None and not contest.match.finished:
        return "hint.hand"
    if session.arranging:
        return "hint.arrange"
    if contest is None or session.paused or session.aim.box is not None:
        return None
    if session.moving:
        return "hint.rolling"
    if contest.match.finished:
        return "hint.rack" if contest.between else "hint.over"
    if contest.level is not None:
        return "hint.thinks"
    if session.shown_shot:
        return "hint.next"
    if contest.in_hand and session.aim.complete and not contest.may_call:
        return "hint.placed"
    return _calling(contest) or ("hint.match" if session.aim.complete else None)


def _calling(contest: Contest) -> str | None:
    """The key of the hint that says what may be called, if anything."""
    may = contest.may_call
    if "push" in may:
        return "hint.push"
    if "pocket" in may:
        return "hint.call"
    return "hint.colour" if "ball" in may else "hint.cue" if "cue" in may else None
