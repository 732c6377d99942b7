"""Balls in the air: closed forms, whole scenes, and what a flight must never do."""

import json
import math
import random
from cmath import rect
from dataclasses import replace

import numpy as np
import pytest

from benchmarks import aloft
from physics import (
    Ball,
    Cloth,
    CueStroke,
    Shot,
    TimeStepping,
    Wall,
    World,
    laws,
    sensitivity,
    simulate,
    tables,
    trace,
)
from physics.batch.many import simulate_many
from physics.files.store import dumps, loads
from tests.support import fifty

RADIUS, MASS = 0.03075, 0.21


def table(**heights):
    """A match table with balls in a row, 0.4 m apart, named and lifted as given."""
    world = tables.match_carom()
    for k, (name, height) in enumerate(heights.items()):
        ball = world.add(Ball(name, (0.4 * k - 0.8, 0.0), radius=RADIUS, mass=MASS))
        ball.height = height
    return world


def kinds(world, *names):
    return [event.kind for event in world.log if set(names) & set(event.balls)]


def test_p1_a_ball_jumps_and_bounces():
    # validation/P1: 2 v / g, v² / 2g, and half of the time after a bounce with e = 1/2
    world = World(Cloth(gravity=9.81, bounce=0.5))
    ball = world.add(Ball("jumper", (0.0, 0.0), velocity=(1.0, 0.0), spin=(3.0, 20.0, 7.0)))
    ball.climb = 1.0
    world.run(0.1)
    assert ball.phase == "airborne"
    world.run(1.0 / 9.81)
    assert ball.height == pytest.approx(0.0509684, abs=1e-7)
    assert ball.spin == pytest.approx((3.0, 20.0, 7.0), abs=1e-12)
    world.run()
    first, second = [event for event in world.log if event.kind == "land"][:2]
    assert first.time == pytest.approx(0.2038736, abs=1e-7)
    assert second.time - first.time == pytest.approx(0.1019368, abs=1e-7)
    assert first.before[0].spin == pytest.approx((3.0, 20.0, 7.0), abs=1e-12)
    assert world.at_rest


@pytest.mark.parametrize("bounce", [0.0, 0.3, 0.9])
def test_a_falling_ball_comes_up_as_fast_as_the_cloth_says(bounce):
    world = World(Cloth(gravity=9.81, bounce=bounce))
    ball = world.add(Ball("stone", (0.0, 0.0)))
    ball.height = 0.2
    world.run()
    landing = world.log[0]
    assert landing.closing == pytest.approx(math.sqrt(2 * 9.81 * 0.2), rel=1e-14)
    assert landing.after[0].climb == pytest.approx(bounce * landing.closing, rel=1e-14)
    assert landing.impulse == pytest.approx(0.25 * (1 + bounce) * landing.closing, rel=1e-14)
    # every bounce takes its share until one is slower than what parts: ⌈log(1e-3 / v) / log e⌉
    some = bounce and math.log(1e-3 / landing.closing) / math.log(bounce)
    assert len(world.log) == max(1, math.ceil(some))


def test_a_landing_rubs_as_a_sliding_ball_does():
    # with enough friction the slip ends: v = (5 v₀ + 2 w₀) / 7; with less, μ (1 + e) v_z is all
    for slide, speed in ((0.9, (5 * 1.0 + 2 * -0.2) / 7), (0.1, 1.0 - 0.1 * 1.5 * 2.0)):
        world = World(Cloth(slide=slide, bounce=0.5))
        ball = world.add(Ball("b", (0.0, 0.0), velocity=(1.0, 0.0)))
        ball.spin = 0.0, -0.2 / 0.03275, 0.0
        ball.climb = -2.0
        world.run(0.0)
        landed = world.log[0].after[0]
        assert world.log[0].time == 0.0
        assert landed.velocity == pytest.approx((speed, 0.0), abs=1e-14)
        turned = -0.2 - 2.5 * (speed - 1.0)
        assert landed.spin[1] * 0.03275 == pytest.approx(turned, abs=1e-14)
        assert landed.climb == 1.0


