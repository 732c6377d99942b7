"""Contacts in the air: as on the table where they can be compared, and what every hit must keep."""

import math
import random
from cmath import rect

import numpy as np
import pytest

from physics import laws
from physics.kernel.body import Body
from physics.kernel.flight import hit_aloft, hit_nose
from physics.kernel.laws import hit_ball, hit_wall
from physics.kernel.obstacle import Shape

RADIUS, MASS = 0.03075, 0.21


def random_body(dice, position):
    body = Body(RADIUS, MASS, position=position)
    body.velocity, body.roll = (complex(dice.gauss(0, 1), dice.gauss(0, 1)) for _ in range(2))
    body.side = dice.gauss(0, 1)
    return body


RULES = [laws.SmoothBall(0.9), *(laws.RoughBall(0.95, mu) for mu in (0.03, 0.9, "alciatore"))]


@pytest.mark.parametrize("law", RULES, ids=repr)
def test_two_balls_at_one_height_hit_as_on_the_table(law):
    dice, rule = random.Random(1), law.rule()
    for _ in range(50):
        line = rect(2 * RADIUS, dice.uniform(-math.pi, math.pi))
        pairs = []
        for hit in (hit_ball, hit_aloft):
            state = dice.getstate()
            a, b = random_body(dice, 0j), random_body(dice, line)
            a.velocity += 5 * line / RADIUS
            push = hit(a, b, rule)
            pairs.append((push, a.velocity, b.velocity, a.roll, b.roll, a.side, b.side))
            dice.setstate(state)
        random_body(dice, 0j)
        assert np.abs(np.subtract(*pairs)).max() < 1e-13
        # what the table takes up goes upward in the air, equal and opposite
        assert a.climb == pytest.approx(-b.climb, abs=1e-15)


def test_a_cushion_meets_a_ball_just_off_the_cloth_as_on_it():
    dice, rule = random.Random(2), laws.RigidCushion(nose=1.2).rule()
    wall = Shape(1j, -0.5, -1j)
    for _ in range(50):
        state = dice.getstate()
        low, high = (random_body(dice, complex(0.3, -0.5 + RADIUS)) for _ in range(2))
        dice.setstate(state)
        high = random_body(dice, complex(0.3, -0.5 + RADIUS))
        low.velocity = high.velocity = complex(high.velocity.real, -1 - abs(high.velocity.imag))
        before = wall.inward * high.velocity, wall.inward * high.roll
        hit_wall(low, wall.normal, rule)
        hit_nose(high, wall, rule)
        assert abs(low.velocity - high.velocity) < 1e-14
        assert abs(low.roll - high.roll) < 1e-14
        assert low.side == pytest.approx(high.side, abs=1e-14)
        # push and rub upward, from what they did; a table would have held what is left of them
        rub = (wall.inward * high.roll - before[1]).real / 2.5
        push = ((wall.inward * high.velocity - before[0]).real - rule.height * rub) / rule.level
        assert high.climb == pytest.approx(rule.level * rub - rule.height * push, abs=1e-14)


@pytest.mark.parametrize("radius", [RADIUS, 0.02, 0.05])
@pytest.mark.parametrize("law", RULES, ids=repr)
def test_a_hit_in_the_air_keeps_momentum_and_angular_momentum_and_makes_no_energy(law, radius):
    dice, rule = random.Random(3), law.rule()
    for _ in range(100):
        far = RADIUS + radius
        a, b = random_body(dice, 0j), random_body(dice, rect(far, 1.0) * 0.8)
        a.lift, b.lift, b.radius, b.mass = RADIUS, radius, radius, 0.3
        b.height = 0.6 * far + RADIUS - radius
        a.velocity, a.climb, b.climb = 5 * b.position / RADIUS, 2.0, dice.gauss(0, 1)
        arm = np.array([b.position.real, b.position.imag, 0.6 * far])

        def sums(a=a, b=b, arm=arm):
            momentum = spin = energy = 0.0
            for body, place in ((a, 0.0 * arm), (b, arm)):
                v = np.array([body.velocity.real, body.velocity.imag, body.climb])
                w = np.array([-body.roll.imag, body.roll.real, body.side])
                momentum = momentum + body.mass * v
                spin = spin + body.mass * (np.cross(place, v) + 0.4 * body.radius * w)
                energy += body.mass * (0.5 * v @ v + 0.2 * w @ w)
            return momentum, spin, energy

        before = sums()
        assert hit_aloft(a, b, rule) > 0.0
        after = sums()
        assert np.abs(after[0] - before[0]).max() < 1e-14
        assert np.abs(after[1] - before[1]).max() < 1e-15
        assert after[2] < before[2]
