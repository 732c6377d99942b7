"""A hit between balls of two sizes on the cloth, whose line of centres is tilted: by itself."""

import math
from cmath import rect
from random import Random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from physics import laws
from physics.kernel.body import Body
from physics.kernel.laws import hit_ball


def spheres(dice, ratio=None):
    """Two bodies that touch and close, of random sizes, masses and spins."""
    radii = 0.03, 0.03 * (math.exp(dice.gauss(0.0, 1.0)) if ratio is None else ratio)
    line = rect(1.0, dice.uniform(-math.pi, math.pi))
    found = []
    for k, radius in enumerate(radii):
        body = Body(radius, math.exp(dice.gauss(0.0, 1.5)), radius)
        body.position = 2.0 * math.sqrt(radii[0] * radii[1]) * line * k
        body.velocity, body.roll = (complex(dice.gauss(0, 1), dice.gauss(0, 1)) for _ in "vw")
        body.side = dice.gauss(0, 1)
        found.append(body)
    a, b = found
    a.velocity += (dice.uniform(0.1, 2.0) - closing(a, b)) * line
    return a, b


def closing(a, b):
    line = b.position - a.position
    return (line.conjugate() * (a.velocity - b.velocity)).real / abs(line)


def energy(*balls):
    return sum(
        ball.mass
        * (0.5 * abs(ball.velocity) ** 2 + 0.2 * (abs(ball.roll) ** 2 + ball.side * ball.side))
        for ball in balls
    )


def momentum(*balls):
    """Over the table, and about the vertical: 2/5 m R² ω_z is spin."""
    along = sum(ball.mass * ball.velocity for ball in balls)
    return along, sum(
        ball.mass
        * ((ball.position.conjugate() * ball.velocity).imag + 0.4 * ball.radius * ball.side)
        for ball in balls
    )


LAWS = st.one_of(
    st.builds(laws.SmoothBall, st.floats(0.0, 1.0)),
    st.builds(laws.RoughBall, st.floats(0.0, 1.0), st.floats(0.0, 3.0)),
    st.builds(laws.RoughBall, st.floats(0.0, 1.0)),
)


@settings(max_examples=500, deadline=None)
@given(st.integers(0, 10**9), LAWS)
def test_a_hit_keeps_momentum_makes_no_energy_and_parts_with_its_restitution(seed, law):
    a, b = spheres(Random(seed))
    speed, had, before = closing(a, b), energy(a, b), momentum(a, b)
    push = hit_ball(a, b, law.rule())
    scale = (a.mass + b.mass) * (1.0 + abs(a.velocity) + abs(b.velocity))
    assert energy(a, b) <= had * (1.0 + 1e-13)
    assert abs(momentum(a, b)[0] - before[0]) < 1e-14 * scale
    assert abs(momentum(a, b)[1] - before[1]) < 1e-14 * scale
    parting = max(law.e * speed, 1e-3)  # a rule's own floor
    assert closing(a, b) == pytest.approx(-parting, abs=1e-13 * (1.0 + scale / min(a.mass, b.mass)))
    assert push == pytest.approx(a.mass * b.mass / (a.mass + b.mass) * (speed + parting), rel=1e-12)


@pytest.mark.parametrize("seed", range(50))
def test_an_elastic_hit_without_friction_keeps_energy_exactly(seed):
    a, b = spheres(Random(seed))
    had, rolls = energy(a, b), (a.roll, a.side, b.roll, b.side)
    hit_ball(a, b, laws.SmoothBall(1.0).rule())
    assert energy(a, b) == pytest.approx(had, rel=1e-14)
    assert rolls == (a.roll, a.side, b.roll, b.side)


def in_space(v):
    return np.array([v.real, v.imag, 0.0])


def spin(ball):
    """ω as a vector."""
    w = 1j * ball.roll / ball.radius
    return np.array([w.real, w.imag, ball.side / ball.radius])


def by_vectors(a, b, e, mu):
    """The same hit with vectors in space and moments of inertia: velocities and spins after it."""
    rise = b.radius - a.radius
    normal = in_space(b.position - a.position) + np.array([0.0, 0.0, rise])
    normal /= np.linalg.norm(normal)
    level = in_space(b.position - a.position)
    level /= np.linalg.norm(level)
    mass = a.mass * b.mass / (a.mass + b.mass)
    va, vb, wa, wb = in_space(a.velocity), in_space(b.velocity), spin(a), spin(b)
    along = mass * (1.0 + e) * (va - vb) @ level
    across = (va - vb) - ((va - vb) @ level) * level  # the closing itself rubs nothing
    slip = across + np.cross(a.radius * wa + b.radius * wb, normal)
    assert abs(slip @ normal) < 1e-12
    size = np.linalg.norm(slip)
    rub = -min(mu * along / (normal @ level), mass / 3.5 * size) / size * slip
    aside = rub * [1.0, 1.0, 0.0] - (rub @ level) * level  # cloth and push take the rest
    shock = aside - along * level
    turns = [
        w + np.cross(ball.radius * normal * sign, sign * rub) / (0.4 * ball.mass * ball.radius**2)
        for ball, w, sign in ((a, wa, 1.0), (b, wb, -1.0))
    ]
    return va + shock / a.mass, vb - shock / b.mass, *turns


@pytest.mark.parametrize("seed", range(100))
@pytest.mark.parametrize("mu", [0.05, 5.0])
def test_a_hit_is_the_same_with_vectors_in_space(seed, mu):
    a, b = spheres(Random(seed))
    wanted = by_vectors(a, b, 0.9, mu)
    hit_ball(a, b, laws.RoughBall(0.9, mu).rule())
    found = in_space(a.velocity), in_space(b.velocity), spin(a), spin(b)
    for one, other in zip(found, wanted, strict=True):
        assert one == pytest.approx(other, abs=1e-12 * (1.0 + np.abs(other).max()))


@pytest.mark.parametrize("law", [laws.RoughBall(0.95, 0.06), laws.RoughBall(), laws.SmoothBall()])
def test_nearly_equal_balls_hit_nearly_as_equal_ones(law):
    for seed in range(20):
        ends = []
        for ratio in (1.0, 1.0 + 1e-9):
            a, b = spheres(Random(seed), ratio)
            hit_ball(a, b, law.rule())
            ends.append([a.velocity, b.velocity, a.roll, b.roll, a.side, b.side])
        assert np.abs(np.subtract(*ends)).max() < 1e-8


def test_which_ball_is_first_changes_nothing():
    for seed in range(20):
        ends = []
        for swapped in (False, True):
            a, b = spheres(Random(seed))
            hit_ball(*((b, a) if swapped else (a, b)), laws.RoughBall(0.9, 0.1).rule())
            ends.append([a.velocity, b.velocity, a.roll, b.roll, a.side, b.side])
        assert np.abs(np.subtract(*ends)).max() < 1e-13
