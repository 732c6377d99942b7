"""Work counters against committed ceilings: a lost skip costs no digit, so only this can notice it.

Counts are the same on every machine, up to what rounding makes of the break. After a change that is
meant to cost, write the new counts with `python -m tests.physics.test_work`.
"""

import json
from math import inf
from pathlib import Path

import pytest

from benchmarks.golden import STRUCK, UNTIL
from physics import World, scenes
from tests.support.counting import work

FILE = Path(__file__).parents[1] / "ceilings.json"
CEILINGS = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}


def measured(name: str) -> dict[str, int]:
    world: World = scenes.SCENES[name]()
    if name in STRUCK:
        world.strike(*STRUCK[name])
    return work(world, UNTIL if world.cloth.roll == 0.0 else inf)


@pytest.mark.parametrize("name", scenes.SCENES)
def test_a_scene_takes_no_more_work_than_it_did(name):
    counts = measured(name)
    assert {what: n for what, n in counts.items() if n > CEILINGS[name][what]} == {}


def test_no_pair_of_resting_balls_and_no_ball_out_of_reach_costs_a_contact_solve():
    world = scenes.carom()
    world.strike("white", STRUCK["carom"][1])
    counts = work(world, inf)
    everything = counts["legs"] * (len(world.balls) - 1)
    assert counts["contact solves"] < 0.5 * everything


def test_a_world_at_rest_costs_nothing():
    world = scenes.carom()
    world.run()
    assert not any(work(world, 10.0).values())


if __name__ == "__main__":
    FILE.write_text(json.dumps({name: measured(name) for name in scenes.SCENES}, indent=1) + "\n")
