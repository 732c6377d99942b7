"""How far a shot may be off, and how thick it hits: from the exact derivatives of its contacts."""

from __future__ import annotations

from cmath import phase
from collections.abc import Callable
from math import inf
from typing import Any, NamedTuple

import numpy as np

from danggu.rules.stroke import TIE
from physics import Sensitivity, World, sensitivity, simulate

from .bench import Bench
from .chances import Route
from .errors import SPIN
from .levels import Attempt
from .solution import Thickness, Tolerance

NUMBERS = ("speed", "angle", "follow", "side")
MIDDLE = 0.01  # of the width of two radii: a hit that near the middle is full
STEPS = 16  # strokes of which each is off by more than the one before
REACH = np.array([[20.0], [0.5], [0.3], [0.3]])  # of them, where the range is longer
FARTHEST = (180.0, 1.0, 1.0, 1.0)  # degrees, share, radii: an input that may go so far has no limit
Limit = tuple[float, Any, float, float]  # a value, its slopes, and between what it has to stay
Limits = Callable[[Sensitivity], list[Limit]]


class Meeting(NamedTuple):
    """The cue ball as it meets another ball.

    ball: name of the other.
    line: from the cue ball's centre to the other's, m.
    speed: of the cue ball over the other, m/s.
    lines, speeds: (N,), their derivatives.
    """

    ball: str
    line: complex
    speed: complex
    lines: Any
    speeds: Any

    @property
    def aside(self) -> float:
        """How far the other's centre is to the left of where the cue ball is heading, m."""
        return (self.speed.conjugate() * self.line).imag / abs(self.speed)

    @property
    def limits(self) -> list[Limit]:
        """Neither does it pass the other, nor does it stop before it."""
        way, width = self.speed / abs(self.speed), abs(self.line)
        along = (way.conjugate() * self.line).real
        turns = (way.conjugate() * self.speeds).imag / abs(self.speed)
        aside = (way.conjugate() * self.lines).imag - along * turns
        square = abs(self.speed) ** 2
        return [
            (self.aside, aside, -width, width),
            (square, 2.0 * (self.speed.conjugate() * self.speeds).real, 0.0, inf),
        ]


def thickness(world: World, cue: str, aim: Attempt) -> Thickness | None:
    """How the stroke hits its first ball; None if it hits none."""
    hit = next(
        (e for e in simulate(world, cue, aim.shot()).log if e.kind == "ball" and cue in e.balls),
        None,
    )
    return None if hit is None else thick(_met(hit, cue, None))


def thick(met: Meeting) -> Thickness:
    """How it hits that ball."""
    part = met.aside / abs(met.line)
    # the other's centre to the left: its right side is hit
    side = "full" if abs(part) < MIDDLE else "right" if part > 0.0 else "left"
    return Thickness(met.ball, 8.0 * (1.0 - abs(part)), side)


def tolerance(world: World, cue: str, aim: Attempt, limits: Limits) -> Tolerance | None:
    """How far the stroke may be off within these limits; None where no derivatives are known."""
    try:
        slopes = sensitivity(world, cue, aim.shot(), NUMBERS)
    except ValueError:
        return None
    found = [(x, _by(by, aim), low, high) for x, by, low, high in limits(slopes)]
    angle, speed, right, up = (
        _range([(x, by[k], low, high) for x, by, low, high in found], most)
        for k, most in enumerate(FARTHEST)
    )
    return Tolerance(angle, speed, right, up)


def until(cue: str, time: float) -> Limits:
    """The cue ball still hits the balls that it hits until then, s."""

    def limits(slopes: Sensitivity) -> list[Limit]:
        hits = [one for one in slopes.events if one.event.kind == "ball" and cue in one.event.balls]
        met = [_met(one.event, cue, one.before) for one in hits if one.event.time <= time + TIE]
        return [limit for each in met for limit in each.limits]

    return limits


def into(cue: str, way: Route) -> Limits:
    """The ball still goes into its pocket."""

    def limits(slopes: Sensitivity) -> list[Limit]:
        for one in slopes.events:
            names = one.event.balls
            if one.event.kind == "ball" and {*names} == {cue, way.ball}:
                k = names.index(way.ball)
                off = phase(complex(*one.event.after[k].velocity) * way.opening.way.conjugate())
                return [(off, one.headings()[k], -way.opening.half, way.opening.half)]
        return []

    return limits


def tried(bench: Bench, aim: Attempt, found: Tolerance) -> Tolerance:
    """The tolerance as far as strokes in fact score that are off by parts of it: to first order
    alone, kisses are overlooked and long ranges come out too long."""
    ends = np.array([found.angle, found.speed, found.right, found.up])
    most = np.clip(ends, -REACH, REACH)
    offs = np.zeros((4, 2, STEPS, 4))
    for k in range(4):
        offs[k, :, :, k] = most[k][:, None] * np.arange(1, STEPS + 1) / STEPS
    made = bench.play(_off(aim, offs.reshape(-1, 4))).made.reshape(4, 2, STEPS)
    reached = np.cumprod(made, axis=2).sum(axis=2)
    ends = np.where(reached == STEPS, ends, most * reached / STEPS)
    return Tolerance(*((float(low), float(high)) for low, high in ends))


def _off(aim: Attempt, offs: Any) -> Any:
    """(strokes, 6): shots that are off by these, (strokes, 4), as in a Tolerance."""
    angle, speed = aim.angle + offs[:, 0], aim.speed * (1.0 + offs[:, 1])
    spin, none = SPIN * speed, np.zeros(len(offs))
    up, right = spin * (aim.up + offs[:, 3]), spin * (aim.right + offs[:, 2])
    return np.stack([speed, angle, up, none, right, none], axis=1)


def _met(event: Any, cue: str, slopes: Any) -> Meeting:
    own = event.balls.index(cue)
    a, b = event.before[own], event.before[1 - own]
    line = complex(*b.position) - complex(*a.position)
    speed = complex(*a.velocity) - complex(*b.velocity)
    if slopes is None:
        return Meeting(event.balls[1 - own], line, speed, 0.0, 0.0)
    apart = slopes[1 - own] - slopes[own]
    return Meeting(
        event.balls[1 - own], line, speed, apart[0] + 1j * apart[1], -apart[2] - 1j * apart[3]
    )


def _by(slopes: Any, aim: Attempt) -> tuple[float, float, float, float]:
    """By angle, share of the speed, and the tip, from those by the numbers of a shot: the spin goes
    with the speed."""
    speed, angle, follow, side = slopes
    spin = SPIN * aim.speed
    up, right = spin * follow, spin * side
    return angle, aim.speed * speed + aim.up * up + aim.right * right, right, up


def _range(limits: list[Any], farthest: float) -> tuple[float, float]:
    """How far an input may go down and up."""
    low, high = -inf, inf
    for x, slope, least, most in limits:
        if slope and least <= x <= most:  # a ball off the jaw is outside from the first
            ends = sorted(((least - x) / slope, (most - x) / slope))
            low, high = max(low, ends[0]), min(high, ends[1])
    low, high = min(float(low), 0.0), max(float(high), 0.0)
    return low if low > -farthest else -inf, high if high < farthest else inf
