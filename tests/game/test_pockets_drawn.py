"""Tables with pockets: their picture is true to the physics, and leaves the rest as it was."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pygame
import pytest

from game.render.table import ground, plan
from game.render.table.background import background
from game.ui.table.furniture import across, furnished
from physics import Pocket, Post, Wall, tables
from tests.support.pictures import changed, pixels
from tests.support.stages import TABLES, layout_of

EVERY = pytest.mark.parametrize("table", TABLES.values(), ids=TABLES)


def at(surface: pygame.Surface, layout, point: complex) -> np.ndarray:
    """The mean colour of 3 x 3 pixels around a point of the table."""
    x, y = map(int, layout.to_screen(point.real, point.imag))
    return pixels(surface)[x - 1 : x + 2, y - 1 : y + 2].reshape(-1, 3).mean(axis=0)


@EVERY
def test_a_table_has_six_cushions_each_between_two_pockets(table):
    found = plan.cushions(table)
    assert len(found) == 6
    for piece in table.obstacles:
        if piece.part in ("rail", "facing"):
            p, q = piece.points
            for spot in (p, 0.5 * (p + q), q):
                x, y = np.array([spot.real]), np.array([spot.imag])
                assert min(abs(plan.distance(c, x, y)[0]) for c in found) < 1e-6


@EVERY
def test_a_point_inside_a_cushion_has_a_negative_distance_and_a_ball_on_the_bed_none(table):
    long, short = plan.north_east(table)
    inside = np.array([0.25 * table.length]), np.array([0.5 * table.width + 0.02])
    assert plan.distance(long, *inside)[0] == pytest.approx(-0.02, abs=1e-5)
    middle = np.zeros(1), np.zeros(1)
    assert plan.distance(short, *middle)[0] == pytest.approx(0.5 * table.length, abs=1e-5)


@EVERY
def test_a_hole_begins_where_a_ball_drops(table):
    layout = layout_of(table, (1920, 1080))
    for patch in ground.patches(layout, table):
        hole = patch.hole
        toward = -hole.at / abs(hole.at)
        edge = hole.at + hole.radius * toward
        for off in (0.004, -0.004):
            spot = edge + off * toward
            x, y = layout.to_screen(spot.real, spot.imag)
            drop = patch.turned(patch.ground.drop)
            found = drop[int(x) - patch.box.x, int(y) - patch.box.y]
            assert found == pytest.approx(off, abs=0.8 / layout.scale)


@EVERY
def test_holes_are_dark_and_the_shelf_before_them_is_cloth(table):
    layout = layout_of(table)
    surface = background(layout, table=table)
    cloth = at(surface, layout, complex(0.1, 0.1)).sum()
    for hole in plan.holes(table):
        assert at(surface, layout, hole.rim).sum() < 0.2 * cloth
        toward = -hole.at / abs(hole.at) if hole.corner else -1j * np.sign(hole.at.imag)
        assert at(surface, layout, hole.at + (hole.radius + 0.02) * toward).sum() > 0.3 * cloth


@EVERY
def test_pockets_change_nothing_beside_them(table):
    layout = layout_of(table)
    without = background(layout, table=replace(table, pockets=None))
    new = (pixels(background(layout, table=table)) != pixels(without)).any(axis=-1)
    for patch in ground.patches(layout, table):
        box = patch.box.inflate(6, 6)  # a diamond on each long rail is gone
        new[box.x : box.right, box.y : box.bottom] = False
    assert not new.any()


@EVERY
@pytest.mark.parametrize("size", [(1281, 723), (960, 540)])
def test_a_patch_lies_around_its_own_hole_in_every_quarter(table, size):
    layout = layout_of(table, size)
    holes = [patch.hole for patch in ground.patches(layout, table)]
    assert {*holes} == {*plan.holes(table)}
    for patch in ground.patches(layout, table):
        rim = patch.hole.rim
        x, y = layout.to_screen(rim.real, rim.imag)
        middle = patch.turned(patch.ground.rim)[int(x) - patch.box.x, int(y) - patch.box.y]
        assert middle == pytest.approx(-patch.hole.width, abs=0.8 / layout.scale)


def test_the_leather_stays_within_the_wood_of_every_pool_table():
    for feet in (7, 8, 9):
        table = tables.pool(feet)
        for hole in plan.holes(table):
            out = abs(hole.rim.imag) - 0.5 * table.width + hole.width + plan.LINER
            assert out < plan.BORDER


@EVERY
def test_the_picture_is_the_same_every_time(table):
    layout = layout_of(table, (960, 540))
    first, second = background(layout, table=table), background(layout, table=table)
    assert np.array_equal(pixels(first), pixels(second))


def test_the_baulk_line_and_the_d_are_drawn_on_a_snooker_table():
    table = tables.SNOOKER_12FT
    layout = layout_of(table)
    surface = background(layout, table=table)
    line = table.head_string
    assert line is not None
    for spot in (complex(line, 0.6), complex(line - 0.292, 0.0)):
        assert at(surface, layout, spot)[0] > at(surface, layout, spot + 0.02)[0] + 10


def test_a_carom_table_is_drawn_as_without_its_name():
    table = tables.MEDIUM_CAROM
    layout = layout_of(table)
    plain = pixels(background(layout))
    assert np.array_equal(pixels(background(layout, table=table)), plain)


# -- anything else -------------------------------------------------------------------------------

THINGS = {
    "segment": (Wall.segment((-0.5, -0.3), (-0.2, 0.2)), (-0.35, -0.05)),
    "arc": (Wall.arc((0.3, 0.0), 0.25, 0.0, 200.0), (0.3, 0.25)),
    "post": (Post((0.8, 0.3), 0.06), (0.8, 0.3)),
    "pocket": (Pocket((-0.9, 0.3), 0.06), (-0.9, 0.3)),
    "line": (Wall.through((0.9, -0.635), (1.27, -0.3)), (1.085, -0.4675)),
}


@pytest.mark.parametrize("name", THINGS)
def test_whatever_stands_on_a_table_is_drawn_where_it_is(name):
    thing, spot = THINGS[name]
    world = tables.MEDIUM_CAROM.world()
    layout = layout_of(tables.MEDIUM_CAROM)
    before = pixels(furnished(layout, world)[0])
    world.add(thing)
    seen = changed(before, furnished(layout, world)[0])
    assert seen.w
    assert seen.inflate(4, 4).collidepoint(layout.to_screen(*spot))
    assert seen.w < 0.45 * layout.table.w


def test_of_a_line_the_part_on_the_bed_is_drawn():
    ends = across(1j, 0.2, (1.0, 0.5))
    assert ends == [(-1.0, 0.2), (1.0, 0.2)]
    assert across(1j, 0.7, (1.0, 0.5)) == []
    (x0, y0), (x1, y1) = across(complex(0.6, 0.8), 0.1, (1.0, 0.5))
    for x, y in ((x0, y0), (x1, y1)):
        assert 0.6 * x + 0.8 * y == pytest.approx(0.1)
        assert max(abs(x), 2 * abs(y)) == pytest.approx(1.0)
    assert all(a <= b for a, b in pairwise((x0, x1)))
