"""Aims that may be worth trying, drawn at random where points are dense."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import asin, atan2, cos, degrees, dist, exp, log, sin, sqrt, tau
from random import Random

from .levels import Attempt

Place = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Style:
    """What is tried: speeds from `slow` to `fast` m/s, tips within `tip` radii of the centre, and
    which share of the aims goes at a cushion first.
    """

    slow: float
    fast: float
    tip: float
    bank: float


DIRECT = Style(0.7, 4.0, 0.45, 0.1)
CUSHIONS = Style(1.8, 6.5, 0.45, 0.25)


def aims(
    cue: Place, targets: Sequence[Place], radius: float, style: Style, rng: Random
) -> Iterator[Attempt]:
    """Aims from the ball at `cue` without end: at any thickness of a target, or anywhere.

    Places in m; equal balls of `radius` m.
    """
    while True:
        if not targets or rng.random() < style.bank:
            angle = rng.uniform(-180.0, 180.0)
        else:
            angle = _cut(cue, rng.choice(targets), 2 * radius, rng)
        speed = exp(rng.uniform(log(style.slow), log(style.fast)))
        out, turn = style.tip * sqrt(rng.random()), tau * rng.random()
        yield Attempt(angle, speed, out * cos(turn), out * sin(turn))


def _cut(cue: Place, target: Place, reach: float, rng: Random) -> float:
    """The direction in degrees of a hit on the target at a random thickness."""
    bearing = atan2(target[1] - cue[1], target[0] - cue[0])
    widest = reach / max(reach, dist(cue, target))
    return degrees(bearing + asin(widest * rng.uniform(-1.0, 1.0)))
