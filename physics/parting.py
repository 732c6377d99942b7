"""Balls that fixed steps have left overlapping are parted before an exact engine moves them on."""

from collections.abc import Sequence

from .ball import Ball
from .kernel.motion import length
from .places import OVERLAP, overlapping
from .wall import Obstacle

GAP = 3e-5  # radii: how far apart they are put; it cannot be seen, and brings the sweeps to an end
SWEEPS = 2_000  # 60 balls in a heap take 700; where there is no room, some overlap remains


def part(balls: Sequence[Ball], walls: Sequence[Obstacle]) -> None:
    """Move balls on the cloth as little as it takes: both of a pair by half, sweep after sweep."""
    here = [ball for ball in balls if ball.height == 0.0 and not ball.gone]
    for _ in range(SWEEPS):
        pairs = list(overlapping(here, OVERLAP))
        for ball, other in pairs:
            _push_apart(ball, other)
        if not (_push_inside(here, walls) or pairs):
            return


def _push_apart(ball: Ball, other: Ball) -> None:
    """Half of what is missing for each, along their line; a ball in the same place goes east."""
    p, q = complex(*ball.position), complex(*other.position)
    far, line = length(q - p), q - p
    lacks = ball.touching_distance(other) - far
    if lacks > OVERLAP:
        shift = 0.5 * (lacks + GAP * ball.radius) * (line / far if far else 1.0)
        _move(ball, p - shift)
        _move(other, q + shift)


def _push_inside(balls: Sequence[Ball], walls: Sequence[Obstacle]) -> bool:
    """Bring every ball back in front of the walls; returns whether one was behind them."""
    some = False
    for ball in balls:
        for wall in walls:
            if not wall.pushes:
                continue
            lacks = ball.radius - wall.distance(ball.position)
            if lacks > OVERLAP:
                away = (lacks + GAP * ball.radius) * wall.facing(ball.position)
                _move(ball, complex(*ball.position) + away)
                some = True
    return some


def _move(ball: Ball, to: complex) -> None:
    ball.disturb().position = to
