"""Where a player's aim begins: at a ball that may be hit first, and that the cue ball can reach."""

from __future__ import annotations

from cmath import rect
from collections.abc import Collection, Iterator, Mapping
from math import asin, inf, sqrt

from physics import World

ASIDE = (0.0, 0.25, -0.25, 0.5, -0.5, 0.75, -0.75, 0.9, -0.9)
"""Of the distance at which two balls touch: full on the ball first, then thinner and thinner."""


def way(world: World, cue: str, wanted: Collection[str]) -> complex:
    """From the cue ball to the nearest of the wanted balls that would be met first, m.

    Full on it where that is free; where none can be reached, towards the nearest all the same,
    and along the table if there is none.
    """
    own = complex(*world.ball(cue).position)
    others = {b.name: complex(*b.position) - own for b in world.balls if not b.gone}
    touch = {b.name: world.ball(cue).touching_distance(b) for b in world.balls}
    others.pop(cue, None)
    near = sorted((name for name in wanted if name in others), key=lambda n: abs(others[n]))
    ways = list(_ways([others[name] for name in near], [touch[name] for name in near]))
    free = (w for w in ways if _met(w, others, touch) in wanted)
    return next(free, ways[0] if ways else 1.0 + 0j)


def _ways(lines: list[complex], touch: list[float]) -> Iterator[complex]:
    for part in ASIDE:
        for line, wide in zip(lines, touch, strict=True):
            yield line * rect(1.0, asin(part * min(wide / abs(line), 1.0))) if part else line


def _met(way: complex, others: Mapping[str, complex], touch: Mapping[str, float]) -> str:
    """The ball that is met first along a straight way, or ""."""
    ahead = way / abs(way)
    reach = {name: _reach(line / ahead, touch[name]) for name, line in others.items()}
    found = min(reach, key=lambda name: reach[name], default="")
    return found if found and reach[found] < inf else ""


def _reach(line: complex, touch: float) -> float:
    """How far along the way a ball is met, which lies at `line` as seen along it; inf if not."""
    left = touch * touch - line.imag * line.imag
    return line.real - sqrt(left) if line.real > 0 and left > 0 else inf
