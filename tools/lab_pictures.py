"""Draw the pictures of docs/labs.md without a window: labs.png, labs_ko.png and compared.png.

python tools/lab_pictures.py [FOLDER]      needs Pillow: pip install pillow

docs/lab_page.png is the page of `python -m danggu lab right-angle --seed 7` in a browser.
"""

import os
import sys
from collections.abc import Iterable
from pathlib import Path

from PIL import Image

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame

from danggu import labs
from game import options
from game.__main__ import new_game
from game.app import App
from game.session.action import Action

DOCS = Path(__file__).parent.parent / "docs"
COLOURS = 128
LAB, SEED = "right-angle", 7
ANSWERED = ("angle", "white")
"""The fields whose boxes have an answer, the second one that is wrong."""


def main(folder: Path) -> None:
    """Draw all three."""
    for language, name in (("en", "labs.png"), ("ko", "labs_ko.png")):
        save(page(language), folder / name)
    app = begun("en")
    given = Action("graphs"), Action("compare"), Action("shoot"), Action("skip")
    save(done(app, given), folder / "compared.png")


def begun(language: str) -> App:
    """A game whose first frame is still to come."""
    chosen = options.read(["--size", "1280x720", "--lang", language, "--frames", "9999"])
    return App(new_game(chosen), chosen)


def done(app: App, actions: Iterable[Action]) -> App:
    """The game after these actions."""
    for action in actions:
        app.perform(action)
    return app


def page(language: str) -> App:
    """The page of labs, with a right and a wrong answer."""
    app = done(begun(language), [Action("sheet", "labs")])
    shown = app.view.labs
    shown.place, shown.seed = shown.names.index(LAB), SEED
    truth = labs.lab(LAB, SEED).truth
    for place, (name, share) in enumerate(zip(ANSWERED, (1.0, 1.2), strict=True)):
        shown.fields[place].type(f"{share * truth[name]:.2f}")
    shown.do("check", app.view.sight)
    shown.focus = len(ANSWERED)
    return app


def save(app: App, path: Path) -> None:
    """Let everything come on show, then write the picture in few colours."""
    for _ in range(30):
        app.frame(app.clock.frame(busy=True))
    whole = Image.frombytes("RGB", app.screen.get_size(), pygame.image.tobytes(app.screen, "RGB"))
    whole.quantize(COLOURS, kmeans=2).save(path, optimize=True)
    print(f"{path}: {path.stat().st_size // 1024} KB")
    app.close()


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS)
