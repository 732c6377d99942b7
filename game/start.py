"""What a game begins with beside its balls: settings, and a record that is written or played."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from .options import Options
from .play import Game, Notice
from .preferences import Preferences
from .record import Record, Recorder
from .replay import Replay
from .settings import Store

if TYPE_CHECKING:
    from .app import App

WINDOWLESS = ("dummy", "offscreen")
"""SDL's video drivers that show nothing."""
DIFFERS = 3
"""Exit code of a replay that came out differently."""


def preferences(options: Options) -> Preferences:
    """Return the player's own, or the usual ones where nobody looks or the game is a script's."""
    windowless = os.environ.get("SDL_VIDEODRIVER") in WINDOWLESS
    if options.settings is None and (windowless or options.virtual or options.headless):
        return Preferences()
    store = Store(Path(options.settings) if options.settings else None)
    return Preferences(store.load(), store)


def journal(options: Options, game: Game, played: Record | None) -> Recorder | Replay | None:
    """Return what is to look on: a replay, a recorder, or nobody."""
    if played is not None:
        return Replay(played, game)
    return Recorder(options.record, options, game) if options.record else None


def greet(app: App) -> None:
    """Say once that the settings were broken."""
    store = app.preferences.store
    if store is not None and store.faults:
        app.game.notice = Notice("settings.broken")


def told(replay: Replay | None) -> int:
    """Say how a replay came out; returns the exit code."""
    if replay is None:
        return 0
    differs = replay.differs is not None
    out = sys.stderr if differs else sys.stdout
    print(f"replay of {replay.record.name}: {replay.verdict()}", file=out)
    return DIFFERS if differs else 0
