"""Balls that fall into pockets: seen for a moment, in the hole alone, also when scrubbed."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pygame
import pytest

from game.render.table.wells import DEEP, Wells
from game.session.ticks import TICKS
from game.ui.table.dropped import AWAY, LONGEST, Hole, fallen
from physics import Ball, Pocket, Shot, World, tables
from tests.support.pictures import changed, pixels
from tests.support.stages import TABLES, a_stage, shown

FRAME = TICKS // 60
HOLE = Hole(0j, 0.06)
R = 0.0286


def pot() -> World:
    """A cue ball that can be struck into the north-eastern pocket, and another one."""
    world = tables.pool_9ft()
    world.add(Ball("cue", at=(0.9, 0.3)))
    world.add(Ball("9", at=(-0.9, 0.3)))
    return world


def pots(speed: float = 2.0, rolls: float = 0.0):
    """A stage on which the cue ball has been struck into the corner, while the other one rolls."""
    world = pot()
    if rolls:
        world.strike("9", Shot(rolls, 200.0))
    session, stage = a_stage(world)
    session.aim.texts = [f"{speed}", "0", "0", "0", "42.5"]
    session.strike()
    return session, stage


def play(session, stage, frames: int) -> None:
    for _ in range(frames):
        session.advance(FRAME)
        stage.follow(session)


@pytest.mark.parametrize("speed", [0.05, 0.3, 1.0, 4.0, 12.0])
def test_a_falling_ball_stays_in_the_hole_and_goes_down_without_a_jump(speed):
    start = -0.0599 + 0j
    places = [fallen(HOLE, R, start, complex(speed, 0.1 * speed), k / 240) for k in range(120)]
    for (p, down), (q, further) in pairwise(places):
        assert abs(q) <= 0.06
        assert further >= down
        assert abs(q - p) <= (speed * 1.01 + 2 * 2.5 * 0.12) / 240 + 1e-9
    assert places[0] == (start, 0.0)
    assert places[-1][1] > DEEP


def test_every_fall_is_over_in_time():
    for speed in (0.0, 0.01, 0.1, 1.0, 10.0):
        assert fallen(HOLE, R, -0.06 + 0j, complex(speed), 0.5 * LONGEST)[1] > DEEP


def test_a_slow_ball_takes_longer_to_tip_over_than_a_fast_one():
    slow, fast = (fallen(HOLE, R, -0.06 + 0j, complex(v), 0.1)[1] for v in (0.1, 2.0))
    assert 0 < slow < fast


def test_a_ball_is_seen_while_it_falls_and_then_no_more():
    session, stage = pots()
    heights = []
    for _ in range(120):
        play(session, stage, 1)
        heights.append(stage.dropped.spots(session)[0].height)
    falls = [h for h in heights if AWAY < h < 0]
    assert 4 <= len(falls) <= 30
    assert heights[-1] == AWAY
    assert sorted(falls, reverse=True) == falls


def test_a_fall_looks_the_same_played_and_scrubbed():
    session, stage = pots(rolls=1.0)
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    seen = {}
    for _ in range(90):
        play(session, stage, 1)
        seen[session.timeline.now] = stage.dropped.spots(session)
    falling = {t: spots for t, spots in seen.items() if AWAY < spots[0].height < 0}
    assert falling
    for ticks, spots in falling.items():
        session.timeline.at = ticks
        (a, b), (c, d) = spots, stage.dropped.spots(session)
        assert (a.at, a.height, b) == (pytest.approx(c.at), pytest.approx(c.height), d)


@pytest.mark.parametrize("rolls", [0.0, 1.0])
def test_the_last_ball_falls_on_though_nothing_moves_and_then_the_picture_rests(rolls):
    session, stage = pots(rolls=rolls)
    on = []
    for _ in range(400):
        play(session, stage, 1)
        on.append(stage.dropped.falls(session))
    assert not session.moving
    assert any(on) == (not rolls)
    assert not any(on[-60:])
    assert sum(on) <= 30


def test_a_resized_window_does_not_let_a_ball_fall_again():
    session, stage = pots()
    play(session, stage, 200)
    _, other = a_stage(session.world, (1280, 720))
    other.take_over(stage)
    assert other.dropped.spots(session)[0].height == AWAY


def test_before_it_fell_a_ball_lies_on_the_table_again():
    session, stage = pots()
    play(session, stage, 300)
    assert not session.moving
    assert stage.dropped.spots(session)[0].height == AWAY
    session.timeline.at = 0
    assert stage.dropped.spots(session)[0].at == (0.9, 0.3)


def test_a_ball_that_is_down_from_the_beginning_is_not_drawn():
    session, stage = pots()
    play(session, stage, 300)
    session.cue = "9"
    session.aim.texts = ["0.5", "0", "0", "0", "0"]
    session.strike()
    play(session, stage, 3)
    assert [spot.height for spot in stage.dropped.spots(session)] == [AWAY, 0.0]
    session.timeline.at = 0
    assert stage.dropped.spots(session)[0].height == AWAY


@pytest.mark.parametrize("speed", [0.6, 2.0, 6.0])
def test_a_fall_drawn_in_part_is_the_same_as_drawn_again(speed):
    session, stage = pots(speed)
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    for frame in range(150):
        play(session, stage, 1)
        stage.draw(surface, session)
        falls = AWAY < stage.dropped.spots(session)[0].height < 0
        if frame % 50 == 49 or (falls and frame % 3 == 0):
            assert np.array_equal(pixels(surface), pixels(shown(session, stage)))


@pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)
def test_a_deep_ball_is_seen_in_the_opening_alone(table):
    stage = a_stage(pot() if table.kind == "pool" else _one(table))[1]
    wells = stage.sprites.wells
    assert wells is not None
    assert len(wells.openings) == 6
    for box, opening in wells.openings:
        assert 0.2 < opening.max() <= 1.0
        surface = pygame.Surface(stage.layout.size, 0, 32)
        surface.blit(stage.base, (0, 0))
        before = pixels(surface)
        x, y = np.unravel_index(opening.argmax(), opening.shape)
        picture, _ = stage.sprites.sprite(0, (0.0, 0.0))
        wells.sink(surface, picture, (box.x + x + 8, box.y + y), table.radius, 0.8 * DEEP)
        area = changed(before, surface)
        assert area.w
        moved = (pixels(surface) != before).any(axis=-1)
        outside = np.ones(moved.shape, bool)
        outside[box.x : box.right, box.y : box.bottom] = opening == 0
        assert not (moved & outside).any()


def _one(table: tables.Table) -> World:
    world = table.world()
    world.add(Ball("cue", at=(0.1, 0.0)))
    return world


def test_a_ball_falls_into_a_hole_in_the_middle_of_a_table_as_well():
    world = tables.MEDIUM_CAROM.world()
    world.add(Pocket((0.5, 0.0), 0.06, "trap"))
    world.add(Ball("white", at=(0.0, 0.0)))
    session, stage = a_stage(world)
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    session.aim.texts = ["1", "0", "0", "0", "0"]
    session.strike()
    heights = set()
    for _ in range(90):
        play(session, stage, 1)
        stage.draw(surface, session)
        heights.add(stage.dropped.spots(session)[0].height)
    assert any(AWAY < h < 0 for h in heights)
    assert AWAY in heights


def test_openings_are_made_when_the_first_ball_falls():
    wells = Wells(a_stage(pot())[1].layout)
    assert wells.openings == []
