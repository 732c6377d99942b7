"""The same scenes elsewhere: pymunk, the thesis's program, and pooltool where it is installed.

Two questions. What does a shot cost? And where does an object ball go that is cut at random: along
the line of centres at the moment of contact, says geometry, which every engine here means to obey.
"""

from collections.abc import Callable
from functools import partial
from importlib.util import find_spec
from math import asin, degrees, inf
from random import Random
from statistics import median
from typing import Any, NamedTuple

from physics import Ball, Cloth, Shot, TimeStepping, World, laws, scenes

from . import report
from .report import Report, duration, figure
from .timing import Cost, in_turns
from .workload import Batch, break_shot, carom_shot, exact, play

RADIUS, MASS = 0.03275, 0.25
SCENES = {"single ball": scenes.single, "carom shot": carom_shot, "break": break_shot}
CUTS = (5, 50, 500)
INTERPRETED, COMPILED = "exact, interpreted", "exact, compiled"
SHOTS = {INTERPRETED: 10, COMPILED: 500}  # timed as a whole; of the others, one


class Cut(NamedTuple):
    """A ball rolls along a line at distance `offset`, m, from the centre of one that rests."""

    speed: float
    heading: float  # degrees
    offset: float
    run_up: float  # m between the centres

    @property
    def start(self) -> complex:
        d = Shot(1.0, self.heading).velocity()
        return d * (complex(0.0, self.offset) - (self.run_up**2 - self.offset**2) ** 0.5)

    @property
    def velocity(self) -> complex:
        return Shot(self.speed, self.heading).velocity()

    def error(self, v: complex) -> float:
        """Degrees between where the object ball goes and the line of centres at contact."""
        line = Shot(1.0, self.heading - degrees(asin(self.offset / (2.0 * RADIUS)))).velocity()
        turn = v * line.conjugate()
        return abs(degrees(asin(turn.imag / abs(turn)))) if turn.real > 0.0 else 180.0


def cuts(count: int) -> list[Cut]:
    """Random cuts, from full to nearly missed, at 1 to 4 m/s."""
    chance = Random(7)
    return [
        Cut(chance.uniform(1.0, 4.0), chance.uniform(0.0, 360.0),
            chance.uniform(-1.9, 1.9) * RADIUS, chance.uniform(0.2, 0.5))
        for _ in range(count)
    ]  # fmt: skip


def pair(cut: Cut, engine: Any = None) -> World:
    """The cut on ice, with smooth balls, in this package."""
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(0.95), engine=engine)
    at, v = cut.start, cut.velocity
    spin = (-v.imag / RADIUS, v.real / RADIUS, 0.0)
    world.add(Ball("cue", (at.real, at.imag), (v.real, v.imag), spin, RADIUS, MASS))
    world.add(Ball("object", (0.0, 0.0), radius=RADIUS, mass=MASS))
    return world


def cut_here(engine: Any, cut: Cut) -> complex:
    """The velocity of the object ball just after the hit, in one of this package's engines."""
    world = pair(cut, engine)
    world.run(1.0)
    hit = next((event for event in world.log if event.kind == "ball"), None)
    return complex(*hit.after[hit.balls.index("object")].velocity) if hit else 0j


def with_engine(make: Callable[[], World], engine: Any, until: float) -> None:
    world = make()
    world.engine = engine
    world.run(until)


class Peer(NamedTuple):
    """An engine: how it plays a scene (None: not timed), and how it cuts."""

    name: str
    play: Callable[[Callable[[], World], float], Callable[[], Any]]
    cut: Callable[[Cut], complex] | None


def stepping(dt: float, scheme: str, name: str) -> Peer:
    def shot(make: Callable[[], World], rests: float) -> Callable[[], Any]:
        return partial(with_engine, make, TimeStepping(dt, scheme, budget=10**7), rests)

    return Peer(name, shot, partial(cut_here, TimeStepping(dt, scheme)))


