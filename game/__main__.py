"""Start the game: `danggu` or `python -m game`; `--help` lists the options."""

from __future__ import annotations

import os
import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType, ModuleType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .options import Options
    from .play import Game


def main(arguments: list[str] | None = None) -> int:
    """Play; returns the exit code: 0, or 2 with a message on stderr when that is impossible."""
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    from . import options as command_line

    options = command_line.read(arguments)
    if options.version:
        return _version()
    try:
        with _sigterm_closes_the_window():
            return _play(options)
    except ValueError as error:
        print(f"danggu: {error}", file=sys.stderr)
        return 2


@contextmanager
def _sigterm_closes_the_window() -> Iterator[None]:
    """Take SIGTERM as a QUIT, also before SDL listens; put the old handler back after."""

    def leave(number: int, frame: FrameType | None) -> None:
        pygame = sys.modules.get("pygame")
        if pygame is None or not getattr(pygame, "display", None) or not pygame.display.get_init():
            raise SystemExit(0)
        pygame.event.post(pygame.event.Event(pygame.QUIT, sure=True))

    before = signal.signal(signal.SIGTERM, leave)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


def _pygame() -> ModuleType:
    """Import pygame, which would load setuptools (0.1 s) to find its own icon; it can without."""
    absent = "pkg_resources" not in sys.modules
    if absent:
        sys.modules["pkg_resources"] = None  # type: ignore[assignment]
    import pygame

    if absent:
        del sys.modules["pkg_resources"]
    return pygame


def _version() -> int:
    from importlib.metadata import PackageNotFoundError, version

    pygame = _pygame()

    try:
        own = version("danggu")
    except PackageNotFoundError:
        own = "(not installed)"
    kind = "pygame-ce" if getattr(pygame, "IS_CE", False) else "pygame"
    sdl = ".".join(map(str, pygame.get_sdl_version()))
    print(f"danggu {own}, {kind} {pygame.version.ver}, SDL {sdl}")
    return 0


def _play(options: Options) -> int:
    pygame = _pygame()
    from . import record, start
    from .app import App
    from .replay import headless
    from .script import read

    preferences = start.preferences(options)
    options = preferences.settings.applied(options) if preferences.store else options
    played = record.read(options.replay, options) if options.replay else None
    options = played.setup if played else options
    game = new_game(options)
    if played and options.headless:
        return start.told(headless(played, game))
    script = read(options.script) if options.script else None
    try:
        app = App(game, options, script, preferences, start.journal(options, game, played))
    except pygame.error as error:
        raise ValueError(f"cannot open a window: {error}") from None
    start.greet(app)
    try:
        app.run()
        if options.screenshot:
            app.save(options.screenshot)
    except KeyboardInterrupt:
        pass
    except (pygame.error, OSError) as error:
        raise ValueError(f"cannot save {options.screenshot!r}: {error}") from None
    finally:
        app.close()
    if options.stats:
        print(app.report())
    return start.told(app.replay)


def new_game(options: Options) -> Game:
    """The game that the options ask for."""
    from . import choices, fixture, setup, sitting
    from .play import Game

    world = setup.scene_world(options.scene) if options.scene else setup.table_world(options.table)
    game = Game(world, options.substeps, options.seed, options.scene or options.table)
    game.language = options.lang
    if "engine" in options.given:
        game.match_engine = options.engine
    if options.law:
        choices.law(game, options.law)
    if options.cloth != "table":
        choices.cloth(game, options.cloth)
    if options.engine != "exact":
        choices.engine(game, options.engine)
    if options.setup:
        sitting.line(game, options.setup)
    elif options.game != fixture.FREE:
        sitting.match(game, fixture.asked(options).line())
    return game


if __name__ == "__main__":
    sys.exit(main())
