"""Touching clusters, accurately: springs of Hertz between the balls, until all have parted.

Every contact pushes with F = k δ^(3/2) (1 + λ δ'), δ its overlap, along a line of centres that
stays as it is (docs/physics.md, "Clusters"). The outcome depends neither on speed nor on
stiffness nor on radius, so all is computed with the greatest closing speed, a mass and a k of 1.
"""

from collections.abc import Sequence
from math import inf, sqrt
from typing import TYPE_CHECKING, Any

from physics.kernel.body import Body, Scene
from physics.kernel.calendar import happen as happen_quickly
from physics.kernel.calendar import plan_meetings, start_leg
from physics.kernel.cluster import closing_speed
from physics.kernel.coefficients import restitution
from physics.kernel.grid import MISSING, pass_by
from physics.kernel.impulses import RUB, ask, slip_between, solve
from physics.kernel.kinds import CLUSTER, NOTHING, SLIDING, UNSOLVED
from physics.kernel.lasting import leans
from physics.kernel.laws import ALCIATORE_BALL, CUSTOM_BALL, ROUGH_BALL, grip, press, toward
from physics.kernel.leg import carry, place
from physics.kernel.subset import room
from physics.kernel.tilt import between, tilt

if TYPE_CHECKING:
    from physics.laws import HertzCluster

TOLERANCE = 1e-9  # of a step, in units of the overlap and of the greatest speed
QUIET = 1e-9  # of the greatest closing speed: what closes more slowly is left to the next event
STEPS = 20_000  # a full rack takes about 200
ODD = 101  # with fifty terms the fraction has all digits up to 20
LEAST = 1e-3  # restitution: no damping is strong enough for 0

# Dormand and Prince, "A family of embedded Runge-Kutta formulae", J. Comp. Appl. Math. 6 (1980) 19
STAGES = (
    (1 / 5,),
    (3 / 40, 9 / 40),
    (44 / 45, -56 / 15, 32 / 9),
    (19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729),
    (9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656),
    (35 / 384, 0.0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84),
)
ERROR = (71 / 57600, 0.0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40)

Contacts = list[tuple[int, int]]


def happen(i: int, scene: Scene, law: "HertzCluster") -> Any:
    """The next event of ball i, as the kernel's own function returns it.

    It is the kernel's own, except for clusters that close with more than the least parting speed.
    """
    balls, rule = scene.balls, scene.ball_rule
    if scene.celled and pass_by(i, balls, scene.grid):
        return NOTHING, MISSING
    ball = balls[i]
    time, j = ball.next, ball.partner
    if ball.meets > ball.leg_end or len(balls) < 3 or max(ball.phase, balls[j].phase) > SLIDING:
        return happen_quickly(i, scene)
    members, contacts = gather(i, j, time, balls, law.gap)
    if len(members) < 3:
        return happen_quickly(i, scene)
    for m in members:
        carry(balls[m], time, scene.cloth)
    closing = [closing_speed(balls[a], balls[b]) for a, b in contacts]
    quiet = max(closing) <= rule.parting or leans(ball, balls[j], scene.cloth)
    if quiet:  # contacts that last are the kernel's
        return happen_quickly(i, scene)
    e = _restitution(law, max(closing), rule)
    pushes = outcome([balls[m] for m in members], _within(contacts, members), e)
    if not _apply(contacts, pushes, scene):
        return UNSOLVED, len(contacts)
    for m in members:
        start_leg(m, scene)
    for m in members:
        plan_meetings(m, scene)
    return CLUSTER, len(contacts)


def gather(i: int, j: int, time: float, balls: Any, gap: float) -> tuple[list[int], Contacts]:
    """The balls connected with i and j by gaps below `gap`, m; and their contacts."""
    members, contacts = [i, j], [(i, j)]
    for a in members:
        spot = place(balls[a], time - balls[a].since)
        for k, other in enumerate(balls):
            if k == a or {a, k} == {i, j} or other.phase > SLIDING:
                continue
            far = between(balls[a], other, place(other, time - other.since) - spot)
            if far < balls[a].radius + other.radius + gap:
                if k not in members:
                    members.append(k)
                if members.index(k) > members.index(a):
                    contacts.append((a, k))
    return members, contacts


def _within(contacts: Contacts, members: list[int]) -> Contacts:
    at = {m: k for k, m in enumerate(members)}
    return [(at[a], at[b]) for a, b in contacts]


def _restitution(law: "HertzCluster", closing: float, rule: Any) -> float:
    if law.e is None and rule.kind == CUSTOM_BALL:
        raise ValueError("HertzCluster.e must be given: a custom ball law has no such number")
    return max(LEAST, restitution(closing, rule) if law.e is None else law.e)


def _apply(contacts: Contacts, pushes: Sequence[float], scene: Scene) -> bool:
    """The pushes, then the rubs; and a note of them where the engine looks for it.

    False if the rubs could not be found.
    """
    balls = scene.balls
    room(scene.ties, len(contacts))
    ties = scene.ties.contacts[: len(contacts)]
    for tie, (first, second), push in zip(ties, contacts, pushes, strict=True):
        tie.first, tie.second, tie.total = first, second, push
        a, b = balls[first], balls[second]
        press(a, b, toward(a, b), push, 0j)
    if scene.ball_rule.kind in (ROUGH_BALL, ALCIATORE_BALL):
        return _rub(len(contacts), scene)
    return True


