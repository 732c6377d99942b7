"""A player made of posted events: games without a clock, keys and text as SDL would send them."""

from __future__ import annotations

import atexit
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import pygame

from game.__main__ import new_game
from game.app import App
from game.input.bindings import DEFAULTS
from game.options import Options
from game.session.session import Session
from game.session.ticks import TICKS

FRAME = TICKS // 60
FOLDER = TemporaryDirectory()
"""Where set-ups are saved instead of in the user's folder."""
atexit.register(FOLDER.cleanup)  # or every worker ends in a traceback of a ResourceWarning
_LETTERS = [chr(c) for c in range(ord("a"), ord("z") + 1)]
FREE, SPARE = [c for c in _LETTERS if c not in {b.key for b in DEFAULTS.values()}][:2]
"""Keys that nothing has by default."""
TWO_SHOTS = """
0.10 key return
1.37 key right
1.37 text 2
1.37 key return
1.37 text 0
1.37 key return
1.37 text 1
1.37 key return
1.37 text -1
1.37 key return
1.37 text 200
1.37 key return
1.50 key return
"""
"""A script: the second shot is played while the balls of the first one move."""


def an_app(size=(960, 540), **options) -> App:
    """An app whose frames the test asks for."""
    chosen = replace(Options(), size=size, frames=1, **options)
    app = App(new_game(chosen), chosen)
    app.view.pages["shelf"].library.path = Path(FOLDER.name) / f"{id(app)}.json"
    app.view.labs.folder = app.exports = Path(FOLDER.name)
    app.frame(0)
    return app


def press(app: App, *names: str, frames: bool = True) -> None:
    """Press keys by name, "ctrl+return" for example, each in a frame of its own."""
    for name in names:
        *held, last = name.split("+")
        mods = {"ctrl": pygame.KMOD_CTRL, "shift": pygame.KMOD_SHIFT}
        key = ord(last) if len(last) == 1 else getattr(pygame, f"K_{last.upper()}")
        char = last if len(last) == 1 else ""
        mod = sum(mods[h] for h in held)
        pygame.event.post(pygame.event.Event(pygame.KEYDOWN, key=key, mod=mod, unicode=char))
        if frames:
            app.frame(FRAME)


def write(app: App, text: str) -> None:
    """Send characters as an input method does."""
    for char in text:
        pygame.event.post(pygame.event.Event(pygame.TEXTINPUT, text=char))
    app.frame(FRAME)


def enter(app: App, *texts: str) -> None:
    """Clear the boxes, fill in texts and complete the entry."""
    press(app, "right")
    for text in texts:
        write(app, text)
        press(app, "return")


def click(app: App, at: tuple[float, float], to: tuple[float, float] | None = None) -> None:
    """Press the left button at a place of the picture, drag if asked, release."""
    at = in_window(app, at)
    end = at if to is None else in_window(app, to)
    kinds = pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEMOTION, pygame.MOUSEBUTTONUP
    for kind, pos in zip(kinds, (at, at, end, end), strict=True):
        event = pygame.event.Event(kind, pos=pos, button=1, rel=(0, 0), buttons=(1, 0, 0))
        pygame.event.post(event)
    app.frame(FRAME)


def in_window(app: App, at: tuple[float, float]) -> tuple[int, int]:
    """Where in the window a place of the picture is."""
    canvas = app.canvas
    x, y = (int(side / canvas.scale) for side in at)
    return x + canvas.part.x, y + canvas.part.y


def run_to_rest(app: App) -> None:
    """Let time pass until nothing moves, in frames too long to be watched."""
    for _ in range(300):
        if not app.session.moving:
            return
        app.frame(10 * FRAME)
    raise AssertionError("the balls never came to rest")


def places(session: Session) -> list[tuple[float, float]]:
    """Where the balls are."""
    return [ball.position for ball in session.world.balls]


def pixels(app: App) -> bytes:
    """The whole picture."""
    return pygame.image.tobytes(app.screen, "RGB")


def assert_same_as_anew(app: App) -> None:
    """What is on the screen is what a full redraw gives, pixel for pixel."""
    app.render()
    partly = pixels(app)
    app.view.expose()
    app.canvas.show(app.view.draw(app.canvas.surface))
    assert pixels(app) == partly
