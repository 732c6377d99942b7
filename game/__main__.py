"""Start the game: `danggu` or `python -m game`; `--help` lists the options."""

from __future__ import annotations

import os
import sys
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
        return _play(options)
    except ValueError as error:
        print(f"danggu: {error}", file=sys.stderr)
        return 2


def _version() -> int:
    from importlib.metadata import PackageNotFoundError, version

    import pygame

    try:
        own = version("danggu")
    except PackageNotFoundError:
        own = "(not installed)"
    kind = "pygame-ce" if getattr(pygame, "IS_CE", False) else "pygame"
    sdl = ".".join(map(str, pygame.get_sdl_version()))
    print(f"danggu {own}, {kind} {pygame.version.ver}, SDL {sdl}")
    return 0


def _play(options: Options) -> int:
    import pygame

    from .app import App
    from .script import read

    script = read(options.script) if options.script else None
    try:
        app = App(new_game(options), options, script)
    except pygame.error as error:
        raise ValueError(f"cannot open a window: {error}") from None
    try:
        app.run()
        if options.screenshot:
            app.save(options.screenshot)
    except KeyboardInterrupt:
        pass
    except (pygame.error, OSError) as error:
        raise ValueError(f"cannot save {options.screenshot!r}: {error}") from None
    finally:
        pygame.display.quit()
    if options.stats:
        print(app.report())
    return 0


def new_game(options: Options) -> Game:
    """The game that the options ask for."""
    from . import setup
    from .play import Game

    world = setup.SCENES[options.scene]() if options.scene else setup.table_world(options.table)
    game = Game(world, options.substeps, options.seed, options.scene or options.table)
    game.language = options.lang
    if options.law:
        game.choose_law(options.law)
    if options.engine != "exact":
        game.choose_engine(options.engine)
    return game


if __name__ == "__main__":
    sys.exit(main())
