"""Contacts that last, and many at one instant: exact answers, few events, every joule in place."""

from math import cos, pi, sin, sqrt
from random import Random

import pytest

from benchmarks.invariants import faults
from physics import (
    Ball,
    Cloth,
    ContactError,
    EventDriven,
    Shot,
    Wall,
    World,
    laws,
    simulate,
    tables,
)
from physics.studies.ledger import ledger
from tests.support.batches import same

R = 0.03275
ICE = Cloth(0.0, 0.0, 0.0)


def row(law, cloth=ICE, **engine):
    return World(cloth, law, engine=EventDriven(**engine))


# Many at one instant


@pytest.mark.parametrize("ratio", [1.0, 100.0, 1e4, 1e6, 1e9])
@pytest.mark.parametrize("e", [1.0, 0.95, 0.5])
def test_a_mirror_squeeze_reverses_whatever_the_masses(ratio, e):
    world = row(laws.SmoothBall(e), vmin=0.0)
    squeeze = (("a", 0.0, 1.0, ratio), ("b", 2 * R, 0.0, 1.0), ("c", 4 * R, -1.0, ratio))
    for name, x, v, m in squeeze:
        world.add(Ball(name, at=(x, 0.0), velocity=(v, 0.0), mass=m))
    world.run(until=1e-12)
    assert [ball.velocity[0] for ball in world.balls] == pytest.approx([-e, 0.0, e], abs=1e-13)
    assert len(world.log) == 2


@pytest.mark.parametrize("balls", [3, 20, 50, 120, 200])
def test_a_row_that_is_squeezed_evenly_reverses_ball_by_ball(balls):
    world = row(laws.SmoothBall(1.0))
    for i in range(balls):
        x = 2 * R * (i - (balls - 1) / 2)
        world.add(Ball(f"{i}", at=(x, 0.0), velocity=(-10.0 * x, 0.0)))
    world.run(until=1e-9)
    for i, ball in enumerate(world.balls):
        x = 2 * R * (i - (balls - 1) / 2)
        assert ball.velocity[0] == pytest.approx(10.0 * x, abs=1e-12)


def test_a_lattice_that_is_squeezed_evenly_reverses_although_its_pushes_are_not_unique():
    world = row(laws.SmoothBall(1.0))
    spots = [2 * R * complex(i + 0.5 * j, 0.5 * sqrt(3.0) * j) for i in range(-3, 4)
             for j in range(-3, 4) if abs(i + j) <= 3]
    for k, p in enumerate(spots):
        v = -5.0 * p
        world.add(Ball(f"{k}", at=(p.real, p.imag), velocity=(v.real, v.imag)))
    world.run(until=1e-9)
    for ball, p in zip(world.balls, spots, strict=True):
        assert complex(*ball.velocity) == pytest.approx(5.0 * p, abs=1e-9)


@pytest.mark.parametrize("ratio", [1.0, 2081.0, 1e6])
@pytest.mark.parametrize("e", [0.0, 0.7, 1.0])
def test_a_diamond_between_heavy_balls_takes_four_contacts_and_makes_no_energy(ratio, e):
    world, s = row(laws.SmoothBall(e), vmin=0.0), sqrt(3.0) * R
    for name, at, v, m in (("a", (-s, 0.0), 1.0, ratio), ("b", (0.0, R), 0.0, 1.0),
                           ("c", (0.0, -R), 0.0, 1.0), ("d", (s, 0.0), -1.0, ratio)):  # fmt: skip
        world.add(Ball(name, at=at, velocity=(v, 0.0), mass=m))
    world.run(until=1e-13)
    assert len(world.log) == 4
    had = 2.0 * ratio
    has = sum(b.mass * (b.velocity[0] ** 2 + b.velocity[1] ** 2) for b in world.balls)
    assert has <= had * (1.0 + 1e-12)
    if e == 1.0:
        assert has == pytest.approx(had, rel=1e-12)


@pytest.mark.parametrize("law", [laws.SmoothBall(0.9), laws.RoughBall(0.9, 0.2)])
def test_impulses_agree_in_every_bit_when_compiled(law):
    pytest.importorskip("numba")
    from physics import simulate_many

    world = tables.medium_carom()
    world.ball_law = law
    dice = Random(5)
    for k in range(6):
        p = 2 * R * complex(cos(pi / 3 * k), sin(pi / 3 * k))
        world.add(Ball(f"{k}", at=(p.real, p.imag), mass=0.25 * 10 ** dice.uniform(-1.5, 1.5)))
    world.add(Ball("in", at=(0.0, 0.0)))
    world.add(Ball("rail", at=(1.27 - R, 0.0)))
    world.add(Ball("cue", at=(-0.8, 0.0), mass=3.0))
    shots = [Shot(dice.uniform(0.2, 4.0), dice.uniform(-6.0, 6.0), follow=dice.uniform(-4, 6))
             for _ in range(60)]
    fast = simulate_many(world, "cue", shots, compiled=True)
    plain = simulate_many(world, "cue", shots, compiled=False)
    assert same(fast, plain)


