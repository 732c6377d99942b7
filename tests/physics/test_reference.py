"""Whole scenes and single collisions against an independent solver with 50 digits."""

import json
from math import isfinite
from pathlib import Path

import pytest

from physics import Ball, Cloth, EventDriven, State, Wall, World, laws

DATA = json.loads((Path(__file__).parents[1] / "data" / "reference_cases.json").read_text())
KINDS = {"roll": "roll", "rest": "rest", "cushion": "cushion", "ball-ball": "ball"}
SINGLE = {
    "cushion_text": lambda e, mu: laws.ThesisCushion(e, mu),
    "cushion_capped": lambda e, mu: laws.CappedCushion(e, mu),
    "cushion_tilted": lambda e, mu: laws.RigidCushion(e, mu, 1.4),
}
PAIR = {
    "bb_text": lambda e, mu: laws.ThesisBall(e),
    "bb_restitution": lambda e, mu: laws.SmoothBall(e),
    "bb_friction": lambda e, mu: laws.RoughBall(e, mu),
}


def numbers(values):
    return tuple(float(value) for value in values)


def build(case):
    constants = {**DATA["constants"], **DATA["lawsets"][case["lawset"]]["overrides"]}
    c = {name: float(value) for name, value in constants.items()}
    lawset = DATA["lawsets"][case["lawset"]]
    world = World(
        Cloth(c["mu_s"], c["mu_r"], c["alpha_z"], c["g"]),
        PAIR[lawset["ball_ball"]](c["e_b"], c["mu_b"]),
        SINGLE[lawset["cushion"]](c["e_c"], c["mu_c"]),
        EventDriven(vmin=1e-4),
    )
    if case["walls"]:
        for name, a, b in (("west", 1, 0), ("east", -1, 0), ("south", 0, 1), ("north", 0, -1)):
            world.add(Wall.line(a, b, 1.224 if a else 0.635, name))
    for name, state in case["events"][0]["state"].items():
        r, v, w = (numbers(state[key]) for key in "rvw")
        world.add(Ball(name, at=r, velocity=v, spin=w, radius=c["R"], mass=c["m"]))
    return world


def distance(state: State, expected) -> float:
    """The largest difference of two states of a ball, spin as surface speed."""
    radius = float(DATA["constants"]["R"])
    position, velocity, spin = (numbers(expected[key]) for key in "rvw")
    pairs = zip(
        (*state.position, *state.velocity, *(radius * w for w in state.spin)),
        (*position, *velocity, *(radius * w for w in spin)),
        strict=True,
    )
    return max(abs(a - b) for a, b in pairs)


@pytest.mark.parametrize("case", DATA["cases"], ids=lambda case: case["id"])
def test_a_scene_agrees_with_fifty_digits_at_every_event(case):
    world = build(case)
    world.run(float(case["t_end"]) if case["t_end"] else float("inf"))
    condition = float(case["condition_last_state"])
    expected = [event for event in case["events"] if event["kind"] in KINDS]
    if not isfinite(condition):  # an outcome that hangs on the last digit: up to there
        expected, condition = expected[:2], 1.0
    events = list(world.log)[: len(expected)]
    assert [event.kind for event in events] == [KINDS[event["kind"]] for event in expected]
    for event, wanted in zip(events, expected, strict=True):
        assert abs(event.time - float(wanted["t"])) < 1e-12 * condition
        assert {*event.balls, event.wall} - {None} == set(wanted["who"])
        for name, state in wanted["state"].items():
            seen = event.after[event.balls.index(name)] if name in event.balls else None
            state_then = seen or world.log.at(event.time)[name]
            assert distance(state_then, state) < 1e-12 * max(condition, 1.0)


CUSHION_HITS = [hit for hit in DATA["single_collisions"] if hit["law"] in SINGLE]
PAIR_HITS = [hit for hit in DATA["single_collisions"] if hit["law"] in PAIR]


def compare(state: State, v, w):
    radius = float(DATA["constants"]["R"])
    for seen, wanted in zip(state.velocity, numbers(v), strict=True):
        assert seen == pytest.approx(wanted, abs=4e-15)
    for seen, wanted in zip(state.spin, numbers(w), strict=True):
        assert radius * seen == pytest.approx(radius * wanted, abs=4e-15)


@pytest.mark.parametrize("hit", CUSHION_HITS, ids=lambda hit: f"{hit['law']} {hit['label']}")
def test_a_single_cushion_agrees_with_fifty_digits(hit):
    normal, radius = numbers(hit["n"]), float(DATA["constants"]["R"])
    world = World(cushion_law=SINGLE[hit["law"]](float(hit["e_c"]), float(hit["mu_c"])))
    world.add(Wall.line(*normal, 0.0))
    at = (normal[0] * radius, normal[1] * radius)
    world.add(Ball("white", at, numbers(hit["v_in"]), numbers(hit["w_in"]), radius=radius))
    world.run(until=1e-6)
    compare(world.log[0].after[0], hit["v_out"], hit["w_out"])


@pytest.mark.parametrize("hit", PAIR_HITS, ids=lambda hit: hit["law"])
def test_a_single_hit_of_two_balls_agrees_with_fifty_digits(hit):
    normal, radius = numbers(hit["n"]), float(DATA["constants"]["R"])
    world = World(ball_law=PAIR[hit["law"]](float(hit["e_b"]), float(hit["mu_b"])))
    at = (2 * normal[0] * radius, 2 * normal[1] * radius)
    world.add(Ball("one", (0.0, 0.0), numbers(hit["v1_in"]), numbers(hit["w1_in"]), radius=radius))
    world.add(Ball("two", at, numbers(hit["v2_in"]), numbers(hit["w2_in"]), radius=radius))
    world.run(until=1e-6)
    event = world.log[0]
    assert event.balls == ("one", "two")
    for k, state in enumerate(event.after, start=1):
        compare(state, hit[f"v{k}_out"], hit[f"w{k}_out"])
