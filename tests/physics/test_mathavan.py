"""The Mathavan cushion against the paper's own scheme, against itself converged, and as physics."""

import cmath
import importlib
import math
from itertools import pairwise
from math import cos, degrees, inf, radians, sin, sqrt

import numpy as np
import pytest

from physics.kernel import mathavan
from physics.kernel.body import Rule
from physics.kernel.mathavan import mathavan_cushion
from tests.support.published import CHECKS


def rule(e, friction, nose, slide=0.212, parting=0.0):
    height = nose - 1
    return Rule(0, e, friction, height, sqrt(1 - height * height), slide, parting)


MATCH = rule(0.901, 0.222, 1.203)
MEDIUM = rule(0.901, 0.222, 1.191)
PAPER = rule(0.98, 0.14, 1.4)


def random_states(count, seed):
    """Fast and slow, steep and grazing, rolling and with surface speeds up to three times v."""
    draw = np.random.default_rng(seed)
    states = []
    for _ in range(count):
        angle = draw.uniform(-90, 90)
        normal = cos(radians(angle)) if draw.random() < 0.85 else 10 ** draw.uniform(-4, -1)
        v = complex(-normal, math.copysign(sqrt(1 - normal**2), angle))
        spin = draw.normal(size=3)
        spin *= 3 * draw.random() ** (1 / 3) / np.linalg.norm(spin)
        roll = v if draw.random() < 0.4 else complex(spin[0], spin[1])
        states.append((v, roll, float(spin[2])))
    return states


def energy(v, roll, side):
    """Per half mass: I = 2/5 m R²."""
    return abs(v) ** 2 + 0.4 * (abs(roll) ** 2 + side**2)


def turned(out, expected):
    """Degrees between two velocities."""
    return abs(degrees(np.angle(out / expected)))


def paper_scheme(states, r, steps):
    """Mathavan 2010, eqs 12–17 and the work of the normal impulse, in their frame: equal steps.

    x along the cushion, y into it, m = R = 1; all the states at once.
    """
    v = np.array([state[0] for state in states])
    roll = np.array([state[1] for state in states])
    vx, vy, wx, wy = v.imag, -v.real, roll.real, roll.imag
    wz = np.array([state[2] for state in states])
    s, c, mw, ms = r.height, r.level, r.friction, r.slide
    step, work, goal = vy / steps, np.zeros(len(vy)), np.full(len(vy), inf)
    while np.any(step):
        ix, iy = vx + wy * s - wz * c, -vy * s + wx
        cx, cy = vx - wy, vy + wx
        i, k = np.hypot(ix, iy) + 1e-300, np.hypot(cx, cy) + 1e-300
        ci, si, ck, sk = ix / i, iy / i, cx / k, cy / k
        table = np.maximum(s + mw * c * si, 0.0)
        before = vy
        vx = vx - step * (mw * ci + ms * ck * table)
        vy = vy - step * (c - mw * s * si + ms * sk * table)
        wx = wx - step * 2.5 * (mw * si + ms * sk * table)
        wy = wy - step * 2.5 * (mw * s * ci - ms * ck * table)
        wz = wz + step * 2.5 * mw * c * ci
        work = work + c * step * abs(before + vy) / 2
        pressed = (vy <= 0) & (goal == inf)
        goal = np.where(pressed, (1 + r.restitution**2) * work, goal)
        step = np.where(work >= goal, 0.0, step)
    return -vy + 1j * vx, wx + 1j * wy, wz


def paper_cases():
    given = CHECKS["K2"]["input"]
    for angle, rolling, side in zip(
        given["alpha_from_cushion"], given["kT"], given["kS"], strict=True
    ):
        a = radians(angle)
        yield complex(-sin(a), cos(a)), rolling * complex(-sin(a), cos(a)), float(side)


def test_k2_the_paper_s_constants_give_the_converged_speeds_and_angles():
    expected = CHECKS["K2"]["expected"]
    for state, speed, angle in zip(
        paper_cases(), expected["speed"], expected["angle"], strict=True
    ):
        v = mathavan_cushion(*state, PAPER)[0]
        assert abs(v) == pytest.approx(speed, abs=5.5e-5)  # printed to 4 digits
        assert degrees(math.atan2(v.real, v.imag)) == pytest.approx(angle, abs=1.1e-3)  # and 3


