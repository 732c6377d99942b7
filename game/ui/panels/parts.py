"""Parts of the window around the table: a rectangle, a key that says how it looks, a picture."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass

import pygame

from game.aim import advice
from game.aim.entry import BOXES, MINUS, MOST, Fault, shown
from game.render.layout import Layout
from game.render.parts import cards, fields, icons
from game.render.parts.text_line import TextLine
from game.render.theme import ACCENT, TEXT_SOFT
from game.session.action import Action
from game.session.notice import Notice
from game.session.session import Session
from game.table.own_table import is_own
from game.ui.names import scene_name
from game.ui.sight import Place, Sight
from game.ui.table.looks import ball_words

from . import coach_words, launch_card, prompts, tray, warning

WARNINGS = ("miscue",)
"""Notices of something that was put right, so that the shot can be played."""


Key = Callable[[Sight], Hashable]
Draw = Callable[[pygame.Surface, pygame.Rect, Sight], pygame.Rect]
Touch = Callable[[Place, pygame.Rect, Sight], Action | None]
Wheel = Callable[[int, Sight], Action | None]


def _no_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    return None


def _no_wheel(steps: int, sight: Sight) -> Action | None:
    return None


@dataclass(frozen=True, slots=True)
class Panel:
    """A piece of the window.

    name   what the mouse's `over` and `held` call it
    rect   where it is
    key    what its picture depends on
    draw   paints it and returns what it touched
    touch  what a press of the mouse there means
    drags  is it touched again while the mouse moves?
    mode   of the column in which alone it is shown, or several, "" for all
    spill  px at s = 1 by which the picture may stand out
    wheel  what so many notches up mean
    """

    name: str
    rect: pygame.Rect
    key: Key
    draw: Draw
    touch: Touch = _no_touch
    drags: bool = False
    mode: str = ""
    spill: int = 0
    wheel: Wheel = _no_wheel


def number(value: float, places: int = 2) -> str:
    """A number as it is written in the window."""
    text = f"{value:.{places}f}"
    return text.replace("-", MINUS)


# -- the five boxes ------------------------------------------------------------------------------


def box_part(index: int, rect: pygame.Rect) -> Panel:
    """One of the five boxes."""

    def key(sight: Sight) -> Hashable:
        return _box_look(index, sight)

    def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
        line, state = _box_look(index, sight)
        w = sight.words
        unit = _unit(index, w)
        label = sight.type.fitted(_label(BOXES[index], w), 12, rect.w - 24 * sight.layout.s)
        args = (surface, rect, sight.type, label, line.text, unit, state)
        return fields.field(*args, line=line)

    def touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
        return _box_touch(index, at, rect, sight)

    return Panel(f"box {index}", rect, key, draw, touch, spill=4)


def _label(box: str, w: dict[str, str]) -> str:
    """The name of a box, and of a spin which way is positive."""
    return " · ".join(w[key] for key in (f"box.{box}", f"sign.{box}") if key in w)


def _box_touch(index: int, at: Place, rect: pygame.Rect, sight: Sight) -> Action:
    """The first press begins to edit all of the box, the next one chooses a place in it."""
    edited = sight.session.aim.edited
    if edited is None or sight.session.aim.box != index:
        return Action("edit", index)
    unit, text = _unit(index, sight.words), shown(edited.text)
    return Action("caret", fields.caret_at(rect, sight.type, text, at[0], unit, edited.caret))


def _unit(index: int, w: dict[str, str]) -> str:
    return w["unit.angle" if BOXES[index] == "angle" else "unit.speed"]


def _box_look(index: int, sight: Sight) -> tuple[TextLine, str]:
    """What is in a box, and its state."""
    aim = sight.session.aim
    line, edited = TextLine(shown(aim.texts[index])), aim.box == index
    if edited and aim.edited is not None:
        line = sight.line(aim.edited)._replace(text=line.text)
    if any(f.box == index for f in aim.shown_faults):
        state = "invalid"
    elif edited:
        state = "focused"
    elif sight.pointer.over == f"box {index}":
        state = "hover"
    else:
        state = "disabled" if sight.session.moving else "idle"
    return line, state


# -- button and hint -----------------------------------------------------------------------------


def _shoot_look(sight: Sight) -> tuple[str, str, str]:
    """Label, key cap and state of the button."""
    session, w = sight.session, sight.words
    hot = sight.pointer.over == "shoot"
    state = ("pressed" if sight.pointer.down else "hover") if hot else "idle"
    label, cap, action = prompts.button(session)
    if action is None or (action.name in ("fire", "next") and session.aim.shown_faults):
        state = "disabled"
    return w[label], w[cap] if cap else "", state


def _shoot_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return fields.button(surface, rect, sight.type, *_shoot_look(sight))


def _shoot_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    return prompts.button(sight.session)[2]


def why(fault: Fault, w: dict[str, str], pattern: str = "fault") -> str:
    """Say in words what is wrong with a box."""
    reason = w["why." + fault.reason].format(most=f"{MOST[BOXES[fault.box]]:g}")
    return w[pattern].format(box=w["box." + BOXES[fault.box]], why=reason)


def hint(session: Session, w: dict[str, str]) -> tuple[str, bool]:
    """The line of help, or of what went wrong."""
    aim = session.aim
    if session.notice is not None and session.notice.error:
        return _noticed(session.notice, session, w), True
    if aim.wrong:
        faults = aim.faults
        return (why(faults[0], w, "wrong"), True) if faults else (w["wrong.mended"], True)
    if aim.shown_faults:
        return why(aim.shown_faults[0], w), True
    if session.notice is not None:
        return _noticed(session.notice, session, w), False
    return w[prompts.hint(session) or "hint." + _situation(session)], False


def _noticed(notice: Notice, session: Session, w: dict[str, str]) -> str:
    if notice.key == "coach.found":
        return coach_words.said(advice.read(notice.about), w)
    names = {"law": w[f"law.{session.law}"], "engine": w[f"engine.{session.engine}"]}
    names["level"] = w.get(f"set.level.{notice.about}", "")
    names["ball"] = ball_words(notice.about, w) if notice.about else ""
    names["about"] = notice.about
    return w[f"notice.{notice.key}"].format(*notice.about.split(), **names)


def _situation(session: Session) -> str:
    if session.paused:
        return "paused"
    if session.aim.box is not None:
        return "last" if session.aim.box == len(BOXES) - 1 else "editing"
    if session.moving:
        return "moving"
    if session.aim.complete:
        return "ready"
    return "rest" if session.shown_shot else "spent"


def _hint_look(sight: Sight) -> tuple[str, bool, bool]:
    """The line, whether it is an error, and whether it warns of what is done all the same."""
    notice = sight.session.notice
    if notice is None and (said := warning.of(sight)):
        return said, False, True
    return *hint(sight.session, sight.words), notice is not None and notice.key in WARNINGS


def _hint_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return fields.hint(surface, rect, sight.type, *_hint_look(sight))


# -- engine and read-outs ------------------------------------------------------------------------


def badge(session: Session, w: dict[str, str]) -> tuple[str, str]:
    """Engine and laws in use, and the table."""
    key = "own" if is_own(session.table) else session.table
    table = w.get("table." + key) or scene_name(key, w, session.language)
    if getattr(session.world.cushion_law, "creates_energy", False):
        table = f"{w['law.creates']} · {table}"
    return f"{w['engine.' + session.engine]} · {w['law.' + session.law]}", table


def _short_badge(session: Session, w: dict[str, str]) -> str:
    """Engine and laws where there is little room: neither is left out."""
    law = w.get(f"set.law.{session.law}") or w[f"law.{session.law}"]
    return f"{w['engine.short.' + session.engine]} · {law}"


TOOLS = {
    "coach": Action("coach", 1),
    "sketch": Action("sketch"),
    "menu": Action("sheet", "menu"),
    "mute": Action("mute"),
    "settings": Action("settings"),
}
"""The small buttons at the top right of the card, and what they do."""
TOOL = 20
"""Side of one, px at s = 1."""


def _tools(rect: pygame.Rect, sight: Sight) -> dict[str, pygame.Rect]:
    side = round(TOOL * sight.layout.s)
    left = rect.right - round(6 * sight.layout.s) - len(TOOLS) * side
    return {
        name: pygame.Rect(left + i * side, rect.y + round(7 * sight.layout.s), side, side)
        for i, name in enumerate(TOOLS)
    }


def _engine_key(sight: Sight) -> Hashable:
    session = sight.session
    return badge(session, sight.words), sight.preferences.audio.silent, session.sketching


def _engine_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    first, second = badge(sight.session, sight.words)
    kept = TOOL * len(TOOLS)
    if sight.type.width(first, 13) > rect.w - (42 + kept) * sight.layout.s:
        first = _short_badge(sight.session, sight.words)
    cards.engine(surface, rect, sight.type, first, second, sight.words["corner"], kept=kept)
    pictures = {"mute": "silent" if sight.preferences.audio.silent else "sound"}
    for name, box in _tools(rect, sight).items():
        ink = ACCENT if name == "sketch" and sight.session.sketching else TEXT_SOFT
        icons.draw(surface, box, pictures.get(name, name), sight.layout.s, ink)
    return rect


def _engine_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    for name, box in _tools(rect, sight).items():
        if box.collidepoint(at):
            return TOOLS[name]
    if at[0] > rect.right - 70 * sight.layout.s and at[1] > rect.centery:
        return Action("language")
    return Action("engine") if at[1] < rect.centery else Action("law")


def _readouts_key(sight: Sight) -> Hashable:
    if sight.mode != "after" and tray.wanted(sight.session):
        return tray.key(sight)
    if launch_card.wanted(sight):
        return launch_card.key(sight)
    return tuple(number(v) for v in sight.session.readout)


def _readouts_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    if sight.mode != "after" and tray.wanted(sight.session):
        return tray.draw(surface, rect, sight)
    if launch_card.wanted(sight):
        return launch_card.draw(surface, rect, sight)
    w = sight.words
    names = (w["read.v"], w["read.w"], w["read.wz"])
    values = (number(v) for v in sight.session.readout)
    items = [(name, value, w["unit.speed"]) for name, value in zip(names, values, strict=True)]
    return cards.readouts(surface, rect, sight.type, items)


def fixed_parts(layout: Layout) -> list[Panel]:
    """The parts that every state of the game shows."""
    return [
        *(box_part(i, rect) for i, rect in enumerate(layout.fields)),
        Panel("shoot", layout.shoot, _shoot_look, _shoot_draw, _shoot_touch),
        Panel("hint", layout.hint, _hint_look, _hint_draw),
        Panel("engine", layout.engine, _engine_key, _engine_draw, _engine_touch),
        Panel("read", layout.readouts, _readouts_key, _readouts_draw, mode="aim asked"),
        Panel("read after", layout.readouts_after, _readouts_key, _readouts_draw, mode="after"),
    ]
