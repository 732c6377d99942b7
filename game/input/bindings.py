"""Keys: which one does what, as the player has set them.

Keys that move between boxes or mend what is in them are fixed. Every other one of the
table of commands does one thing, and the player may choose another key for that.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import pygame

from game.session.action import Action

from .key_tables import ALWAYS, CODES, NAMES, PLAY


def _codes(*names: str) -> frozenset[int]:
    return frozenset(getattr(pygame, f"K_{name}") for name in names)


FIXED = _codes("RETURN", "KP_ENTER", "TAB", "ESCAPE", "BACKSPACE", "UNKNOWN") | _codes(
    "LSHIFT", "RSHIFT", "LCTRL", "RCTRL", "LALT", "RALT", "LMETA", "RMETA", "CAPSLOCK",
    "NUMLOCKCLEAR", "MODE",
)  # fmt: skip
"""Keys with a meaning of their own."""
BEGIN = _codes(
    *"0123456789", *(f"KP{n}" for n in range(10)), "PLUS", "MINUS", "EQUALS", "KP_PLUS", "KP_MINUS"
)
"""Keys that begin an entry: they type into boxes from play as well."""
TYPE = (
    BEGIN
    | frozenset(range(32, 127))
    | _codes("LEFT", "RIGHT", "HOME", "END", "DELETE", "INSERT")
    | _codes(*(f"KP_{name}" for name in ("PERIOD", "DIVIDE", "MULTIPLY", "EQUALS")))
)
"""Keys that type into a text field that is being edited, or move its caret."""


class Binding(NamedTuple):
    """An action, the key it has by default, and whether that works in boxes too."""

    action: Action
    key: str
    always: bool


def _bindings() -> dict[str, Binding]:
    found: dict[str, Binding] = {}
    for table, always in ((PLAY, False), (ALWAYS, True)):
        for code, action in table.items():
            if code not in FIXED:
                found.setdefault(action.ident, Binding(action, NAMES[code], always))
    return found


DEFAULTS = _bindings()


def refused(name: str, key: str) -> str:
    """Say why an action cannot have a key, whatever the others have: "unknown" "fixed" "types"."""
    if key not in CODES:
        return "unknown"
    if CODES[key] in FIXED:
        return "fixed"
    return "types" if CODES[key] in (TYPE if DEFAULTS[name].always else BEGIN) else ""


class Keys:
    """Every action's key: the default ones but for those in `changed` (action to key name)."""

    def __init__(self, changed: Mapping[str, str] | None = None) -> None:
        self.changed = dict(changed or {})
        self.names = {name: self.changed.get(name, b.key) for name, b in DEFAULTS.items()}
        self.always = self._table(always=True)
        self.play = {c: a for c, a in PLAY.items() if c in FIXED} | self._table(always=False)

    def _table(self, *, always: bool) -> dict[int, Action]:
        chosen = ((name, b) for name, b in DEFAULTS.items() if b.always == always)
        return {CODES[self.names[name]]: b.action for name, b in chosen}

    def owner(self, key: str) -> str | None:
        """Return the action that has a key."""
        return next((name for name, own in self.names.items() if own == key), None)

    def with_key(self, name: str, key: str) -> Keys:
        """Return the keys with another one for an action; ValueError says why that cannot be."""
        why = refused(name, key) or ("taken" if self.owner(key) not in (None, name) else "")
        if why:
            raise ValueError(why)
        return Keys(_changes({**self.changed, name: key}))


def _changes(keys: Mapping[str, str]) -> dict[str, str]:
    return {name: key for name, key in keys.items() if key != DEFAULTS[name].key}


def sound(wanted: Mapping[str, object]) -> tuple[dict[str, str], list[str]]:
    """Return those of `wanted` that can be had together, and the names of the others.

    No two actions get the same key: of those that would, the changed ones go back to their own.
    """
    good = {
        name: key
        for name, key in wanted.items()
        if name in DEFAULTS and isinstance(key, str) and not refused(name, key)
    }
    bad = [name for name in wanted if name not in good]
    while clash := _clash(good):
        bad.append(clash)
        del good[clash]
    return _changes(good), bad


def _clash(changed: Mapping[str, str]) -> str | None:
    """A changed action that has the key of another one."""
    names = {name: changed.get(name, b.key) for name, b in DEFAULTS.items()}
    keys = list(names.values())
    return next((name for name in changed if keys.count(names[name]) > 1), None)
