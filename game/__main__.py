"""Start the game: `danggu` or `python -m game`; `--help` lists the options."""

from __future__ import annotations

import os
import sys
from io import TextIOWrapper

TYPE_CHECKING = False  # as typing has it, whose import leaves time for a Ctrl+C with a traceback
if TYPE_CHECKING:
    from types import ModuleType

    from .app import App
    from .options import Options
    from .replay.game_record import Record
    from .replay.replay import Replay
    from .session.session import Game
    from .settings.preferences import Preferences


def main(arguments: list[str] | None = None) -> int:
    """Play; returns the exit code: 0, or 2 with a message on stderr when that is impossible."""
    try:
        from .window import signals

        with signals.orderly():
            return _begin(arguments)
    except KeyboardInterrupt:  # before anything listens
        return 130


def _begin(arguments: list[str] | None) -> int:
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    _write_anything()
    from . import options as command_line
    from .text.quoting import in_a_line

    options = command_line.read(arguments)
    if options.version:
        return _version()
    try:
        return _play(options)
    except ValueError as error:
        print(f"danggu: {in_a_line(error)}", file=sys.stderr)
        return 2


def _write_anything() -> None:
    """Let names be printed on every terminal: what it does not know is written as an escape."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")


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
    from . import start
    from .replay import game_record
    from .replay.replay import excused

    hidden = start.unseen(options)
    if not hidden:
        start.display(options)
    try:
        preferences = start.preferences(options)
        options = preferences.settings.applied(options)
        if not options.replay:
            return _run(options, preferences, new_game(options))
        played = game_record.read(options.replay, options)
        with excused(played.name):
            game = new_game(played.setup)
        return _replay(played, game, preferences, hidden)
    finally:
        pygame.display.quit()


def _replay(played: Record, game: Game, preferences: Preferences, hidden: bool) -> int:
    from . import start
    from .replay.replay import Replay, headless
    from .window import signals

    if not hidden:
        return _run(start.watched(played.setup), preferences, game, Replay(played, game))
    signals.fail()
    return start.told(headless(played, game))


def _run(
    options: Options, preferences: Preferences, game: Game, replay: Replay | None = None
) -> int:
    """Play in a window, and keep what is to be kept at the end."""
    from contextlib import nullcontext

    import pygame

    from . import start
    from .app import App
    from .replay.recorder import Recorder
    from .replay.replay import excused
    from .replay.script import read
    from .window import signals

    script = read(options.script) if options.script else None
    recorder = Recorder(options.record, options, game) if options.record else None
    try:
        app = App(game, options, script, preferences, replay or recorder)
    except pygame.error as error:
        raise ValueError(f"cannot open a window: {error}") from None
    start.greet(app)
    try:
        with excused(replay.record.name, game) if replay else nullcontext():
            app.run()
        if options.screenshot:
            _photograph(app, options.screenshot)
    finally:
        signals.ignore()
        app.close()
        code = start.regret(app)
    if options.stats:
        print(app.report())
    return start.told(replay) if replay else code


def _photograph(app: App, path: str) -> None:
    import pygame

    try:
        app.save(path)
    except (pygame.error, OSError) as error:
        raise ValueError(f"cannot save {path!r}: {error}") from None


def new_game(options: Options) -> Game:
    """The game that the options ask for."""
    from .session import commands, equipment, terms
    from .session.session import Game
    from .table import presets

    world = (
        presets.scene_world(options.scene) if options.scene else presets.table_world(options.table)
    )
    game = Game(world, options.substeps, options.seed, options.scene or options.table)
    game.language, game.edition = options.lang, options.edition
    if "engine" in options.given:
        game.match_engine = options.engine
    if options.setup:
        commands.line(game, options.setup)
    elif options.game != terms.FREE:
        commands.match(game, terms.asked(options).line())
    # after the table is laid: each table comes with its own
    if options.law:
        equipment.law(game, options.law)
    if options.cloth != "table":
        equipment.cloth(game, options.cloth)
    if options.engine != "exact":
        equipment.engine(game, options.engine)
    return game


if __name__ == "__main__":
    sys.exit(main())
