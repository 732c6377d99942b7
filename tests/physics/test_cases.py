"""Scenes that once broke the engine: data files in tests/cases."""

from math import hypot, inf
from pathlib import Path

import pytest

from benchmarks.invariants import faults
from tests.support.cases import load

CASES = sorted((Path(__file__).parents[1] / "cases").glob("*.json"))


@pytest.mark.parametrize("path", CASES, ids=lambda path: path.stem)
def test_what_once_broke_holds(path):
    world, case = load(path)
    holds = case["holds"]
    world.run(inf if case["until"] is None else case["until"])
    if holds.get("invariants"):
        assert faults(world) == []
    assert len(world.log) <= holds.get("events", inf)
    for name, speed in holds.get("speeds", {}).items():
        assert hypot(*world.ball(name).velocity) == pytest.approx(speed, abs=1e-14)
    if "energy" in holds:
        energy = sum(0.5 * ball.mass * hypot(*ball.velocity) ** 2 for ball in world.balls)
        assert energy == pytest.approx(holds["energy"], rel=1e-12)


def test_there_are_cases():
    assert len(CASES) >= 7
