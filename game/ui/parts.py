"""Parts of the window around the table: a rectangle, a key that says how it looks, a picture."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from dataclasses import dataclass

import pygame

from game.actions import Action
from game.aim import BOXES, MINUS, MOST, Fault, shown
from game.play import Game
from game.preferences import Preferences
from game.render import cards, fields, icons
from game.render.layout import Layout
from game.render.text import Type
from game.settings import Settings
from game.spread import Spread
from game.text import words

from . import prompts
from .touch import Pointer

Place = tuple[float, float]


@dataclass(slots=True)
class Sight:
    """Everything a part draws from."""

    game: Game
    layout: Layout
    type: Type
    pointer: Pointer
    preferences: Preferences
    spread: Spread
    mode: str = "aim"
    """The right column: "aim" shows the next shot, "after" the last one."""
    portrait: Callable[[int], pygame.Surface] | None = None
    """The picture of a ball, by its place among the balls, for lists and plates."""

    @property
    def words(self) -> dict[str, str]:
        return words(self.game.language)

    @property
    def settings(self) -> Settings:
        return self.preferences.settings


Key = Callable[[Sight], Hashable]
Draw = Callable[[pygame.Surface, pygame.Rect, Sight], pygame.Rect]
Touch = Callable[[Place, pygame.Rect, Sight], Action | None]
Wheel = Callable[[int, Sight], Action | None]


def _no_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    return None


def _no_wheel(steps: int, sight: Sight) -> Action | None:
    return None


@dataclass(frozen=True, slots=True)
class Part:
    """A piece of the window.

    key: what its picture depends on; draw: paints it and returns what it touched; touch: what a
    press of the mouse there means; wheel: what so many notches up mean; `drags` parts are touched
    again while the mouse moves; `mode`: shown in this column only; `spill`: px at s = 1 by which
    the picture may stand out.
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


def box_part(index: int, rect: pygame.Rect) -> Part:
    """One of the five boxes."""

    def key(sight: Sight) -> Hashable:
        return _box_look(index, sight)

    def draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
        value, state, caret, selected = _box_look(index, sight)
        w = sight.words
        unit = w["unit.angle" if BOXES[index] == "angle" else "unit.speed"]
        label = sight.type.fitted(_label(BOXES[index], w), 12, rect.w - 24 * sight.layout.s)
        return fields.field(surface, rect, sight.type, label, value, unit, state, caret, selected)

    def touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
        return Action("edit", index)

    return Part(f"box {index}", rect, key, draw, touch, spill=4)


def _label(box: str, w: dict[str, str]) -> str:
    """The name of a box, and of a spin which way is positive."""
    return " · ".join(w[key] for key in (f"box.{box}", f"sign.{box}") if key in w)


def _box_look(index: int, sight: Sight) -> tuple[str, str, int | None, bool]:
    """Value, state, caret and selection of a box."""
    aim = sight.game.aim
    value = shown(aim.texts[index])
    caret = len(value) if aim.box == index else None
    selected = caret is not None and aim.fresh and bool(value)
    if any(f.box == index for f in aim.shown_faults):
        state = "invalid"
    elif aim.box == index:
        state = "focused"
    elif sight.pointer.over == f"box {index}":
        state = "hover"
    else:
        state = "disabled" if sight.game.moving else "idle"
    return value, state, caret, selected


# -- button and hint -----------------------------------------------------------------------------


def _shoot_look(sight: Sight) -> tuple[str, str, str]:
    """Label, key cap and state of the button."""
    game, w = sight.game, sight.words
    hot = sight.pointer.over == "shoot"
    state = ("pressed" if sight.pointer.down else "hover") if hot else "idle"
    if own := prompts.button(game):
        return w[own[0]], w[own[1]], state
    if game.moving:
        return w["stop"], w["key.space"], state
    if sight.mode == "after":
        return w["next"], w["key.enter"], state
    if game.aim.shown_faults:
        state = "disabled"
    return w["shoot"], w["key.enter"], state


def _shoot_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return fields.button(surface, rect, sight.type, *_shoot_look(sight))


def _shoot_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    if own := prompts.button(sight.game):
        return own[2]
    if sight.game.moving:
        return Action("stop")
    return Action("edit", 0) if sight.mode == "after" else Action("fire")


