"""Every shortcut switched off in turn: what it saves in time and work, and that no bit changes."""

from collections import Counter
from collections.abc import Callable
from math import inf
from typing import Any

import physics.world
from physics import World, laws

from . import report
from .crowds import gas
from .pool_shots import pool_break, pool_shot
from .report import Report, duration
from .switches import POCKETS, SMOOTH, SWITCHES, Package, Switch, count, fresh
from .timing import in_turns
from .workload import break_shot, carom_shot

WORK = ("pair solves", "box tests", "quadratics", "obstacles met", "legs planned")


def smooth_break() -> World:
    """The break with balls that do not rub."""
    world = break_shot()
    world.ball_law = laws.SmoothBall(0.95)
    return world


def planned(make: Callable[[], World], package: Package) -> Any:
    """The scene of a world in records of its own, for a kernel that plans it itself."""
    world = make()
    world.plan()
    body = package.body
    twins = [
        body.Body(*(getattr(b, name) for name in type(b).__slots__)) for b in world.scene.balls
    ]
    return world.scene._replace(balls=twins)


def run(package: Package, make: Callable[[], World]) -> tuple[list[Any], int]:
    """Everything to rest: (position, velocity, roll and side of each ball; events)."""
    scene = planned(make, package)
    return go(package, scene)


def go(package: Package, scene: Any) -> tuple[list[Any], int]:
    package.calendar.plan(scene)
    events, last = package.calendar.advance(inf, 10**5, scene)
    return [(b.position, b.velocity, b.roll, b.side, last) for b in scene.balls], events


def compare(
    scene: str, make: Callable[[], World], switches: tuple[Switch, ...], effort: int
) -> list[list[Any]]:
    """Rows of the table: the kernel as it is, then without each shortcut, timed in turns."""
    plain = fresh()
    packages = {"as it is": plain}
    for switch in switches:
        packages[f"without: {switch.name}"] = fresh()
        switch.off(packages[f"without: {switch.name}"])
    again = (1, 5, 10)[effort]
    runs = {
        name: lambda package=package: [run(package, make) for _ in range(again)]
        for name, package in packages.items()
    }
    costs = in_turns(runs, (1, 5, 15)[effort])
    outcome, rows = run(plain, make), []
    for name, package in packages.items():
        bits = repr(run(package, make)) == repr(outcome)  # repr tells 0.0 from -0.0
        work: Counter[str] = Counter()
        count(package, work)
        run(package, make)
        ratio = costs[name].least / costs["as it is"].least
        rows.append(
            [scene, name, duration(costs[name].least / again), f"{ratio:.2f}",
             *(work[kind] for kind in WORK), "same" if bits else "CHANGED"]
        )  # fmt: skip
    return rows


def cells(effort: int) -> list[list[Any]]:
    """Many balls with cells and with the table of all meetings."""
    balls, seconds = (40, 100, 300)[effort], (0.02, 0.1, 0.2)[effort]
    few = physics.world.FEW

    def outcome(least: int) -> list[Any]:
        physics.world.FEW = least
        try:
            world = gas(balls)
            world.run(seconds)
        finally:
            physics.world.FEW = few
        return [ball.position for ball in world.balls] + [event.time for event in world.log]

    runs = {
        "as it is": lambda: outcome(few),
        "without: cells above 30 balls": lambda: outcome(10**6),
    }
    costs = in_turns(runs, (1, 2, 3)[effort])
    same = "same" if outcome(few) == outcome(10**6) else "CHANGED"
    return [
        [f"gas of {balls}", name, duration(cost.least),
         f"{cost.least / costs['as it is'].least:.2f}", *["–"] * len(WORK), same]
        for name, cost in costs.items()
    ]  # fmt: skip


def main(arguments: list[str] | None = None) -> int:
    options = report.options("skips", __doc__, arguments)
    effort = options.effort
    page = Report("skips", "What skipping buys", options.out)
    rows = compare("carom shot", carom_shot, SWITCHES, effort)
    if effort:
        rows += compare("break", break_shot, SWITCHES, effort)
    rows += compare("pool shot", pool_shot, POCKETS, effort)
    if effort:
        rows += compare("pool break", pool_break, POCKETS, effort)
    rows += compare("break, smooth balls", smooth_break, (SMOOTH,), effort)
    rows += cells(effort)
    page.say(
        "Interpreted, CPU time, the least of runs taken in turns, from a world's making to rest."
        " Counted in a run apart. Same: every digit of every ball's position, velocity and spin,"
        " and the number of events."
    )
    heads = ["scene", "kernel", "time", "ratio", *WORK, "bits"]
    page.table(heads, rows)
    drawing = game_rows(page, effort)
    page.data([*heads], rows)
    page.save()
    return int(any("CHANGED" in row for row in rows + drawing))


def game_rows(page: Report, effort: int) -> list[list[Any]]:
    """The game with and without the skipping of frames and of what has not changed in them."""
    from .frame import skipping

    rows = skipping(effort)
    page.say("## The game", "A shot and a rest after it, on the virtual clock, without a window.")
    heads = ["game", "frames", "drawn", "pixels updated", "time a frame", "ratio", "last picture"]
    page.table(heads, rows)
    return rows
