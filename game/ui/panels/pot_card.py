"""The card of the coming pot: which ball, into which pocket, how thin; and what has been called."""

from __future__ import annotations

import pygame

from game.aim.spread import ANGLE
from game.render.parts import gauges
from game.session.session import Session
from game.ui.sight import Sight
from game.ui.table.looks import ball_words

from . import tray
from .parts import number

wanted = tray.wanted


def drops(session: Session) -> dict[str, str]:
    """The balls that the shot in the boxes pockets, each with its pocket."""
    seen = session.preview
    if seen is None:
        return {}
    return {e.balls[0]: e.wall or "" for e in seen.story.events if e.kind == "pocket"}


def title(sight: Sight, ball: str) -> str:
    """What has been called, or else which ball is met and the pocket that takes it."""
    w, session = sight.words, sight.session
    if said := called(session, w):
        return said
    found, name = drops(session), ball_words(ball, w)
    if ball not in found:
        return w["pot.none"].format(ball=name)
    pocket = w.get(f"pocket.{found[ball]}", found[ball])
    return f"{w['pot.title'].format(ball=name)} · {pocket}"


def called(session: Session, w: dict[str, str]) -> str:
    """What the player at the table has declared, in words; "" for nothing."""
    contest = session.contest
    if contest is None:
        return ""
    call = contest.match.call
    words = [w[f"call.{name}"] for name in ("safety", "push") if getattr(call, name)]
    words += [ball_words(call.ball, w)] * bool(call.ball)
    words += [w.get(f"pocket.{call.pocket}", call.pocket)] * bool(call.pocket)
    if call.cue:
        words.append(w["call.cue"].format(ball=ball_words(call.cue, w)))
    return f"{w['call.title']}: {' · '.join(words)}" if words else ""


def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw the card of a shot that meets a ball."""
    session, w = sight.session, sight.words
    seen = session.preview
    assert seen is not None and seen.contact is not None  # noqa: PT018
    contact = seen.contact
    colour = sight.look(contact.ball).ui
    items = [(f"{number(contact.cut, 0)}°", w["pot.cut"])]
    if (share := sight.spread.share) is not None:
        items.append((f"{round(100 * share)} %", w["pot.made"].format(angle=ANGLE)))
    said = sight.type.fitted(title(sight, contact.ball), 13, rect.w - 24 * sight.layout.s)
    gauges.thickness(surface, rect, sight.type, said, items, contact.overlap, colour)
    return rect
