"""Balls in the air at the edges: saved anywhere, laws changed there, off the table, out of time."""

import math
from importlib.util import find_spec

import pytest

from physics import Ball, Cloth, EventDriven, Shot, World, laws, simulate, tables
from physics.batch.many import simulate_many
from physics.files.store import dumps, loads

RADIUS, MASS = 0.03075, 0.21


def table(**spots):
    """A match table with balls at (x, y, height)."""
    world = tables.match_carom()
    for name, (x, y, height) in spots.items():
        world.add(Ball(name, (x, y), radius=RADIUS, mass=MASS)).height = height
    return world


def nearest(world, name):
    """How near the ball has come to a nose in the air, less its radius, m."""
    rule, found = world.scene.cushion_rule, math.inf
    for k in range(400):
        state = world.log.at(k * 0.002)[name]
        for wall in world.walls if state.height > 0.0 else ():
            across = wall.distance(state.position) - RADIUS + RADIUS * rule.level
            found = min(found, math.hypot(across, RADIUS * rule.height - state.height) - RADIUS)
    return found


def above_another():
    world = table(a=(-0.3, 0.0, 0.0), b=(0.0, 0.0, 0.0))
    world.strike("a", Shot(2.0, climb=1.5))
    world.run(0.15)
    return world


def above_the_nose():
    world = table(a=(1.0, 0.2, 0.0))
    world.strike("a", Shot(3.0, climb=1.5))
    world.run(0.136)
    return world


def off_the_table():
    world = table(a=(-0.3, 0.2, 0.0), b=(0.0, 0.0, 0.0))
    world.strike("a", Shot(4.0, angle=90.0, climb=2.0))
    world.run()
    world.strike("b", Shot(1.0))
    return world


def put_above_another():
    return table(a=(0.0, 0.0, 2.5 * RADIUS), b=(0.0, 0.0, 0.0))


PLACES = [above_another, above_the_nose, off_the_table, put_above_another]


@pytest.mark.parametrize("make", PLACES, ids=lambda make: make.__name__)
def test_wherever_a_ball_is_its_world_is_saved_and_goes_on(make):
    world = make()
    other = loads(dumps(world))
    assert dumps(other) == dumps(world)
    until = world.time + 0.5
    for each in (world, other):
        each.run(until)
    for mine, theirs in zip(world.balls, other.balls, strict=True):
        assert (mine.position, mine.height, mine.phase) == (
            theirs.position, theirs.height, theirs.phase
        )  # fmt: skip


@pytest.mark.parametrize("climb", [0.9, 1.2, 1.5])
def test_another_cushion_in_mid_flight_is_met_where_it_is(climb):
    world = table(a=(1.0, 0.0, 0.0))
    world.strike("a", Shot(3.0, climb=climb))
    world.run(0.05)
    world.cushion_law = laws.RigidCushion(nose=1.9)
    world.run()
    assert nearest(world, "a") > -1e-14


def test_a_hop_too_short_for_the_clock_ends_on_the_cloth():
    rests = []
    for vmin in (0.0, 1e-12):
        world = World(engine=EventDriven(vmin=vmin))
        world.add(Ball("a", (0.0, 0.0)))
        shots = [Shot(1.0, climb=1.0)]
        plain = simulate_many(world, "a", shots, compiled=False)
        if find_spec("numba"):
            fast = simulate_many(world, "a", shots, compiled=True)
            assert (fast.positions == plain.positions).all()
        rests.append(plain.positions[0, 0, 0])
    assert rests[0] == pytest.approx(rests[1], abs=1e-9)


@pytest.mark.parametrize(("name", "value"), [("height", 1e50), ("climb", 1e50)])
def test_a_ball_from_beyond_the_sky_comes_down(name, value):
    world = World()
    setattr(world.add(Ball("a", (0.0, 0.0))), name, value)
    world.run()
    assert world.at_rest
    assert world.ball("a").phase == "resting"


def test_a_ball_off_the_table_can_only_be_given_a_position():
    world = off_the_table()
    ball = world.ball("a")
    left = ball.position
    for act in (
        lambda: setattr(ball, "velocity", (1.0, 1.0)),
        lambda: setattr(ball, "spin", (1.0, 1.0, 1.0)),
        lambda: setattr(ball, "height", 0.1),
        lambda: simulate_many(world, "a", [Shot(1.0)]),
        lambda: simulate(world, "a", Shot(1.0)),
    ):
        with pytest.raises(ValueError, match=r"'a'.*has left the table"):
            act()
    with pytest.raises(ValueError, match=r"'a'.*it is off"):
        ball.phase = "resting"
    world.run()
    assert (ball.phase, ball.position, ball.velocity) == ("off", left, (0.0, 0.0))


def test_a_phase_of_the_cloth_is_refused_in_the_air():
    ball = table(a=(0.0, 0.0, 0.1)).ball("a")
    ball.spin = (1.0, 2.0, 3.0)
    for phase in ("resting", "rolling", "sliding"):
        with pytest.raises(ValueError, match="it is airborne"):
            ball.phase = phase
    assert ball.spin == pytest.approx((1.0, 2.0, 3.0), abs=1e-15)


def test_the_log_names_the_wall_that_a_ball_has_jumped():
    world = off_the_table()
    event = next(e for e in world.log if e.kind == "off")
    contact = next(c for c in world.log.contacts() if c.kind == "off")
    assert event.wall == contact.wall == "north"


def test_a_custom_law_keeps_the_nose_that_was_there():
    world = tables.medium_carom()
    height = world.scene.cushion_rule.height
    world.cushion_law = lambda v, roll, side: (complex(-v.real, v.imag), roll, side)
    assert world.scene.cushion_rule.height == pytest.approx(height, abs=1e-16)
    assert world.copy().scene.cushion_rule.height == world.scene.cushion_rule.height


def test_without_friction_and_gravity_a_flight_still_meets_what_is_in_its_way():
    world = World(Cloth(0.0, 0.0, 0.0, gravity=0.0), laws.SmoothBall(1.0))
    for k, name in enumerate("ab"):
        world.add(Ball(name, (k * 1.0, 0.0))).height = 0.5
    world.ball("a").velocity = (1.0, 0.0)
    world.run(2.0)
    assert world.ball("b").velocity == pytest.approx((1.0, 0.0), abs=1e-15)
    assert world.ball("b").height == 0.5
