"""What keys mean in a text field, the same in each: moving the caret, deleting, the clipboard."""

from __future__ import annotations

import pygame

from game.session.action import Action
from game.text.text_field import TextField
from game.window import clipboard

COMMAND = pygame.KMOD_CTRL | pygame.KMOD_META
STEPS = {
    pygame.K_LEFT: ("left", "back"),
    pygame.K_RIGHT: ("right", "ahead"),
    pygame.K_HOME: ("home", "home"),
    pygame.K_END: ("end", "end"),
}
"""Where the caret goes without Ctrl, and with it."""
WITH_COMMAND = {
    pygame.K_a: Action("caret", "all"),
    pygame.K_c: Action("copy"),
    pygame.K_x: Action("cut"),
    pygame.K_v: Action("paste"),
    pygame.K_INSERT: Action("copy"),
}
WITH_SHIFT = {pygame.K_INSERT: Action("paste"), pygame.K_DELETE: Action("cut")}
DELETING = {pygame.K_BACKSPACE: Action("erase"), pygame.K_DELETE: Action("delete")}


def of_key(event: pygame.event.Event) -> Action | None:
    """Return what a KEYDOWN means in a text field; None for a key that fields do not have.

    erase · delete · caret WHERE, as the methods of `TextField`; copy · cut · paste.
    """
    key, mod = event.key, getattr(event, "mod", 0)
    if mod & pygame.KMOD_ALT:
        return None
    shift, command = bool(mod & pygame.KMOD_SHIFT), bool(mod & COMMAND)
    if key in STEPS:
        return Action("caret", ("+" if shift else "") + STEPS[key][command])
    if command:
        return WITH_COMMAND.get(key)
    return (WITH_SHIFT.get(key) if shift else None) or DELETING.get(key)


def with_clipboard(action: Action | None, field: TextField) -> Action | None:
    """Return what is to be done to the field itself: copying is done here, pasting is typing."""
    match action:
        case Action("paste"):
            text = " ".join(clipboard.get().split())
            return Action("type", text) if text else None
        case Action("copy" | "cut" as name):
            copied = bool(field.selected) and clipboard.put(field.selected)
            return Action("erase") if name == "cut" and copied else None
    return action


def do(field: TextField, action: Action) -> bool:
    """Do to a field what a key means; returns whether there was room for what was typed."""
    match action:
        case Action("type", text):
            return field.type(str(text))
        case Action("caret", to) if to is not None:
            field.go(to)
        case Action("erase"):
            field.erase()
        case Action("delete"):
            field.delete()
    return True
