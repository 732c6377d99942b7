"""What an event and a shot cost among 1 to 10 000 balls: cells keep the one nearly flat."""

from collections.abc import Callable
from functools import partial
from math import inf, nan
from pathlib import Path
from typing import Any, NamedTuple

from physics import Shot, World, simulate

from . import report
from .crowds import field, gas, program
from .figures import BLUE, GREY, SKY, pyplot, save
from .report import Report, duration
from .timing import once

SIZES = (
    (1, 4, 40),
    (1, 4, 16, 30, 31, 100, 1000),
    (1, 2, 4, 8, 16, 30, 31, 100, 300, 1000, 3000, 10_000),
)
ROUNDS = (1, 3, 5)
SHOT = Shot(3.0, 20.0, follow=0.5, side=1.5)
LIMIT = 1e8  # pairs looked at in a test of the thesis's program


class Size(NamedTuple):
    """CPU seconds among so many balls: an event, a shot, and a second of the thesis's program."""

    balls: int
    event: float
    compiled_event: float
    shot: float
    compiled_shot: float
    shot_events: int
    program_substep: float
    program_event: float


def advance_for(world: World, events: int) -> int:
    """Let the gas go on for about that many events; returns how many there were."""
    before = len(world.log)
    while len(world.log) - before < events:
        world.run(world.time + 0.05 * max(1.0, events / len(world.balls)) / 20.0)
    return len(world.log) - before


def event_cost(balls: int, effort: int) -> tuple[float, float]:
    """(interpreted, compiled) CPU seconds of an event in the gas; planning is not counted."""
    from physics.batch.compiled import kernel, packed

    events, best, best_compiled = (200, 2000, 5000)[effort], inf, inf
    advance: Any = kernel().calendar.advance
    for _ in range(ROUNDS[effort]):
        world = gas(balls)
        world.plan()
        scene = packed(world.scene)
        seconds, done = spent(partial(advance_for, world, events))
        best = min(best, seconds / done)
        advance(0.0, 0, scene)  # so that loading is not timed
        seconds, (done, _) = spent(partial(advance, world.time, 10**9, scene))
        best_compiled = min(best_compiled, seconds / done)
    return best, best_compiled


def spent(run: Callable[[], Any]) -> tuple[float, Any]:
    """(CPU seconds, result) of a run."""
    results: list[Any] = []
    return once(lambda: results.append(run())), results[0]


def shot_cost(balls: int, effort: int) -> tuple[float, float, int]:
    """(interpreted, compiled, events) of a shot to rest among balls that lie still."""
    from .workload import Batch

    world = field(balls)
    struck = world.balls[0].name
    world.plan()
    best, events = inf, 0
    for _ in range(ROUNDS[effort]):
        seconds, after = spent(partial(simulate, world, struck, SHOT))
        best, events = min(best, seconds), len(after.log)
    world.strike(struck, SHOT)
    batch = Batch(world, max(1, (20, 300, 3000)[effort] // balls))
    batch()
    compiled = min(once(batch) for _ in range(ROUNDS[effort])) / batch.shots
    return best, compiled, events


def program_cost(balls: int, effort: int) -> tuple[float, float]:
    """(a substep, an event) of the thesis's program in the gas, CPU seconds."""
    substeps = int(min(180, LIMIT ** (0.5 * effort) / balls**2))
    if substeps == 0:
        return nan, nan
    world = program(gas(balls))
    exact = gas(balls)
    exact.run(1.0 if balls <= 1000 else 0.1)
    rate = len(exact.log) / exact.time
    world.plan()
    seconds = once(lambda: world.run((substeps - 0.5) / 180)) / substeps
    return seconds, seconds * 180 / rate if rate else nan


def measure(balls: int, effort: int) -> Size:
    event, compiled_event = event_cost(balls, effort)
    shot, compiled_shot, events = shot_cost(balls, effort)
    return Size(
        balls, event, compiled_event, shot, compiled_shot, events, *program_cost(balls, effort)
    )


def draw(sizes: list[Size], out: Path) -> None:
    """Cost of an event and of a shot over the number of balls."""
    figure, (left, right) = pyplot().subplots(1, 2, figsize=(8.6, 3.5), layout="constrained")
    balls = [s.balls for s in sizes]
    lines: tuple[tuple[Any, str, str, str, str], ...] = (
        (left, "program_event", GREY, "X", "thesis's program"),
        (left, "event", BLUE, "o", "exact, interpreted"),
        (left, "compiled_event", SKY, "P", "exact, compiled"),
        (right, "shot", BLUE, "o", "exact, interpreted"),
        (right, "compiled_shot", SKY, "P", "exact, compiled"),
    )
    for axes, name, colour, marker, label in lines:
        times = [getattr(s, name) for s in sizes]
        axes.plot(balls, times, color=colour, marker=marker, ms=5, lw=1.4, label=label)
    left.set(title="An event in a gas of discs", ylabel="CPU time")
    right.set(title="A shot among balls at rest", ylabel="CPU time")
    for axes in (left, right):
        axes.set(xscale="log", yscale="log", xlabel="balls")
        low, high = axes.get_ylim()
        ticks = [t for t in (10.0**k for k in range(-7, 2)) if low <= t <= high]
        axes.set_yticks(ticks, [duration(t) for t in ticks])
        axes.set_xticks([1, 10, 100, 1000, 10000], ["1", "10", "100", "1 000", "10 000"])
        axes.minorticks_off()
    figure.legend(*left.get_legend_handles_labels(), loc="outside lower center", ncols=3)
    save(figure, out, "scale")


def main(arguments: list[str] | None = None) -> int:
    options = report.options("scale", __doc__, arguments)
    page = Report("scale", "Cost against the number of balls", options.out)
    sizes = []
    for balls in SIZES[options.effort]:
        sizes.append(measure(balls, options.effort))
        print(f"  {balls} balls are done", flush=True)
    page.say(
        "CPU time, the least of several runs. An event: discs that lose nothing, in a box filled"
        " to 30 %. A shot: one ball struck at 3 m/s among balls at rest; interpreted, with a copy"
        " of the world. The thesis's program looks at all pairs at each of 180 substeps a second,"
        " whatever happens: its cost of an event is that of a second over the collisions that the"
        " exact engine finds in one. Up to 30 balls all meetings are kept in a table; above that"
        " there are cells."
    )
    page.table(
        ["balls", "event, interpreted", "compiled", "thesis's program", "its substep",
         "shot, interpreted", "compiled", "events"],
        [
            [s.balls, *map(duration, (s.event, s.compiled_event, s.program_event, s.program_substep,
                                      s.shot, s.compiled_shot)), s.shot_events]
            for s in sizes
        ],
    )  # fmt: skip
    page.data(Size._fields, sizes)
    draw(sizes, options.out)
    page.save()
    return 0
