"""Numerical error: the engine against the same source run in 50-digit numbers."""

import random

import pytest

from physics import Shot, World, scenes
from tests.support import fifty


def error(world: World) -> float:
    """The largest distance, in metres, between a ball's rest position and the exact one."""
    exact, events = fifty.rest(world)
    world.run()
    assert len(world.log) == events
    return max(
        float(abs(complex(*ball.position) - rest))
        for ball, rest in zip(world.balls, exact, strict=True)
    )


@pytest.mark.parametrize("scene", [scenes.single, scenes.thesis_1, scenes.thesis_2])
def test_a_single_ball_ends_within_a_few_roundings(scene):
    assert error(scene()) < 2e-14  # measured 2e-15 to 8e-15, after 4 to 13 events


@pytest.mark.parametrize("seed", range(12))
def test_a_carom_shot_keeps_all_digits_that_its_hits_leave(seed):
    world = scenes.carom()
    chance = random.Random(seed)
    shot = Shot(3.0, chance.uniform(0, 360), chance.uniform(-2, 2), 0.0, chance.uniform(-2, 2))
    world.strike("white", shot)
    # each hit multiplies an error by about 10: the largest of 200 such shots has 2e-11
    hits = error_and_hits(world)
    assert hits[0] < 1e-14 * 12.0 ** hits[1]


def error_and_hits(world: World) -> tuple[float, int]:
    wrong = error(world)
    return wrong, sum(event.kind == "ball" for event in world.log)


@pytest.mark.parametrize("offset", [0.0, 0.001, 0.003, 0.01])
def test_a_break_ends_where_it_should(offset):
    world = scenes.rack15()
    world.balls[0].position = (-0.6, offset)
    assert error(world) < 1e-11  # measured 2e-14 to 3e-13


@pytest.mark.parametrize("angle", [0.0, 37.0, 90.0])
def test_a_cradle_is_exact(angle):
    world = scenes.cradle(5, angle)
    assert error(world) < 1e-13


def test_a_kernel_loaded_again_under_its_name_is_whole():
    first, again = fifty.kernel.__wrapped__(), fifty.kernel.__wrapped__()
    assert again.contact is not first.contact
    assert again.calendar.meeting is again.contact.meeting
