"""Derivatives by the numbers of a shot: against central differences in 50 digits."""

import math
from dataclasses import astuple

import mpmath
import numpy as np
import pytest

from physics import (
    Ball,
    Shot,
    TimeStepping,
    Wall,
    World,
    laws,
    scenes,
    sensitivity,
    simulate,
    tables,
)
from physics.studies.dual import value
from physics.studies.sensitivity import NUMBERS, Replay
from tests.support import fifty

STEP = "1e-16"  # in 50 digits: truncation and rounding both stay below 1e-20 of the result
SPEED, ANGLE = map(NUMBERS.index, ("speed", "angle"))


def state(ball):
    p, v, w, r = ball.position, ball.velocity, ball.roll / ball.radius, ball.radius
    return [p.real, p.imag, v.real, v.imag, -w.imag, w.real, ball.side / r]


def outcome(world, struck, numbers):
    """In 50 digits: the balls of each event, all times, states after the events, rest positions."""
    kernel = fifty.kernel()
    scene = world.scene._replace(
        balls=[fifty.record(ball.body) for ball in world.balls],
        meetings=[mpmath.inf] * len(world.balls) ** 2,
        walls=[fifty.record(wall) for wall in world.scene.walls],
        cloth=fifty.record(world.scene.cloth),
        ball_rule=fifty.record(world.scene.ball_rule),
        cushion_rule=fifty.record(world.scene.cushion_rule),
        ties=kernel.body.ties(len(world.balls)),
        celled=False,
        grid=kernel.body.no_grid(len(world.balls)),
    )
    speed, angle, follow, masse, side = numbers
    along = mpmath.expj(angle * mpmath.pi / 180)
    ball = scene.balls[[ball.name for ball in world.balls].index(struck)]
    ball.velocity, ball.roll, ball.side = speed * along, mpmath.mpc(follow, -masse) * along, side
    kernel.calendar.plan(scene)
    found: dict = {}
    while True:
        i = kernel.calendar.soonest(scene)
        time = scene.balls[i].next
        if time == mpmath.inf:
            return found | {("rest", i): state(b)[:2] for i, b in enumerate(scene.balls)}
        kind, other = kernel.calendar.happen(i, scene)
        pair = [i, other] if kind == kernel.calendar.PAIR else [i]
        for m in pair:
            found[label(found, m)] = [time, *state(scene.balls[m])]


def label(found, ball):
    """Its number among the events of that ball: events of one instant have no order."""
    return ball, sum(key[0] == ball for key in found)


def central_differences(world, struck, shot):
    """{(ball, its event): (8, 5)} and {("rest", ball): (2, 5)}, by the five numbers of the shot."""
    fifty.kernel()  # sets the digits
    at, step = [mpmath.mpf(x) for x in astuple(shot)[:5]], mpmath.mpf(STEP)
    columns = []
    for k in range(5):
        low, high = (
            outcome(world, struck, [x + sign * step if m == k else x for m, x in enumerate(at)])
            for sign in (-1, 1)
        )
        assert list(low) == list(high)
        columns.append(
            {
                key: [float((b - a) / (2 * step)) for a, b in zip(low[key], high[key], strict=True)]
                for key in low
            }
        )
    return {key: np.array([column[key] for column in columns]).T for key in columns[0]}


def slopes(seen):
    """The same, from `sensitivity`."""
    names = [ball.name for ball in seen.world.balls]
    found: dict = {}
    for event in seen.events:
        for name, after in zip(event.event.balls, event.after, strict=True):
            found[label(found, names.index(name))] = np.vstack((event.time, after))
    return found | {("rest", i): rest for i, rest in enumerate(seen.rest)}


def disagreement(world, struck, shot):
    """The worst relative error of any event's or rest position's derivatives; and the hits."""
    seen = sensitivity(world, struck, shot)
    found, wanted = slopes(seen), central_differences(world, struck, shot)
    assert found.keys() == wanted.keys()
    worst = max(
        np.abs(found[key] - exact).max() / max(np.abs(exact).max(), 1e-3)
        for key, exact in wanted.items()
    )
    return worst, sum(event.event.kind == "ball" for event in seen.events)


def lone(cushion_law):
    world = tables.medium_carom()
    world.cushion_law = cushion_law
    world.add(Ball("white", (-0.6, 0.0)))
    return world


def carom(ball_law="rough", cushion_law=None):
    world = scenes.carom()
    world.ball_law = ball_law
    if cushion_law:
        world.cushion_law = cushion_law
    return world