def test_a_ball_that_jumps_high_enough_is_over_the_next():
    world = table(cue=0.0, block=0.0, target=0.0)
    low, high = (simulate(world, "cue", Shot(2.0, climb=climb)) for climb in (0.0, 1.9))
    for after, met in ((low, "block"), (high, "target")):
        first = next(event for event in after.log if event.kind == "ball")
        assert set(first.balls) == {"cue", met}


def test_a_ball_over_the_cushion_is_gone_and_can_be_put_back():
    world = table(cue=0.0, other=0.0)
    world.strike("cue", Shot(3.0, angle=90.0, climb=1.5))
    cue = world.ball("cue")
    world.run()
    assert kinds(world, "cue") == ["off"]
    assert world.log[0].energy_lost == pytest.approx(
        0.5 * MASS * (9.0 + 1.5**2), rel=1e-13
    )  # also what it had in height
    assert (cue.phase, cue.velocity, cue.height) == ("off", (0.0, 0.0), 0.0)
    assert world.at_rest
    assert [(c.kind, c.balls) for c in world.log.contacts()] == [("off", ("cue",))]
    for act in (lambda: world.strike("cue", Shot(1.0)), lambda: setattr(cue, "climb", 1.0)):
        with pytest.raises(ValueError, match=r"'cue'.*has left the table"):
            act()
    world.strike("other", Shot(3.0, angle=90.0))  # goes where the ball would have lain
    world.run()
    cue.position = (0.0, 0.0)
    world.strike("cue", Shot(1.0))
    world.run()
    assert cue.phase == "resting"


def test_the_nose_stops_a_ball_that_is_not_over_it():
    world = table(cue=0.0)
    for climb, kind in ((1.2, "cushion"), (1.5, "off")):
        first = simulate(world, "cue", Shot(3.0, angle=90.0, climb=climb)).log[0]
        assert first.kind == kind
    hit = simulate(world, "cue", Shot(3.0, angle=90.0, climb=1.2)).log[0]
    rule = world.scene.cushion_rule
    across = 0.71 - hit.before[0].position[1] - RADIUS + RADIUS * rule.level
    above = RADIUS * rule.height - hit.before[0].height
    assert math.hypot(across, above) == pytest.approx(RADIUS, abs=1e-14)
    assert hit.after[0].climb > hit.before[0].climb  # met above the nose, it is thrown up


def scene(seed, balls=8):
    dice = random.Random(seed)
    world = dice.choice([tables.medium_carom, tables.match_carom])()
    world.ball_law = dice.choice(["rough", "smooth", laws.RoughBall(0.9, 0.06)])
    spots = []
    while len(spots) < balls:
        spot = dice.uniform(-0.9, 0.9), dice.uniform(-0.5, 0.5)
        if all(math.dist(spot, other) > 2 * RADIUS + 1e-6 for other in spots):
            spots.append(spot)
    for k, spot in enumerate(spots):
        ball = world.add(Ball(str(k), spot, radius=RADIUS, mass=MASS))
        if dice.random() < 0.7:
            ball.velocity = dice.gauss(0, 1.5), dice.gauss(0, 1.5)
            ball.spin = dice.gauss(0, 40), dice.gauss(0, 40), dice.gauss(0, 40)
        if dice.random() < 0.6:
            ball.height, ball.climb = dice.choice([0.0, dice.uniform(0, 0.1)]), dice.gauss(0, 1.2)
    return world


@pytest.mark.parametrize("seed", range(25))
def test_nothing_in_the_air_overlaps_and_every_joule_is_in_the_ledger(seed):
    world = scene(seed)
    world.run()
    assert aloft.flew(world)
    assert aloft.faults(world) == []


@pytest.mark.parametrize("seed", range(4))
def test_steps_of_any_length_lead_to_the_same_rest(seed):
    ends = []
    for steps in (1, 7):
        world = scene(seed)
        while not world.at_rest:
            world.step(0.1 / steps)
        ends.append([ball.position for ball in world.balls])
    run = scene(seed)
    run.run()
    assert ends[0] == ends[1] == [ball.position for ball in run.balls]


@pytest.mark.parametrize("seed", range(4))
def test_a_jump_has_its_digits(seed):
    world = table(cue=0.0, red=0.0)
    shot = Shot(1.5, angle=seed - 1.5, climb=0.8, side=0.4, follow=-1.0)
    world.strike("cue", shot)
    spots, events = fifty.rest(world.copy())
    world.run()
    assert events == len(world.log) > 15
    ends = [complex(*ball.position) for ball in world.balls]
    assert max(abs(a - complex(b)) for a, b in zip(ends, spots, strict=True)) < 1e-12


