"""Balls on the score plates: in 8-ball a player's group, in snooker those of the running break."""

from __future__ import annotations

from math import ceil

import pygame

from danggu.rules.eight_ball import GROUPS
from danggu.rules.reasons import EIGHT
from game.render import theme
from game.render.font import PART
from game.render.parts import shapes
from game.render.table.balls import portrait
from game.session import scorecard
from game.session.running_match import Contest
from game.session.terms import HUMAN
from game.ui.sight import Sight

from .rack_words import FRAMES

GROUP, BREAK = 12.3, 9.0
"""Radii, px at s = 1: of a group's balls at most, and of a break's."""
PITCH = 2.2
"""Radii from one ball to the next."""
APART = 0.5
"""Radii by which the 8 stands apart from the group."""
GAP = 8
"""Between words and balls, px at s = 1."""
DIM = 110
"""How far the 8 shows before it is on, of 255."""


def of(contest: Contest, index: int) -> tuple[str, ...]:
    """Names of the balls on a player's plate, () where there are none."""
    match = contest.match
    if match.rules.key == "eight_ball" and (group := match.state.group(index)):
        return (*GROUPS[group], EIGHT)
    if match.rules.key == FRAMES and match.at == index:
        return scorecard.running(contest.card, match)
    return ()


def grouped(names: tuple[str, ...]) -> bool:
    """Are these a group of 8-ball, and not a break?"""
    return EIGHT in names


def beside(
    contest: Contest, sight: Sight, names: tuple[str, ...], said: tuple[str, str], room: int
) -> int:
    """How much of the room before the points the words get, px; a gap comes after them.

    said: the player's name, and the line below it, of which the first part has to be seen.
    """
    t, w = sight.type, sight.words
    if grouped(names):
        # the same for both players at any time, or the balls would change their size
        texts = [w["score.solids"], w["score.stripes"], w["score.rack.won"]]
        if any(seat.level != HUMAN for seat in contest.terms.seats):
            texts += [w["score.thinking"], w["score.intends"].format(n=100)]
        return min(max(t.width(text, 12) for text in texts), room // 2)
    name, line, first = (
        t.width(text, size)
        for text, size in ((said[0], 15), (said[1], 12), (said[1].partition(PART)[0], 12))
    )
    free = room - ceil(PITCH * BREAK * t.s * len(names)) - round(GAP * t.s)
    return max(min(max(name, first), room // 2), min(max(name, line), free))


def radius(names: tuple[str, ...], room: float, s: float) -> float:
    """Of each ball, px: where `room` is scarce a group is smaller; a break is cut instead."""
    if not grouped(names):
        return BREAK * s
    return min(GROUP * s, room / (PITCH * len(names) + APART))


def draw(
    surface: pygame.Surface, room: pygame.Rect, sight: Sight, names: tuple[str, ...]
) -> pygame.Rect:
    """Draw the balls at the right end of `room`; of a long break the last ones that fit."""
    r = radius(names, room.w, sight.layout.s)
    if grouped(names):
        _group(surface, room, sight, names, r)
    else:
        _break(surface, room, sight, names, r)
    return room


def _group(
    surface: pygame.Surface, room: pygame.Rect, sight: Sight, names: tuple[str, ...], r: float
) -> None:
    """A group with rings for the balls that are down, and the 8, dim until it is on."""
    contest = sight.session.contest
    left = contest.match.state.left if contest is not None else ()
    early = {*names[:-1]} & {*left}
    for place, name in enumerate(reversed(names)):
        x = room.right - (PITCH * (place + 0.5) + APART * (name != EIGHT)) * r
        if name in left:
            alpha = DIM if name == EIGHT and early else 255
            _ball(surface, sight, name, (x, room.centery), r, alpha)
        else:
            shapes.disc(surface, (x, room.centery), r, theme.PANEL, theme.LINE_INPUT, sight.type.s)


def _break(
    surface: pygame.Surface, room: pygame.Rect, sight: Sight, names: tuple[str, ...], r: float
) -> None:
    fit = max(int(room.w / (PITCH * r)), 1)
    if len(names) > fit:
        names = names[len(names) - fit + 1 :]
        x = room.right - PITCH * r * (len(names) + 0.5)
        at = (x, room.centery + sight.type.cap(12) / 2)
        sight.type.draw(surface, "…", at, 12, theme.TEXT_SOFT, "centre")
    for place, name in enumerate(reversed(names)):
        x = room.right - PITCH * r * (place + 0.5)
        _ball(surface, sight, name, (x, room.centery), r)


def _ball(
    surface: pygame.Surface,
    sight: Sight,
    name: str,
    at: tuple[float, float],
    r: float,
    alpha: int = 255,
) -> None:
    picture = portrait(sight.look(name), round(r, 1))
    if alpha < 255:
        picture = picture.copy()
        picture.set_alpha(alpha)
    surface.blit(picture, picture.get_rect(center=(round(at[0]), round(at[1]))))
