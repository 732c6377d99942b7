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
    from .session.session import Session
    from .settings.preferences import Preferences


def main(arguments: list[str] | None = None) -> int:
    """Play; returns the exit code: 0, or 2 with a message on stderr when that is impossible."""
    try:
        given = sys.argv[1:] if arguments is None else arguments
        if given[:1] in (["lab"], ["sweep"]):
            from danggu.__main__ import main as without_the_game

            return without_the_game(given)
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
            session = new_game(played.setup)
        return _replay(played, session, preferences, hidden)
    finally:
        pygame.display.quit()


def _replay(played: Record, session: Session, preferences: Preferences, hidden: bool) -> int:
    from . import start
    from .replay.replay import Replay, headless
    from .window import signals

    if not hidden:
        return _run(start.watched(played.setup), preferences, session, Replay(played, session))
    signals.fail()
    return start.outcome(headless(played, session))


def _run(
    options: Options, preferences: Preferences, session: Session, replay: Replay | None = None
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
    recorder = Recorder(options.record, options, session) if options.record else None
    try:
        folder = start.kept_in(options, preferences)
        app = App(session, options, script, preferences, replay or recorder, folder)
    except pygame.error as error:
        raise ValueError(f"cannot open a window: {error}") from None
    start.greet(app)
    try:
        with excused(replay.record.name, session) if replay else nullcontext():
            app.run()
        if options.screenshot:
            _photograph(app, options.screenshot)
    finally:
        signals.ignore()
        app.close()
        code = start.regret(app)
    if options.stats:
        print(app.report())
    return start.outcome(replay) if replay else code


def _photograph(app: App, path: str) -> None:
    import pygame

    try:
        app.save(path)
    except (pygame.error, OSError) as error:
        raise ValueError(f"cannot save {path!r}: {error}") from None


def new_game(options: Options) -> Session:
    """The game that the options ask for."""
    from . import options as command_line
    from .session import table_commands, terms
    from .session.session import Session
    from .table import presets

    world = (
        presets.scene_world(options.scene) if options.scene else presets.table_world(options.table)
    )
    session = Session(
        world,
        options.substeps,
        options.seed,
        options.scene or options.table,
        options.lang,
        options.edition,
        options.engine if "engine" in options.given else "exact",
    )
    if options.setup:
        table_commands.line(session, options.setup)
    elif options.game != terms.FREE:
        table_commands.match(session, command_line.asked(options).line())
    # after the table is laid: each table comes with its own
    if options.law:
        table_commands.use_law(session, options.law)
    if options.cloth != "table":
        table_commands.use_cloth(session, options.cloth)
    if options.engine != "exact":
        table_commands.use_engine(session, options.engine)
    return session


if __name__ == "__main__":
    sys.exit(main())