def test_batches_of_jumps_are_the_same_shots_compiled_and_not():
    world = table(cue=0.0, red=0.04, blue=0.0)
    shots = [Shot(2.0, angle=0.5 * k, climb=0.3 * k - 1.0, side=0.5) for k in range(20)]
    plain = simulate_many(world, "cue", shots, compiled=False)
    one_by_one = [simulate(world, "cue", shot) for shot in shots]
    rests = [[(math.nan, math.nan) if b.gone else b.position for b in w.balls] for w in one_by_one]
    assert np.array_equal(plain.positions, rests, equal_nan=True)
    assert np.isnan(plain.positions).any()  # one of them leaves the table
    assert plain.events.tolist() == [len(w.log) for w in one_by_one]
    pytest.importorskip("numba")
    fast = simulate_many(world, "cue", shots, compiled=True)
    assert np.array_equal(fast.positions, plain.positions, equal_nan=True)
    assert (fast.times == plain.times).all()


def test_a_world_saved_in_mid_flight_goes_on_bit_for_bit():
    world = scene(5)
    world.run(0.15)
    assert "airborne" in [ball.phase for ball in world.balls]
    other = loads(dumps(world))
    assert [b.height for b in other.balls] == [b.height for b in world.balls]
    for each in (world, other):
        each.run()
    assert [b.position for b in other.balls] == [b.position for b in world.balls]
    assert [b.phase for b in other.balls] == [b.phase for b in world.balls]


def test_a_file_from_before_balls_flew_is_read():
    world = table(cue=0.0)
    world.strike("cue", Shot(1.0))
    data = json.loads(dumps(world))
    data["version"] = 1
    del data["cloth"]["bounce"]
    for ball in data["balls"]:
        for name in ("height", "climb", "fall"):
            del ball[name]
    other = loads(json.dumps(data))
    world.run()
    other.run()
    assert other.ball("cue").position == world.ball("cue").position
    assert loads('{"danggu": "shot", "version": 1, "speed": 2, "angle": 0, "follow": 0, "masse": 0,'
                 ' "side": 0}') == Shot(2.0)  # fmt: skip


def test_a_ball_dropped_into_a_nest_of_three_drives_them_apart():
    world = World(Cloth(), "smooth")
    for k in range(3):
        p = rect(2.0001 * RADIUS / math.sqrt(3), 2 * math.pi * k / 3)
        world.add(Ball(str(k), (p.real, p.imag), radius=RADIUS, mass=MASS))
    stone = world.add(Ball("stone", (0.0, 0.0), radius=RADIUS, mass=MASS))
    stone.height = 0.1
    world.run()
    assert stone.height == 0.0
    assert min(math.hypot(*ball.position) for ball in world.balls[:3]) > 3 * RADIUS


def test_custom_laws_are_asked_in_the_air_too():
    def swap(v, roll, side, mass):
        return 2.0 * mass * v.real, 0j

    ours, theirs = table(a=0.05, b=0.05), table(a=0.05, b=0.05)
    ours.ball_law, theirs.ball_law = laws.SmoothBall(1.0), swap
    theirs.cushion_law = lambda v, roll, side: (complex(-v.real, v.imag), roll, side)
    for world in (ours, theirs):
        world.ball("a").velocity = (8.0, 0.0)
        world.run(0.06)
    assert kinds(theirs, "a")[0] == "ball"
    for mine, other in zip(ours.balls, theirs.balls, strict=True):
        assert mine.velocity == pytest.approx(other.velocity, abs=1e-12)
    theirs.strike("b", Shot(6.0, angle=90.0, climb=0.2))
    theirs.run()
    assert "cushion" in kinds(theirs, "b")


@pytest.mark.parametrize("value", [math.nan, math.inf, "high", None])
def test_a_height_or_climb_that_is_none_is_refused_by_name(value):
    ball = table(cue=0.0).ball("cue")
    for name in ("height", "climb"):
        with pytest.raises(ValueError, match=f"'cue': {name}"):
            setattr(ball, name, value)
    with pytest.raises(ValueError, match=r"Shot\.climb"):
        Shot(1.0, climb=value)
    assert (ball.height, ball.climb, ball.phase) == (0.0, 0.0, "resting")


