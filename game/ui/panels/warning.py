"""What is wrong with the coming stroke of a match, as the preview shows it."""

from __future__ import annotations

from game.session.running_match import Contest
from game.session.session import Session
from game.ui.sight import Sight
from game.ui.table.looks import ball_words


def of(sight: Sight) -> str:
    """The foul that the shot in the boxes would be for certain, or ""."""
    session, contest, aim = sight.session, sight.session.contest, sight.session.aim
    if contest is None or contest.terms.discipline.position or contest.level is not None:
        return ""
    idle = session.moving or session.shown_shot or session.arranging or session.sketching
    ready = aim.complete and not aim.faults and contest.match.asked is None
    if idle or not ready or contest.lag is not None or sight.settings.aids == "off":
        return ""
    w = sight.words
    return _first(session, contest, w) or _down(session, contest, w) or _other(session, w)


def _first(session: Session, contest: Contest, w: dict[str, str]) -> str:
    """Another ball than one that is on would be hit first, or none."""
    seen, match = session.preview, contest.match
    touched = any(match.cue in pair for pair in match.state.touching)
    if seen is None or touched or match.call.push:
        return ""
    if seen.contact is None:
        return _down(session, contest, w) or w["warn.nothing"]
    ball = seen.contact.ball
    if ball in match.rules.targets(match.turn):
        return ""
    return w["warn.not_on"].format(ball=ball_words(ball, w))


def _down(session: Session, contest: Contest, w: dict[str, str]) -> str:
    """The cue ball would leave the table, or go down where it may not: in pyramid it may."""
    seen, cue = session.preview, contest.match.cue
    if seen is not None and any(e.kind == "off" and cue in e.balls for e in seen.story.events):
        return w["warn.off"]
    if seen is None or contest.match.rules.key.endswith("pyramid"):
        return ""
    falls = (e.wall or "" for e in seen.story.events if e.kind == "pocket" and cue in e.balls)
    pocket = next(falls, None)
    return "" if pocket is None else w["warn.cue"].format(pocket=w.get(f"pocket.{pocket}", pocket))


def _other(session: Session, w: dict[str, str]) -> str:
    """Any other foul that the rules see in the whole stroke: no cushion, a jump in snooker."""
    seen = session.preview
    return w[f"reason.{seen.fault}"] if seen is not None and seen.fault else ""
