"""What a game begins with beside its balls: a display, settings, a record to write or to play."""

from __future__ import annotations

import os
import sys
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import pygame

from .app import App, prepare_environment
from .contradictions import LAID
from .options import Options
from .replay.recorder import Recorder
from .session.action import Action
from .settings import user_files
from .settings.preferences import Preferences
from .settings.settings import Store
from .table import library
from .ui.pages.menu import MenuPage

if TYPE_CHECKING:
    from .replay.replay import Replay

WINDOWLESS = ("dummy", "offscreen")
"""SDL's video drivers that show nothing."""
ENDLESS = 10**9
"""Frames: half a year."""
DIFFERS = 3
"""Exit code of a replay that came out differently."""
SEEN = frozenset({"frames", "script", "screenshot", "stats"})
"""Options with which a replay is drawn even where no window is shown."""


def windowless() -> bool:
    """Has the user asked SDL for a driver that shows nothing?"""
    return os.environ.get("SDL_VIDEODRIVER", "").lower() in WINDOWLESS


def unseen(options: Options) -> bool:
    """Is it a replay that nobody can watch, so that it need not be drawn?"""
    return options.headless or bool(options.replay and windowless() and not SEEN & options.given)


def watched(options: Options) -> Options:
    """Return the options of a replay in a window; where there is none, it ends with the record."""
    return replace(options, frames=options.frames or ENDLESS) if windowless() else options


def display(options: Options) -> None:
    """Let SDL find a display; ValueError says why there is none.

    Without one SDL takes a driver that shows nothing: the game would run for ever, unseen. It may
    only where that was asked for, or after so many frames is over.
    """
    prepare_environment()
    try:
        pygame.display.init()
    except pygame.error as error:
        raise ValueError(f"cannot open a window: {error}") from None
    if pygame.display.get_driver() in WINDOWLESS and not (windowless() or options.virtual):
        pygame.display.quit()
        names = ("DISPLAY", "WAYLAND_DISPLAY")
        found = [f"{n} is {os.environ[n]!r}" if n in os.environ else f"no {n}" for n in names]
        without = "SDL_VIDEODRIVER=dummy runs without a window"
        raise ValueError(f"cannot open a window: no display ({', '.join(found)}); {without}")


def preferences(options: Options) -> Preferences:
    """Return the player's own, or the usual ones where nobody looks or the game is a script's.

    Watching a replay, they are read and never written. ValueError for --settings that is no file.
    """
    if options.settings is None and (windowless() or options.virtual or options.headless):
        return Preferences()
    path = Path(options.settings) if options.settings else None
    if path is not None:
        try:
            user_files.regular(path)
        except OSError as error:
            why = error.strerror or error
            raise ValueError(f"cannot keep settings in {options.settings!r}: {why}") from None
    store = Store(path)
    return Preferences(store.read()) if options.replay else Preferences(store.load(), store)


def kept_in(options: Options, preferences: Preferences) -> Path | None:
    """Return the folder in which matches and figures are kept; None where nothing is."""
    if preferences.store is None or options.replay:
        return None
    return library.folder()


def greet(app: App) -> None:
    """Say once that the settings were broken, or that there is no place for them; where nothing
    else was asked for, offer the match that can be gone on with."""
    if app.preferences.settings.squirt == "on" and app.replay is None:
        app.perform(Action("squirt", "on"))
    begun = {*LAID, "script"} & app.options.given
    if not begun and app.keeper.offered():
        app.perform(Action("sheet", "menu"))
        menu = app.view.pages["menu"]
        if isinstance(menu, MenuPage):
            menu.offer()
    elif app.keeper.matches.faulty:
        app.session.say("match.broken")
    if not begun and newcomer(app):
        app.view.guide.over = app.preferences.guided
        app.view.guide.begin(app.session)
    store = app.preferences.store
    if store is not None and (store.trouble or store.path is None):
        app.session.say("settings.unsaved", error=True)
    elif store is not None and store.faults:
        app.session.say("settings.broken")


def newcomer(app: App) -> bool:
    """Is it the player's very first game, in a window that can be seen?"""
    store, options = app.preferences.store, app.options
    seen = not (windowless() or options.virtual or options.replay)
    first = store is not None and store.path is not None and not store.path.exists()
    return seen and first and not app.preferences.settings.guided


def regret(app: App) -> int:
    """Say what could not be kept; returns the exit code: 2 for a record that was cut off."""
    store, journal = app.preferences.store, app.journal
    if store is not None and store.trouble:
        print(f"danggu: settings were not saved in {store.path}: {store.trouble}", file=sys.stderr)
    fault = journal.fault if isinstance(journal, Recorder) else ""
    if fault:
        print(f"danggu: {fault}", file=sys.stderr)
    return 2 if fault else 0


def outcome(replay: Replay) -> int:
    """Say how a replay came out; returns the exit code."""
    differs = replay.differs is not None
    out = sys.stderr if differs else sys.stdout
    print(f"replay of {replay.record.name}: {replay.verdict()}", file=out)
    return DIFFERS if differs else 0
