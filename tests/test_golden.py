"""Every scene ends where it ended when tests/golden.json was written."""

import pytest

from benchmarks import golden
from physics import scenes

GOLDEN = golden.read()


def test_every_scene_has_a_golden_outcome():
    assert set(GOLDEN["scenes"]) == set(scenes.SCENES)


@pytest.mark.parametrize("name", scenes.SCENES)
def test_a_scene_ends_as_it_always_did(name):
    off, allowed = golden.difference(name, GOLDEN), golden.tolerance(name, GOLDEN)
    assert off <= allowed, "if that is meant: python -m benchmarks golden --write"


@pytest.mark.parametrize("name", scenes.SCENES)
def test_a_scene_ends_the_same_three_times(name):
    assert golden.outcome(name) == golden.outcome(name) == golden.outcome(name)