def why(fault: Fault, w: dict[str, str], pattern: str = "fault") -> str:
    """Say in words what is wrong with a box."""
    reason = w["why." + fault.reason].format(most=f"{MOST[BOXES[fault.box]]:g}")
    return w[pattern].format(box=w["box." + BOXES[fault.box]], why=reason)


def hint(game: Game, w: dict[str, str]) -> tuple[str, bool]:
    """The line of help, or of what went wrong."""
    aim = game.aim
    if game.notice is not None and game.notice.error:
        return w["notice." + game.notice.key], True
    if aim.wrong:
        faults = aim.faults
        return (why(faults[0], w, "wrong"), True) if faults else (w["wrong.mended"], True)
    if aim.shown_faults:
        return why(aim.shown_faults[0], w), True
    if game.notice is not None:
        return w["notice." + game.notice.key], False
    return w[prompts.hint(game) or "hint." + _situation(game)], False


def _situation(game: Game) -> str:
    if game.paused:
        return "paused"
    if game.aim.box is not None:
        return "last" if game.aim.box == len(BOXES) - 1 else "editing"
    if game.moving:
        return "moving"
    if game.aim.complete:
        return "ready"
    return "rest" if game.shown_shot else "spent"


def _hint_key(sight: Sight) -> Hashable:
    return hint(sight.game, sight.words)


def _hint_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    return fields.hint(surface, rect, sight.type, *hint(sight.game, sight.words))


# -- engine and read-outs ------------------------------------------------------------------------


def badge(game: Game, w: dict[str, str]) -> tuple[str, str]:
    """Engine and laws in use, and the table."""
    own = w.get("table." + game.table)
    table = own or w["table.scene"].format(name=game.table)
    if getattr(game.world.cushion_law, "creates_energy", False):
        table = f"{w['law.creates']} · {table}"
    return f"{w['engine.' + game.engine]} · {w['law.' + game.law]}", table


TOOLS = {"menu": Action("sheet", "menu"), "mute": Action("mute"), "settings": Action("settings")}
"""The small buttons at the top right of the card, and what they do."""


def _tools(rect: pygame.Rect, sight: Sight) -> dict[str, pygame.Rect]:
    side = round(24 * sight.layout.s)
    left = rect.right - round(6 * sight.layout.s) - len(TOOLS) * side
    return {
        name: pygame.Rect(left + i * side, rect.y + round(5 * sight.layout.s), side, side)
        for i, name in enumerate(TOOLS)
    }


def _engine_key(sight: Sight) -> Hashable:
    return badge(sight.game, sight.words), sight.preferences.audio.silent


def _engine_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    first, second = badge(sight.game, sight.words)
    kept = 24 * len(TOOLS)
    cards.engine(surface, rect, sight.type, first, second, sight.words["corner"], kept=kept)
    pictures = {"mute": "silent" if sight.preferences.audio.silent else "sound"}
    for name, box in _tools(rect, sight).items():
        icons.draw(surface, box, pictures.get(name, name), sight.layout.s)
    return rect


def _engine_touch(at: Place, rect: pygame.Rect, sight: Sight) -> Action | None:
    for name, box in _tools(rect, sight).items():
        if box.collidepoint(at):
            return TOOLS[name]
    if at[0] > rect.right - 70 * sight.layout.s and at[1] > rect.centery:
        return Action("language")
    return Action("engine") if at[1] < rect.centery else Action("law")


def _readouts_key(sight: Sight) -> Hashable:
    return tuple(number(v) for v in sight.game.readout)


def _readouts_draw(surface: pygame.Surface, rect: pygame.Rect, sight: Sight) -> pygame.Rect:
    w = sight.words
    names = (w["read.v"], w["read.w"], w["read.wz"])
    values = (number(v) for v in sight.game.readout)
    items = [(name, value, w["unit.speed"]) for name, value in zip(names, values, strict=True)]
    return cards.readouts(surface, rect, sight.type, items)


def fixed_parts(layout: Layout) -> list[Part]:
    """The parts that every state of the game shows."""
    return [
        *(box_part(i, rect) for i, rect in enumerate(layout.fields)),
        Part("shoot", layout.shoot, _shoot_look, _shoot_draw, _shoot_touch),
        Part("hint", layout.hint, _hint_key, _hint_draw),
        Part("engine", layout.engine, _engine_key, _engine_draw, _engine_touch),
        Part("read", layout.readouts, _readouts_key, _readouts_draw, mode="aim"),
        Part("read after", layout.readouts_after, _readouts_key, _readouts_draw, mode="after"),
    ]
