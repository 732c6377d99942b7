"""Every scene and shot ends where it ended when tests/golden.json was written, on any machine."""

import os
import subprocess
import sys

import pytest

from benchmarks import golden
from physics import scenes

GOLDEN = golden.read()


def test_every_scene_has_a_golden_outcome():
    assert set(GOLDEN["scenes"]) == set(scenes.SCENES)


@pytest.mark.parametrize("name", scenes.SCENES)
def test_a_scene_ends_as_it_always_did(name):
    off, allowed = golden.difference(name, GOLDEN), golden.tolerance(name)
    assert off <= allowed, "if that is meant: python -m benchmarks golden --write"


@pytest.mark.parametrize("name", scenes.SCENES)
def test_a_scene_ends_the_same_three_times(name):
    assert golden.outcome(name) == golden.outcome(name) == golden.outcome(name)


@pytest.mark.skipif(golden.fused(), reason="this Python was built to fuse complex products")
def test_a_hundred_and_fifty_shots_have_the_digits_that_any_machine_must_give():
    assert len(GOLDEN["shots"]) == 150
    assert golden.digests() == GOLDEN["shots"], "if that is meant: benchmarks golden --write"


SPRINGS = """
from physics import Shot, laws, scenes, simulate
world = scenes.rack15()
world.stop()
world.cluster_law = laws.HertzCluster(gap=2e-5)
for angle in (0.1, 0.7):
    print([ball.position for ball in simulate(world, "cue", Shot(8.0, angle)).balls])
"""


def test_springs_of_hertz_have_the_same_digits_on_whatever_processor():
    """OpenBLAS can be made to act as on another one, which multiplies matrices otherwise."""
    found = {
        subprocess.run(
            [sys.executable, "-c", SPRINGS], env={**os.environ, "OPENBLAS_CORETYPE": core},
            capture_output=True, text=True, check=True,
        ).stdout
        for core in ("Nehalem", "Haswell", "SkylakeX")
    }  # fmt: skip
    assert len(found) == 1
