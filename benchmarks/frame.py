"""What a frame of the game costs: moving and idle, drawing what changed or all; and the start.

Without a window: SDL's dummy driver takes the pictures, so the cost of showing them is left out.
"""

import os
import subprocess
import sys
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory
from time import perf_counter, process_time
from typing import Any, NamedTuple

from . import report
from .report import ROOT, Report, duration
from .speed import children

SCRIPT = """0.1 text 2
0.15 key return
0.2 key return
0.25 key return
0.3 key return
0.35 text 30
0.4 key return
0.45 key return
"""  # the shot of the README
SHOT = 30  # frames: by then the ball is on its way
CALM = 60  # seconds after which every shot of 2 m/s lies still


class Pass(NamedTuple):
    """One run of the game on its virtual clock."""

    update: list[float]  # CPU seconds of each frame
    render: list[float]
    shown: list[bool]  # was anything drawn?
    pixels: int
    picture: bytes


def application(frames: int | None, real: bool = False) -> Any:
    """The game with the README's shot to come, without a window."""
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
    os.environ.setdefault("SDL_AUDIODRIVER", "dummy")
    os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
    from game.__main__ import new_game
    from game.app import App
    from game.options import read
    from game.replay.script import parse

    options = read([] if real else ["--frames", str(frames)])
    return App(new_game(options), options, parse("" if real else SCRIPT))


def play(frames: int, everything: bool) -> Pass:
    """Run that many frames, drawing everything in each or only what changed."""
    import pygame

    app = application(frames)
    update, render, shown, pixels = [], [], [], 0
    show, draw = pygame.display.update, app.render
    spent = 0.0

    def counted(rects: Any) -> None:
        nonlocal pixels
        pixels += sum(rect.w * rect.h for rect in rects)
        show(rects)

    def timed() -> bool:
        nonlocal spent
        start = process_time()
        shown.append(bool(draw()))
        spent = process_time() - start
        return shown[-1]

    app.render, pygame.display.update = timed, counted
    try:
        for _ in range(frames):
            if everything:
                pygame.event.post(pygame.event.Event(pygame.WINDOWEXPOSED))
            start = process_time()
            app.frame(app.clock.frame(True))
            render.append(spent)
            update.append(process_time() - start - spent)
        picture = pygame.image.tobytes(app.screen, "RGB")
    finally:
        pygame.display.update = show
        pygame.display.quit()
    return Pass(update, render, shown, pixels, picture)


def length(effort: int) -> int:
    """Frames of a pass: the smallest sees the shot begin, the others see it end."""
    return 90 if effort == report.SMALLEST else 60 * CALM


def skipping(effort: int) -> list[list[Any]]:
    """Rows: the game as it is, and with everything drawn in every frame."""
    frames = length(effort) if effort else 90
    plain, whole = play(frames, everything=False), play(frames, everything=True)
    base = sum(plain.render) + sum(plain.update)
    rows = []
    for name, run in (("as it is", plain), ("everything drawn in every frame", whole)):
        cost = sum(run.render) + sum(run.update)
        rows.append(
            [name, frames, sum(run.shown), f"{run.pixels:,}", duration(cost / frames),
             f"{cost / base:.1f}", "same" if run.picture == plain.picture else "CHANGED"]
        )  # fmt: skip
    return rows


def least(passes: list[Pass], part: str) -> list[float]:
    """Frame by frame, the least of several passes."""
    return [min(times) for times in zip(*(getattr(p, part) for p in passes), strict=True)]


