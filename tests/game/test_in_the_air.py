"""Balls in the air and cues that are raised: seen by their shadows and sizes."""

from __future__ import annotations

from math import cos, radians

import numpy as np
import pygame
import pytest

from game.render.layout import Layout
from game.render.table import cue_stick
from game.render.table.balls import Spot
from game.session.action import Action
from game.session.ticks import TICKS
from physics import Ball, CueStroke, Shot, tables
from tests.support.pictures import black, changed, pixels, sprites
from tests.support.players import an_app, assert_same_as_anew
from tests.support.stages import a_stage, shown

FRAME = TICKS // 60
LAYOUT = Layout((1280, 720), 2.54, 1.27)


def grey() -> pygame.Surface:
    surface = black(LAYOUT)
    surface.fill((120, 120, 120))
    return surface


@pytest.mark.parametrize("table", [tables.pool(9), tables.MEDIUM_CAROM], ids=["pool", "carom"])
def test_a_jump_drawn_in_part_is_the_same_as_drawn_again(table):
    world = table.world()
    world.add(Ball("cue", at=(-0.6, -0.1)))
    world.add(Ball("red", at=(0.9, 0.2)))
    world.strike("cue", CueStroke(4.0, height=0.3, elevation=45.0).jump(world.ball("cue")))
    session, stage = a_stage(world)
    surface = pygame.Surface(stage.layout.size, 0, 32)
    stage.everything(surface, session)
    highest = 0.0
    for frame in range(30):
        session.advance(FRAME)
        stage.follow(session)
        stage.draw(surface, session)
        highest = max(highest, world.ball("cue").height)
        if frame % 3 == 0:
            assert np.array_equal(pixels(surface), pixels(shown(session, stage)))
    assert highest > 0.05


def test_a_ball_in_the_air_is_larger_and_its_shadow_leaves_it_the_higher_it_is():
    balls = sprites()
    bottoms, bright = [], []
    for height in (0.0, 0.05, 0.1):
        surface = grey()
        before = pixels(surface)
        balls.draw_all(surface, [Spot(0, (0.2, 0.0), height)])
        bottoms.append(changed(before, surface).bottom)
        bright.append(int((pixels(surface).min(axis=-1) > 130).sum()))
    assert bottoms == sorted({*bottoms})
    assert bright[0] < bright[1] < bright[2] < 1.5 * bright[0]


def test_a_ball_in_the_air_is_above_one_on_the_cloth_also_if_that_comes_later():
    balls = sprites()
    first, second = grey(), grey()
    spots = [Spot(0, (0.2, 0.0), 0.08), Spot(2, (0.22, 0.0))]
    balls.draw_all(first, spots)
    balls.draw_all(second, spots[::-1])
    assert np.array_equal(pixels(first), pixels(second))


def test_a_raised_cue_is_shorter_and_its_shadow_farther_away():
    lengths = []
    for elevation in (0.0, 40.0, 70.0):
        surface = grey()
        before = pixels(surface)
        args = (LAYOUT, (1.0, 0.3), 0.0, 0.05, 1.0, 0.03, elevation)
        room = cue_stick.room(LAYOUT, (1.0, 0.3), 0.0, 0.05, 0.03, elevation)
        cue_stick.draw(surface, *args)
        seen = changed(before, surface)
        assert room.contains(seen)
        lit = (pixels(surface).astype(int).max(axis=-1) > 150).any(axis=1)
        xs = np.flatnonzero(lit)
        lengths.append((xs[-1] - xs[0], seen.h))
    (flat, low), (middle, higher), (steep, highest) = lengths
    assert middle == pytest.approx(flat * cos(radians(40.0)), rel=0.08)
    assert steep < 0.5 * middle
    assert low < higher < highest


def test_a_cue_in_the_hand_is_drawn_as_steep_as_its_stroke():
    world = tables.MEDIUM_CAROM.world()
    world.add(Ball("white", at=(0.0, 0.0)))
    session, stage = a_stage(world)
    rooms = []
    for masse in ("0", "1.5"):
        session.aim.texts = ["2", "0", masse, "1.5", "0"]
        surface = pygame.Surface(stage.layout.size, 0, 32)
        stage.everything(surface, session)
        rooms.append(stage._cue[1])
    assert rooms[1].w < rooms[0].w
    assert rooms[1].h > rooms[0].h


def test_a_ball_high_above_the_rail_leaves_the_cards_beside_the_table_alone():
    app = an_app(size=(1280, 720), game="snooker", table="snooker")
    app.perform(Action("arrange"))
    app.session.world.ball("black").position = (1.6, 0.75)
    app.session.world.strike("black", Shot(0.5, 200.0, climb=4.0))
    app.session.timeline.moving = app.session.timeline.shown = True
    for _ in range(30):
        app.frame(FRAME)
        assert app.session.world.ball("black").height > 0.0
        assert_same_as_anew(app)
