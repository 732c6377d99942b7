"""Cells for many balls: no bit of an outcome changes, and no ball more makes an event dearer."""

import random
from math import cos, sin, sqrt

import numpy as np
import pytest

from physics import Ball, Cloth, Shot, Wall, World, laws, scenes, simulate_many
from physics.kernel import contact
from physics.kernel import grid as cells


def gas(balls: int, seed: int = 1, cloth: Cloth | None = None) -> World:
    """Discs in a box that they fill to 30 %, each on its way."""
    radius = 0.01
    side = sqrt(balls * 3.1416 * radius**2 / 0.3)
    world = World(cloth or Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0), laws.RigidCushion(1, 0, 1))
    for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        world.add(Wall.line(a, b, side / 2))
    chance = random.Random(seed)
    lines = int(sqrt(balls) + 0.999)
    for k in range(balls):
        at = (side * ((k % lines + 0.5) / lines - 0.5), side * ((k // lines + 0.5) / lines - 0.5))
        v = (chance.uniform(-1, 1), chance.uniform(-1, 1))
        world.add(Ball(f"{k}", at, v, radius=radius, mass=0.1))
    return world


def mixed() -> World:
    """Balls of many sizes, on cloth, in a pentagon."""
    world = gas(50, seed=3, cloth=Cloth())
    world.ball_law, world.cushion_law = laws.RoughBall(), laws.RigidCushion()
    world.add(Wall.through((0.17, -0.02), (0.02, 0.17)))
    return world


def outcome(world: World, until: float) -> list[tuple[float, float]]:
    world.run(until)
    return [ball.position for ball in world.balls] + [(e.time, 0.0) for e in world.log]


@pytest.mark.parametrize(
    ("scene", "until"),
    [(scenes.rack15, 9e9), (lambda: gas(40), 1.0), (lambda: gas(80, 2), 0.5), (mixed, 9e9)],
)
def test_cells_change_no_bit(scene, until, monkeypatch):
    monkeypatch.setattr("physics.world.FEW", 1000)
    table = outcome(scene(), until)
    monkeypatch.setattr("physics.world.FEW", 1)
    assert outcome(scene(), until) == table


def test_cells_change_no_bit_of_a_cluster(monkeypatch):
    outcomes = []
    for few in (1000, 1):
        monkeypatch.setattr("physics.world.FEW", few)
        world = scenes.rack15(gap=0.0)
        outcomes.append(outcome(world, 9e9))
    # the order in which a cluster's contacts are listed may differ, and with it the last digits
    for (x, y), (u, v) in zip(*outcomes, strict=True):
        assert (x, y) == pytest.approx((u, v), abs=1e-9)


def test_compiled_cells_agree_in_every_bit():
    pytest.importorskip("numba")
    world = gas(60, cloth=Cloth())
    world.run()
    shots = [Shot(2.0, 30.0 * k) for k in range(6)]
    compiled = simulate_many(world, "0", shots, compiled=True)
    interpreted = simulate_many(world, "0", shots, compiled=False)
    assert np.array_equal(compiled.positions, interpreted.positions)
    assert np.array_equal(compiled.events, interpreted.events)


def test_an_event_costs_no_more_work_among_a_thousand_balls_than_among_a_hundred(monkeypatch):
    calls = {"meeting": 0, "rank": 0}

    def counted(name, function):
        def count(*args):
            calls[name] += 1
            return function(*args)

        return count

    monkeypatch.setattr(cells, "meeting", counted("meeting", contact.meeting))
    monkeypatch.setattr(cells, "rank", counted("rank", cells.rank))
    work = {}
    for balls in (100, 1000):
        world = gas(balls)
        world.plan()
        calls.update(meeting=0, rank=0)
        while len(world.log) < 400:
            world.run(world.time + 2.0 / balls)
        work[balls] = {name: count / len(world.log) for name, count in calls.items()}
    for name in calls:
        assert work[1000][name] < 1.5 * work[100][name]


def test_a_ball_put_elsewhere_is_found_there():
    world = gas(60, cloth=Cloth())
    world.run()
    first, other = world.balls[:2]
    x, y = other.position
    others = [complex(*ball.position) for ball in world.balls[1:]]
    ways = [complex(cos(0.1 * k), sin(0.1 * k)) for k in range(63)]
    spots = [complex(x, y) + 0.021 * way for way in ways]
    free = next(p for p in spots if min(abs(p - q) for q in others) > 0.0201)
    world.log.clear()
    way = complex(x, y) - free
    first.position, first.velocity = (free.real, free.imag), (way.real / 0.02, way.imag / 0.02)
    world.run(world.time + 0.01)
    assert set(world.log[0].balls) == {"0", "1"}


def test_balls_far_apart_in_line_have_no_more_cells_than_balls():
    for spacing in (1e5, 1e48):
        world = World(Cloth(), "smooth")
        for k in range(31):
            world.add(Ball(str(k), (k * spacing, 0.0)))
        world.plan()
        assert len(world.scene.grid.head) <= 32
