"""The table that a world stands on has the cloth and laws that the world has now."""

import pytest

from physics import Cloth, World, fit, laws, tables
from tests.support.table_of_tracks import case

CHANGES = {
    "cloth": Cloth(slide=0.19, roll=0.006),
    "ball_law": laws.RoughBall(0.91, 0.04),
    "cushion_law": laws.RigidCushion(0.8, 0.15, 1.2),
}


@pytest.mark.parametrize("name", CHANGES)
@pytest.mark.parametrize("made", [tables.match_carom, tables.pool_9ft], ids=["match", "pool"])
def test_a_table_has_what_was_assigned_to_its_world(name, made):
    world, before = made(), made()
    preset, copy = world.table, world.copy()
    setattr(world, name, CHANGES[name])
    assert getattr(world.table, name) == CHANGES[name]
    assert world.table is world.table
    assert copy.table == before.table == preset
    assert world.copy().table == world.table


def test_a_saved_table_is_the_one_that_was_changed(tmp_path):
    world = tables.pool_9ft(corner_mouth=0.117)
    world.cloth = CHANGES["cloth"]
    tables.save(world.table, tmp_path / "table.json")
    tables.save(world, tmp_path / "world.json")
    assert tables.load(tmp_path / "table.json") == tables.load(tmp_path / "world.json")
    assert tables.load(tmp_path / "world.json").cloth == CHANGES["cloth"]


def test_a_table_that_knows_no_cloth_stays_as_it_is():
    class Small:
        radius, mass = 0.02, 0.1

    table = Small()
    assert World(CHANGES["cloth"], table=table).table is table
    assert World().table is None


def test_a_fit_has_the_table_that_it_found(tmp_path):
    given = case(16, strokes=2)
    found = fit(given.world, given.tracks, ["cloth.roll"])
    assert found.table.cloth == found.world.cloth != given.world.table.cloth
    tables.save(found.table, tmp_path / "mine.json")
    assert tables.load(tmp_path / "mine.json") == found.table