def test_the_paper_s_equal_steps_converge_to_the_kernel_at_first_order():
    states = list(paper_cases()) + random_states(120, 1)
    kernel = np.array([mathavan_cushion(*state, PAPER) for state in states])

    def error(steps):
        found = np.array(paper_scheme(states, PAPER, steps)).T
        return np.quantile(np.abs(found - kernel).max(axis=1), 0.9)

    coarse, fine = error(500), error(4000)
    assert 6 < coarse / fine < 10
    assert fine < 1e-3


def converged(monkeypatch, states, r):
    with monkeypatch.context() as patch:
        for name, share in {"LEAP": 0.1, "TURN": 0.2, "LOSS": 0.4, "NONE": 0.1}.items():
            patch.setattr(mathavan, name, share * getattr(mathavan, name))
        return [mathavan_cushion(*state, r) for state in states]


@pytest.mark.parametrize("r", [MATCH, MEDIUM, PAPER], ids=["match", "medium", "paper"])
def test_speed_is_right_to_1e_4_and_direction_to_a_hundredth_of_a_degree(monkeypatch, r):
    states = random_states(400, 2)
    exact = [out[0] for out in converged(monkeypatch, states, r)]
    found = [mathavan_cushion(*state, r)[0] for state in states]
    speeds = [abs(abs(a) - abs(b)) for a, b in zip(found, exact, strict=True)]
    angles = [turned(a, b) for a, b in zip(found, exact, strict=True)]
    assert max(speeds) < 1e-4
    assert max(angles) < 0.01
    assert np.quantile(speeds, 0.98) < 1e-5
    assert np.quantile(angles, 0.98) < 1e-3


def test_the_integration_is_of_fourth_order_while_both_slips_last(monkeypatch):
    state = (complex(-1, 2), complex(1.5, -1), 1.0)
    for name in ("TURN", "LOSS"):
        monkeypatch.setattr(mathavan, name, inf)
    monkeypatch.setattr(mathavan, "CLOSE", 1e-9)

    def out(leap):
        monkeypatch.setattr(mathavan, "LEAP", leap)
        return np.array(mathavan_cushion(*state, MATCH))

    exact = out(1 / 256)
    errors = [abs(out(leap) - exact).max() for leap in (1 / 4, 1 / 8, 1 / 16)]
    orders = [math.log2(a / b) for a, b in pairwise(errors)]
    assert orders == pytest.approx([4, 4], abs=0.5)


@pytest.mark.parametrize("r", [MATCH, PAPER], ids=["match", "paper"])
def test_k4_energy_never_grows(r):
    gains = [
        energy(*mathavan_cushion(*state, r)) - energy(*state) for state in random_states(5000, 3)
    ]
    assert max(gains) <= 0


def test_k4_without_friction_and_loss_the_hit_is_a_mirror():
    mirror = rule(1.0, 0.0, 1.203, slide=0.0)
    for v, roll, side in random_states(100, 4):
        out, rolled, sided = mathavan_cushion(v, roll, side, mirror)
        assert abs(out + v.conjugate()) < 1e-12
        assert abs(rolled - roll) < 1e-12
        assert sided == side


@pytest.mark.parametrize("r", [MATCH, MEDIUM], ids=["match", "medium"])
def test_k5_k6_a_rolling_ball_leaves_within_the_measured_bands_and_skids(r):
    for along in np.linspace(-0.5, 0.5, 21):
        v = complex(-1.0, along)
        out, roll, _ = mathavan_cushion(v, v, 0.0, r)
        assert 0.85 < out.real < 0.93
        assert -0.47 < roll.real < -0.11
        assert 0.53 < (5 * out.real + 2 * roll.real) / 7 < 0.60
        assert abs(out - roll) >= 0.8


def test_only_ratios_matter():
    for v, roll, side in random_states(200, 5):
        out = np.array(mathavan_cushion(v, roll, side, MATCH))
        assert (np.array(mathavan_cushion(8 * v, 8 * roll, 8 * side, MATCH)) == 8 * out).all()
        other = np.array(mathavan_cushion(0.3 * v, 0.3 * roll, 0.3 * side, MATCH))
        assert abs(other / 0.3 - out).max() < 2e-5  # rounding may choose other steps


