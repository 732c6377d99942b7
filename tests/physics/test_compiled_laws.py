"""Custom laws that are marked as compiled: batches with them run compiled, with the same digits."""

import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from physics import Shot, Wall, laws, scenes, simulate, simulate_many

pytest.importorskip("numba")

SHOTS = [Shot(3.0, 7.3 * k, follow=1.0, side=-0.5) for k in range(60)]


@laws.compiled
def felt(v, roll, side):
    return complex(-v.real * 2 / 3, v.imag * 0.9), roll, side


@laws.compiled
def damped(v, roll, side):
    return complex(-0.5 * v.real, 0.0), 0.5 * roll, 0.0


@laws.compiled
def smooth(v, roll, side, mass):
    return mass * 1.95 * v.real, 0j


@laws.compiled
def raspy(v, roll, side, mass):
    push = mass * 1.9 * v.real
    slip = complex(v.imag + side, -roll.real)
    return push, -0.05 * push * slip / (1.0 + abs(slip.real))


def world(**given):
    made = scenes.carom()
    for name, law in given.items():
        setattr(made, name, law)
    return made


WORLDS = {
    "a cushion": lambda: world(cushion_law=felt),
    "balls": lambda: world(ball_law=raspy),
    "both": lambda: world(cushion_law=damped, ball_law=smooth),
}


def own():
    """A wall with a law of its own."""
    made = scenes.carom()
    made.add(Wall.segment((0.4, -0.5), (0.9, -0.2), "soft", law=damped))
    return made


@pytest.mark.parametrize("make", [*WORLDS.values(), own], ids=[*WORLDS, "one wall"])
def test_a_compiled_batch_with_custom_laws_has_the_digits_of_the_interpreter(make):
    fast = simulate_many(make(), "white", SHOTS, compiled=True)
    slow = simulate_many(make(), "white", SHOTS, compiled=False)
    assert (fast.positions == slow.positions).all()
    assert (fast.times == slow.times).all()
    assert (fast.events == slow.events).all()
    last = [ball.position for ball in simulate(make(), "white", SHOTS[-1]).balls]
    assert fast.positions[-1].tolist() == [[*position] for position in last]


def test_a_custom_law_that_is_a_named_one_does_the_same():
    named = simulate_many(world(ball_law=laws.SmoothBall(0.95)), "white", SHOTS, compiled=True)
    ours = simulate_many(world(ball_law=smooth), "white", SHOTS, compiled=True)
    assert np.abs(ours.positions - named.positions).max() < 1e-9


def test_threads_share_a_batch_with_a_custom_law():
    with ThreadPoolExecutor(2) as threads:
        shared = simulate_many(
            world(cushion_law=felt), "white", SHOTS, executor=threads, compiled=True
        )
    alone = simulate_many(world(cushion_law=felt), "white", SHOTS, compiled=True)
    assert (shared.positions == alone.positions).all()


def test_a_law_that_is_not_marked_is_refused_with_what_to_do():
    with pytest.raises(ValueError, match=r"unless it is marked as @laws\.compiled"):
        simulate_many(world(cushion_law=lambda *state: state), "white", SHOTS, compiled=True)


def test_a_law_that_numba_cannot_compile_is_refused_with_the_reason():
    @laws.compiled
    def named(v, roll, side):
        return laws.RigidCushion()(v, roll, side)

    with pytest.raises(ValueError, match=r"the law named cannot be compiled: .*RigidCushion"):
        simulate_many(world(cushion_law=named), "white", SHOTS, compiled=True)


def test_a_marked_law_is_the_function_itself_and_can_be_sent_to_another_process():
    assert felt(-3.0 + 1.0j, 0j, 0.5) == (2.0 + 0.9j, 0j, 0.5)
    assert pickle.loads(pickle.dumps(felt)) is felt
    with pytest.raises(ValueError, match="only a function can be marked as compiled, not"):
        laws.compiled("rigid".upper)


def test_a_marked_law_is_watched_where_it_is_interpreted():
    @laws.compiled
    def wrong(v, roll, side):
        return complex(float("nan"), 0.0), roll, side

    with pytest.raises(ValueError, match="the cushion law wrong"):
        simulate(world(cushion_law=wrong), "white", SHOTS[0])
