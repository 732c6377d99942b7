"""Balls of pool, snooker and pyramid: numbers that can be read, colours that can be told apart."""

from __future__ import annotations

from itertools import combinations
from math import pi

import numpy as np
import pygame
import pytest

from game.render import ball_sets, theme
from game.render.layout import Layout
from game.render.table import rotation
from game.render.table.balls import BallSprites, Spot, portrait
from game.ui.table.looks import look, looks_of
from tests.support.colour_blind import EYES, nearest
from tests.support.pictures import pixels
from tests.support.stages import TABLES, racked

LAYOUT = Layout((1280, 720), 2.54, 1.27)
NAMES = [name for name in ball_sets.POOL if name != "cue"]
SPOTS = [Spot(i, (-0.9 + 0.11 * i, 0.25 - 0.03 * i)) for i in range(16)]


def many(looks=ball_sets.POOL, layout=LAYOUT, radius=0.028575, **given) -> BallSprites:
    return BallSprites(layout, [*looks.values()], radius, "pool", many=True, **given)


def picture(balls: BallSprites, spot: Spot) -> bytes:
    return pygame.image.tobytes(balls.sprite(spot.ball, spot.at)[0], "RGBA")


def test_balls_painted_together_look_as_each_by_itself():
    together, alone = many(), many()
    for balls in (together, alone):
        for i in range(16):
            balls.rotate(i, (3.0 * i, 7.0, i - 4.0), 0.05)
    together.prepare(SPOTS)
    assert [picture(together, s) for s in SPOTS] == [picture(alone, s) for s in SPOTS]


def test_a_ball_that_rests_is_not_painted_again():
    balls = many()
    balls.prepare(SPOTS)
    painted = []
    for sheet in balls._sheets.values():
        sheet.paint = painted.append
    balls.prepare(SPOTS)
    assert painted == []
    balls.rotate(3, (1.0, 0.0, 0.0), 0.1)
    balls.prepare(SPOTS)
    assert [turn.cell for (turn,) in painted] == [3]


def test_a_ball_with_dots_looks_nearly_as_smooth_together_as_alone():
    looks = [*theme.BALLS.values()]
    sheet = BallSprites(LAYOUT, looks, many=True)
    single = BallSprites(LAYOUT, looks)
    for i in range(4):
        (a, p), (b, q) = sheet.sprite(i, (0.1, 0.1)), single.sprite(i, (0.1, 0.1))
        one, two = (pygame.Surface((60, 60), 0, 32) for _ in range(2))
        one.blit(a, (p[0] - q[0] + 10, p[1] - q[1] + 10))
        two.blit(b, (10, 10))
        assert np.abs(pixels(one).astype(int) - pixels(two)).mean() < 3


@pytest.mark.parametrize("size", [(960, 540), (1280, 720), (3840, 2160)])
def test_a_ball_of_a_sheet_covers_a_disc_of_its_true_area_centred_on_its_place(size):
    balls = many(layout=Layout(size, 2.54, 1.27))
    for at in ((0.0, 0.0), (0.1234, -0.2345), (-1.1, 0.5), (0.0015, 0.0007)):
        sprite, corner = balls.sprite(1, at)
        alpha = pygame.surfarray.array_alpha(sprite) / 255
        assert alpha.sum() == pytest.approx(pi * balls.px**2, rel=0.02)
        i, j = np.indices(alpha.shape) + 0.5
        middle = ((alpha * k).sum() / alpha.sum() for k in (i, j))
        shown = [m + c for m, c in zip(middle, corner, strict=True)]
        assert shown == pytest.approx(balls.layout.to_screen(*at), abs=0.3)


def test_every_ball_has_a_picture_of_its_own():
    for sets in (ball_sets.POOL, ball_sets.SAFE_POOL, ball_sets.SAFE_SNOOKER, ball_sets.PYRAMID):
        balls = many(sets)
        seen = [picture(balls, Spot(i, (0.0, 0.0))) for i in range(len(sets))]
        assert len(set(seen)) == len(seen)


