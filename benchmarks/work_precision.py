"""Error against CPU time: the exact engine, the thesis's stepping and textbook integrators.

A single step size is a lottery, since a contact falls early or late in its step by chance: so every
nominal step stands for many sizes in the half octave around it, and medians are compared.
"""

from collections.abc import Callable
from functools import partial
from math import inf, log, nan
from random import Random
from statistics import fmean, median, quantiles
from typing import Any, NamedTuple

from physics import Shot, World, scenes

from . import report
from .report import Report, duration, figure
from .timing import in_turns, once
from .workload import (
    SCENES,
    STEPPED,
    TIMES,
    Batch,
    Truth,
    along,
    exact,
    fan,
    play,
    stepped,
    truth,
    worst,
)

FRAME = 1 / 60
SUBSTEPS = ((2, 6), (1, 3, 10, 30), (1, 3, 10, 30, 100, 300, 1000))  # a frame, by effort
SAMPLES = (2, 6, 31)  # step sizes about each nominal one, at most
PATIENCE = (0.1, 0.3, 1.5)  # s of CPU for one setting; but never fewer than
FEWEST = 3  # samples, and a setting whose single run would take longer than
TOO_LONG = (1.0, 0.5, 5.0)  # s is left out
SATURATED = 0.05  # m: from there on the outcome is another one, and errors say nothing of order
ROUNDING = 1e-12  # m: nor do they where a method is exact
DRAWS = 400  # of the bootstrap


class Setting(NamedTuple):
    """One method at one nominal step: for every sample the step, the CPU time and the errors."""

    scene: str
    method: str
    substeps: int
    steps: list[float]
    times: list[float]
    errors: list[list[float]]  # one list for each of TIMES


class Exact(NamedTuple):
    """The exact engine on a scene: CPU seconds a shot, and the errors at TIMES."""

    scene: str
    events: int
    interpreted: float
    compiled: float
    errors: list[float]


def sizes(substeps: int, samples: int) -> list[float]:
    """Step sizes from nominal / 2^¼ to nominal · 2^¼, evenly on the logarithm, in mixed order."""
    nominal = FRAME / substeps
    spread = [nominal * 2.0 ** ((k + 0.5) / samples / 2 - 0.25) for k in range(samples)]
    Random(substeps).shuffle(spread)
    return spread


def sample(make: Callable[[], World], scheme: str, dt: float, true: Truth) -> tuple[float, Any]:
    """(CPU seconds, error at each of TIMES) of one run; NaN where the method broke down."""
    world, places = stepped(make, scheme, dt), []
    try:
        seconds = once(lambda: places.extend(along(world, TIMES, true.rests)))
    except (ArithmeticError, ValueError, RuntimeError):
        return nan, [nan for _ in TIMES]
    return seconds, [worst(there, at) for there, at in zip(places, true.positions, strict=True)]


def setting(
    scene: str, method: str, substeps: int, true: Truth, effort: int, expected: float
) -> Setting | None:
    """Run one method at many steps about a nominal one; None if that would take too long."""
    if expected > TOO_LONG[effort]:
        return None
    steps, times, errors = [], [], []
    for dt in sizes(substeps, SAMPLES[effort]):
        seconds, off = sample(SCENES[scene], STEPPED[method], dt, true)
        steps.append(dt)
        times.append(seconds)
        errors.append(off)
        if seconds > TOO_LONG[effort] or (sum(times) > PATIENCE[effort] and len(times) >= FEWEST):
            break
    return Setting(
        scene, method, substeps, steps, times, [list(e) for e in zip(*errors, strict=True)]
    )


def sweep(scene: str, true: Truth, effort: int) -> list[Setting]:
    """All stepping methods at all steps; what each will cost is guessed from the step before."""
    done = []
    for method in STEPPED:
        last: Setting | None = None
        for substeps in SUBSTEPS[effort]:
            ratio = substeps / last.substeps if last else 1
            expected = ratio * min(last.times) if last else 0.0
            last = setting(scene, method, substeps, true, effort, expected)
            if last is None:
                break
            done.append(last)
    return done


def measure_exact(scene: str, true: Truth, effort: int) -> Exact:
    """The exact engine, interpreted and compiled, in turns."""
    make = SCENES[scene]
    batch = Batch(exact(make), (2, 100, 1000)[effort])
    batch()
    runs = {"interpreted": partial(play, make, (2, 10, 30)[effort]), "compiled": batch}
    costs = in_turns(runs, (2, 7, 15)[effort])
    places = along(exact(make), TIMES, true.rests)
    if batch.positions() != places[-1]:
        raise AssertionError(f"{scene}: compiled and interpreted differ")
    errors = [worst(there, at) for there, at in zip(places, true.positions, strict=True)]
    interpreted = costs["interpreted"].least / (2, 10, 30)[effort]
    return Exact(scene, true.events, interpreted, costs["compiled"].least / batch.shots, errors)


def slope(points: list[tuple[float, float]]) -> float:
    """Of the straight line that fits log y over log x best."""
    xs, ys = [log(x) for x, _ in points], [log(y) for _, y in points]
    x, y = fmean(xs), fmean(ys)
    over = sum((a - x) ** 2 for a in xs)
    return sum((a - x) * (b - y) for a, b in zip(xs, ys, strict=True)) / over


