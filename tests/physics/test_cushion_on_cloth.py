"""Mathavan's cushion rubs on the world's own cloth, unless it brings a friction of its own."""

import json

import pytest

from physics import Ball, Cloth, Shot, World, laws, simulate, store, tables

SHOT = Shot(3.0, 40.0, follow=1.0, side=1.5)


def table(law, cloth=tables.MEASURED):
    world = tables.match_carom()
    world.cloth, world.cushion_law = cloth, law
    world.add(Ball("white", at=(0.0, 0.0), radius=0.03075, mass=0.21))
    return world


def end(world):
    white = simulate(world, "white", SHOT).ball("white")
    return white.position, white.spin


@pytest.mark.parametrize("slide", [0.15, 0.2, 0.212, 0.4])
def test_the_friction_is_the_cloth_s_unless_it_is_given(slide):
    cloth = Cloth(slide=slide, roll=0.0045, gravity=9.81)
    own = end(table(laws.MathavanCushion(), cloth))
    assert own == end(table(laws.MathavanCushion(slide=slide), cloth))
    assert (own == end(table(laws.MathavanCushion(slide=0.212), cloth))) == (slide == 0.212)


def test_another_cloth_reaches_the_cushion_in_whatever_order_they_come():
    world = table(laws.MathavanCushion())
    for cloth in (tables.CLOTHS["humid"], tables.CLOTHS["new"]):
        world.cloth = cloth
        assert end(world) == end(table(laws.MathavanCushion(slide=cloth.slide), cloth))
        assert end(world.copy()) == end(world)
    built = World(tables.CLOTHS["new"], "rough", laws.MathavanCushion())
    assert built.scene.cushion_rule.slide == 0.15


def test_tried_by_hand_it_is_on_the_measured_cloth():
    state = -1.0 + 0.5j, -0.8 + 0.2j, 0.3
    assert laws.MathavanCushion()(*state) == laws.MathavanCushion(slide=0.212)(*state)
    assert laws.MathavanCushion().rule().slide == tables.MEASURED.slide


def test_a_cloth_on_which_the_ball_would_jam_is_refused_and_changes_nothing():
    sticky = Cloth(slide=0.99)
    jams = laws.MathavanCushion(mu=0.9, nose=1.5)
    world = table(jams)
    with pytest.raises(ValueError, match=r"slide=0\.99.*jam"):
        world.cloth = sticky
    assert (world.cloth, world.scene.cushion_rule.slide) == (tables.MEASURED, 0.212)
    with pytest.raises(ValueError, match=r"MathavanCushion\.slide must be .* not 1\.5"):
        World(Cloth(slide=1.5), cushion_law="mathavan")
    world = table(laws.RigidCushion(), sticky)
    with pytest.raises(ValueError, match="jam"):
        world.cushion_law = jams
    assert world.cushion_law == laws.RigidCushion()
    assert end(world) == end(table(laws.RigidCushion(), sticky))


def test_value_and_repr_say_whether_the_friction_was_given():
    own, given = laws.MathavanCushion(), laws.MathavanCushion(slide=0.212)
    assert own != given
    assert own == eval(repr(own), vars(laws))
    assert given == eval(repr(given), vars(laws))


@pytest.mark.parametrize("slide", [None, 0.212, 0.3])
def test_a_file_keeps_whether_the_friction_was_given_and_every_digit(slide):
    world = table(laws.MathavanCushion(slide=slide), tables.CLOTHS["humid"])
    loaded = store.loads(store.dumps(world))
    assert loaded.cushion_law == laws.MathavanCushion(slide=slide)
    assert end(loaded) == end(world)


def test_an_older_file_which_always_names_the_friction_keeps_its_digits():
    data = json.loads(store.dumps(table("mathavan", tables.CLOTHS["humid"])))
    data["cushion_law"] = {"name": "MathavanCushion", "e": 0.901, "mu": 0.222, "slide": 0.212,
                           "nose": 0.037 / 0.03075}  # fmt: skip
    before = laws.MathavanCushion(slide=0.212, nose=0.037 / 0.03075)
    loaded = store.restore(data)
    assert loaded.cushion_law == before
    assert end(loaded) == end(table(before, tables.CLOTHS["humid"]))
