"""The cards of the next shot: tip point and elevation, power, thickness."""

from __future__ import annotations

from collections.abc import Hashable
from math import atan2, degrees, hypot

import pygame

from game.aim.edit import share, speed_at
from game.aim.preview import FirstContact
from game.aim.spread import ANGLE
from game.aim.thickness import EIGHTHS
from game.aim.tip import STEEPEST
from game.render.layout import Layout
from game.render.parts import cards, cue_card, gauges
from game.render.theme import TEXT_SOFT
from game.session.action import Action
from game.settings.settings import CHOICES
from game.ui.sight import Place, Sight
from game.ui.table.drag_aim import stepped

from . import pot_card
from .parts import Panel, number

TICKS = (0, 0.5, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13)
"""Speeds marked on the power bar, m/s."""
NAMED = (0, 1, 2, 3, 4, 6, 8, 10, 13)


# -- tip point and elevation ---------------------------------------------------------------------


def _refused(sight: Sight) -> bool:
    notice = sight.session.notice
    return notice is not None and notice.key == "miscue"


def tip_key(sight: Sight) -> Hashable:
    """What the card of the tip point depends on."""
    aim = sight.session.aim
    return aim.tip, _refused(sight), sight.settings.aids, aim.squirts


def tip_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw the cue ball as the cue sees it, the elevation from the side, and the aids."""
    w, tip = sight.words, sight.session.aim.tip
    right, up, elevation = tip or (0.0, 0.0, 0.0)
    steep = "–" if tip is None or elevation is None else f"{number(elevation, 0)}°"
    values = [
        (w["tip.side"], _signed(right) if tip else "–"),
        (w["tip.height"], _signed(up) if tip else "–"),
        (w["tip.elevation"], steep),
    ]
    far = max(1.0, hypot(right, up) / 0.97)
    holds = tip is None or tip.holds
    args = (w["tip"], (right / far, up / far), values, holds, _refused(sight), elevation)
    cue_card.tip(surface, rect, sight.type, *args)
    names = [w["aids." + key] for key in CHOICES["aids"]]
    chosen = CHOICES["aids"].index(sight.settings.aids)
    cue_card.choices(surface, _aids(rect, sight), sight.type, names, chosen)
    box, on = cue_card.corner(rect, sight.layout.s), sight.session.aim.squirts
    cue_card.switch(surface, box, sight.type, _squirt(sight), on=on)
    return rect


def _squirt(sight: Sight) -> str:
    """By how much the ball leaves the cue's line, and to which side; or that it does not."""
    aim, w = sight.session.aim, sight.words
    if not aim.squirts:
        return w["squirt.off"]
    side = "left" if aim.squirt > 0.0 else "right"
    return w[f"squirt.{side}"].format(n=number(abs(aim.squirt), 1))


def _aids(rect: pygame.Rect, sight: Sight) -> list[pygame.Rect]:
    names = [sight.words["aids." + key] for key in CHOICES["aids"]]
    return cue_card.choice_boxes(rect, sight.type, names)


def _signed(value: float) -> str:
    return ("+" if value > 0 else "") + number(value) + " R"


def tip_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    """A setting of the aids, the elevation, or a point of the ball."""
    pointer, s = sight.pointer, sight.layout.s
    (x, y), radius = gauges.tip_circle(rect, s)
    right, up = (at[0] - x) / radius, (y - at[1]) / radius
    if pointer.pressing:
        for key, box in zip(CHOICES["aids"], _aids(rect, sight), strict=True):
            if box.collidepoint(at):
                return Action("aids", key)
        if cue_card.corner(rect, s).collidepoint(at):
            return Action("squirt")
        if cue_card.side_view(rect, s).collidepoint(at):
            pointer.grip = "elevation"
        elif hypot(right, up) <= 1.0:
            pointer.grip = "tip"
    if pointer.grip == "elevation":
        ball = cue_card.side_ball(rect, s)
        steep = degrees(atan2(ball[1] - at[1], max(at[0] - ball[0], 1e-9)))
        return Action("elevate", f"{min(max(steep, 0.0), STEEPEST):.0f}")
    return Action("tip", f"{right:.3f} {up:.3f}") if pointer.grip == "tip" else None


def tip_wheel(steps: int, sight: Sight) -> Action:
    """Raise the butt of the cue: 5° a notch, 1° with Shift."""
    step = 1 if pygame.key.get_mods() & pygame.KMOD_SHIFT else 5
    return Action("tilt", str(step * steps))