@pytest.mark.parametrize(
    ("world", "shot"),
    [
        (scenes.single(), Shot(3.0, 25.0, 0.5, 0.1, 1.5)),
        (lone("rigid"), Shot(5.0, 26.5, -1.0, 0.0, 2.0)),
        (lone("thesis"), Shot(3.0, 77.0, 1.0, -0.4, -2.0)),
        (lone("capped"), Shot(3.0, 250.0, 1.0, 0.7, 2.0)),
        (lone("rigid"), Shot(2.0, 90.0, -8.0, 4.0, 0.0)),  # massé
    ],
)
def test_a_ball_among_cushions_has_thirteen_digits_of_every_derivative(world, shot):
    worst, _ = disagreement(world, "white", shot)
    assert worst < 1e-13  # measured 3e-16 to 4e-14 on 31 such shots


@pytest.mark.parametrize("ball_law", ["rough", laws.RoughBall(0.95, 0.05), "smooth", "thesis"])
@pytest.mark.parametrize(
    "shot",
    [
        Shot(3.0, 1.0, 1.0, 0.0, 0.5),
        Shot(5.0, 33.0, 0.5, 1.0, 1.5),
        Shot(4.0, 40.0),  # stun
    ],
)
def test_a_carom_shot_has_ten_digits_of_every_derivative(ball_law, shot):
    worst, hits = disagreement(carom(ball_law), "white", shot)
    assert 1 <= hits <= 4
    assert worst < 1e-10  # each hit costs the digit or two that it magnifies rounding by


def test_a_shot_among_balls_of_three_sizes_has_ten_digits_of_every_derivative():
    world = tables.medium_carom()
    world.ball_law = laws.RoughBall(0.95, 0.1)
    for name, at, radius in (
        ("white", (-0.6, 0.0), 0.04), ("small", (0.0, 0.01), 0.02), ("middle", (0.4, 0.1), 0.03)
    ):  # fmt: skip
        world.add(Ball(name, at, radius=radius, mass=3e3 * radius**3))
    worst, hits = disagreement(world, "white", Shot(4.0, 0.9, 1.0, 0.3, 1.5))
    assert hits >= 2
    assert worst < 1e-10


def test_the_shot_is_gone_through_again_bit_for_bit():
    after = simulate(carom(), "white", Shot(5.0, 33.0, 0.5, 1.0, 1.5))
    again = Replay(after, "white", Shot(5.0, 33.0, 0.5, 1.0, 1.5))
    assert len(list(again.events())) == len(after.log) > 20
    for ball, twin in zip(after.balls, again.balls, strict=True):
        assert value(twin.position) == complex(*ball.position)


def straight_in():
    world = World(ball_law=laws.SmoothBall(1.0))
    world.add(Ball("cue", (0.0, 0.0), radius=0.03075))
    world.add(Ball("object", (1.0, 0.0), radius=0.03075))
    return world


def test_n2_a_straight_hit_at_a_metre_turns_an_error_of_aim_by_one_minus_d_over_2r():
    seen = sensitivity(straight_in(), "cue", Shot(2.0, follow=2.0))
    hit = next(slopes for slopes in seen.events if slopes.event.kind == "ball")
    assert hit.event.balls == ("cue", "object")
    wanted = 1.0 - 1.0 / (2 * 0.03075)  # -15.26016
    assert math.degrees(hit.headings()[1, ANGLE]) == pytest.approx(wanted, rel=1e-14)
    assert seen.amplification() == pytest.approx([-wanted], rel=1e-14)


def test_factors_of_one_ball_after_the_other_multiply_up_to_the_error_of_the_last():
    world = straight_in()
    world.add(Ball("far", (2.0, 0.02), radius=0.03075))
    seen = sensitivity(world, "cue", Shot(3.0, follow=3.0))
    hits = [slopes for slopes in seen.events if slopes.event.kind == "ball"]
    assert [hit.event.balls for hit in hits[:2]] == [("cue", "object"), ("object", "far")]
    last = math.degrees(abs(hits[1].headings()[:, ANGLE]).max())
    assert math.prod(seen.amplification()[:2]) == pytest.approx(last, rel=1e-12)
    assert last > 100.0