def test_a_stripe_is_white_above_and_below_and_a_solid_is_not():
    balls = many(layout=Layout((1920, 1080), 2.54, 1.27))

    def white(name: str) -> float:
        sprite, _ = balls.sprite([*ball_sets.POOL].index(name), (0.0, 0.0))
        seen = pixels(sprite).astype(int)
        bright = (seen.min(axis=-1) > 90) & (pygame.surfarray.array_alpha(sprite) > 200)
        return float(bright.sum() / (pi * balls.px**2))

    for n in range(1, 8):
        assert white(f"{n + 8}") > white(f"{n}") + 0.15


def test_a_number_is_turned_to_the_viewer_when_the_balls_are_to_be_read():
    balls = many()
    for i in range(16):
        balls.rotate(i, (5.0, 3.0 * i, 2.0), 0.4)
    balls.settle()
    for i, name in enumerate(ball_sets.POOL):
        number = rotation.matrix(balls.orientation(i))[:, 0]
        if name != "cue":
            assert 0.93 < abs(number[2]) < 0.99  # a little below the middle: the lamps shine there
            assert number[1] * np.sign(number[2]) < 0
    before = [balls.orientation(i) for i in range(16)]
    balls.settle()
    assert [balls.orientation(i) for i in range(16)] == before


def test_a_ball_settles_on_the_number_that_is_nearer():
    balls = many()
    first = balls.orientation(1)
    balls.orient(1, rotation.rotated(rotation.other_end(first), (0.1, 0.2, 0.0), 1.0))
    balls.settle()
    assert balls.orientation(1) == pytest.approx(rotation.other_end(first))
    assert rotation.between(first, balls.orientation(1)) < 0.1


def test_balls_of_other_sizes_are_drawn_as_large_as_they_are():
    radii = [0.02, 0.05, 0.03]
    for together in (False, True):
        balls = BallSprites(LAYOUT, [*theme.BALLS.values()][:3], radii, many=together)
        for i, radius in enumerate(radii):
            alpha = pygame.surfarray.array_alpha(balls.sprite(i, (0.0, 0.0))[0]) / 255
            assert alpha.sum() == pytest.approx(pi * (radius * LAYOUT.scale) ** 2, rel=0.03)


def test_a_portrait_can_be_as_small_as_a_tray_needs_and_a_black_ball_has_a_ring():
    for px in (7.0, 9.2, 15.0):
        found = portrait(ball_sets.POOL["8"], px)
        assert abs(found.get_width() - 2 * px) < 8
    ringed, plain = (portrait(ball_sets.POOL["8"], 10.0, ringed=k) for k in (True, False))
    assert pixels(ringed).sum() > pixels(plain).sum()


# -- names and colours ---------------------------------------------------------------------------


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_every_ball_of_a_rack_has_the_look_of_its_name(table):
    world = racked(table)
    for colours in ("usual", "safe"):
        for ball, found in zip(world.balls, looks_of(world, colours), strict=True):
            known = look(ball.name, 0, colours, table.kind)
            assert found == known
            if table.kind == "pool" and ball.name != "cue":
                assert found.number == ball.name
                assert found.striped == (int(ball.name) > 8)
            if table.kind == "snooker":
                assert found.letter == ("" if ball.name == "cue" else _letter(ball.name))


def _letter(name: str) -> str:
    return {"brown": "N", "black": "K"}.get(name, name[0].upper())


def test_a_name_that_no_game_knows_has_a_look_too():
    assert look("bowl", 3, "usual", "pool") == look("bowl", 3, "usual", "pool")
    assert look("bowl", 3, "usual", "pool") != look("bowl", 4, "usual", "pool")
    assert look("white", 0, "usual", "snooker") == ball_sets.CUE


@pytest.mark.parametrize("eyes", EYES)
def test_of_the_safe_set_every_two_colours_can_be_told_apart(eyes):
    bodies = {found.body for found in ball_sets.SAFE_POOL.values()}
    assert nearest([*bodies, theme.CLOTHS["pool"]], eyes) > 27.5


def test_a_solid_and_its_stripe_have_paths_of_one_colour_but_not_of_one_stroke():
    for found in (ball_sets.POOL, ball_sets.SAFE_POOL):
        for n in range(1, 8):
            solid, stripe = found[f"{n}"], found[f"{n + 8}"]
            assert solid.ui == stripe.ui
            assert solid.dashes != stripe.dashes
        paths = [found[f"{n}"].ui for n in range(1, 9)]
        assert all(p != q for p, q in combinations(paths, 2))
