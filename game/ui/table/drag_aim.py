"""Aiming on the table itself: drag towards where the ball is to go, or pull the cue back.

With Shift held a drag turns the aim by a tenth of what the mouse turns about the ball.
"""

from __future__ import annotations

from cmath import phase, rect
from dataclasses import dataclass
from math import degrees, radians

import pygame

from game.aim.edit import STRONGEST, share, speed_at
from game.input.key_tables import finer_step
from game.render.table import cue_stick
from game.session.action import Action
from game.ui.sight import Place, Sight

FINE = 0.1
"""Part of the mouse's turn that a fine drag takes over."""
REACH = 14
"""Pixels at s = 1 beside the cue at which it is still taken hold of."""
REST, TRAVEL = 0.02, 0.30
"""How far the tip is from the ball for no power at all, and how much farther for all, m."""


@dataclass(frozen=True, slots=True)
class Grip:
    """What the mouse took hold of: where on the table, and what was true then."""

    kind: str
    at: complex
    angle: float
    share: float


def pull(speed: float, most: float = STRONGEST) -> float:
    """How far the cue is drawn back for a speed, of `most` by hand, m."""
    return REST + TRAVEL * min(share(speed, most), 1.0)


def _ball(sight: Sight) -> complex:
    return complex(*sight.session.world.ball(sight.session.cue).position)


def on_cue(at: complex, sight: Sight) -> bool:
    """Is a point of the table on the drawn cue?"""
    session = sight.session
    shot = session.aim.shot
    if shot is None or sight.mode != "aim":
        return False
    own = session.world.ball(session.cue)
    away = (_ball(sight) - at) * rect(1.0, -radians(shot.angle - session.aim.squirt))
    start = own.radius + pull(session.aim.power or shot.speed, sight.session.aim.strongest)
    reach = REACH * sight.layout.s / sight.layout.scale
    return start - reach < away.real < start + cue_stick.LENGTH and abs(away.imag) < reach


def touch(where: Place, sight: Sight) -> Action | None:
    """What a press on the cloth, or a drag from there, means.

    On the ball itself nothing: from there a pixel would be degrees.
    """
    at = complex(*sight.layout.to_table(*where))
    fine = bool(pygame.key.get_mods() & pygame.KMOD_SHIFT)
    pointer, on_ball = sight.pointer, _on_ball(at, sight)
    if pointer.pressing:
        pointer.grip = _grip("cue" if not on_ball and on_cue(at, sight) else "", at, sight)
    grip = pointer.grip
    if not isinstance(grip, Grip):
        return None
    if grip.kind == "cue":
        return _pulled(grip, at, sight.session.aim.strongest) if pointer.stirred else None
    if on_ball:
        pointer.grip = _grip("", at, sight)
        return None
    if not fine:
        pointer.grip = _grip("", at, sight)
        return Action("set", f"angle {degrees(phase(at - _ball(sight))):.2f}")
    if grip.kind != "fine":
        pointer.grip = _grip("fine", at, sight)
        return None
    return _turned(grip, at, sight)


def _on_ball(at: complex, sight: Sight) -> bool:
    return abs(at - _ball(sight)) <= sight.session.world.ball(sight.session.cue).radius


def _grip(kind: str, at: complex, sight: Sight) -> Grip:
    aim = sight.session.aim
    drawn = share(aim.power or 0.0, aim.strongest) if aim.shot else 0.0
    return Grip(kind, at, aim.angle or 0.0, drawn)


def _pulled(grip: Grip, at: complex, most: float) -> Action:
    along = -((at - grip.at) * rect(1.0, -radians(grip.angle))).real
    return Action("power", f"{speed_at(grip.share + along / TRAVEL, most):.2f}")


def _turned(grip: Grip, at: complex, sight: Sight) -> Action:
    ball = _ball(sight)
    turn = degrees(phase((at - ball) / (grip.at - ball)))
    return Action("set", f"angle {grip.angle + FINE * turn:.2f}")


def wheel(steps: int, sight: Sight) -> Action | None:
    """Turn the aim: 1° a notch, 0.1° with Shift, 0.01° with Ctrl."""
    return stepped("turn", 1.0, steps)


def stepped(name: str, plain: float, steps: int) -> Action:
    """A step of an action by the wheel: plain, or finer with Shift, finest with Ctrl."""
    mods = pygame.key.get_mods()
    if mods & (pygame.KMOD_SHIFT | pygame.KMOD_CTRL):
        one = float(str(finer_step(name, 1, bool(mods & pygame.KMOD_CTRL)).value))
    else:
        one = plain
    return Action(name, f"{one * steps:g}")
