"""What `impulse` and `push` of an event are, checked against the laws that gave them."""

from math import hypot, sqrt

import pytest

from physics import Ball, Cloth, Shot, World, laws, scenes, simulate, tables

R, MASS = 0.03075, 0.21
SHOT = Shot(3.0, 40.0, follow=1.0, masse=0.5, side=1.5)


def first(kind, law=None, shot=SHOT, ball_law="rough", **balls):
    """The first event of that kind when the white is struck."""
    world = tables.match_carom()
    world.ball_law = ball_law
    if law is not None:
        world.cushion_law = law
    for name, at in {"white": (0.0, 0.0), **balls}.items():
        world.add(Ball(name, at=at, radius=R, mass=MASS))
    return next(event for event in simulate(world, "white", shot).log if event.kind == kind)


def change(event, ball=0):
    """By how much a ball's velocity and roll have changed, as complex numbers, m/s."""
    before, after = event.before[ball], event.after[ball]
    v = complex(*after.velocity) - complex(*before.velocity)
    wx, wy = (b - a for a, b in zip(before.spin[:2], after.spin[:2], strict=True))
    return v, R * complex(wy, -wx)


@pytest.mark.parametrize(
    "law",
    [None, laws.MathavanCushion(), laws.ThesisCushion(), laws.CappedCushion(),
     lambda v, roll, side: (complex(-v.real, 0.5 * v.imag), roll, side)],
    ids=["rigid", "mathavan", "thesis", "capped", "custom"],
)  # fmt: skip
def test_at_a_cushion_the_impulse_is_the_change_in_the_plane_and_the_push_its_normal_part(law):
    hit = first("cushion", law)
    assert hit.wall == "north"
    v, _ = change(hit)
    assert hit.impulse == pytest.approx(MASS * abs(v), rel=1e-14)
    assert hit.push == pytest.approx(-MASS * v.imag, rel=1e-14)
    assert hit.push == pytest.approx(MASS * (hit.closing - hit.after[0].velocity[1]), rel=1e-14)
    assert hit.push < hit.impulse


def test_from_the_push_follows_the_force_of_a_rigid_nose_which_lies_above_the_centre():
    """P = (1 + e) m c |v_n| along the line to the centre; the push has friction's part as well."""
    law = tables.MATCH_CAROM.cushion_law
    s = law.nose - 1.0
    c = sqrt(1.0 - s * s)
    hit = first("cushion", law)
    _, roll = change(hit)
    inward = -roll.imag  # north: into the table is -y
    force = (hit.push - 0.4 * s * MASS * inward) / c
    assert force == pytest.approx((1.0 + law.e) * MASS * c * hit.closing, rel=1e-13)
    assert abs(hit.push - force) > 0.01 * force


@pytest.mark.parametrize("law", [laws.ThesisCushion(), laws.CappedCushion()])
def test_where_the_push_of_a_cushion_is_level_it_is_all_of_the_normal_impulse(law):
    hit = first("cushion", law)
    assert hit.push == pytest.approx((1.0 + law.e) * MASS * hit.closing, rel=1e-14)


def test_between_balls_the_push_is_the_law_s_and_the_impulse_has_the_level_rub_but_no_other():
    hit = first("ball", red=(0.4, 0.36))
    v, roll = change(hit)
    line = complex(*hit.before[1].position) - complex(*hit.before[0].position)
    line /= abs(line)
    push, rub = laws.RoughBall()(*_relative(hit, line), 0.5 * MASS)
    assert hit.push == pytest.approx(push, rel=1e-13)
    assert hit.impulse == pytest.approx(hypot(push, rub.real), rel=1e-13)
    assert hit.impulse == pytest.approx(MASS * abs(v), rel=1e-14)
    upward = -0.4 * MASS * (line.conjugate() * roll).real
    assert upward == pytest.approx(rub.imag, rel=1e-11)
    assert abs(upward) > 1e-3 * push


def _relative(hit, line):
    """What a ball law is given for a hit."""
    turn = line.conjugate()
    a, b = hit.before
    roll = sum(R * complex(state.spin[1], -state.spin[0]) for state in hit.before)
    side = sum(R * state.spin[2] for state in hit.before)
    return turn * (complex(*a.velocity) - complex(*b.velocity)), turn * roll, side


def test_without_friction_the_push_is_all_there_is():
    hit = first("ball", ball_law=laws.SmoothBall(0.9), red=(0.4, 0.36))
    assert hit.push == pytest.approx(hit.impulse, rel=1e-14)
    assert hit.push == pytest.approx(0.5 * MASS * 1.9 * hit.closing, rel=1e-13)


def test_on_landing_the_push_is_upward_and_the_impulse_has_the_rub_of_the_cloth():
    hit = first("land", shot=Shot(1.0, climb=1.0))
    bounce = Cloth().bounce
    assert hit.push == pytest.approx(MASS * (1.0 + bounce) * hit.closing, rel=1e-13)
    rub = abs(change(hit)[0])
    assert hit.impulse == pytest.approx(hypot(hit.push, MASS * rub), rel=1e-14)
    assert rub > 0.0


def test_in_the_air_the_impulse_is_the_whole_one():
    world = World()
    world.add(Ball("a", at=(0.0, 0.0), velocity=(2.0, 0.0)))
    world.add(Ball("b", at=(0.2, 0.0)))
    world.ball("a").climb = 0.4
    hit = next(event for event in simulate(world, "a", Shot(2.0, climb=0.4, follow=-3.0)).log
               if event.kind == "ball")  # fmt: skip
    a, b = hit.before
    rise = b.height - a.height
    line = complex(*b.position) - complex(*a.position)
    v, climb = complex(*hit.after[0].velocity) - complex(*a.velocity), hit.after[0].climb - a.climb
    along = (line.conjugate() * v).real + rise * climb
    assert rise < 0.0
    assert hit.push == pytest.approx(-0.25 * along / hypot(abs(line), rise), rel=1e-13)
    assert hit.impulse == pytest.approx(0.25 * hypot(abs(v), climb), rel=1e-14)
    assert hit.push < hit.impulse


def test_in_a_cluster_the_impulse_is_the_push():
    world = World(ball_law="rough")
    for name, x in (("white", 0.0), ("red", 0.4), ("yellow", 0.4 + 2.0 * 0.03275)):
        world.add(Ball(name, at=(x, 0.0)))
    shot = Shot(3.0, 0.5, side=1.5)
    blows = [event for event in simulate(world, "white", shot).log if event.kind == "ball"][:2]
    assert len({event.time for event in blows}) == 1
    assert all(event.impulse == event.push > 0.0 for event in blows)


def test_what_is_no_contact_has_neither():
    log = simulate(scenes.carom(), "white", SHOT).log
    assert {(event.impulse, event.push) for event in log if event.kind in ("roll", "rest")} == {
        (0.0, 0.0)
    }