def test_what_cannot_be_solved_raises_with_the_scene_and_applies_nothing(monkeypatch):
    from physics import store
    from physics.kernel import cluster

    monkeypatch.setattr(cluster, "solve", lambda *_: False)
    world = row(laws.SmoothBall(1.0))
    for name, x, v in (("a", 0.0, 1.0), ("b", 2 * R, 0.0), ("c", 4 * R, -1.0)):
        world.add(Ball(name, at=(x, 0.0), velocity=(v, 0.0)))
    with pytest.raises(ContactError, match=r"make all contacts part at t = 0\.0 s") as info:
        world.run(until=1.0)
    assert len(world.log) == 0
    monkeypatch.undo()
    again = store.restore(info.value.scene)
    again.run(until=1e-9)
    assert [ball.velocity[0] for ball in again.balls] == pytest.approx([-1.0, 0.0, 1.0])


# Contacts that last


def frozen_row(balls, speed, follow, vmin=1e-3):
    world = World(engine=EventDriven(vmin=vmin, budget=10**6))
    for i in range(balls):
        world.add(Ball(f"{i}", at=(2 * R * i, 0.0)))
    return simulate(world, "0", Shot(speed, follow=follow))


@pytest.mark.parametrize("follow", [2.0, 3.0, 4.0])
@pytest.mark.parametrize("speed", [0.5, 1.0, 2.0])
def test_a_driven_frozen_row_takes_few_events(speed, follow):
    assert len(frozen_row(3, speed, follow).log) <= 200


# where rows came to rest when every hit was resolved, at a floor of 1e-5 m/s, and by how much a
# floor of 1e-3 m/s moved them
LIMITS = {
    (3, 2.0, 2.0): ([0.43608, 0.50160, 10.05662], 0.99e-3),
    (4, 2.0, 2.0): ([0.18990, 0.25541, 0.32092, 9.40582], 2.7e-3),
    (5, 2.0, 2.0): ([0.09759, 0.16309, 0.22859, 0.29410, 9.04567], 2.9e-3),
    (3, 1.0, 4.0): ([1.71012, 1.77565, 2.59462], 0.31e-3),
    (4, 1.0, 4.0): ([0.64639, 0.71189, 0.77742, 2.50496], 5.4e-3),
    (5, 1.0, 4.0): ([0.28429, 0.34980, 0.41530, 0.48081, 2.45578], 1.1e-2),
    (3, 0.5, 3.0): ([0.69677, 0.91484, 0.98037], 1.9e-2),
    (4, 0.5, 3.0): ([0.33883, 0.40434, 0.46986, 0.77323], 4.9e-3),
    (5, 0.5, 3.0): ([0.14349, 0.20899, 0.27450, 0.34001, 0.81058], 6.3e-3),
}


@pytest.mark.parametrize(("balls", "speed", "follow"), LIMITS)
def test_a_driven_row_ends_where_ever_smaller_hits_would_lead(balls, speed, follow):
    ends, moved = LIMITS[balls, speed, follow]
    after = frozen_row(balls, speed, follow)
    assert [b.position[0] for b in after.balls] == pytest.approx(ends, abs=moved)


@pytest.mark.parametrize("mass", [4.0, 16.0, 25.0, 250.0])
def test_a_heavy_ball_that_creeps_into_a_light_one_on_the_cushion_comes_to_rest(mass):
    world = tables.medium_carom()
    world.add(Ball("light", at=(1.27 - R, 0.0)))
    world.add(Ball("heavy", at=(1.0, 0.0), mass=mass))
    after = simulate(world, "heavy", Shot(1.0, follow=1.0))
    assert len(after.log) <= 1000
    entries = list(ledger(after.log))
    start = 0.5 * mass + 0.2 * mass
    assert sum(e.energy_lost + e.cloth_lost for e in entries) + entries[-1].energy == pytest.approx(
        start, rel=1e-12
    )


@pytest.mark.parametrize(("e", "mu", "nose"), [(0.0, 0.0, 1.2), (0.0, 0.2, 1.4), (0.1, 0.2, 1.6)])
def test_a_ball_leaves_every_cushion_it_has_hit(e, mu, nose):
    world = World(Cloth(), "smooth", laws.RigidCushion(e, mu, nose))
    world.add(Wall.line(-1.0, 0.0, 1.0, "east"))
    world.add(Ball("a", at=(0.5, 0.0), velocity=(2.0, 0.5)))
    world.run()
    hits = [event for event in world.log if event.kind == "cushion"]
    assert hits
    for event in hits:
        assert event.after[0].velocity[0] < 0.0
    assert len(hits) < 30