def test_a_mirrored_hit_has_the_mirrored_outcome_bit_for_bit():
    for v, roll, side in random_states(200, 6):
        out, rolled, sided = mathavan_cushion(v, roll, side, MATCH)
        other = mathavan_cushion(v.conjugate(), roll.conjugate(), -side, MATCH)
        assert other == (out.conjugate(), rolled.conjugate(), -sided)


def test_the_outcome_is_continuous():
    for v, roll, side in random_states(300, 7):
        closing = -v.real
        out = np.array(mathavan_cushion(v, roll, side, MATCH))
        near = np.array(mathavan_cushion(v, roll + 1e-7 * closing, side - 1e-7 * closing, MATCH))
        assert abs(near - out).max() < 2e-4 * closing + 1e-12  # twice the error of the integration


def test_a_grazing_hit_changes_as_little_as_it_presses():
    for closing in (1e-3, 1e-6, 1e-9, 1e-12):
        for roll, side in ((complex(-closing, 1), 0.0), (2 + 0j, 1.0), (1j, -2.0)):
            v = complex(-closing, 1)
            out, rolled, sided = mathavan_cushion(v, roll, side, MATCH)
            assert max(abs(out - v), abs(rolled - roll), abs(sided - side)) < 3 * closing


def random_laws(count, seed):
    """Any coefficients with which no push can jam the ball between nose and cloth."""
    draw = np.random.default_rng(seed)
    while count:
        e, friction, slide = draw.random(3)
        r = rule(e, friction, draw.uniform(0.7, 1.7), slide)
        down = max(0.0, r.height + r.level * friction)
        if r.level - abs(r.height) * friction - slide * down > 0.05:
            count -= 1
            yield r


def test_any_law_that_cannot_jam_ends_and_creates_no_energy(monkeypatch):
    steps, leap = [0], mathavan.leap

    def counted(*args):
        steps[-1] += 1
        return leap(*args)

    monkeypatch.setattr(mathavan, "leap", counted)
    for r, state in zip(random_laws(600, 9), random_states(600, 10), strict=True):
        steps.append(0)
        assert energy(*mathavan_cushion(*state, r)) <= energy(*state)
    # a slip may flicker until `none` has grown from 1e-8 to all there is: 8 times PATIENCE
    assert mathavan.PATIENCE / 10 < max(steps) < 8 * mathavan.PATIENCE


def test_whatever_touches_parts():
    slow = rule(0.0, 0.222, 1.203, parting=1e-3)
    for v in (-1 + 0.5j, -1e-4 + 0.5j, 0.5j):
        assert mathavan_cushion(v, 0.2 - 1j, 0.3, slow)[0].real == pytest.approx(1e-3, rel=1e-9)
    assert mathavan_cushion(0.5j, 0.5j, 0.0, MATCH) == (0.5j, 0.5j, 0.0)


def test_a_nan_ends_the_hit_instead_of_never():
    for state in ((complex(math.nan, 1), 1j, 0.0), (-1 + 1j, complex(math.nan, 0), 0.0)):
        assert any(map(cmath.isnan, mathavan_cushion(*state, MATCH)))


def test_the_compiled_law_gives_the_same_bits():
    numba = pytest.importorskip("numba")
    from physics.batch import compiled
    from physics.kernel.body import rows

    package = compiled.kernel().__name__
    law = importlib.import_module(f"{package}.mathavan").mathavan_cushion
    record = rows([MATCH])[0]
    hit = numba.njit(lambda v, roll, side, rule: law(v, roll, side, rule))
    for state in random_states(300, 8):
        assert hit(*state, record) == mathavan_cushion(*state, MATCH)


def test_what_compiled_code_alone_can_call_says_so():
    pytest.importorskip("numba")
    from physics.batch import compiled

    package = compiled.kernel().__name__
    length = importlib.import_module(f"{package}.motion").length
    with pytest.raises(TypeError, match="only compiled code can call length"):
        length(3 + 4j)
