"""What commands of play do to a session: the five boxes, the stroke, and its time."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from game.aim import advice, edit, thickness
from game.aim.entry import BOXES
from game.aim.preview import GLIMPSE, rests
from game.table import presets
from physics import Placed

from . import moves
from .session import Session
from .ticks import TICKS
from .timeline import FRAME, LONGEST_SHOT

WHOLE = 99.0
"""Per cent of a drawn path that is followed, from which on it is called all of it."""

# -- the boxes -----------------------------------------------------------------------------------


def edit_box(session: Session, box: int = 0) -> None:
    """Edit the five boxes as they are, from one of them on."""
    session.show_aim()
    session.arranging = False
    session.aim.edit(box)


def clear(session: Session) -> None:
    """Clear all five boxes and edit them."""
    edit_box(session)
    session.aim.edit(clear=True)


def type_into(session: Session, characters: str) -> None:
    """Type into the box being edited, or begin to with the first one."""
    if session.aim.box is None:
        edit_box(session)
    if not session.aim.type(characters):
        session.warn("full")


def enter(session: Session) -> None:
    """Go to the next box; after the fifth the entry is complete."""
    session.aim.enter()
    if session.aim.complete:
        session.warn("complete", error=False)


def in_box(do: Callable[..., object]) -> Callable[..., None]:
    """A method of the aim as a command."""

    def done(session: Session, *value: object) -> None:
        do(session.aim, *value)

    return done


def aimed(change: Callable[..., str | None]) -> Callable[..., None]:
    """A function of `aim.edit` as a command: it writes the next shot, once the balls lie still."""

    def do(session: Session, *value: object) -> None:
        if session.ready():
            session.aim.hops = _hops(session)
            if said := change(session.aim, *value):
                session.warn(said, error=said != edit.MISCUE)
            _make_room(session)
            _written(session)

    return do


def _hops(session: Session) -> bool:
    """Does a raised cue make the ball hop?  Only the exact engine knows balls in the air."""
    return session.edition >= presets.HOPPING and session.engine == "exact"


def _make_room(session: Session) -> None:
    if _hops(session):
        edit.make_room(session.aim, session.world, session.cue)


def _written(session: Session) -> None:
    """The boxes have been written: the entry is complete if it can be read."""
    session.aim.leave()
    if not session.aim.faults:
        session.aim.finish()


def past(wanted: Callable[[float, int], int]) -> Callable[[Session, int], None]:
    """Aiming past the first ball by the eighths that `wanted` makes of those now and a value."""

    def do(session: Session, value: int) -> None:
        if session.contest is not None:
            session.show_aim()  # it begins with the numbers of the player at the table
        seen = session.preview
        if session.moving or session.aim.shot is None:
            return
        if seen is None or seen.contact is None:
            session.warn("thickness.none")
            return
        eighths = wanted(thickness.aside(seen.contact), value)
        angle = edit.past(session.aim, session.world, session.cue, seen, eighths)
        if angle is None:
            session.warn("thickness.blocked")
        elif session.ready():
            session.aim.put(4, angle=angle)
            _make_room(session)
            _written(session)

    return do


# -- the stroke ----------------------------------------------------------------------------------


def shoot(session: Session) -> None:
    """RETURN in play: one shot for each completed entry; in a match first the next turn."""
    if session.contest is not None and session.moving:
        session.refuse("moving")
    elif session.contest is not None and session.shown_shot:
        show_next(session)
    elif session.aim.complete:
        session.strike()
    elif not session.aim.wrong:
        session.show_aim()
        session.warn("spent", error=False)


def fire(session: Session) -> None:
    """Complete the entry as it stands, and shoot; in a match that is the coming stroke."""
    if session.contest is not None:
        session.show_aim()
    session.aim.leave()
    if session.aim.finish():
        session.strike()


def show_next(session: Session) -> None:
    """Show the coming stroke in place of the last one; after a rack, rack again."""
    if session.contest is not None and session.contest.between and not session.moving:
        session.contest.next_rack(session.world)
        session.put(session.world.layout())
        session.seat()
    if session.contest is not None and session.contest.over:
        session.refuse("over")
        return
    session.show_aim()
    session.aim.leave()
    session.aim.finish()


def intend(session: Session, shot: str) -> None:
    """Write five numbers into the boxes: the stroke that the computer means to play."""
    words = shot.split()
    if len(words) == len(BOXES) and not session.moving:
        session.timeline.shown = False
        session.aim.leave()
        session.aim.texts = words
        session.aim.finish()


def sketch(session: Session) -> None:
    """Begin or end drawing the path that the cue ball is to take."""
    if not session.sketching and session.moving:
        session.refuse("moving")
        return
    session.show_aim()
    session.sketching, session.arranging = not session.sketching, False
    session.aim.leave()


def recover(session: Session, found: str) -> None:
    """Write the shot that was found for a drawn path into the boxes, and say how well it fits."""
    if session.ready():
        numbers, known = found.split()[: len(BOXES)], found.split()[len(BOXES) :]
        session.aim.texts = numbers
        _written(session)
        whole = float(known[-1]) >= WHOLE
        session.warn(f"sketch.{'found' if whole else 'partly'}", False, " ".join(known))


def coach(session: Session, way: int) -> None:
    """Ask the coach for a way to score, or for the next one (1) or the one before (-1)."""
    if session.contest is not None and not session.contest.terms.hints:
        session.refuse("coach")
    elif session.ready():
        session.sketching = session.arranging = False
        session.coaching += way
    else:
        session.refuse("moving")


def suggest(session: Session, line: str) -> None:
    """Write a way that the coach shows into the boxes, and say how to play it."""
    if session.ready():
        session.aim.texts = list(advice.read(line).texts)
        _written(session)
        session.warn("coach.found", False, line)


def play(session: Session, shot: str) -> None:
    """Strike with five numbers: the stroke as the computer carries it out."""
    intend(session, shot)
    if session.aim.shot is not None:
        session.strike()


def stop(session: Session) -> None:
    """Stop all balls; the stroke of a match goes on to its end instead, for it counts."""
    if session.contest is not None and session.moving:
        skip(session)
        return
    session.world.stop()
    if moves.moves(session.world):
        session.changed()  # what was in the air falls
    else:
        session.rest()
    session.read()


def retry(session: Session) -> None:
    """The balls go back to where they lay before the last shot; the same entry may be shot."""
    lies: Sequence[Placed] = session.lies
    if session.contest is not None:
        texts, before = session.contest.take_back()
        session.aim.texts = list(texts or session.aim.texts)
        session.cue, lies = session.contest.match.cue, before or lies
    session.put(lies)
    session.aim.leave()
    if not session.moving:
        session.aim.finish()


def undo(session: Session) -> None:
    """Take the last step back; in a match with the computer as far as a person's turn."""
    if not _step_back(session):
        session.warn("undo", error=False)
    while session.contest is not None and session.contest.waits and _step_back(session):
        pass