def crowd(seed):
    """Up to 22 balls, some frozen to others and to rails, masses up to a thousand to one."""
    dice = Random(seed)
    world = dice.choice([tables.medium_carom, tables.match_carom, tables.thesis])()
    world.cushion_law = dice.choice(["rigid", "mathavan"])
    world.ball_law = dice.choice([laws.RoughBall(), laws.SmoothBall(dice.choice([1.0, 0.5, 0.0])),
                                  laws.RoughBall(0.3, 0.2)])  # fmt: skip
    spots: list[complex] = []
    balls = dice.randint(2, 22)
    while len(spots) < balls:
        p = complex(dice.uniform(-1.2, 1.2), dice.uniform(-0.6, 0.6))
        if spots and dice.random() < 0.6:
            a = dice.uniform(-pi, pi)
            gap = 1.0 + dice.choice([0.0, 0.0, 1e-9, 1e-6, 1e-4])
            p = dice.choice(spots) + 2 * R * gap * complex(cos(a), sin(a))
        elif dice.random() < 0.5:
            wall = dice.choice(world.walls)
            p -= wall.normal * (wall.distance((p.real, p.imag)) - R)
        inside = all(wall.distance((p.real, p.imag)) >= R - 1e-12 for wall in world.walls)
        if inside and all(abs(p - q) >= 2 * R - 1e-12 for q in spots):
            spots.append(p)
    for k, p in enumerate(spots):
        mass = 0.25 * 1e3 ** dice.uniform(-0.5, 0.5)
        world.add(Ball(f"{k}", at=(p.real, p.imag), radius=R, mass=mass))
    shot = Shot(dice.uniform(0.1, 6.0), dice.uniform(0.0, 360.0), dice.uniform(-4.0, 4.0), 0.0, 1.0)
    world.strike("0", shot)
    return world


@pytest.mark.parametrize("seed", range(40))
def test_any_legal_scene_takes_at_most_two_thousand_events(seed):
    world = crowd(seed)
    world.run()
    assert len(world.log) <= 2000
    assert faults(world) == []


@pytest.mark.stress
def test_a_thousand_legal_scenes_take_at_most_two_thousand_events_each():
    for seed in range(1000):
        world = crowd(seed)
        world.run()
        assert len(world.log) <= 2000, seed
        assert faults(world) == [], seed


# In other units


@pytest.mark.parametrize("scale", [1e-4, 1e-7, 1e-9, 1e3])
def test_the_same_scene_in_other_units_ends_alike(scale):
    def played(s):
        world = World(Cloth(0.2, 0.01, 10.0, 9.8 * s), "smooth", laws.RigidCushion(0.9, 0.1, 1.2))
        world.engine = EventDriven(vmin=1e-3 * s)
        for a, b, d in ((1, 0, 1), (-1, 0, 1), (0, 1, 0.5), (0, -1, 0.5)):
            world.add(Wall.line(a, b, d * s))
        for name, x, y in (("a", -0.5, 0.01), ("b", 0.0, 0.0), ("c", 2 * R, 0.0)):
            world.add(Ball(name, at=(x * s, y * s), radius=R * s))
        after = simulate(world, "a", Shot(2.0 * s, 3.0, follow=1.0 * s))
        return [x / s for ball in after.balls for x in ball.position]

    assert played(scale) == pytest.approx(played(1.0), abs=1e-9)


@pytest.mark.parametrize("mass", [1e-160, 1e-200, 1e40])
def test_the_outcome_does_not_depend_on_the_unit_of_mass(mass):
    def played(m):
        world = tables.medium_carom()
        world.add(Ball("a", at=(-0.5, 0.01), mass=m))
        world.add(Ball("b", at=(0.0, 0.0), mass=m))
        return simulate(world, "a", Shot(2.0, 3.0)).ball("a").position

    assert played(mass) == pytest.approx(played(1.0), abs=1e-12)


def test_a_mass_whose_inverse_is_no_number_is_refused():
    with pytest.raises(ValueError, match="mass must be at least 1e-250, not 1e-300"):
        Ball("a", at=(0.0, 0.0), mass=1e-300)


def test_a_wall_whose_normal_is_a_little_long_keeps_the_speed():
    world = World(ICE, laws.SmoothBall(1.0), laws.RigidCushion(1.0, 0.0, 1.0))
    world.add(Wall(1.0000000009 + 0j, 0.0))
    world.add(Wall(-1.0000000009 + 0j, -1.0))
    ball = world.add(Ball("a", at=(0.5, 0.0), velocity=(1.0, 0.0)))
    world.run(until=1000.0)
    assert len(world.log) > 1000
    assert abs(ball.velocity[0]) == pytest.approx(1.0, abs=1e-15)
    assert abs(world.walls[0].normal) == 1.0


def test_a_number_too_large_for_a_float_is_refused_by_a_batch_too():
    from physics import simulate_many

    world = tables.medium_carom()
    world.add(Ball("a", at=(0.0, 0.0)))
    with pytest.raises(ValueError, match="shots must be"):
        simulate_many(world, "a", [[10**400, 0, 0, 0, 0]])
