"""Tables of keys: which action each means, in play, in a box, and with Shift, Ctrl or Alt."""

from __future__ import annotations

from collections.abc import Mapping

import pygame

from game.aim.entry import BOXES, typed
from game.session.action import Action
from game.session.commands import TABLE

from .editing import COMMAND

_CONSTANTS = sorted((n[2:].lower(), c) for n, c in vars(pygame).items() if n.startswith("K_"))
CODES: dict[str, int] = dict(_CONSTANTS)
NAMES: dict[int, str] = {code: name for name, code in reversed(_CONSTANTS)}
"""Keys by pygame's names for them and back, small letters: "left" "f1" "period" "p"."""


def usual(*, always: bool) -> dict[int, Action]:
    """What keys do by default: those that work everywhere, or those of play."""
    return {
        CODES[key.name]: Action(command.name, key.value)
        for command in TABLE
        for key in command.keys
        if key.always == always
    }


ALWAYS, PLAY = usual(always=True), usual(always=False)
EDITING = {
    pygame.K_RETURN: Action("enter"),
    pygame.K_KP_ENTER: Action("enter"),
    pygame.K_ESCAPE: Action("leave"),
}

FINER = {command.name: command.finer for command in TABLE if command.finer}
"""What these take a step of with Shift and with Ctrl, degrees and m/s."""
SHIFTED = {
    Action(command.name, key.value): key.shift
    for command in TABLE
    for key in command.keys
    if key.shift is not None
}
SIDEWAYS = {pygame.K_LEFT: 1, pygame.K_RIGHT: -1}
CUE = {
    pygame.K_LEFT: ("nudge", "-{} 0", "0.05", "0.01"),
    pygame.K_RIGHT: ("nudge", "{} 0", "0.05", "0.01"),
    pygame.K_UP: ("nudge", "0 {}", "0.05", "0.01"),
    pygame.K_DOWN: ("nudge", "0 -{}", "0.05", "0.01"),
    pygame.K_PAGEUP: ("tilt", "{}", "5", "1"),
    pygame.K_PAGEDOWN: ("tilt", "-{}", "5", "1"),
}
"""Keys that move the cue while Alt is held: action, value, and its step without and with Shift."""
COMMANDED = {
    pygame.K_z: Action("undo"),
    pygame.K_y: Action("redo"),
    pygame.K_s: Action("sheet", "save"),
    pygame.K_o: Action("sheet", "shots"),
}
"""What Ctrl makes of letters in play and in boxes, whatever they mean without."""
FIRST = frozenset("0123456789+-")
"""Characters with which an entry may begin in play."""
KEYPAD = {getattr(pygame, f"K_KP{n}"): str(n) for n in range(10)}
"""Digits of the number pad: without text input they come without a character."""


def of_key(
    event: pygame.event.Event,
    box: int | None,
    texts: bool,
    play: Mapping[int, Action] = PLAY,
    always: Mapping[int, Action] = ALWAYS,
) -> Action | None:
    """Return what a KEYDOWN means while `box` is edited, or in play (None).

    `texts` says that a TEXTINPUT follows for each character: then the key itself is none. `play`
    and `always` are the tables of keys in use.
    """
    key, mod = event.key, getattr(event, "mod", 0)
    if key in always:
        return always[key]
    if key in (pygame.K_RETURN, pygame.K_KP_ENTER) and mod & pygame.KMOD_CTRL:
        return Action("fire")
    if mod & COMMAND and not mod & pygame.KMOD_ALT and key in COMMANDED:
        back = key == pygame.K_z and mod & pygame.KMOD_SHIFT
        return Action("redo") if back else COMMANDED[key]
    if box is None and mod & (pygame.KMOD_SHIFT | pygame.KMOD_CTRL | pygame.KMOD_ALT):
        special = _modified(key, mod, play)
        if special is not None:
            return special
    if mod & (pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META):
        return None
    if key == pygame.K_TAB:
        return _tab(box, bool(mod & pygame.KMOD_SHIFT))
    text = "" if texts else character(event)
    if box is not None:
        return EDITING.get(key) or _characters(text)
    return play.get(key) or _first_character(text)


def character(event: pygame.event.Event) -> str:
    """Return the character that a KEYDOWN gives where no TEXTINPUT follows, or ""."""
    return getattr(event, "unicode", "") or KEYPAD.get(event.key, "")


def _modified(key: int, mod: int, play: Mapping[int, Action]) -> Action | None:
    """What a key means in play with Shift, Ctrl or Alt held."""
    shift, ctrl = bool(mod & pygame.KMOD_SHIFT), bool(mod & pygame.KMOD_CTRL)
    if mod & pygame.KMOD_ALT:
        if ctrl or key not in CUE:
            return None
        name, value, step, finer = CUE[key]
        return Action(name, value.format(finer if shift else step))
    if key in SIDEWAYS:
        return finer_step("turn", SIDEWAYS[key], ctrl)
    action = play.get(key)
    if action is None:
        return None
    if action.name in FINER:
        return finer_step(action.name, -1 if str(action.value).startswith("-") else 1, ctrl)
    if ctrl and action.name in ("undo", "redo"):
        return Action("redo") if shift else action
    return SHIFTED.get(action) if shift and not ctrl else None


def finer_step(name: str, way: int, finest: bool) -> Action:
    """A small step of an action that way (1 or -1)."""
    return Action(name, ("" if way > 0 else "-") + FINER[name][finest])


def of_text(event: pygame.event.Event, box: int | None) -> Action | None:
    """What a TEXTINPUT means: characters for a box, or in play the beginning of an entry."""
    return _characters(event.text) if box is not None else _first_character(event.text)


def _tab(box: int | None, back: bool) -> Action:
    if box is None:
        return Action("edit", len(BOXES) - 1 if back else 0)
    return Action("edit", (box + (-1 if back else 1)) % len(BOXES))


def _first_character(text: str) -> Action | None:
    """A digit or a sign in play begins an entry; all else is a shortcut there, or nothing."""
    return _characters(text) if typed(text)[:1] in FIRST else None


def _characters(text: str) -> Action | None:
    text = typed(text)
    return Action("type", text) if text else None
