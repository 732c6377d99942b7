"""What commands of a match do to a session: answers to questions, calls, and the ball in hand."""

from __future__ import annotations

from cmath import phase
from dataclasses import replace

from danggu.players.hand import hindrance
from danggu.rules.state import ANYWHERE, Call
from game.aim.entry import BOXES
from game.table import placing
from physics import Pocket, World

from . import calls
from .notice import Notice
from .session import Session

# -- questions -------------------------------------------------------------------------------------


def answer(session: Session, key: str) -> None:
    """Answer the question of the match with one of its options."""
    contest = session.contest
    if contest is None or contest.match.asked is None or session.moving:
        session.refuse("answer")
        return
    try:
        contest.answer(key, session.world)
    except ValueError:
        session.refuse("answer")
        return
    session.changed()
    session.timeline.restart()
    session.seat()
    session.show_aim()
    session.aim.leave()
    session.aim.finish()


# -- calls -----------------------------------------------------------------------------------------


def call(session: Session, what: str) -> None:
    """Declare "ball NAME", "pocket NAME", "cue NAME", "safety" or "push"; a second time, not."""
    contest = session.contest
    if contest is None or session.moving:
        session.refuse("call.none")
        return
    word, _, name = what.partition(" ")
    if word == "pocket" and name not in pockets(session.world):
        session.refuse("call.none")
        return
    _declare(session, _called(contest.match.call, word, name), name)


def _called(now: Call, word: str, name: str) -> Call:
    """The call with this said: once more takes it back, and each excludes what it contradicts."""
    match word:
        case "ball":
            ball = "" if now.ball == name else name
            return Call(ball, now.pocket, cue=now.cue)
        case "pocket":
            return Call(now.ball, "" if now.pocket == name else name, cue=now.cue)
        case "safety":
            return Call(safety=not now.safety, cue=now.cue)
        case "push":
            return Call(push=not now.push, cue=now.cue)
    return replace(now, cue=name)


def _declare(session: Session, wanted: Call, name: str = "") -> None:
    contest = session.contest
    assert contest is not None
    before = contest.match.cue
    try:
        contest.call(wanted)
    except ValueError as error:
        session.warn(f"refused.{error}", about=name)
        return
    session.timeline.stamp += 1  # what the coming stroke would be worth has changed
    session.cue = contest.match.cue
    if session.cue != before:
        _aim(session)


def next_ball(session: Session, way: int) -> None:
    """Nominate the next ball, or the one before (-1); in free pyramid play with it."""
    contest = session.contest
    if contest is None or session.moving:
        session.refuse("call.none")
        return
    match, may = contest.match, contest.may_call
    if "cue" in may:
        names = tuple(b.name for b in session.world.balls if not b.gone)
        _declare(session, replace(match.call, cue=calls.after(names, match.cue, way) or names[0]))
    elif "ball" in may:
        ball = calls.after(calls.balls(match), match.call.ball, way)
        _declare(session, Call(ball, match.call.pocket))
    else:
        session.refuse("call.none")


def next_pocket(session: Session, way: int) -> None:
    """Nominate the next pocket, or the one before (-1)."""
    contest = session.contest
    if contest is None or session.moving or "pocket" not in contest.may_call:
        session.refuse("call.none")
        return
    now = contest.match.call
    pocket = calls.after((*pockets(session.world),), now.pocket, way)
    _declare(session, Call(now.ball, pocket))


def pockets(world: World) -> dict[str, tuple[float, float]]:
    """Names and places of the pockets, anticlockwise from the east, m."""
    found = {w.name: w.at for w in world.walls if isinstance(w, Pocket) and w.name}
    return dict(sorted(found.items(), key=lambda item: phase(complex(*item[1]))))


# -- the ball in hand ------------------------------------------------------------------------------


def hold_in_hand(session: Session) -> None:
    """Take the cue ball in hand, or put it down where it is."""
    contest = session.contest
    if contest is None:
        return
    if session.moving:
        session.refuse("moving")
    elif not contest.in_hand:
        session.refuse("match" if contest.terms.discipline.position else "hand")
    else:
        session.show_aim()
        session.arranging, session.held_ball = not session.arranging, session.cue
        if not session.arranging:
            _aim(session)
            session.aim.finish()


def move_in_hand(session: Session, to: tuple[float, float]) -> None:
    """Put the cue ball in hand there, m; where it may not be it stays, and the reason is said."""
    contest = session.contest
    if contest is None or not session.arranging or not contest.in_hand:
        return
    region = contest.match.state.region
    why = hindrance(session.world, session.cue, to, region)
    if why is not None:
        where = "anywhere" if region == ANYWHERE else session.world.table.kind
        key = f"hand.{where if why.why == 'region' else why.why}"
        session.notice = Notice(key, error=True, about=why.ball, at=to)
        return
    if session.world.ball(session.cue).position == to:
        return
    cue, balls = session.world.ball(session.cue), session.world.layout()
    place = placing.lying_at(to)
    session.put([place if b is cue else p for b, p in zip(session.world.balls, balls, strict=True)])


def put(session: Session, to: str) -> None:
    """Put the cue ball in hand at "X Y" metres, as the computer does: all at once."""
    x, y = map(float, to.split())
    if session.contest is not None and session.contest.in_hand and not session.moving:
        session.arranging = True
        move_in_hand(session, (x, y))
        session.arranging = False


def _aim(session: Session) -> None:
    """Aim the player's next stroke from where the cue ball lies now."""
    contest = session.contest
    if contest is not None and not session.moving:
        session.aim.leave()
        session.aim.texts[len(BOXES) - 1] = contest.angle(session.world)
