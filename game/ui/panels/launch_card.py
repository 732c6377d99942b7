"""The read-outs before the stroke: how the ball will leave the cue."""

from __future__ import annotations

from collections.abc import Hashable

import pygame

from game.aim.launch import Launch, launch
from game.render.parts import cards
from game.text.numerals import MINUS
from game.ui.sight import Sight

UNSEEN = 0.05
"""Degrees of squirt that are written as none."""


def wanted(sight: Sight) -> bool:
    """Is a stroke to come that says how the ball will leave?"""
    session = sight.session
    return sight.mode == "aim" and not session.moving and session.aim.shot is not None


def key(sight: Sight) -> Hashable:
    """What the card depends on."""
    session = sight.session
    return "launch", (*session.aim.texts,), session.cue, session.stamp, session.squirt


def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw speed, spin and squirt; of a ball that hops how steeply in place of the squirt."""
    return cards.readouts(surface, rect, sight.type, _items(sight))


def line(sight: Sight) -> str:
    """The same in a line, for a table whose card has other things to show; "" without a stroke."""
    if not wanted(sight):
        return ""
    return " · ".join(f"{value} {unit}".strip() for _, value, unit in _items(sight))


def _items(sight: Sight) -> list[tuple[str, str, str]]:
    """What it says: name, value and unit of each."""
    session, w = sight.session, sight.words
    shot, ball = session.aim.shot, session.world.ball(session.cue)
    assert shot is not None, "there is a stroke to come"
    found = launch(shot, ball, session.world.cloth.bounce)
    return [
        (w["launch.speed"], _written(found.speed, 2), w["unit.speed"]),
        (w["launch.spin"], _written(found.spin, 1), w["unit.spin"]),
        _way(found, w, off=session.squirt == "off"),
    ]


def _way(found: Launch, w: dict[str, str], *, off: bool) -> tuple[str, str, str]:
    """Where it leaves to; with squirt off the ball goes where the cue points."""
    if found.rise:
        return w["launch.rise"], f"{_written(found.rise, 1)}°", ""
    if found.squirt is None:
        return w["launch.squirt"], "–", ""
    size = 0.0 if off else abs(found.squirt)
    side = "" if size < UNSEEN else w["launch.left" if found.squirt > 0.0 else "launch.right"]
    return w["launch.squirt"], f"{_written(size, 1)}°", side


def _written(value: float, places: int) -> str:
    return f"{value:.{places}f}".replace("-", MINUS)
