"""Which offsets and angles go in: the exact windows of mirror pockets, published and traced."""

import json
from math import cos, pi, radians, sin
from pathlib import Path

import pytest

from physics import Ball, Cloth, Pocket, Wall, World, laws
from physics.tables.pocket_tables import INCH

FILE = Path(__file__).parents[1] / "data" / "pocket_windows.json"
CASES = json.loads(FILE.read_text())["cases"]
NAMES = [f"{case['geometry']} at {case['angle']}" for case in CASES]
STEP = 0.01  # in: no gap in these windows is narrower


def pocket(case) -> World:
    """Two rails, two facings and a hole; the mouth's middle is 0, and north leads into it."""
    world = World(Cloth(0.0, 0.0, 0.0), "rough", laws.RigidCushion(1.0, 0.0, 1.0))
    half, turn = 0.5 * case["mouth"] * INCH, radians(case["facing"])
    deep = complex(half - 10 * INCH * sin(turn), 10 * INCH * cos(turn))
    slope = 0.0 if case["pocket"] == "side" else 0.25 * pi
    rail = half + 2.0 * complex(cos(slope), -sin(slope))
    for p, q in ((half, deep), (rail, half)):
        world.add(Wall.segment((p.real, p.imag), (q.real, q.imag)))
        world.add(Wall.segment((-q.real, q.imag), (-p.real, p.imag)))
    hole = case["hole"] * INCH
    world.add(Pocket((0.0, hole + case["shelf"] * INCH), hole, "hole"))
    world.add(Ball("a", (0.0, -0.5), radius=case["ball_radius"] * INCH))
    return world


def goes_in(world: World, angle: float, offset: float) -> bool:
    """Does the ball, on its way at that angle, m to the right of the mouth's middle?"""
    way = complex(sin(angle), cos(angle))
    start = offset * complex(way.imag, -way.real) - 30 * INCH * way
    ball = world.ball("a")
    ball.position, ball.velocity = (start.real, start.imag), (way.real, way.imag)
    world.run(world.time + 4.0)
    return ball.phase == "pocketed"


def edge(world: World, angle: float, side: int) -> float:
    """The first offset to that side, m, that fails."""
    good, step = 0.0, side * STEP * INCH
    while goes_in(world, angle, good + step):
        good += step
    bad = good + step
    for _ in range(50):
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if goes_in(world, angle, middle) else (good, middle)
    return 0.5 * (good + bad)


@pytest.mark.parametrize("case", CASES, ids=NAMES)
def test_a_mirror_pocket_takes_what_it_should(case):
    """To the nine digits after the point, in inches, that are published."""
    world, angle = pocket(case), radians(case["angle"])
    left, right = edge(world, angle, -1), edge(world, angle, 1)
    assert left / INCH == pytest.approx(case["left"], abs=1e-9)
    assert right / INCH == pytest.approx(case["right"], abs=1e-9)


@pytest.mark.parametrize("case", CASES[1::7], ids=NAMES[1::7])
def test_a_mirrored_path_has_the_mirrored_window_to_the_last_bit(case):
    world, angle = pocket(case), radians(case["angle"])
    assert edge(world, -angle, -1) == -edge(world, angle, 1)
    assert edge(world, -angle, 1) == -edge(world, angle, -1)