# -- power ---------------------------------------------------------------------------------------


def power_key(sight: Sight) -> Hashable:
    """What the power bar depends on."""
    return sight.session.aim.power, sight.session.aim.strongest


def power_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw the power bar, with more room for slow shots than for fast ones."""
    w, speed, most = sight.words, sight.session.aim.power, sight.session.aim.strongest
    value = number(speed) if speed is not None else "–"
    part = share(speed or 0.0, most)
    ticks = [(share(v, most), str(v) if v in NAMED else "") for v in TICKS if v <= most]
    args = (w["power"], value, w["unit.speed"], part, ticks)
    return gauges.power(surface, rect, sight.type, *args)


def power_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action:
    """The speed at a point of the bar."""
    track = gauges.power_track(rect, sight.layout.s)
    part = (at[0] - track.x - track.h / 2) / (track.w - track.h)
    most = sight.session.aim.strongest
    return Action("power", f"{speed_at(part, most):.2f}" if part < 1.0 else f"{most:g}")


def power_wheel(steps: int, sight: Sight) -> Action:
    """0.5 m/s a notch, 0.1 with Shift, 0.01 with Ctrl."""
    return stepped("push", 0.5, steps)


# -- thickness -----------------------------------------------------------------------------------


def _contact(sight: Sight) -> FirstContact | None:
    seen = sight.session.preview if sight.settings.aids != "off" else None
    return seen.contact if seen else None


def thickness_key(sight: Sight) -> Hashable:
    """What the card of the thickness depends on."""
    session, aids = sight.session, sight.settings.aids
    called = session.contest.match.call if session.contest is not None else None
    return session.preview is None, _contact(sight), aids, sight.spread.share, called


def thickness_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    """Draw how full the first ball is met, and a row of exact eighths to choose from."""
    w, contact, session = sight.words, _contact(sight), sight.session
    if contact is None:
        return _nothing_met(surface, rect, sight)
    colour = sight.look(contact.ball).ui
    if pot_card.wanted(session):
        pot_card.draw(surface, rect, sight)
    else:
        cut = w["thickness.cut"].format(angle=number(contact.cut, 1))
        items = [(eighths(contact.overlap), cut)]
        if (share_made := sight.spread.share) is not None:
            items.append((f"{round(100 * share_made)} %", w["spread.made"].format(angle=ANGLE)))
        args = (w["thickness"], items, contact.overlap, colour)
        gauges.thickness(surface, rect, sight.type, *args)
    gauges.eighths(surface, rect, sight.type, contact.overlap, colour)
    return rect


def thickness_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    """An exact eighth."""
    for place, box in enumerate(gauges.eighth_boxes(rect, sight.layout.s)):
        if box.collidepoint(at):
            return Action("thick", gauges.EIGHTHS_SHOWN[place])
    return None


def thickness_wheel(steps: int, sight: Sight) -> Action:
    """The next exact eighth."""
    return Action("thicker", 1 if steps > 0 else -1)


def _nothing_met(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    s, t, w = sight.layout.s, sight.type, sight.words
    cards.card(surface, rect, s)
    t.draw(surface, w["thickness"], (rect.x + 12 * s, rect.y + 24 * s), 13, TEXT_SOFT)
    known = sight.session.preview is not None and sight.settings.aids != "off"
    said = pot_card.called(sight.session, w) or (w["thickness.free"] if known else "–")
    t.draw(surface, said, (rect.x + 12 * s, rect.y + 56 * s), 15, TEXT_SOFT)
    return rect


def eighths(overlap: float) -> str:
    """The thickness to the nearest eighth, in lowest terms: "<1/8" "1/8" "1/2" "1"."""
    n, d = round(abs(overlap) * EIGHTHS), EIGHTHS
    while n and n % 2 == 0 and d > 1:
        n, d = n // 2, d // 2
    return "<1/8" if n == 0 else str(n) if d == 1 else f"{n}/{d}"


def parts(layout: Layout) -> list[Panel]:
    """The cards, from the top."""
    tip = tip_key, tip_draw, tip_touch, True, "aim", 0, tip_wheel
    power = power_key, power_draw, power_touch, True, "aim", 0, power_wheel
    thickness = thickness_key, thickness_draw, thickness_touch, False, "aim", 0, thickness_wheel
    return [
        Panel("tip", layout.tip, *tip),
        Panel("power", layout.power, *power),
        Panel("thickness", layout.thickness, *thickness),
    ]
