"""A hit of two balls on a cloth that rubs meanwhile, integrated: Mathavan, Jackson and Parkin 2014.

What friction between the balls presses down is dragged by the cloth, at once (Sports Engineering 17
(2014) 227). The picture is that of laws: ball 2 lies towards +x; mass 1; see physics/laws.py.
"""

from typing import NamedTuple

STEPS = 1000


class Moving(NamedTuple):
    """A ball: velocity, roll and side, m/s."""

    v: complex
    roll: complex = 0j
    side: float = 0.0


def unit(z):
    return z / abs(z) if abs(z) > 1e-12 else 0j


def dragged(ball, press, slide):
    """What the cloth takes from a ball that is pressed on it, as a change of velocity."""
    slip = ball.v - ball.roll
    most = slide * max(0.0, press)
    return -min(most, abs(slip) / 3.5) * unit(slip)


def step(one, two, push, mu, slide):
    """Both balls after a push so small that all slips stay."""
    along = (one.v - two.v).imag + one.side + two.side
    slip = complex(along, -(one.roll + two.roll).real)
    rub = -min(mu * push, abs(slip) / 7.0) * unit(slip)
    found = []
    for ball, sign in ((one, 1.0), (two, -1.0)):
        drag = dragged(ball, -sign * rub.imag, slide)
        v = ball.v + sign * complex(-push, rub.real) + drag
        found.append(Moving(v, ball.roll - 2.5 * rub.imag - 2.5 * drag, ball.side + 2.5 * rub.real))
    return found


def hit(one, two, e=0.946, mu=0.05, slide=0.212):
    """Both balls after it; restitution is that of the work (Stronge), as in the paper."""
    push = (one.v - two.v).real / STEPS
    work, goal = 0.0, None
    while goal is None or work < goal:
        before = (one.v - two.v).real
        one, two = step(one, two, push, mu, slide)
        after = (one.v - two.v).real
        work += 0.5 * push * abs(before + after)
        if goal is None and after <= 0.0:
            goal, work = e * e * work, 0.0
    return one, two
