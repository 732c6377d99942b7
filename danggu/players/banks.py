"""Pots and hits by one cushion: along mirror images, and a little beside them."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees

from physics import heading

from .chances import Lie, Opening, Route
from .declaring import declared
from .levels import Attempt
from .lies import lie_and_targets
from .potting import FASTEST, Found, speed_along, speed_for
from .starts import Start
from .trying import Candidate, Trials

FANNED = (0.0, 2.0, -2.0, 4.0, -4.0, 6.0)  # degrees that a bank is tried off the mirror's way
BANKED, KICKED = (1.6, 2.6), (1.2, 2.2)  # multiples of the slowest speed
LOST = 0.6  # of a radius, to either side: what a mouth takes of a ball that a cushion has turned
MOUTH = 0.1  # m from a pocket: there is no rail to be met


def kicks(trials: Trials, start: Start, count: int) -> Found:
    """Strokes at a cushion first, from which the cue ball comes to a ball that is on."""
    found: list[Candidate] = []
    lie, targets = lie_and_targets(trials.world, start.match)
    ways = [
        (far, name, line)
        for name in targets
        for line, far in mirrored(trials, start.at, lie[name], name, lie)
    ]
    for far, name, line in sorted(ways, key=lambda one: one[0])[:count]:
        slowest = speed_along(trials.world, 1.3 * far)
        turn = degrees(2 * trials.radius / far)
        call = declared(start.match, name, safety=True)
        for times in KICKED:
            for fan in FANNED:
                aim = Attempt(heading(line) + 0.3 * fan * turn, times * slowest)
                done = trials.play(start, call, aim)
                yield
                if done is not None and not done.verdict.foul:
                    found.append(Candidate(start, call, aim, False, done.worth))
    return found


def banks(trials: Trials, start: Start, count: int) -> Found:
    """Pots off one cushion, the likeliest of as many ways."""
    found: list[Candidate] = []
    for way, far in sorted(_banked(trials, start), key=lambda one: -one[0].chance)[:count]:
        call = declared(start.match, way.ball, way.opening.hole.name)
        slowest = speed_for(trials.world, way, 1.5 * far)
        turns = way.run / (trials.judge.eye.width * way.cut)
        for times in BANKED:
            for fan in FANNED:
                aim = Attempt(
                    heading(way.ghost - start.at) - fan / turns, min(FASTEST, times * slowest)
                )
                done = trials.play(start, call, aim)
                yield
                if done is not None and done.verdict.made:
                    found.append(Candidate(start, call, aim, True, way.chance * done.worth, way))
    return found


def _banked(trials: Trials, start: Start) -> Iterator[tuple[Route, float]]:
    """Ways to the mirror images of the mouths, and how far they are, m."""
    eye = trials.judge.eye
    lie, targets = lie_and_targets(trials.world, start.match)
    for name in targets:
        others = [place for ball, place in lie.items() if ball != name]
        for hole in eye.holes:
            for line, far in mirrored(trials, lie[name], hole.middle, name, lie):
                opening = Opening(hole, line / far, LOST * trials.radius / far)
                way = eye.way(start.at, name, lie[name], opening, others)
                if way is not None:
                    yield way, far


def mirrored(
    trials: Trials, start: complex, end: complex, name: str, lie: Lie
) -> Iterator[tuple[complex, float]]:
    """The straight lines from a place to the mirror images of another one, and their lengths, m,
    as far as no ball but `name` stands beside either part."""
    table, eye = trials.world.table, trials.judge.eye
    x, y = table.length / 2 - trials.radius, table.width / 2 - trials.radius
    others = [place for ball, place in lie.items() if ball != name]
    for image in (
        complex(2 * x - end.real, end.imag), complex(-2 * x - end.real, end.imag),
        complex(end.real, 2 * y - end.imag), complex(end.real, -2 * y - end.imag),
    ):  # fmt: skip
        turn = _crossing(start, image, x, y)
        if turn is None or not eye.free(start, turn, others):
            continue
        near = end - eye.width * (end - turn) / max(abs(end - turn), 1e-9)
        if eye.free(turn, near, others):
            yield image - start, abs(image - start)


def _crossing(at: complex, image: complex, x: float, y: float) -> complex | None:
    """Where the straight line leaves the rectangle of the centres, unless at a pocket."""
    line = image - at
    shares = [
        (side - have) / step
        for side, have, step in (
            (x, at.real, line.real), (-x, at.real, line.real),
            (y, at.imag, line.imag), (-y, at.imag, line.imag),
        )
        if step and (side - have) / step > 1e-6
    ]  # fmt: skip
    turn = at + min(shares) * line if shares else at
    near_corner = abs(turn.real) > x - MOUTH and abs(turn.imag) > y - MOUTH
    near_side = abs(turn.real) < MOUTH and abs(turn.imag) > y - 1e-6
    return None if near_corner or near_side else turn