def _rub(contacts: int, scene: Scene) -> bool:
    """Of all rubs that friction can hold, those that leave the least energy."""
    balls, ties, chosen = scene.balls, scene.ties, 0
    for c in range(contacts):
        tie = ties.contacts[c]
        a, b = balls[tie.first], balls[tie.second]
        slip = slip_between(a, b, toward(a, b))
        ask(RUB, tie, balls)
        tie.bound = grip(slip, scene.ball_rule) / tilt(a, b)[0] * tie.total / tie.size
        if tie.total > 0.0:
            ties.chosen[chosen] = c
            chosen += 1
    return bool(solve(RUB, chosen, balls, ties))


def outcome(balls: Sequence[Body], contacts: Contacts, e: float) -> list[float]:
    """The impulse along the table, N s, of every contact (ball, ball) until all have parted.

    All contacts begin to touch at once; one that closes with the greatest speed, alone, parts with
    e times that speed.
    """
    import numpy as np

    lines = [toward(balls[a], balls[b]) for a, b in contacts]
    levels = np.array([tilt(balls[a], balls[b])[0] for a, b in contacts])
    arms = np.zeros((len(contacts), len(balls)), complex)
    springs = np.empty(len(contacts))
    for c, (a, b) in enumerate(contacts):
        arms[c, a], arms[c, b] = lines[c].conjugate(), -lines[c].conjugate()
        springs[c] = sqrt(
            balls[a].radius * balls[b].radius / (balls[a].radius + balls[b].radius)
        )
    arms *= levels[:, None]
    closing = _dots(arms.conj(), np.array([ball.velocity for ball in balls]))
    speed, mass = closing.max(), balls[0].mass
    yielding = _dots(arms[:, None], arms / [ball.mass / mass for ball in balls])
    pushes = _follow(closing / speed, yielding, springs / springs[0], damping(e), np)
    return [float(push) for push in mass * speed * pushes * levels]


def _dots(a: Any, b: Any) -> Any:
    """The inner products of vectors of plane vectors, added up in their order: what numpy makes of
    `@`, and of complex products, differs with the processor."""
    return (a.real * b.real + a.imag * b.imag).sum(axis=-1)


def damping(e: float) -> float:
    """λ times the closing speed, for F = k δ^(3/2) (1 + λ δ') to part with e times that speed.

    The root of x (1 + e) = log((1 + x) / (1 - e x)), by u = x (1 + e) / 2 that of coth u - 1/u =
    (1 - e) / (1 + e); the law is Hunt and Crossley's, J. Appl. Mech. 42 (1975) 440.
    """
    if e == 1.0:
        return 0.0
    low, high, wanted = 0.0, 1.0 / e, (1.0 - e) / (1.0 + e)
    while True:
        x = 0.5 * (low + high)
        if not low < x < high:
            return x
        if _langevin(0.5 * (1.0 + e) * x) > wanted:
            high = x
        else:
            low = x


def _langevin(u: float) -> float:
    """coth u - 1/u, by Lambert's continued fraction u / (3 + u²/(5 + u²/(7 + ...))."""
    if u > 20.0:
        return 1.0 - 1.0 / u  # the hyperbolic cotangent is 1 to all digits
    square, part = u * u, 0.0
    for odd in range(ODD, 1, -2):
        part = square / (odd + part)
    return part / u


def _follow(closing: Any, yielding: Any, springs: Any, damp: float, np: Any) -> Any:
    """The pushes when no contact closes any more; `yielding` @ pushes is what they take off the
    closing speeds."""
    n = len(closing)

    def rates(y: Any) -> Any:
        speeds = closing - (yielding * y[n:]).sum(axis=-1)
        depth = np.maximum(y[:n], 0.0)
        force = springs * depth * np.sqrt(depth) * np.maximum(1.0 + damp * speeds, 0.0)
        return np.concatenate((speeds, force))

    y, h = np.zeros(2 * n), 0.01
    rate = rates(y)
    for _ in range(STEPS):
        if not (y[:n] > 0.0).any():
            y[:n] += _flight(y[:n], rate[:n], np) * rate[:n]
            if not ((y[:n] >= 0.0) & (rate[:n] > QUIET)).any():
                break
        y, rate, h = _step(y, rate, h, rates, np)
    pushes = y[n:]
    # the steps err by 1e-7 of the energy at most; any gain of it is taken back here
    taken = ((yielding * pushes).sum(axis=-1) * pushes).sum()
    return pushes * min(1.0, 2.0 * (closing * pushes).sum() / taken)


def _flight(overlaps: Any, speeds: Any, np: Any) -> float:
    """How long until the next contact when none is pressed: 0 if none comes."""
    comes = (overlaps < 0.0) & (speeds > QUIET)
    if ((overlaps >= 0.0) & (speeds > QUIET)).any() or not comes.any():
        return 0.0
    return float((-overlaps[comes] / speeds[comes]).min())


def _step(y: Any, rate: Any, h: float, rates: Any, np: Any) -> tuple[Any, Any, float]:
    """One step of Dormand and Prince, tried until its error is small; and the next one's length."""
    while True:
        k = np.empty((7, len(y)))
        k[0] = rate
        for s, weights in enumerate(STAGES):
            new = y + h * _weighed(weights, k, np)
            k[s + 1] = rates(new)
        error = h * float(np.abs(_weighed(ERROR, k, np)).max()) / TOLERANCE
        eighth = sqrt(sqrt(sqrt(error)))  # for 3/16 and not 1/5: roots round alike everywhere
        factor = min(5.0, max(0.2, 0.9 / (eighth * sqrt(eighth)) if error > 0.0 else inf))
        if error <= 1.0:
            return new, k[6], h * factor
        h *= factor


def _weighed(weights: Sequence[float], rates: Any, np: Any) -> Any:
    """The weighted sum of the rates, as many as there are weights."""
    return (np.array(weights)[:, None] * rates[: len(weights)]).sum(axis=0)