def order(settings: list[Setting], when: int) -> tuple[float, float, float] | None:
    """(order, low, high): how the median error falls with the step, and 95 % of bootstrap fits.

    None with fewer than three steps at which the error is small enough to have an order.
    """
    fit = [
        (s.steps, s.errors[when]) for s in settings if ROUNDING < median(s.errors[when]) < SATURATED
    ]
    if len(fit) < 3:
        return None
    chance, slopes = Random(1), []
    for _ in range(DRAWS):
        points = []
        for steps, errors in fit:
            drawn = [chance.randrange(len(steps)) for _ in steps]
            points.append((median(steps[k] for k in drawn), median(errors[k] for k in drawn)))
        if all(y > 0 for _, y in points):
            slopes.append(slope(points))
    cuts = quantiles(slopes, n=40)
    return slope([(median(x), median(y)) for x, y in fit]), cuts[0], cuts[-1]


def order_text(settings: list[Setting], when: int) -> str:
    if all(median(s.errors[when]) < ROUNDING for s in settings):
        return "exact"
    fit = order(settings, when)
    return "–" if fit is None else f"{fit[0]:.2f} ({fit[1]:.2f} … {fit[2]:.2f})"


def exact_table(page: Report, exacts: list[Exact]) -> None:
    page.say("## The exact engine", "Worst ball against the same kernel in 50-digit numbers.")
    page.table(
        ["scene", "events", "interpreted", "compiled", "error at 1 s, m", "at 2 s", "at rest"],
        [
            [
                e.scene,
                e.events,
                duration(e.interpreted),
                duration(e.compiled),
                *map(figure, e.errors),
            ]
            for e in exacts
        ],
    )


def summary(s: Setting) -> str:
    return f"{figure(median(s.errors[-1]), 2)}, {duration(min(s.times))}"


def stepped_table(page: Report, settings: list[Setting], substeps: tuple[int, ...]) -> None:
    shown = [n for n in (3, 30, 300, 1000) if n in substeps] or list(substeps)
    page.say(
        "## Fixed steps",
        "Median error of the worst ball at rest, m, and CPU time, with n substeps in 1/60 s;"
        " order of convergence with its 95 % interval, where errors are below"
        f" {SATURATED} m at three steps or more. The thesis's program has laws of its own: its"
        " error is mostly a difference of models.",
    )
    heads = ["scene", "method", *(f"n = {n}" for n in shown), "order at 1 s", "order at rest"]
    rows = []
    for scene in dict.fromkeys(s.scene for s in settings):
        for method in STEPPED:
            mine = [s for s in settings if (s.scene, s.method) == (scene, method)]
            at = {s.substeps: summary(s) for s in mine}
            orders = [order_text(mine, when) for when in (0, -1)]
            rows.append([scene, method, *(at.get(n, "–") for n in shown), *orders])
    page.table(heads, rows)


def fan_table(page: Report, effort: int) -> None:
    """The carom shot in many directions: no single one is typical."""
    shots = fan((2, 12, 72)[effort])
    rows = []
    truths = [truth(partial(_struck, shot), (inf,)) for shot in shots]
    ways = [("exact", None, 0), ("thesis stepping", "thesis", 3), ("thesis stepping", "thesis", 30)]
    ways += [("RK4", "rk4", 3), ("RK4, contacts located", "rk4-located", 3)]
    for method, scheme, n in ways if effort else ways[:2]:
        off = []
        for shot, true in zip(shots, truths, strict=True):
            make = partial(_struck, shot)
            world = stepped(make, scheme, FRAME / n) if scheme else make()
            off.append(worst(along(world, (inf,), true.rests)[0], true.positions[0]))
        off.sort()
        tenth = off[(9 * len(off)) // 10]
        rows.append([method, n or "–", figure(median(off)), figure(tenth), figure(off[-1])])
    page.say(
        "## Four balls, many directions",
        f"{len(shots)} shots at 3 m/s around the circle: error at rest of the worst ball, m.",
    )
    page.table(["method", "n", "median", "worst tenth", "worst"], rows)


def _struck(shot: Shot) -> World:
    world = scenes.carom()
    world.strike("white", shot)
    return world


def keep(page: Report, exacts: list[Exact], settings: list[Setting]) -> None:
    """Every number as CSV."""
    rows: list[list[Any]] = []
    for e in exacts:
        rows.append([e.scene, "exact, interpreted", "", "", 1, e.interpreted, *e.errors, "", ""])
        rows.append([e.scene, "exact, compiled", "", "", 1, e.compiled, *e.errors, "", ""])
    for s in settings:
        spread = quantiles(s.errors[-1] * 2, n=4, method="inclusive")  # twice: one will do
        middles = [median(errors) for errors in s.errors]
        rows.append(
            [s.scene, s.method, s.substeps, median(s.steps), len(s.steps), min(s.times), *middles,
             spread[0], spread[2]]
        )  # fmt: skip
    page.data(
        ["scene", "method", "substeps", "dt s", "samples", "cpu s", "error at 1 s m",
         "error at 2 s m", "error at rest m", "its lower quartile", "its upper quartile"], rows,
    )  # fmt: skip


def main(arguments: list[str] | None = None) -> int:
    options = report.options("work-precision", __doc__, arguments)
    effort = options.effort
    page = Report("work-precision", "Error against CPU time", options.out)
    exacts, settings = [], []
    for scene in list(SCENES) if effort else ["thesis 2"]:
        true = truth(SCENES[scene])
        exacts.append(measure_exact(scene, true, effort))
        settings += sweep(scene, true, effort)
        print(f"  {scene} is done", flush=True)
    exact_table(page, exacts)
    stepped_table(page, settings, SUBSTEPS[effort])
    fan_table(page, effort)
    keep(page, exacts, settings)
    from .figures import work_precision

    work_precision(options.out)
    page.save()
    return 0
