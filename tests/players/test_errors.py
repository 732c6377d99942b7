"""Errors of many shots at once: those that a level makes one by one."""

from random import Random

import numpy as np
import pytest

from danggu.players.errors import missed
from danggu.players.levels import EXPERT, MISCUE, NOVICE, PERFECT, Attempt, Level

RADIUS = 0.03075
SHOTS = np.array([[3.0, 40.0, 1.5, 0.2, -2.0, 0.4], [2.0, 170.0, 0.0, 0.0, 0.0, 0.0]])


def generator():
    return np.random.default_rng(5)


def test_a_perfect_player_plays_each_copy_as_it_is_meant():
    copies = missed(SHOTS, PERFECT, 3, RADIUS, generator())
    assert copies == pytest.approx(np.repeat(SHOTS, 3, axis=0), rel=1e-15)


def test_the_errors_are_as_large_as_those_of_single_attempts():
    aim, dice, n = Attempt(40.0, 3.0, -0.2, 0.1), Random(1), 20_000
    shot = aim.shot()
    row = [shot.speed, shot.angle, shot.follow, shot.masse, shot.side, shot.climb]
    one_by_one = [NOVICE.missed(aim, dice, RADIUS).shot() for _ in range(n)]
    many = missed([row], NOVICE, n, RADIUS, generator())
    for column, name in ((0, "speed"), (1, "angle"), (2, "follow"), (4, "side")):
        single = np.array([getattr(each, name) for each in one_by_one])
        spread = single.std()
        # five standard deviations of a mean, and of a deviation, of so many
        assert many[:, column].mean() == pytest.approx(single.mean(), abs=7.1 * spread / n**0.5)
        assert many[:, column].std() == pytest.approx(spread, rel=5.0 / n**0.5)


def test_no_error_makes_the_tip_slip_or_a_stroke_none():
    shots = np.array([[0.06, 0.0, 0.0, 0.0, 2.5 * 0.06 * 0.5, 0.0]])
    copies = missed(shots, NOVICE, 5_000, RADIUS, generator())
    out = np.hypot(copies[:, 2], copies[:, 4]) / (2.5 * copies[:, 0])
    assert out.max() <= MISCUE * (1.0 + 1e-12)
    assert copies[:, 0].min() >= 0.05


def test_the_same_seed_draws_the_same_errors():
    first, again = (missed(SHOTS, EXPERT, 4, RADIUS, generator()) for _ in range(2))
    assert np.array_equal(first, again)


@pytest.mark.parametrize("error", [-0.1, float("nan"), float("inf"), 1e9])
@pytest.mark.parametrize("place", [0, 1, 2])
def test_an_error_that_no_player_makes_is_refused_by_name(place, error):
    errors = [0.1, 0.1, 0.1]
    errors[place] = error
    with pytest.raises(ValueError, match=f"Level.{('angle', 'speed', 'tip')[place]} must be"):
        Level("odd", *errors)