def break_off(frames: int) -> tuple[list[float], list[int]]:
    """What drawing the table takes in each frame of a break at 8-ball, and how many balls move."""
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
    import pygame

    from game.render.layout import Layout
    from game.session.session import Session
    from game.session.ticks import TICKS
    from game.settings.settings import Settings
    from game.ui.table.stage import Stage
    from physics import Ball, tables

    table = tables.pool(9)
    world = table.world()
    world.add(Ball("cue", at=(-0.98, -0.1)))
    for ball in table.rack("8-ball", seed=3):
        world.add(ball)
    session = Session(world)
    stage = Stage(Layout((1280, 720), table.length, table.width), session, Settings())
    surface = pygame.Surface((1280, 720), 0, 32)
    stage.everything(surface, session)
    session.aim.texts = ["8", "0", "0", "0", "7.5"]
    session.strike()
    drawn, moving = [], []
    while session.moving and len(drawn) < frames:
        session.advance(TICKS // 60)
        stage.follow(session)
        start = process_time()
        stage.draw(surface, session)
        drawn.append(process_time() - start)
        moving.append(sum(not ball.lies for ball in world.balls))
    return drawn, moving


def rows_of_break(rounds: int, frames: int) -> list[list[Any]]:
    """Median and worst of drawing the table, by how many balls move."""
    runs = [break_off(frames) for _ in range(rounds)]
    times = [min(frame) for frame in zip(*(drawn for drawn, _ in runs), strict=True)]
    rows = []
    for least in (1, 8, 12):
        some = [t for t, n in zip(times, runs[0][1], strict=True) if n >= least]
        if some:
            figures = duration(median(some)), duration(max(some))
            rows.append([f"{least} or more", len(some), *figures])
    return rows


def idle_share(seconds: float) -> float:
    """CPU seconds a second of the game on its real clock, after two seconds' calm."""
    import pygame

    app = application(None, real=True)
    try:
        start, cpu, busy = perf_counter(), 0.0, True
        settled = False
        while perf_counter() - start < seconds + 2.0:
            if not settled and perf_counter() - start >= 2.0:
                settled, cpu = True, process_time()
            busy = app.frame(app.clock.frame(busy))
        return (process_time() - cpu) / seconds
    finally:
        pygame.display.quit()


def start_up(rounds: int) -> tuple[float, float]:
    """(on the wall, CPU) seconds from the command to the end of the first frame, the least."""
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")
    wall, cpu = [], []
    with TemporaryDirectory() as folder:
        for _ in range(rounds + 1):
            start = perf_counter()
            cpu.append(children(["-m", "game", "--frames", "1"], Path(folder)))
            wall.append(perf_counter() - start)
    return min(wall[1:]), min(cpu[1:])  # the first has written the bytecode


def unused() -> list[str]:
    """Heavy modules and devices in use by the first frame: there should be none."""
    code = (
        "import sys; from game.__main__ import main; main(['--frames', '1']); import pygame;"
        "print(*sorted({'numba', 'matplotlib', 'dask', 'mpmath'} & set(sys.modules)),"
        " *['mixer'] * bool(pygame.mixer.get_init()))"
    )
    quiet = {**os.environ, "PYGAME_HIDE_SUPPORT_PROMPT": "1"}
    done = subprocess.run(
        [sys.executable, "-c", code],
        cwd=ROOT,
        env=quiet,
        capture_output=True,
        text=True,
        check=True,
    )
    return done.stdout.split()


def rows_of(passes: list[Pass], whole: list[Pass], moving: int) -> list[list[Any]]:
    """Median and worst of update and drawing, while balls move and when they rest."""
    rows = []
    for name, part, runs in (
        ("update", "update", passes),
        ("drawing what changed", "render", passes),
        ("drawing everything", "render", whole),
    ):
        times = least(runs, part)
        ways = (("moving", times[SHOT:moving]), ("at rest", times[moving:]))
        rows += [[name, way, duration(median(t)), duration(max(t))] for way, t in ways if t]
    return rows


def main(arguments: list[str] | None = None) -> int:
    options = report.options("frame", __doc__, arguments)
    effort = options.effort
    page = Report("frame", "What a frame costs", options.out)
    frames, rounds = length(effort), (1, 2, 5)[effort]
    passes = [play(frames, everything=False) for _ in range(rounds)]
    short = min(frames, 20 * 60)
    whole = [play(short, everything=True) for _ in range(rounds)]
    moving = min(short - 10, max(k for k, drawn in enumerate(passes[0].shown) if drawn) + 1)
    page.say(
        f"The README's shot on the medium table, 1280 × 720, {frames} frames at 60 a second without"
        f" a window; balls move until frame {moving}. CPU time, frame by frame the least of"
        f" {rounds} runs. A frame at 60 Hz has 16.7 ms."
    )
    page.table(["what", "when", "median", "worst"], rows_of(passes, whole, moving))
    page.say("The table alone, in a break of sixteen balls at 8-ball, by how many of them move.")
    crowd = rows_of_break(rounds, (30, 60 * CALM)[effort > 0])
    page.table(["balls that move", "frames", "median", "worst"], crowd)
    page.say(
        f"Frames drawn: {sum(passes[0].shown)} of {frames}; pixels shown {passes[0].pixels:,},"
        f" against {frames * 1280 * 720:,} if every frame were shown whole."
    )
    if effort:
        share = idle_share((0, 3, 10)[effort])
        wall, cpu = start_up((1, 3, 7)[effort])
        loaded = unused()
        page.say(
            f"Idle on the real clock: {100 * share:.2f} % of one core. From command to first frame:"
            f" {duration(wall)} on the wall, {duration(cpu)} of CPU."
            f" Of numba, matplotlib, dask, mpmath and the mixer it has loaded"
            f" {', '.join(loaded) or 'none'}."
        )
    columns = range(moving), least(passes, "update"), least(passes, "render")
    page.data(["frame", "update s", "draw s"], list(zip(*columns, strict=False)))
    page.save()
    return 0