def own() -> list[Peer]:
    return [
        Peer(
            INTERPRETED,
            lambda make, _: partial(play, make, SHOTS[INTERPRETED]),
            partial(cut_here, None),
        ),
        Peer(COMPILED, lambda make, _: Batch(exact(make), SHOTS[COMPILED]), None),
        stepping(1 / 180, "thesis", "thesis's stepping, 1/180 s"),
        stepping(1 / 180, "literal", "thesis's program, 1/180 s"),
    ]


def others() -> tuple[list[Peer], list[str]]:
    """(the peers that are installed, sentences about the others)."""
    found, missing = [], []
    for module, package in (("pymunk", "'.[peers]'"), ("pooltool", "pooltool-billiards")):
        if find_spec(module):
            from importlib import import_module

            found += import_module(f"benchmarks.peer_{module}").peers()
        else:
            missing.append(
                f"{module} is not installed, so it is left out: `pip install {package}`."
            )
    return found, missing


def timed(peers: list[Peer], effort: int) -> dict[str, dict[str, Cost]]:
    """scene -> peer -> CPU seconds a shot, in turns."""
    costs: dict[str, dict[str, Cost]] = {}
    for scene, make in list(SCENES.items())[: 3 if effort else 1]:
        world = make()
        world.run()
        runs = {peer.name: peer.play(make, world.time) for peer in peers}
        for run in runs.values():
            run()  # so that loading and compiling are not timed
        costs[scene] = in_turns(runs, (1, 3, 7)[effort])
        for name, shots in SHOTS.items():
            costs[scene][name] = costs[scene][name].per(shots)
    return costs


def cut_errors(peers: list[Peer], effort: int) -> dict[str, list[float]]:
    """peer -> the error of each cut, degrees, sorted; inf where the balls did not meet."""
    errors = {}
    for peer in peers:
        if peer.cut is not None:
            pairs = [(cut, peer.cut(cut)) for cut in cuts(CUTS[effort])]
            errors[peer.name] = sorted(cut.error(v) if v else inf for cut, v in pairs)
    return errors


def main(arguments: list[str] | None = None) -> int:
    options = report.options("peers", __doc__, arguments)
    effort = options.effort
    page = Report("peers", "The same scenes elsewhere", options.out)
    found, missing = others()
    peers = [*own(), *found]
    costs, errors = timed(peers, effort), cut_errors(peers, effort)
    page.say(
        "CPU time of a shot until the exact engine's balls rest, the least of runs in turns; every"
        " engine with its own laws, so the shots are alike, not equal: pymunk knows no spin and no"
        " sliding (and asks a function in Python for rolling friction: on ice it does without),"
        " pooltool has a cushion of its own. Error of direction: cuts of a resting ball at random,"
        " smooth balls, against the line of centres at contact; a degree is 17 mm a metre on."
        " The thesis's program is its arithmetic without its pictures.",
        *missing,
    )
    rows = []
    for peer in peers:
        off = errors.get(INTERPRETED if peer.name == COMPILED else peer.name)  # the same bits
        angles = [median(off), off[(9 * len(off)) // 10], off[-1]] if off else []
        times = [duration(costs[scene][peer.name].least) for scene in costs]
        rows.append([peer.name, *times, *(map(_angle, angles) if off else "–––")])
    page.table(["engine", *costs, "error of direction, median", "worst tenth", "worst"], rows)
    rows = pool_beside(page, effort)
    page.data(
        ["engine", "scene", "least s", "median s"],
        [[peer.name, scene, *costs[scene][peer.name]] for scene in costs for peer in peers] + rows,
    )
    page.save()
    return 0


def pool_beside(page: Report, effort: int) -> list[list[Any]]:
    """The section on pool, where pooltool is installed; its numbers."""
    if not find_spec("pooltool"):
        return []
    from importlib import import_module

    from . import peer_pool

    return peer_pool.compare(page, import_module("benchmarks.peer_pooltool").pool(), effort)


def _angle(degree: float) -> str:
    return "missed" if degree == inf else f"{figure(degree, 2)}°"
