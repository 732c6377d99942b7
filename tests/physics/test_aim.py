"""Aims, checked by playing them: left is left, a mirror a mirror, and the engine finds the rest."""

import pytest

from physics import Ball, Shot, World, aim, laws, simulate, tables
from physics.shot import direction, heading

R = 0.03


def mirror(v, roll, side):
    """A cushion that is a mirror, on a table without friction."""
    return complex(-v.real, v.imag), complex(-roll.real, roll.imag), -side


def ice(*balls):
    """Nothing rubs and nothing is lost: what geometry says is what happens."""
    world = tables.match_carom()
    world.cloth = type(world.cloth)(0.0, 0.0, 0.0)
    world.ball_law, world.cushion_law = laws.SmoothBall(1.0), mirror
    for name, at in balls:
        world.add(Ball(name, at=at, radius=R))
    return world


PAIR = ("white", (-0.5, -0.2)), ("red", (0.3, 0.1))


def played(world, shot, ball="white", until=5.0):
    after = world.copy()
    after.strike(ball, shot)
    after.run(until)
    return after


def turned(a, b):
    return abs(heading(direction(a) * direction(b).conjugate()))


@pytest.mark.parametrize("cut", [0.0, 10.0, 30.0, -30.0, 60.0, -85.0])
def test_a_ball_is_cut_by_that_angle_to_the_left_of_the_player(cut):
    found = aim.at(ice(*PAIR), "white", "red", cut=cut)
    hit = played(ice(*PAIR), found.shot(2.0)).log.first("ball")
    assert turned(hit.after["red"].heading, found.angle + cut) < 1e-9
    assert turned(hit.after["red"].heading, found.line) < 1e-9
    assert hit.after["white"].position == pytest.approx(found.ghost, abs=1e-12)
    # from behind the cue, left is where i times the course points
    left = (complex(*hit.after["red"].velocity) * direction(found.angle).conjugate()).imag
    assert (left > 0.0) == (cut > 0.0)


def test_a_half_ball_is_four_eighths_and_a_full_one_eight():
    world = ice(*PAIR)
    assert aim.at(world, "white", "red", cut=30.0).eighths == pytest.approx(4.0)
    assert aim.at(world, "white", "red").eighths == 8.0
    for eighths in (8.0, 6.0, 4.0, 1.0, -4.0):
        found = aim.at(world, "white", "red", eighths=eighths)
        assert found.eighths == pytest.approx(abs(eighths))
        assert found.cut * eighths >= 0.0
        # so much of the width of the red is covered, seen along the course
        course = direction(found.angle).conjugate()
        off = ((complex(0.3, 0.1) - complex(*found.ghost)) * course).imag
        assert abs(off) == pytest.approx(2.0 * R * (1.0 - abs(eighths) / 8.0))


def test_balls_of_two_sizes_are_cut_where_they_touch():
    world = World(type(tables.MEASURED)(0.0, 0.0, 0.0), laws.SmoothBall(1.0))
    world.add(Ball("small", (0.0, 0.0), radius=0.02))
    world.add(Ball("big", (0.4, 0.1), radius=0.05))
    found = aim.at(world, "small", "big", cut=40.0)
    hit = played(world, found.shot(1.0), "small").log.first("ball")
    assert turned(hit.after["big"].heading, found.angle + 40.0) < 1e-9


def test_a_ball_is_sent_to_a_place_and_into_a_pocket():
    world = tables.pool_9ft()
    for name, at in (("white", (-0.5, -0.2)), ("1", (0.5, 0.1))):
        world.add(Ball(name, at=at))
    found = aim.to(world, "white", "1", "north-east pocket")
    assert found.cut == pytest.approx(found.line - found.angle)
    assert found.line == pytest.approx(heading(complex(*found.place) - (0.5 + 0.1j)))
    for shot in (Shot(2.0), Shot(1.5, follow=1.5, side=0.5), Shot(3.0, follow=-3.0, side=-1.0)):
        after = simulate(world, "white", found.refined(world, shot))
        assert after.log.first("pocket", "1").wall == "north-east pocket"


@pytest.mark.parametrize("walls", [["north"], ["south"], ["north", "east"], ["north", "south"]])
@pytest.mark.parametrize("cut", [0.0, 20.0, -40.0])
def test_a_kick_by_mirrors_meets_the_ball_with_that_cut(walls, cut):
    balls = ("white", (-0.5, -0.2)), ("red", (0.3, 0.1))
    found = aim.kick(ice(*balls), "white", "red", *walls, cut=cut)
    after = played(ice(*balls), found.shot(2.0))
    met = [e for e in after.log if e.kind == "cushion" and e.time < after.log.first("ball").time]
    assert [e.wall for e in met] == walls
    assert [e.after[0].position for e in met] == [pytest.approx(s, abs=1e-9) for s in found.spots]
    hit = after.log.first("ball")
    assert hit.before["white"].position == pytest.approx(found.ghost, abs=1e-9)
    assert turned(hit.after["red"].heading, hit.before["white"].heading + cut) < 1e-7
    assert turned(hit.after["red"].heading, found.line) < 1e-7


