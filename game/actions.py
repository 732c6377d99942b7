"""Actions: what the player means, as small values that can be logged, written down and replayed."""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import pygame

from .aim import BOXES, typed


class Action(NamedTuple):
    """One thing the player wants; `value` is its argument, if it has one.

    edit BOX · clear · type TEXT · erase · enter · leave · shoot · fire · place · stop · retry ·
    pause · frame · skip · help · settings · set "BOX NUMBER ..." · quit ·
    engine KEY · law KEY · cloth KEY · table KEY · language KEY (no key: the next one)
    """

    name: str
    value: str | int | None = None


ALWAYS = {
    pygame.K_F1: Action("help"),
    pygame.K_F2: Action("language"),
    pygame.K_F3: Action("settings"),
}
PLAY = {
    pygame.K_LEFT: Action("edit", 0),
    pygame.K_RIGHT: Action("clear"),
    pygame.K_DOWN: Action("place"),
    pygame.K_SPACE: Action("stop"),
    pygame.K_RETURN: Action("shoot"),
    pygame.K_KP_ENTER: Action("shoot"),
    pygame.K_TAB: Action("edit", 0),
    pygame.K_p: Action("pause"),
    pygame.K_PERIOD: Action("frame"),
    pygame.K_e: Action("engine"),
    pygame.K_l: Action("law"),
    pygame.K_r: Action("retry"),
    pygame.K_a: Action("aids"),
    pygame.K_m: Action("mute"),
    pygame.K_END: Action("skip"),
}
EDITING = {
    pygame.K_RETURN: Action("enter"),
    pygame.K_KP_ENTER: Action("enter"),
    pygame.K_BACKSPACE: Action("erase"),
    pygame.K_ESCAPE: Action("leave"),
}


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
    if mod & (pygame.KMOD_CTRL | pygame.KMOD_ALT | pygame.KMOD_META):
        return None
    if key == pygame.K_TAB:
        return _tab(box, bool(mod & pygame.KMOD_SHIFT))
    text = "" if texts else getattr(event, "unicode", "")
    if box is not None:
        return EDITING.get(key) or _characters(text)
    return play.get(key) or _first_character(text)


def of_text(event: pygame.event.Event, box: int | None) -> Action | None:
    """What a TEXTINPUT means: characters for a box, if any of them fit into one."""
    return _characters(event.text) if box is not None else _first_character(event.text)


def _tab(box: int | None, back: bool) -> Action:
    if box is None:
        return Action("edit", len(BOXES) - 1 if back else 0)
    return Action("edit", (box + (-1 if back else 1)) % len(BOXES))


def _first_character(text: str) -> Action | None:
    """A digit or a sign in play begins an entry; `.` and `e` are shortcuts there."""
    return None if text in (".", "e") else _characters(text)


def _characters(text: str) -> Action | None:
    text = typed(text)
    return Action("type", text) if text else None