def test_the_scatter_at_rest_is_that_of_shots_that_miss_by_a_little():
    world, shot, errors = carom(), Shot(2.0, 1.0, 2.0, 0.0, 0.3), (1e-6, 3e-6, 2e-6, 1e-6, 3e-6)
    seen = sensitivity(world, "white", shot)
    wanted = np.zeros((4, 2, 2))
    for k, error in enumerate(errors):
        ends = []
        for sign in (-1, 1):
            numbers = list(astuple(shot)[:5])
            numbers[k] += sign * error
            after = simulate(world, "white", Shot(*numbers))
            ends.append(np.array([ball.position for ball in after.balls]))
        moved = (ends[1] - ends[0]) / 2
        wanted += moved[:, :, None] * moved[:, None, :]
    covariance = seen.covariance(errors)
    assert covariance == pytest.approx(wanted, rel=1e-4, abs=1e-5 * wanted.max())
    assert (np.linalg.eigvalsh(covariance) > -1e-20).all()


def test_a_custom_law_is_probed_to_ten_digits():
    cushion, ball = laws.RigidCushion(0.891, 0.242), laws.RoughBall()
    shot = Shot(3.0, 1.0, 1.0, 0.0, 0.5)
    own = sensitivity(carom(ball, cushion), "white", shot)
    custom = sensitivity(
        carom(lambda *contact: ball(*contact), lambda *hit: cushion(*hit)), "white", shot
    )
    assert custom.rest == pytest.approx(own.rest, rel=1e-9, abs=1e-9)
    assert (custom.rest != own.rest).any()


def test_a_ball_that_rolls_already_depends_on_the_shot_only_once_it_is_hit():
    world = straight_in()
    world.ball("object").velocity, world.ball("object").spin = (0.5, 0.0), (0.0, 0.5 / 0.03075, 0.0)
    world.run(0.1)
    seen = sensitivity(world, "cue", Shot(3.0, 0.5, 1.0))
    hit = next(slopes for slopes in seen.events if "object" in slopes.event.balls)
    assert hit.event.balls == ("cue", "object")
    moved = np.outer(hit.event.before[1].velocity, hit.time)  # it comes as ever, if later
    assert hit.before[1, :2] == pytest.approx(moved, abs=1e-15)
    ends = [
        simulate(world, "cue", Shot(3.0 + error, 0.5, 1.0)).ball("object").position
        for error in (-1e-6, 1e-6)
    ]
    moved = (np.array(ends[1]) - ends[0]) / 2e-6
    assert seen.rest[1, :, SPEED] == pytest.approx(moved, rel=1e-7)


def test_a_cradle_hands_the_speed_on_undiminished():
    seen = sensitivity(scenes.cradle(5), "0", Shot(1.0, follow=1.0))
    last = seen.events[-1]
    assert last.event.balls == ("3", "4")
    assert last.after[1, 2, SPEED] == pytest.approx(1.0, abs=1e-14)
    assert last.time[SPEED] == pytest.approx(-0.1, abs=1e-14)  # 0.1 m at 1 m/s
    assert np.isnan(seen.rest[4]).all()  # no cloth slows it: it never rests


def test_a_contact_that_begins_without_speed_has_no_derivative():
    world = World()
    world.add(Wall.through((0.0, 0.0), (1.0, 0.0)))
    world.add(Ball("white", (0.0, 0.03275)))
    seen = sensitivity(world, "white", Shot(1.0, masse=1.0))
    assert seen.events[0].event.closing == 0.0
    assert np.isnan(seen.events[0].time).all()


def test_only_the_exact_engine_has_derivatives():
    world = carom()
    world.engine = TimeStepping(1 / 180)
    with pytest.raises(ValueError, match="needs the engine EventDriven"):
        sensitivity(world, "white", Shot(1.0))


def test_a_ball_of_another_world_is_refused():
    with pytest.raises(ValueError, match="no ball 'blue'"):
        sensitivity(tables.thesis(), "blue", Shot(1.0))


@pytest.mark.parametrize("errors", [(1.0, 1.0), (0.0, -1.0, 0.0, 0.0, 0.0)])
def test_errors_that_cannot_be_are_refused(errors):
    seen = sensitivity(straight_in(), "cue", Shot(2.0))
    with pytest.raises(ValueError, match="errors must"):
        seen.covariance(errors)


def test_springs_between_touching_balls_are_refused():
    world = scenes.cradle(3)
    world.cluster_law = laws.HertzCluster()
    with pytest.raises(ValueError, match="no derivatives of HertzCluster"):
        sensitivity(world, "0", Shot(1.0, follow=1.0))