@pytest.mark.parametrize("rails", [["north"], ["east"], ["north", "east"]])
def test_a_bank_by_mirrors_comes_over_its_place(rails):
    place = (0.2, -0.4)
    found = aim.bank(ice(*PAIR), "white", "red", place, *rails)
    after = played(ice(*PAIR), found.shot(2.0), until=20.0)
    begun = after.log.all("cushion", "red")[len(rails) - 1].time
    times = [begun + 0.001 * k for k in range(9000)]
    ways = after.log.at(times)["red"].position - place
    assert min((ways**2).sum(axis=1)) < 1e-6
    assert [event.wall for event in after.log.all("cushion", "red")][: len(rails)] == rails


SPUN = [Shot(2.5, follow=2.5), Shot(4.0, follow=-2.0, side=1.0), Shot(3.0, side=-1.5)]


@pytest.mark.parametrize("shot", SPUN, ids=str)
def test_refined_has_throw_and_cushions_in_it(shot):
    world = tables.match_carom()
    for name, at in PAIR:
        world.add(Ball(name, at=at))
    cut = aim.at(world, "white", "red", cut=35.0)
    good = cut.refined(world, shot)
    assert (good.speed, good.follow, good.side) == (shot.speed, shot.follow, shot.side)
    leaves = simulate(world, "white", good).log.first("ball").after["red"].heading
    assert turned(leaves, cut.line) < 1e-6
    assert 0.01 < turned(good.angle, cut.angle) < 5.0
    kick = aim.kick(world, "white", "red", "north")
    hit = simulate(world, "white", kick.refined(world, shot)).log
    assert turned(hit.first("ball").after["red"].heading, kick.line) < 1e-6
    assert hit.first("cushion", "white").wall == "north"


def test_a_bank_is_refined_until_it_comes_over_its_place():
    world = tables.match_carom()
    for name, at in PAIR:
        world.add(Ball(name, at=at))
    bank = aim.bank(world, "white", "red", (0.9, -0.2), "north")
    after = simulate(world, "white", bank.refined(world, Shot(3.0, follow=1.0)))
    begun = after.log.first("cushion", "red").time
    times = [begun + 0.0002 * k for k in range(15000)]
    ways = after.log.at(times)["red"].position - (0.9, -0.2)
    assert min((ways**2).sum(axis=1)) < 1e-7


@pytest.mark.parametrize(
    ("ask", "words"),
    [(lambda w: aim.at(w, "white", "blue"), "no ball 'blue'"),
     (lambda w: aim.at(w, "white", "red", cut=90.0), "cut must be between"),
     (lambda w: aim.at(w, "white", "red", eighths=9), "eighths must be from -8 to 8, not 9"),
     (lambda w: aim.kick(w, "white", "red", "up"), "no straight cushion 'up' in this world, only"),
     (lambda w: aim.kick(w, "white", "red", "west", "west"), "there is no way by the cushion"),
     (lambda w: aim.kick(w, "white", "red", "east", "north"), "where 'north' is in the way"),
     (lambda w: aim.to(w, "white", "red", "corner"), "there is no pocket 'corner'"),
     (lambda w: aim.to(w, "white", "red", (-1.0, 0.0)), "'red' would have to be cut by"),
     (lambda w: aim.to(w, "white", "red", (0.3, 0.1)), "lies at"),
     (lambda w: aim.to(w, "white", "red", (0.3,)), "place must be 2 numbers")],
)  # fmt: skip
def test_an_aim_that_cannot_be_is_refused(ask, words):
    with pytest.raises(ValueError, match=words):
        ask(ice(*PAIR))


def test_balls_that_touch_leave_nothing_to_aim_along():
    world = ice(("white", (0.0, 0.0)), ("red", (2.0 * R, 0.0)))
    with pytest.raises(ValueError, match="the balls touch"):
        aim.at(world, "white", "red")


def test_a_mirrored_way_into_a_pocket_is_none():
    world = tables.pool_9ft()
    world.add(Ball("white", at=(-0.1, -0.3)))
    world.add(Ball("1", at=(0.1, -0.3)))
    with pytest.raises(ValueError, match="mirrored, the way"):
        aim.kick(world, "white", "1", "north-west")


def test_a_ball_in_the_way_is_said_by_refined_alone():
    world = ice(*PAIR, ("blocker", (-0.1, -0.05)))
    found = aim.at(world, "white", "red")
    with pytest.raises(ValueError, match=r"no angle within 12° of .* send 'red' there"):
        found.refined(world, Shot(2.0, follow=2.0))
