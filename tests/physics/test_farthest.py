"""How far a ball gets from what stands on a table, along a path."""

from random import Random

import pytest

from physics import Post, Wall

RAIL = Wall.segment((-0.4, 0.1), (0.5, 0.3))
THINGS = [RAIL, Post((0.1, 0.2), 0.05), Post((-0.3, 0.0), 0.0)]
LOOKS = 2000


def drawn(rng: Random, size: float) -> complex:
    return complex(rng.uniform(-size, size), rng.uniform(-size, size))


@pytest.mark.parametrize("thing", THINGS, ids=lambda thing: thing.kind)
@pytest.mark.parametrize("way", ["straight", "turning back", "curved", "resting"])
def test_the_farthest_of_a_path_is_that_of_many_looks_at_it(thing, way):
    rng = Random(5)
    for _ in range(12):
        p, v, t = drawn(rng, 0.8), drawn(rng, 1.5), rng.uniform(0.1, 1.2)
        a = {"straight": -0.1 * v, "turning back": -2.0 * v, "curved": drawn(rng, 1.0)}.get(way, 0j)
        v = 0j if way == "resting" else v
        path = [p + s * v + 0.5 * s * s * a for s in (k * t / LOOKS for k in range(LOOKS + 1))]
        most = max(thing.distance((q.real, q.imag)) for q in path)
        # between two looks it gets farther by a quarter of a step at most, where it turns
        step = t / LOOKS * (abs(v) + abs(a) * t)
        assert most - 1e-9 <= thing.farthest(p, v, a, t) <= most + step + 1e-9


def test_a_path_beside_a_rail_is_not_searched(monkeypatch):
    monkeypatch.setattr("physics.wall.greatest", None)
    assert RAIL.farthest(0.6j, 0.3 - 0.1j, 0.1 + 0.2j, 0.5) > 0.0
    assert RAIL.farthest(0.6j, 3.0 - 1.0j, -0.3 + 0.1j, 1.0) > 0.0