def _step_back(session: Session) -> bool:
    before = session.history.undo(session.snapshot())
    if before is not None:
        session.restore(before)
    return before is not None


def redo(session: Session) -> None:
    """Do again what was undone: a shot is played again, and must come out as it did."""
    undone = session.history.redo()
    if undone is None:
        session.warn("redo", error=False)
        return
    before, after = undone
    if after.shots > before.shots:
        session.restore(before)
        session.strike()
        skip(session)
        same = after.moving or session.world.layout() == after.layout
        if session.shots == after.shots and same:
            return
    session.restore(after)


# -- time ----------------------------------------------------------------------------------------


def pause(session: Session) -> None:
    """Hold or go on; after the shot, show it once more."""
    if session.timeline.pause(editing=session.aim.box is not None):
        session.read()


def seek(session: Session, ticks: int) -> None:
    """Show the moment `ticks` after the shot began; what has not happened yet happens now."""
    if session.timeline.review(editing=session.aim.box is not None):
        if rolling := session.timeline.seek(ticks):
            session.run(rolling)
        session.read()


def frame(session: Session) -> None:
    """One frame on."""
    if session.moving or session.timeline.at is not None:
        seek(session, session.timeline.now + FRAME)


def back(session: Session) -> None:
    """One frame back."""
    seek(session, session.timeline.now - FRAME)


def event(session: Session, way: int) -> None:
    """Go to the next event (1) or the one before (-1)."""
    if session.timeline.review(editing=session.aim.box is not None):
        to = session.timeline.next_event(way)
        if to is not None:
            seek(session, to)


def home(session: Session) -> None:
    """The beginning of the shot."""
    seek(session, 0)


def skip(session: Session) -> None:
    """Go on to the end of the shot at once; where it has none, as far as is foretold of it."""
    session.timeline.live()
    for _ in range(LONGEST_SHOT if rests(session.world) else int(GLIMPSE)):
        session.run(TICKS)
    session.read()


def faster(session: Session, steps: int) -> None:
    """Let time pass faster by so many steps, or slower."""
    session.timeline.faster(steps)
