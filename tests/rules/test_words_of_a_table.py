"""What the rules name on a table is there, by the same name."""

import pytest

from danggu.rules import GAMES, RACKS, snooker, spots, state
from danggu.rules.pocketed import Pocketed
from danggu.rules.pyramid import COMBINED, DYNAMIC, IN_HAND
from physics import tables

TABLES = {
    "carom": tables.MATCH_CAROM,
    "pool": tables.pool(9),
    "snooker": tables.SNOOKER_12FT,
    "pyramid": tables.PYRAMID_12FT,
}
OF_RACK = {rack: table for table in TABLES.values() for rack in table.racks}


def test_every_game_that_racks_has_a_rack_on_some_table_and_no_rack_is_without_a_game():
    racking = {name for name, made in GAMES.items() if isinstance(made(), Pocketed)}
    assert set(RACKS) == racking
    assert set(RACKS.values()) == set(OF_RACK)


@pytest.mark.parametrize("game", RACKS)
def test_a_game_begins_in_a_region_of_its_table_with_the_balls_of_its_rack(game):
    rules, table = GAMES[game](), OF_RACK[RACKS[game]]
    begun = rules.start(2)
    assert begun.region in table.regions
    assert {ball.name for ball in table.rack(RACKS[game])} == {*begun.left} - {*rules.cues}


def test_every_region_of_the_rules_is_one_of_a_table():
    assert all(state.ANYWHERE in table.regions for table in TABLES.values())
    assert state.KITCHEN in TABLES["pool"].regions
    assert state.D in TABLES["snooker"].regions
    assert {IN_HAND[DYNAMIC], IN_HAND[COMBINED]} <= {*TABLES["pyramid"].regions}


@pytest.mark.parametrize("kind", ["carom", "pool", "pyramid"])
def test_every_spot_of_the_rules_is_one_of_a_table(kind):
    assert {spots.HEAD, spots.CENTRE, spots.FOOT} <= {*TABLES[kind].spots}


def test_a_colour_is_the_name_of_its_spot():
    assert {*snooker.COLOURS} == {*TABLES["snooker"].spots}
