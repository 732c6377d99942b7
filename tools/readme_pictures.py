"""Draw the pictures of README.md without a window: game.png, after.png, korean.png, pool.webp and
snooker.webp of docs.

python tools/readme_pictures.py [FOLDER]      needs Pillow: pip install pillow

The carom matches are played with the answers of the shelf, so that there is a score to be seen; the
others by two computers, until there is something to be seen.
"""

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np
from PIL import Image

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame

from danggu.players.positions import SHELF, Answer
from danggu.rules.match import Match
from game import options
from game.__main__ import new_game
from game.aim.entry import BOXES, START
from game.app import App
from game.render import theme
from game.session.action import Action
from game.session.session import Session
from game.session.ticks import TICKS
from game.table import presets

DOCS = Path(__file__).parent.parent / "docs"
COLOURS, EVEN, RARE = 256, 24, 0.35
COMMON = "--size 1280x720 --frames 9999"
SAGU = f"{COMMON} --game four-ball --players Minsu,Haneul --handicap 20,15"
THREE = f"{COMMON} --game three-cushion --players 조민수,이하늘 --handicap 20 --lang ko"
POOL = f"{COMMON} --game 8-ball --players Mina,Haneul --level master,master --seed 5"
SNOOKER = f"{COMMON} --game snooker --players Mina,Haneul --level master,master --seed 3"
BREAK = 25
"""Points of the break at which the picture of snooker is taken."""
MOST = 40_000
"""Frames in which there must be something to be seen."""
MISS = ""
SAGU_PLAYED = (
    "follow", "draw", "stun", MISS, "gather", "follow", MISS,
    "rail_nurse", "one_cushion", "gather", "two_cushions", "bank", MISS, "draw", "stun", MISS,
)  # fmt: skip
THREE_PLAYED = ("outside", "around", MISS, "inside", MISS, "cross_table", MISS, "reverse", MISS)
ASIDE = 1.2
"""Degrees that a missed stroke goes astray."""
SCRUBBED = 5.6
"""How far into its shot the second picture is, s."""


def main(folder: Path) -> None:
    """Draw all of them."""
    app = begun(SAGU, SAGU_PLAYED)
    length, width = presets.size(app.session.world)
    lay(app.session, {name: (x * length, y * width) for name, (x, y) in presets.BALLS.items()})
    numbers = " ".join(f"{box} {text}" for box, text in zip(BOXES, START, strict=True))
    aimed(app, numbers)
    save(app, folder / "game.png")
    for name, value in (("shoot", None), ("skip", None), ("scrub", round(SCRUBBED * TICKS))):
        app.perform(Action(name, value))
    save(app, folder / "after.png")
    app.close()
    app = begun(THREE, THREE_PLAYED)
    place(app, "outside")
    aimed(app)
    save(app, folder / "korean.png")
    app.close()
    watched(POOL, lambda match: any(match.state.groups) and match.visit > 2, folder / "pool.webp")
    watched(SNOOKER, lambda match: match.run >= BREAK, folder / "snooker.webp")


def watched(command: str, seen: Callable[[Match], bool], path: Path) -> None:
    """Let two computers play until there is what is wanted to be seen, and the balls have run."""
    chosen = options.read(command.split())
    app = App(new_game(chosen), chosen)
    for _ in range(MOST):
        app.frame(TICKS // 60)
        contest = app.session.contest
        if contest is not None and seen(contest.match) and not app.session.moving:
            break
    app.render()
    whole = Image.frombytes("RGB", app.screen.get_size(), pygame.image.tobytes(app.screen, "RGB"))
    whole.save(path, quality=92, method=6)
    print(f"{path}: {path.stat().st_size // 1024} KB")
    app.close()


def begun(command: str, played: Sequence[str]) -> App:
    """A match after these strokes: each made as the shelf says, or missed."""
    chosen = options.read(command.split())
    app = App(new_game(chosen), chosen)
    for key in played:
        place(app, key or "outside" if chosen.table == "match" else key or "follow")
        if key == MISS:
            app.perform(Action("turn", str(ASIDE)))
        for name in ("shoot", "skip", "shoot"):  # play, wait for the end, next
            app.perform(Action(name))
    return app


def place(app: App, key: str) -> None:
    """Lay the balls of a position for the player at the table, and aim as its answer says."""
    session = app.session
    position = next(place for place in SHELF if place.key == key)
    spots = position.on(*presets.size(session.world))
    if session.cue == "yellow":
        spots["white"], spots["yellow"] = spots["yellow"], spots["white"]
    lay(session, spots)
    aim(app, position.answer)


def lay(session: Session, spots: Mapping[str, presets.Place]) -> None:
    """Lay all balls down where they belong, metres."""
    session.lay([spots[ball.name] for ball in session.world.balls])


def aim(app: App, answer: Answer) -> None:
    """Write a stroke into the boxes."""
    angle, speed, right, up = answer
    app.perform(Action("set", f"angle {angle}"))
    app.perform(Action("power", str(speed)))
    app.perform(Action("tip", f"{right} {up}"))


def aimed(app: App, numbers: str = "") -> None:
    """Show an aim, with its spread."""
    if numbers:
        app.perform(Action("set", numbers))
    app.perform(Action("fan"))


def save(app: App, path: Path) -> None:
    """Let everything come on show, then write the picture in few colours."""
    for _ in range(90):
        app.frame(app.clock.frame(busy=True))
    whole = Image.frombytes("RGB", app.screen.get_size(), pygame.image.tobytes(app.screen, "RGB"))
    few = whole.quantize(palette=palette(whole), dither=Image.Dither.FLOYDSTEINBERG)
    few.save(path, optimize=True)
    print(f"{path}: {path.stat().st_size // 1024} KB")


def palette(whole: Image.Image) -> Image.Image:
    """The colours for a picture: even ones as they are; and rare ones, or balls would fade."""
    colours, counts = np.unique(np.asarray(whole).reshape(-1, 3), axis=0, return_counts=True)
    sample = np.repeat(colours, np.ceil(counts**RARE).astype(int), axis=0)
    own = [channel for look in theme.BALLS.values() for channel in look.ui]
    left = COLOURS - EVEN - 1 - len(own) // 3
    others = Image.fromarray(sample[None]).quantize(left, kmeans=4).getpalette() or []
    even = colours[np.argsort(counts)[-EVEN:]].ravel().tolist()
    found = Image.new("P", (1, 1))
    found.putpalette([*theme.GOOD, *own, *even, *others])
    return found


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else DOCS)
