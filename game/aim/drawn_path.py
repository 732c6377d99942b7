"""A path drawn by hand, and the shot with which the cue ball runs along it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from math import dist, hypot
from typing import NamedTuple

from game.text.numerals import plain
from physics import EventDriven, World, recover_drawn

from .entry import BOXES

Place = tuple[float, float]
NEAR = 3.0
"""Radii of the ball within which a path begins at it."""
APART = 0.004
"""Metres between points of a path at least."""
SHORTEST = 0.15
"""Metres of a path at least."""
FARTHEST = 0.06
"""Metres by which a shot may miss the drawing and still be what was meant."""
LEAST = 0.5
"""Part of the drawing that the ball must follow at least."""


class Found(NamedTuple):
    """What has been found.

    value  of the command `recover`: the five numbers, by how many cm the path misses the drawing,
           deviations of speed, angle and spin, and how much of the drawing is followed, %; "" if
           no shot runs along it
    off    by how much the best misses the drawing, cm
    """

    value: str
    off: str


def nearby(world: World, name: str, at: Place) -> bool:
    """Does a path that begins there begin at the ball?"""
    ball = world.ball(name)
    return not ball.gone and dist(ball.position, at) <= NEAR * ball.radius


def on_cloth(world: World, name: str, at: Place, size: Place) -> Place:
    """The place nearest to a point at which the ball may lie between the four sides, m."""
    radius = world.ball(name).radius
    halves = (side / 2 - radius for side in size)
    x, y = (min(max(c, -half), half) for c, half in zip(at, halves, strict=True))
    return x, y


def length(points: Sequence[Place]) -> float:
    """Of a path, m."""
    return sum(dist(a, b) for a, b in pairwise(points))


def recovered(tell: Callable[[object], None], world: World, name: str, path: list[Place]) -> Found:
    """The shot along a path; ValueError for a path or a world in which none can be looked for."""
    world.engine = EventDriven()  # fixed steps have no derivatives
    found = recover_drawn(world, name, path)
    off = plain(100.0 * found.misfit, 1)
    if found.misfit > FARTHEST or found.share < LEAST:
        return Found("", off)
    errors = found.errors
    spin = hypot(errors["follow"], errors["side"])
    known = plain(errors["speed"], 1), plain(errors["angle"], 2), plain(spin, 1)
    numbers = [plain(getattr(found.shot, box), 2) for box in BOXES]
    words = [*numbers, off, *known, f"{100.0 * found.share:.0f}"]
    return Found(" ".join(words), off)
