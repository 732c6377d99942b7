"""Strokes that pot a ball along a way: at several speeds and tips, each aimed by trying it."""

from __future__ import annotations

from cmath import phase
from collections.abc import Generator, Iterator
from dataclasses import replace
from math import degrees, sqrt

from physics import World, heading

from .chances import Route
from .craft import Craft
from .declaring import declared
from .levels import MISCUE, Attempt
from .starts import Start
from .trying import Candidate, Sequel, Trials

ARRIVING = 0.35  # m/s: of a ball that just reaches its pocket
FASTEST = 8.0  # m/s
AIMINGS = 3  # strokes to find an aim
CLOSE = 0.2  # of the window's half: an aim that needs no more
WILDEST = 8.0  # degrees: the greatest correction of an aim

Found = Generator[None, None, list[Candidate]]


def pots(trials: Trials, start: Start, way: Route, craft: Craft) -> Found:
    """Strokes that pot the ball that way; stops after each that is tried."""
    found: list[Candidate] = []
    slowest = speed_for(trials.world, way)
    for times in craft.speeds:
        for right, up in craft.tips:
            aim = Attempt(heading(way.ghost - start.at), min(FASTEST, times * slowest), right, up)
            one = yield from aimed(trials, start, way, aim)
            found += [one] if one else []
    return found


def aimed(
    trials: Trials, start: Start, way: Route, aim: Attempt
) -> Generator[None, None, Candidate | None]:
    """The stroke with its angle set right, None if it does not pot."""
    call = declared(start.match, way.ball, way.opening.hole.name)
    turns = way.run / (trials.judge.eye.width * way.cut)  # of the ball, a degree of the aim
    best: Sequel | None = None
    for _ in range(AIMINGS):
        done = trials.play(start, call, aim)
        yield
        if done is None:
            break
        off = _off(done, way)
        if done.verdict.made and not done.verdict.lost:
            best, meant = done, aim
        if off is None or abs(off) < CLOSE * way.opening.half:
            break
        turn = max(-WILDEST, min(WILDEST, degrees(off) / turns))
        aim = replace(aim, angle=aim.angle + turn)
    if best is None:
        return None
    return Candidate(start, call, meant, True, way.chance * best.worth, way)


def variants(one: Candidate) -> Iterator[Attempt]:
    """The same stroke a little faster, slower, and with the tip elsewhere."""
    aim = one.aim
    yield replace(aim, speed=min(FASTEST, 1.15 * aim.speed))
    yield replace(aim, speed=0.87 * aim.speed)
    for right, up in ((0.0, 0.18), (0.0, -0.18), (0.25, 0.0), (-0.25, 0.0)):
        yield replace(aim, right=aim.right + right, up=aim.up + up).within(0.9 * MISCUE)


def speed_for(world: World, way: Route, far: float | None = None) -> float:
    """The speed of the cue ball with which the ball just arrives at its pocket, m/s.

    far: how far the ball has to roll, m, if it does not go straight.
    """
    if far is None:
        far = abs(way.opening.hole.middle - way.ghost)
    return _faster(world, speed_along(world, far) / (0.95 * way.cut), way.run)


def speed_along(world: World, far: float) -> float:
    """The speed with which a ball that is hit full arrives so far away, m and m/s."""
    # it slides first, until 5/7 of the speed are left
    return 1.4 * _faster(world, ARRIVING, far)


def _faster(world: World, speed: float, far: float) -> float:
    """The speed of a ball that has that speed when it has rolled so far."""
    return sqrt(speed * speed + 2.0 * world.cloth.roll * world.cloth.gravity * far)


def _off(done: Sequel, way: Route) -> float | None:
    """By how much the ball left its way to the left, radians; None if it did not move."""
    legs = done.world.log.legs(way.ball)
    if len(legs) < 2 or not legs[1].velocity:
        return None
    return phase(legs[1].velocity * way.opening.way.conjugate())