def test_what_knows_no_flight_says_so():
    world = table(cue=0.1)
    with pytest.raises(ValueError, match="height"):
        world.ball("cue").height = -0.1
    with pytest.raises(ValueError, match="bounce must be below 1"):
        Cloth(bounce=1.0)
    with pytest.raises(ValueError, match="in the air"):
        sensitivity(table(cue=0.0), "cue", Shot(1.0, climb=1.0))
    world.engine = TimeStepping(1 / 180)
    with pytest.raises(ValueError, match=r"'cue'.*only balls on the table"):
        world.run(1.0)


def test_balls_may_lie_above_each_other_but_not_in_each_other():
    world = table(low=0.0, high=0.0)
    low, high = world.balls
    high.position, high.height = low.position, 2 * RADIUS
    world.plan()
    high.height = 1.9 * RADIUS
    with pytest.raises(ValueError, match="overlap"):
        world.run()
    high.position, high.height = (0.0, 0.71 - 0.6 * RADIUS), 3 * RADIUS  # above the cushion
    world.plan()
    high.height = 0.5 * RADIUS
    with pytest.raises(ValueError, match=r"'high'.*outside the wall"):
        world.run()


def test_height_shows_in_states_and_legs_and_paths_stay_flat():
    world = table(cue=0.0)
    world.strike("cue", Shot(1.0, climb=0.5))
    world.run()
    leg = world.log.legs("cue")[0]
    state = world.log.at(0.02)["cue"]
    assert state.height == pytest.approx(0.5 * 0.02 - 0.5 * leg.fall * 0.02**2, rel=1e-14)
    assert state.climb == pytest.approx(0.5 - leg.fall * 0.02, rel=1e-14)
    times, paths = trace(world, 50.0)
    assert paths.shape == (len(times), 1, 2)
    assert paths[1, 0, 0] == pytest.approx(-0.8 + 0.02, abs=1e-14)


def test_without_gravity_nothing_comes_down():
    world = World(Cloth(gravity=0.0))
    ball = world.add(Ball("b", (0.0, 0.0)))
    ball.climb = 1.0
    world.run(10.0)
    assert ball.height == pytest.approx(10.0)
    assert not world.at_rest


@pytest.mark.parametrize("law", ["thesis", "capped", "mathavan", "rigid"])
def test_every_law_of_cushions_has_a_nose_for_balls_in_the_air(law):
    world = table(cue=0.02)
    world.cushion_law = law
    world.strike("cue", Shot(3.0, angle=90.0, climb=1.2))
    world.run()
    assert kinds(world, "cue")[0] == "cushion"
    assert world.at_rest


def test_an_elevated_cue_makes_the_ball_jump():
    world = table(cue=0.0)
    stroke = CueStroke(3.0, elevation=30.0)
    jump, shot = stroke.jump(world.ball("cue")), stroke.shot(world.ball("cue"))
    assert replace(jump, climb=0.0) == shot
    assert jump.climb == pytest.approx(-shot.speed * math.tan(math.radians(30.0)), rel=1e-14)
    landing = simulate(world, "cue", jump).log[0]
    assert (landing.kind, landing.time) == ("land", 0.0)
    assert landing.after[0].climb == pytest.approx(-0.5 * jump.climb, rel=1e-14)
    assert CueStroke(3.0).jump(world.ball("cue")) == CueStroke(3.0).shot(world.ball("cue"))


def test_the_check_of_worlds_with_flights_sees_a_ball_on_the_cloth_in_a_wall_that_ends():
    world = World(walls=[Wall.segment((-0.5, 0.0), (0.5, 0.0)), Wall.arc((0, 0), 0.5, 0.0, 180.0)])
    ball = world.add(Ball("a", (0.0, 0.2)))
    world.run()
    state = world.log.at(0.0)["a"]
    inside = [state._replace(position=at) for at in ((0.0, 0.02), (0.0, 0.49))]
    for n in range(2):
        assert aloft.clear(world, n, state, ball.radius) > 0.0
        assert aloft.clear(world, n, inside[n], ball.radius) < -0.01
