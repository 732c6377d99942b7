"""Balls of two sizes on one cloth: where they touch, and what becomes of a shot among them."""

import json
import math
from pathlib import Path
from random import Random

import mpmath
import numpy as np
import pytest

from physics import (
    Ball,
    Cloth,
    EventDriven,
    Shot,
    TimeStepping,
    World,
    laws,
    ledger,
    simulate,
    simulate_many,
    store,
    tables,
)
from physics.engines.stepping import SCHEMES
from tests.support import fifty

ICE = Cloth(0.0, 0.0, 0.0)
SMALL, BIG = 0.02, 0.04
APART = 2.0 * math.sqrt(SMALL * BIG)  # .0566 m, where discs touch at .06
OLD = Path(__file__).parents[1] / "data" / "discs_of_version_2.json"


def two(law="smooth", aside=0.0, cloth=ICE, **options):
    """A big ball that runs at 1 m/s towards a small one half a metre away."""
    world = World(cloth, law, **options)
    world.add(Ball("big", (0.0, 0.0), (1.0, 0.0), radius=BIG, mass=0.4))
    world.add(Ball("small", (0.5, aside), radius=SMALL, mass=0.05))
    return world


# -- where they touch


def test_balls_of_two_and_four_centimetres_touch_57_millimetres_apart():
    world = two()
    assert world.balls[0].touching_distance(world.balls[1]) == pytest.approx(0.0566, abs=5e-5)
    world.run(0.5)
    hit = next(event for event in world.log if event.kind == "ball")
    with mpmath.workdps(50):  # with a constant velocity it is met after 0.5 - 2 √(r R) seconds
        exact = 0.5 - 2 * mpmath.sqrt(mpmath.mpf(SMALL) * mpmath.mpf(BIG))
        assert abs(hit.time - exact) < 1e-16


def test_discs_of_those_radii_touch_sixty_millimetres_apart():
    world = two(discs=True)
    assert world.balls[0].touching_distance(world.balls[1]) == SMALL + BIG
    world.run(0.5)
    assert next(e for e in world.log if e.kind == "ball").time == pytest.approx(0.44, abs=1e-15)


def test_an_oblique_hit_of_a_sliding_ball_comes_when_the_centres_are_both_radii_apart_in_space():
    world = two(aside=0.03, cloth=Cloth(slide=0.02))
    world.run(0.6)
    hit = next(event for event in world.log if event.kind == "ball")
    with mpmath.workdps(50):
        slide = mpmath.mpf(world.cloth.slide) * mpmath.mpf(world.cloth.gravity)
        y, r, big = (mpmath.mpf(x) for x in (0.03, SMALL, BIG))

        def gap(t):
            centre = mpmath.matrix([t - slide * t * t / 2, 0, big])
            return mpmath.norm(mpmath.matrix([0.5, y, r]) - centre) - (r + big)

        exact = mpmath.findroot(gap, 0.46)
        assert abs(hit.time - exact) < 2e-16


@pytest.mark.parametrize(
    "engine", [EventDriven(), *(TimeStepping(1e-3, s) for s in SCHEMES)], ids=repr
)
@pytest.mark.parametrize("discs", [False, True])
def test_a_ball_passes_where_a_disc_would_hit(engine, discs):
    world = two(aside=0.5 * (APART + SMALL + BIG), cloth=Cloth(), engine=engine, discs=discs)
    world.run(0.7)
    assert any(event.kind == "ball" for event in world.log) is discs


def test_balls_may_lie_nearer_than_discs_and_not_nearer_than_they_touch():
    world = two(aside=0.0)
    world.stop()
    world.ball("small").position = (APART - 1e-10, 0.0)
    world.run()
    world.ball("small").position = (APART - 1e-8, 0.0)
    with pytest.raises(ValueError, match="overlap"):
        world.run()
    disc = two(discs=True)
    disc.ball("small").position = (APART, 0.0)
    with pytest.raises(ValueError, match="overlap"):
        disc.run()


