"""The rows of the settings page: what each can be, what it is, and the action that changes it."""

from __future__ import annotations

from typing import NamedTuple

from game.input.bindings import DEFAULTS
from game.session.action import Action
from game.session.commands import COMMANDS
from game.session.session import Session
from game.settings.settings import CHOICES, LOUDEST, Settings
from game.table.presets import CAROM, LAWS, POOL


class SettingsRow(NamedTuple):
    """A row of the settings page.

    name  of what it chooses
    kind  "choice" "switch" "slider" or "key"
    keys  its choices
    gap   does a group of rows begin with it?
    """

    name: str
    kind: str
    keys: tuple[str, ...] = ()
    gap: bool = False


SWITCH = ("off", "on")
FREE_TABLES = (*CAROM, *POOL, "snooker", "pyramid")
"""As many as there is room for; the menu has them all."""
CHOSEN: tuple[SettingsRow, ...] = (
    SettingsRow("language", "choice", CHOICES["language"]),
    SettingsRow("table", "choice", FREE_TABLES, gap=True),
    SettingsRow("cloth", "choice", CHOICES["cloth"]),
    SettingsRow("law", "choice", tuple(LAWS)),
    SettingsRow("engine", "choice", CHOICES["engine"]),
    SettingsRow("squirt", "choice", CHOICES["squirt"]),
    SettingsRow("aids", "choice", CHOICES["aids"], gap=True),
    SettingsRow("level", "choice", CHOICES["level"]),
    SettingsRow("diamonds", "choice", CHOICES["diamonds"]),
    SettingsRow("colours", "choice", CHOICES["colours"]),
    SettingsRow("still", "switch", SWITCH),
    SettingsRow("sound", "switch", SWITCH, gap=True),
    SettingsRow("volume", "slider", tuple(str(n) for n in range(LOUDEST + 1))),
)
KEYS: tuple[SettingsRow, ...] = tuple(SettingsRow(name, "key") for name in DEFAULTS)
ROWS = CHOSEN + KEYS


def current(row: SettingsRow, session: Session, settings: Settings) -> str:
    """Return which of a row's keys is chosen; of none ("own" laws, a scene) some other word."""
    if (command := COMMANDS.get(row.name)) and command.kept:
        return str(getattr(session, row.name))
    if row.name == "sound":
        return SWITCH[not settings.muted]
    if row.name == "still":
        return SWITCH[settings.still]
    return str(getattr(settings, row.name))


def chosen(row: SettingsRow, key: str, now: str) -> Action | None:
    """Return what makes `key` the choice of a row that is at `now`; None if it is already."""
    if key == now:
        return None
    if row.kind == "switch":
        return Action("mute" if row.name == "sound" else row.name)
    return Action(row.name, int(key) if row.kind == "slider" else key)


def beside(row: SettingsRow, now: str, step: int) -> str:
    """Return the key `step` places on: round the end, but not on a slider."""
    if now not in row.keys:
        return row.keys[0]
    place = row.keys.index(now) + step
    if row.kind == "slider":
        return row.keys[min(max(place, 0), len(row.keys) - 1)]
    return row.keys[place % len(row.keys)]
