"""What is drawn as cloth and rails is where they are, on tables of any shape."""

import re

import numpy as np
import pytest

from physics import Ball, Shot, Wall, World, scenes, tables, trace
from physics.studies.grounds import CLOTH, WOOD, layers
from physics.studies.plot import extent

L = ((0.0, 0.0), (2.0, 0.0), (2.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0))


def walled(corners, closed=True):
    ends = [*corners[1:], *(corners[:1] if closed else ())]
    world = World(walls=[Wall.segment(p, q) for p, q in zip(corners, ends, strict=False)])
    world.add(Ball("white", at=(0.3, 0.3)))
    world.strike("white", Shot(2.0, 150.0))
    return world


def area(corners):
    z = np.array(corners)
    return 0.5 * abs((z.conj() * np.roll(z, -1)).imag.sum())


@pytest.mark.parametrize(
    ("world", "expected"),
    [
        (walled(L), 3.0),
        (walled(L[::-1]), 3.0),
        (scenes.sinai(), 1.0),
        (scenes.stadium(), 1.0 + np.pi / 4.0),
        (World(walls=[Wall.arc((0.0, 0.0), 1.0, 0.0, 360.0)]), np.pi),
    ],
    ids=["L", "L, clockwise", "sinai", "stadium", "circle"],
)
def test_the_cloth_ends_at_the_walls_that_close_around_it_and_has_no_rails(world, expected):
    ((fill, _, corners),) = layers(world)
    assert fill == CLOTH
    assert area(corners) == pytest.approx(expected, rel=2e-3)  # arcs are drawn in chords


def test_where_walls_leave_a_gap_there_is_cloth_all_over_and_all_of_the_path_is_shown():
    world = walled(L[:3], closed=False)
    world.run()
    ((_, _, corners),) = layers(world)
    west, east, south, north = extent(world)
    assert min(z.real for z in corners) < west
    assert max(z.imag for z in corners) > north
    _, paths = trace(world, 50.0)
    low, high = paths.min(axis=(0, 1)), paths.max(axis=(0, 1))
    assert west < low[0] < -1.0
    assert (south <= low[1], high[1] < north, high[0] < east) == (True, True, True)


def test_a_rail_that_was_taken_from_a_table_is_not_drawn():
    world = tables.pool_9ft()
    assert [fill for fill, *_ in layers(world)] == [WOOD, CLOTH]
    world.remove(next(wall for wall in world.walls if wall.name == "east"))
    assert WOOD not in [fill for fill, *_ in layers(world)]


def test_the_svg_has_as_many_polygons_as_there_are_layers():
    for world, count in ((scenes.stadium(), 1), (tables.pool_9ft(), 2)):
        assert len(re.findall("<polygon", world._repr_svg_())) == count
