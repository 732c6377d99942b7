"""Play without a window and write it as an animation: a three-cushion shot, or a rack of 9-ball.

python tools/animate.py [three-cushion|run-out] [OUT.webp]      needs Pillow: pip install pillow

In the first the cue turns to the answer of a position of the shelf and shoots; after the point
comes the verdict. In the second the computer breaks and runs out.
"""

import os
import sys
from collections.abc import Iterator
from math import cos, pi
from pathlib import Path

from PIL import Image

os.environ["SDL_VIDEODRIVER"] = "dummy"

import pygame

from danggu.players.positions import SHELF
from danggu.rules.stroke import stroke
from game import options
from game.__main__ import new_game
from game.app import App
from game.session.action import Action
from game.table.presets import size

DOCS = Path(__file__).parent.parent / "docs"
FPS, AIMING, AFTER, VERDICT = 20, 1.1, 0.3, 1.2
"""Frames a second, and seconds: of aiming, after the second ball, and of the verdict."""
SIZE, QUALITY = (800, 450), 62
KEY, BESIDE = "around", 7.0
"""The position that is played, and how many degrees beside its answer the aiming begins."""
COMMAND = "--game three-cushion --handicap 20 --size 1280x720 --frames 9999 --fps"
RUN_OUT = "--game 9-ball --level master,master --seed 5 --size 1280x720 --frames 99999 --fps"
SLOW, EACH, ENOUGH = 10, 0.06, 1200
"""Of a rack: frames a second; every how many seconds of play one is kept; and how many at most."""


def main(what: str, out: Path) -> None:
    """Write the animation to a file."""
    command, shown, rate = {
        "three-cushion": (COMMAND, frames, FPS), "run-out": (RUN_OUT, rack, SLOW),
    }[what]  # fmt: skip
    chosen = options.read([*command.split(), str(rate)])
    app = App(new_game(chosen), chosen)
    try:
        first, *rest = shown(app)
    finally:
        app.close()
    first.save(
        out, save_all=True, append_images=rest, duration=1000 // FPS, loop=0,
        quality=QUALITY, method=6,
    )  # fmt: skip
    print(f"{out}: {1 + len(rest)} frames, {out.stat().st_size // 1024} KB")


def rack(app: App) -> Iterator[Image.Image]:
    """The pictures of a rack that the computer plays: at twice the pace, without its thinking."""
    session, seen = app.session, -1.0
    for _ in range(20 * ENOUGH):
        made = picture(app)
        contest = session.contest
        if contest is not None and contest.match.finished:
            break
        if abs(session.world.time - seen) >= EACH:
            seen = session.world.time
            yield made
    for _ in range(2 * FPS):
        yield picture(app)


def frames(app: App) -> Iterator[Image.Image]:
    """The pictures: aiming, the shot until both balls are hit, and the verdict."""
    session = app.session
    position = next(place for place in SHELF if place.key == KEY)
    spots = position.on(*size(session.world))
    session.lay([spots[ball.name] for ball in session.world.balls])
    angle, speed, right, up = position.answer
    for action in (("set", f"angle {angle + BESIDE}"), ("power", str(speed))):
        app.perform(Action(*action))
    app.perform(Action("tip", f"{right} {up}"))
    count = round(AIMING * FPS)
    for i in range(count):
        turned = min(1.0, i / (0.7 * count))  # then the cue is still
        beside = BESIDE * (1 + cos(pi * turned)) / 2
        app.perform(Action("set", f"angle {angle + beside:.2f}"))
        yield picture(app)
    app.perform(Action("shoot"))
    while not (hits := stroke(session.world.log, session.cue).hits()).keys() >= {"red", "yellow"}:
        yield picture(app)
    while session.world.time < session.began + hits["yellow"] + AFTER:
        yield picture(app)
    app.perform(Action("skip"))
    for _ in range(round(VERDICT * FPS)):
        yield picture(app)


def picture(app: App) -> Image.Image:
    """The next frame, made small."""
    app.frame(app.clock.frame(busy=True))
    pixels = pygame.image.tobytes(app.screen, "RGB")
    whole = Image.frombytes("RGB", app.screen.get_size(), pixels)
    return whole.resize(SIZE, Image.Resampling.LANCZOS)


if __name__ == "__main__":
    name = sys.argv[1] if len(sys.argv) > 1 else "three-cushion"
    main(name, Path(sys.argv[2]) if len(sys.argv) > 2 else DOCS / f"{name}.webp")
