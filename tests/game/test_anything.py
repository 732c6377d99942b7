"""A game that is played at random, with every engine at every place, goes on."""

import pytest

from tests.support.anything import KINDS, PLACES, RACKS, trial

LONG = 100_000 // (len(KINDS) * len(PLACES)) + 1
"""Inputs of a trial: a hundred thousand in all."""
SOME = [(kind, place) for k, kind in enumerate(KINDS) for place in PLACES[k % 5 :: 5][:2]]


@pytest.mark.parametrize(("kind", "place"), SOME, ids=str)
def test_a_hundred_inputs_at_random_raise_nothing_and_undo_gives_back_the_digits(kind, place):
    trial(kind, place, 0, 100)


@pytest.mark.parametrize("place", RACKS, ids=str)
def test_sixty_inputs_at_random_raise_nothing_on_a_table_with_pockets(place):
    trial("exact", place, 0, 60)


@pytest.mark.stress
@pytest.mark.parametrize("place", RACKS, ids=str)
@pytest.mark.parametrize("kind", ["exact", "tired", "jumps"])
def test_a_hundred_thousand_inputs_at_random_raise_nothing_with_pockets(kind, place):
    trial(kind, place, 2, 100_000 // (3 * len(RACKS)) + 1)


@pytest.mark.stress
@pytest.mark.parametrize("place", PLACES, ids=str)
@pytest.mark.parametrize("kind", KINDS)
def test_a_hundred_thousand_inputs_at_random_raise_nothing(kind, place):
    trial(kind, place, 1, LONG)
