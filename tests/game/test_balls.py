"""Balls that turn as they roll, where they are and as large as they are."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
import pygame
import pytest

from game.render import theme
from game.render.layout import Layout
from game.render.table import rotation
from game.render.table.balls import BallSprites
from tests.support.pictures import pixels, sprites


def picture(ball: BallSprites, index: int = 0) -> bytes:
    return pygame.image.tobytes(ball.sprite(index, (0.1, 0.1))[0], "RGBA")


@pytest.mark.parametrize("looks", [theme.BALLS, theme.SAFE_BALLS], ids=["usual", "safe"])
def test_a_ball_that_turns_changes_its_picture_and_one_that_rests_does_not(looks):
    ball = BallSprites(Layout((1280, 720), 2.448, 1.270), list(looks.values()))
    before = [picture(ball, i) for i in range(4)]
    assert [picture(ball, i) for i in range(4)] == before
    for i in range(4):
        ball.rotate(i, (8.0, 20.0, 3.0), 0.02)
    assert all(picture(ball, i) != before[i] for i in range(4))


def test_an_unturned_ball_is_not_painted_again():
    ball = sprites()
    assert ball.sprite(0, (0.1, 0.1))[0] is ball.sprite(0, (0.1, 0.1))[0]


def test_a_ball_rolled_a_full_turn_in_small_steps_comes_back_to_the_same_picture():
    ball = sprites()
    before = pygame.surfarray.array3d(ball.sprite(0, (0.1, 0.1))[0]).astype(int)
    for _ in range(600):
        ball.rotate(0, (12.0, 16.0, 0.0), 2 * pi / 20 / 600)
    after = pygame.surfarray.array3d(ball.sprite(0, (0.1, 0.1))[0]).astype(int)
    assert np.abs(after - before).max() <= 2


def test_a_ball_rolling_to_the_right_carries_its_dot_to_the_right():
    ball = sprites((3840, 2160))
    ball.orient(0, (1.0, 0.0, 0.0, 0.0))

    def dot() -> float:
        shown = pixels(ball.sprite(0, (0.0, 0.0))[0]).astype(int)
        middle = shown.shape[0] // 2
        red = shown[..., 0] - shown[..., 1] > 90
        near = red & (np.hypot(*(np.indices(red.shape) - middle)) < ball.px * 0.75)
        return float(np.flatnonzero(near.any(axis=1)).mean() - middle)

    assert dot() == pytest.approx(0, abs=1)
    ball.rotate(0, (0.0, 1.0, 0.0), 0.4)
    assert dot() == pytest.approx(ball.px * sin(0.4), abs=2)


def test_thousands_of_turns_leave_a_rotation():
    q = rotation.RACKED
    for i in range(5000):
        q = rotation.rotated(q, (sin(i), cos(i), 0.3), 0.01)
    m = rotation.matrix(q)
    assert m @ m.T == pytest.approx(np.eye(3), abs=1e-5)


def test_a_turn_is_undone_by_the_opposite_turn():
    q = rotation.unit(rotation.RACKED)
    there = rotation.rotated(q, (3.0, -2.0, 1.0), 0.2)
    assert rotation.rotated(there, (-3.0, 2.0, -1.0), 0.2) == pytest.approx(q, abs=1e-12)


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (3840, 2160)])
def test_a_ball_covers_a_disc_of_its_true_area_centred_on_its_place(size):
    ball = sprites(size)
    for at in ((0.0, 0.0), (0.1234, -0.2345), (-1.1, 0.5)):
        sprite, corner = ball.sprite(1, at)
        alpha = pygame.surfarray.array_alpha(sprite) / 255
        assert alpha.sum() == pytest.approx(pi * ball.px**2, rel=0.02)
        i, j = np.indices(alpha.shape) + 0.5
        middle = ((alpha * k).sum() / alpha.sum() for k in (i, j))
        shown = [m + c for m, c in zip(middle, corner, strict=True)]
        assert shown == pytest.approx(ball.layout.to_screen(*at), abs=0.3)