def test_many_balls_of_two_sizes_in_cells_never_overlap_and_do_as_all_pairs_do():
    dice, outcomes = Random(3), []
    spots = [(0.07 * (k % 7), 0.07 * (k // 7)) for k in range(35)]
    speeds = [(dice.gauss(0, 1), dice.gauss(0, 1)) for _ in spots]
    for few in (30, 100):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr("physics.world.FEW", few)
            world = World(Cloth(), laws.RoughBall(0.95, 0.05))
            for k, (at, v) in enumerate(zip(spots, speeds, strict=True)):
                world.add(Ball(f"{k}", at, v, radius=(SMALL, 0.025, 0.03)[k % 3]))
            world.run(0.4)
            assert world.scene.celled == (few == 30)
            outcomes.append([ball.position for ball in world.balls])
    assert outcomes[0] == outcomes[1]
    for i, ball in enumerate(world.balls):
        for other in world.balls[:i]:
            gap = math.dist(ball.position, other.position) - ball.touching_distance(other)
            assert gap > -1e-12


def test_a_flying_ball_meets_a_smaller_one_where_the_centres_are_both_radii_apart_in_space():
    height = 0.01
    for discs, rise in ((False, height + BIG - SMALL), (True, height)):
        world = two(cloth=Cloth(0.0, 0.0, 0.0, gravity=0.0), discs=discs)
        world.ball("big").height = height
        world.run(0.6)
        across = math.sqrt((SMALL + BIG) ** 2 - rise**2)
        assert world.log[0].time == pytest.approx(0.5 - across, abs=1e-15)
        assert world.ball("big").climb > 0.0


# -- whole shots


def test_an_oversize_cue_ball_hits_low_on_the_object_ball_and_follows_it():
    """60.3 mm and 57.15 mm, of one stuff: a full stun shot."""
    world = tables.medium_carom()
    big, small = 0.0603 / 2, 0.05715 / 2
    world.add(Ball("cue", (0.0, 0.0), radius=big, mass=0.17 * (big / small) ** 3))
    world.add(Ball("object", (0.3, 0.0), radius=small, mass=0.17))
    after = simulate(world, "cue", Shot(2.0))
    hit = next(event for event in after.log if event.kind == "ball")
    place = [state.position[0] for state in hit.before]
    assert place[1] - place[0] == pytest.approx(2.0 * math.sqrt(big * small), abs=1e-15)
    assert big + small - (place[1] - place[0]) == pytest.approx(2.1e-5, abs=1e-6)
    # the point divides the line of centres as the radii do
    assert hit.point[0] - place[0] == pytest.approx(
        big / (big + small) * (place[1] - place[0]), abs=1e-15
    )
    light, heavy = 0.17, world.ball("cue").mass
    v, e = hit.before[0].velocity[0], world.ball_law.e
    assert hit.closing == v
    assert hit.after[0].velocity[0] == pytest.approx((heavy - e * light) / (heavy + light) * v)
    assert hit.after[1].velocity[0] == pytest.approx((1.0 + e) * heavy / (heavy + light) * v)
    assert hit.impulse == pytest.approx(heavy * light / (heavy + light) * (1.0 + e) * v)


def test_the_ledger_of_a_shot_among_unequal_balls_adds_up():
    world = heap()
    world.run()
    entries = list(ledger(world.log))
    masses = dict(zip(world.log.names, world.log.masses, strict=True))
    start = sum(world.log.legs(name)[0].energy(mass) for name, mass in masses.items())
    lost = math.fsum(entry.energy_lost + entry.cloth_lost for entry in entries)
    assert lost + entries[-1].energy == pytest.approx(start, rel=1e-13)
    assert all(entry.energy_lost > -1e-6 * start for entry in entries)


# -- several at once, other ways to compute it


def row(law, cluster_law=None):
    """Balls of three sizes and one mass in a touching row; the first comes at 1 m/s."""
    world = World(ICE, law, engine=EventDriven(vmin=1e-12))
    world.cluster_law = cluster_law
    x, last = 0.0, None
    for k, radius in enumerate((0.03, 0.02, 0.04, 0.02, 0.03)):
        ball = Ball(f"{k}", (0.0, 0.0), radius=radius, mass=0.2)
        x += ball.touching_distance(last) if last else 0.0
        ball.position = (x, 0.0)
        last = world.add(ball)
    world.ball("0").velocity = (1.0, 0.0)
    return world


def test_a_row_of_big_and_small_balls_of_one_mass_passes_a_blow_on():
    world = row(laws.SmoothBall(1.0))
    world.run(1e-3)
    assert [ball.velocity[0] for ball in world.balls] == pytest.approx([0, 0, 0, 0, 1], abs=1e-12)


def test_springs_between_big_and_small_balls_keep_momentum_and_energy():
    world = row(laws.SmoothBall(1.0), laws.HertzCluster())
    world.run(1e-3)
    v = np.array([ball.velocity[0] for ball in world.balls])
    assert v.sum() == pytest.approx(1.0, rel=1e-12)
    assert (v * v).sum() == pytest.approx(1.0, rel=1e-6)  # the error of their steps
    assert (np.diff(v) > -1e-9).all()


@pytest.mark.parametrize("cluster_law", [None, laws.HertzCluster()])
def test_a_lone_pair_in_a_cluster_parts_as_a_pair_does(cluster_law):
    """The third touches, and is square to the blow."""
    speeds = []
    for third in (False, True):
        world = World(ICE, laws.SmoothBall(0.9), engine=EventDriven(vmin=1e-12))
        world.cluster_law = cluster_law
        a = world.add(Ball("a", (0.0, 0.0), (1.0, 0.0), radius=BIG, mass=0.4))
        b = world.add(Ball("b", (APART, 0.0), radius=SMALL, mass=0.05))
        if third:
            world.add(Ball("c", (APART, 2 * SMALL), radius=SMALL, mass=0.05))
        world.run(1e-6)
        speeds.append((a.velocity[0], b.velocity[0]))
    assert speeds[0] == pytest.approx(speeds[1], abs=1e-6)


def heap():
    """Balls of many sizes on a table, some of which touch; the first is struck."""
    world = tables.medium_carom()
    world.add(Ball("cue", (-0.6, 0.0), radius=0.0325, mass=0.25))
    for k, radius in enumerate((0.02, 0.04, 0.025, 0.05)):
        before = world.balls[-1]
        ball = Ball(f"{k}", (0.0, 0.0), radius=radius, mass=1e3 * radius**2)
        x = 0.2 if k == 0 else before.position[0] + before.touching_distance(ball)
        ball.position = (x, 0.0)
        world.add(ball)
    world.add(Ball("far", (0.1, 0.3), radius=0.03, mass=0.2))
    world.strike("cue", Shot(4.0, 1.0, 1.0, 0.0, 0.7))
    return world


@pytest.mark.parametrize("law", [laws.RoughBall(), laws.RoughBall(0.95, 0.1), laws.SmoothBall(0.5)])
def test_compiled_and_interpreted_agree_in_every_bit(law):
    pytest.importorskip("numba")
    world = heap()
    world.ball_law = law
    world.stop()
    shots = [Shot(4.0, 15.0 * k, 0.5, 0.3, 0.5, climb=0.4 * (k % 3)) for k in range(24)]
    fast, slow = (simulate_many(world, "cue", shots, compiled=c) for c in (True, False))
    for one, other in zip(fast, slow, strict=True):
        assert np.array_equal(one, other)


def test_a_shot_among_unequal_balls_is_the_same_in_fifty_digits():
    world = heap()
    world.ball("1").position = (0.5, -0.2)  # no cluster: each hit costs a digit
    exact, events = fifty.rest(world)
    world.run()
    assert len(world.log) == events
    for ball, rest in zip(world.balls, exact, strict=True):
        assert float(abs(complex(*ball.position) - rest)) < 1e-9


def test_lengths_four_times_as_long_and_speeds_twice_as_fast_are_the_same_motion():
    ends = []
    for scale in (1.0, 4.0):
        world = World(Cloth(spin_decay=10.0 / scale), laws.RoughBall(0.95, 0.1))
        world.engine = EventDriven(vmin=1e-3 * scale**0.5)
        for k, radius in enumerate((0.03, 0.02, 0.04)):
            at = scale * 0.3 * k, scale * 0.01 * k
            world.add(Ball(f"{k}", at, radius=scale * radius, mass=(1 + k) * 0.1))
        world.strike("0", Shot(2.0 * scale**0.5, 1.0, 1.0 * scale**0.5, 0.0, scale**0.5))
        world.run()
        assert sum(event.kind == "ball" for event in world.log) >= 2
        ends.append(np.array([ball.position for ball in world.balls]) / scale)
    assert np.abs(ends[1] - ends[0]).max() < 1e-11


# -- laws of one's own, and files


def test_a_law_of_your_own_sees_a_tilted_pair_level_and_makes_no_energy_there(recwarn):
    seen = []

    def sticky(v, roll, side, mass):
        seen.append((v, roll, side, mass))
        return laws.RoughBall(1.0, 1e9)(v, roll, side, mass)

    ends = []
    for law in (sticky, laws.RoughBall(1.0, 1e9)):
        world = two(law, aside=0.02)
        world.ball("big").spin = (10.0, -20.0, 30.0)
        world.run(0.6)
        ends.append([(ball.velocity, ball.spin) for ball in world.balls])
    assert ends[0] == ends[1]
    assert not recwarn.list
    (_, roll, side, mass), rise = seen[0], (SMALL - BIG) / (SMALL + BIG)
    line = complex(math.sqrt(APART**2 - 0.02**2), 0.02) / APART
    turned = line.conjugate() * complex(-20.0, -10.0) * BIG
    level = APART / (SMALL + BIG)
    assert roll == pytest.approx(complex(turned.real, level * turned.imag - rise * 1.2), abs=1e-12)
    assert side == pytest.approx(level * 1.2 + rise * turned.imag, abs=1e-12)
    assert mass == pytest.approx(0.4 * 0.05 / 0.45, rel=1e-15)


def test_a_file_from_before_keeps_its_discs_and_its_digits():
    old = json.loads(OLD.read_text(encoding="utf-8"))
    world = store.restore(old["world"])
    assert world.discs
    world.run()
    assert {b.name: [x.hex() for x in b.position] for b in world.balls} == old["rest"]


@pytest.mark.parametrize("discs", [False, True])
def test_a_saved_world_keeps_what_its_balls_are(discs):
    world = two(discs=discs, cloth=Cloth())
    world.run(0.3)
    again = store.loads(store.dumps(world))
    assert again.discs is discs
    for each in (world, again):
        each.run()
    assert [b.position for b in again.balls] == [b.position for b in world.balls]
    assert world.copy().discs is discs


@pytest.mark.parametrize("value", [None, 1, "yes"])
def test_whether_balls_are_discs_is_true_or_false(value):
    with pytest.raises(ValueError, match="discs"):
        World(discs=value)
