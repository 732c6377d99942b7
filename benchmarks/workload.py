"""The scenes that are timed, the ways to run them, and where their balls truly come to rest."""

from collections.abc import Callable, Sequence
from math import inf
from typing import Any, NamedTuple

from physics import EventDriven, Shot, TimeStepping, World, scenes, simulate

STRIKE = Shot(3.0, 40.0, follow=0.5, side=1.5)  # three hits of balls
BREAK = Shot(8.0, 1.5)  # off centre: head-on is symmetric, and half the work
SINGLE = Shot(3.0, 25.0, follow=0.5, side=1.5)  # what the scene `single` begins with
TIMES = (1.0, 2.0, inf)  # s: when errors are taken

Positions = list[complex]


def carom_shot() -> World:
    """The scene `carom` with the white on its way."""
    world = scenes.carom()
    world.strike("white", STRIKE)
    return world


def break_shot() -> World:
    """Sixteen balls, gaps of 1e-5 m, broken at 8 m/s."""
    world = scenes.rack15()
    world.strike("cue", BREAK)
    return world


SCENES: dict[str, Callable[[], World]] = {
    "thesis 1": scenes.thesis_1,
    "thesis 2": scenes.thesis_2,
    "thesis 3a": scenes.thesis_3a,
    "thesis 3b": scenes.thesis_3b,
    "single ball": scenes.single,
    "carom shot": carom_shot,
    "break": break_shot,
}
STEPPED = {
    "thesis stepping": "thesis",
    "thesis program": "literal",
    "Euler": "euler",
    "RK4": "rk4",
    "RK4, contacts located": "rk4-located",
}


def positions(world: World) -> Positions:
    return [complex(*ball.position) for ball in world.balls]


def worst(there: Sequence[complex], true: Sequence[Any]) -> float:
    """The distance, m, of the ball that is furthest from where it should be."""
    return max(float(abs(q - p)) for p, q in zip(there, true, strict=True))


class Truth(NamedTuple):
    """Where the balls are at each of TIMES, in 50 digits; when all rest, s; how many events."""

    positions: list[list[Any]]
    rests: float
    events: int


def truth(make: Callable[[], World], times: Sequence[float] = TIMES) -> Truth:
    """The same kernel source run in 50-digit numbers."""
    from tests.support import fifty

    package: Any = fifty.kernel()
    scene, places, events, last = fifty.scene(make()), [], 0, 0.0
    for time in times:
        more, when = package.calendar.advance(time, 10**5, scene)
        if more:
            events, last = events + more, float(when)
        lapse = [fifty.exact(time) - ball.since if time < inf else 0 for ball in scene.balls]
        pairs = zip(scene.balls, lapse, strict=True)
        places.append([package.leg.place(ball, t) if t else ball.position for ball, t in pairs])
    return Truth(places, last, events)


def along(world: World, times: Sequence[float], rests: float) -> list[Positions]:
    """Where the balls are at each time of a run; one that never rests stops at `rests`."""
    never = isinstance(world.engine, TimeStepping) and world.engine.scheme == "literal"
    places = []
    for time in times:
        end = rests if never and time == inf else time
        if end > world.time:
            world.run(end)
        places.append(positions(world))
    return places


def stepped(make: Callable[[], World], scheme: str, dt: float) -> World:
    """The scene with a stepping engine."""
    world = make()
    world.engine = TimeStepping(dt, scheme, budget=10**7)
    return world


class Batch:
    """The same scene many times over, in arrays, for the compiled kernel; each with a shot of the
    table, if it is said which ball is struck."""

    def __init__(self, world: World, shots: int, struck: int = -1) -> None:
        import numpy as np

        from physics.batch.compiled import kernel, near, packed
        from physics.batch.outcomes import contact_type
        from physics.batch.shots import before_of

        world.plan()
        n, body = len(world.balls), kernel().body
        self.many, self.scene, self.before = (
            kernel().calendar.many,
            packed(world.scene),
            before_of(world),
        )
        self.struck = struck
        self.places, self.table, self.rests = (
            np.empty((0, n, 2)),
            np.empty((shots, 6)),
            np.empty((shots, n, 2)),
        )
        self.times, self.events = np.empty(shots), np.empty(shots, np.int64)
        self.notes = body.Notes(
            0, np.zeros((0, 0), contact_type()), np.zeros(0, np.int64), *near(1, 0)
        )

    def __call__(self) -> None:
        self.many(
            self.before, self.places, self.table, self.struck, self.rests, self.times,
            self.events, 10**5, self.scene, self.notes,
        )  # fmt: skip

    def positions(self) -> Positions:
        """Where the balls of the last shot rest."""
        return [complex(x, y) for x, y in self.rests[-1]]


def fan(shots: int) -> list[Shot]:
    """Shots at 3 m/s with follow and side, in so many directions."""
    return [Shot(3.0, 360.0 * k / shots, follow=0.5, side=1.5) for k in range(shots)]


def at_rest(make: Callable[[], World]) -> World:
    """The scene before anything was struck."""
    world = make()
    world.stop()
    world.plan()
    return world


def play_shot(world: World, ball: str, shot: Shot, times: int) -> None:
    """The same shot from the same world, again and again."""
    for _ in range(times):
        simulate(world, ball, shot)


def play_fan(world: World, shots: Sequence[Shot]) -> int:
    """Every shot at the white, one after the other; how many events that was."""
    return sum(len(simulate(world, "white", shot).log) for shot in shots)


def play(make: Callable[[], World], times: int) -> None:
    """A scene to rest, again and again."""
    for _ in range(times):
        make().run()


def exact(make: Callable[[], World]) -> World:
    """The scene with the exact engine."""
    world = make()
    world.engine = EventDriven()
    return world
