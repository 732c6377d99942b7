"""Balls that are down: a tray with a slot for each ball; and the ball on in its corner."""

from __future__ import annotations

from collections.abc import Hashable
from math import ceil

import pygame

from danggu.rules.snooker import COLOUR, COLOURS
from danggu.rules.snooker import kind as colour_of
from game.render import theme
from game.render.parts import cards, shapes
from game.session.session import Session
from game.ui.sight import Sight
from game.ui.table.looks import ball_words

from . import launch_card

SLOT = 11
"""Radius of a slot at most, px at s = 1."""
ROWS = 9
"""Balls in a row at most: fifteen go in two of eight and seven."""


def wanted(session: Session) -> bool:
    """Has the table pockets?"""
    return any(not wall.pushes for wall in session.world.walls)


def key(sight: Sight) -> Hashable:
    """What the tray depends on."""
    session = sight.session
    gone = tuple(ball.gone for ball in session.world.balls)
    contest = session.contest
    leaves = launch_card.key(sight) if launch_card.wanted(sight) else None
    return gone, leaves, session.cue, contest and contest.match, sight.settings


def slots(session: Session) -> list[str]:
    """The object balls that have a slot, in their order: of snooker's reds one for all."""
    names = [ball.name for ball in session.world.balls if ball.name != session.cue]
    names = [name for name in names if name != "cue"]
    if "black" in names:
        there = {colour_of(name) for name in names}
        return [name for name in ("red", *COLOURS) if name in there]
    return sorted(names, key=lambda name: (int(name) if name.isdigit() else 0, name))


def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw the tray; while a stroke is aimed its head says how the ball will leave."""
    s, t, w, session = sight.layout.s, sight.type, sight.words, sight.session
    cards.card(surface, rect, s)
    names = slots(session)
    rows = 1 if len(names) <= ROWS else 2
    said, right = on(session, w), rect.right - 12 * s
    end = t.draw(surface, said, (right, rect.y + 18 * s), 12, theme.TEXT, "right").x
    title = launch_card.line(sight) or w["down.title"]
    title = t.fitted(title, 12, end - rect.x - 20 * s)
    t.draw(surface, title, (rect.x + 12 * s, rect.y + 18 * s), 12, theme.TEXT_SOFT)
    across = ceil(len(names) / rows)
    if not across:
        return rect
    pitch = (rect.w - 24 * s) / across
    room = (rect.h - 28 * s) / rows
    radius = min(SLOT * s, 0.46 * pitch, 0.46 * room)
    for place, name in enumerate(names):
        x = rect.x + 12 * s + (place % across + 0.5) * pitch
        y = rect.y + 24 * s + (place // across + 0.5) * room
        _slot(surface, sight, name, (x, y), radius)
    return rect


def _slot(
    surface: pygame.Surface, sight: Sight, name: str, at: tuple[float, float], radius: float
) -> None:
    session, t = sight.session, sight.type
    balls = session.world.balls
    mine = [b for b in balls if colour_of(b.name) == name] if name == "red" else [
        b for b in balls if b.name == name
    ]  # fmt: skip
    down = sum(ball.gone for ball in mine)
    colour = sight.look(mine[0].name).body
    plain = theme.LINE_INPUT if name.isdigit() or _dark(colour) else colour
    edge = theme.ACCENT if name in targets(session) else plain
    shapes.disc(surface, at, radius, colour if down else theme.PANEL, edge, 1.5 * t.s)
    text = str(down or "") if name == "red" else name if name.isdigit() else ""
    size = 12 if radius >= 9 * t.s else 11
    ink = _ink(colour) if down else theme.TEXT_SOFT
    if radius * 2 >= t.width(text, size):
        t.draw(surface, text, (at[0], at[1] + t.cap(size) / 2), size, ink, "centre")


def _dark(colour: tuple[int, int, int]) -> bool:
    """Would a ring of this colour be lost on the panel?"""
    return max(colour) - max(theme.PANEL) < 40


def _ink(colour: tuple[int, int, int]) -> tuple[int, int, int]:
    """Black or white, whichever can be read on a colour."""
    light = 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2]
    return theme.BACKGROUND if light > 128 else theme.WHITE


def targets(session: Session) -> set[str]:
    """The slots of the balls that may be hit first."""
    contest = session.contest
    if contest is None or contest.match.finished:
        return set()
    names = contest.match.rules.targets(contest.match.turn)
    return {colour_of(name) if name.startswith("red") else name for name in names}


def on(session: Session, w: dict[str, str]) -> str:
    """What is on, or how many balls are left, in words."""
    contest = session.contest
    left = sum(not ball.gone and ball.name != "cue" for ball in session.world.balls)
    if contest is None or contest.match.finished:
        return w["on.left"].format(n=left)
    state, match = contest.match.state, contest.match
    if match.rules.key == "snooker":
        said = w["on.colour"] if state.on == COLOUR else w["on.red"]
        if state.on in COLOURS:
            said = ball_words(state.on, w)
        return f"{w['on.title']}: {w['on.free'] if state.free else said}"
    names = match.rules.targets(match.turn)
    if len(names) == 1:
        return f"{w['on.title']}: {ball_words(names[0], w)}"
    return w["on.left"].format(n=left)
