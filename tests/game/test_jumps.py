"""A raised cue makes the ball hop, and balls and cushions behind the cue ball raise it."""

from math import cos, radians, sin
from random import Random

import pytest

from game.aim import cue_room
from game.aim.entry import Aim
from game.aim.spread import off
from game.aim.tip import STEEPEST, Tip
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.table import lineup, presets
from game.ui.table import cue_pose
from physics import Ball, CueStroke, Shot, tables
from tests.support.racked_games import leave, playing

RADIUS = tables.pool(9).radius


def pool(**places):
    world = tables.pool(9).world()
    for name, at in places.items():
        world.add(Ball(name, at))
    return world


def game(edition=4, **places):
    return Session(pool(**places), edition=edition)


def do(session, *steps):
    for step in steps:
        name, _, value = step.partition(" ")
        perform(session, Action(name, int(value) if name == "edit" else value or None))


# -- the stroke ------------------------------------------------------------------------------------


@pytest.mark.parametrize(("right", "up"), [(0.0, 0.0), (0.2, -0.1), (-0.1, 0.3)])
def test_a_raised_cue_gives_what_the_physics_has_for_a_jump_at_the_same_speed_of_the_cue(right, up):
    aim, steep, mass = Aim(texts=["3", "0", "0", "0", "0"]), 40.0, tables.pool(9)
    aim.hold(Tip(right, up))
    level = CueStroke.along(1.0, right=right, up=up, friction=0.9)
    cue = 3.0 / level.shot(mass).speed
    aim.hold(Tip(right, up, steep))
    stroke = CueStroke.along(cue, 0.0, right, up, steep, end_ratio=1e12, friction=0.9)
    jump, shot = stroke.jump(mass), aim.shot
    for name in ("speed", "follow", "masse", "side", "climb"):
        assert getattr(shot, name) == pytest.approx(getattr(jump, name), abs=0.02)


def test_raising_the_cue_and_lowering_it_again_gives_the_old_numbers_back():
    session = game(cue=(0.0, 0.0))
    do(session, "set speed 3.37 follow 0 masse 0 side 0", "tip 0.2 0.1")
    before = session.aim.texts[:]
    do(session, *["tilt 7"] * 9, *["tilt -7"] * 9)
    assert session.aim.texts == before
    assert session.aim.shot.climb == 0.0


def test_the_power_is_the_cue_s_and_its_ball_hops_in_proportion():
    session = game(cue=(0.0, 0.0))
    do(session, "set speed 3 follow 0 masse 0 side 0", "elevate 60", "power 4")
    shot = session.aim.shot
    assert shot.speed == pytest.approx(4.0 * cos(radians(60.0)), abs=0.005)
    assert shot.climb == pytest.approx(-4.0 * sin(radians(60.0)), abs=0.01)
    do(session, "push 1")
    assert session.aim.power == 5.0


def test_the_ball_of_a_raised_cue_flies_over_another_as_its_preview_says():
    session = game(cue=(-0.4, 0.0), near=(-0.1, 0.0), far=(0.5, 0.0))
    do(session, "set speed 5 follow 0 masse 0 side 0 angle 0")
    assert session.preview.contact.ball == "near"
    do(session, "elevate 45")
    assert session.preview.contact.ball == "far"
    do(session, "fire")
    session.world.run(0.2)
    assert session.world.ball("cue").height > 0.01
    session.world.run(4.0)
    assert session.world.ball("near").position == (-0.1, 0.0)
    assert session.world.ball("far").position != (0.5, 0.0)


def test_the_spread_of_a_jump_jumps_as_hard_as_it_is_struck():
    shot = Shot(3.0, climb=-2.0)
    for seed in range(5):
        one = off(shot, Random(seed))
        assert one.climb / one.speed == pytest.approx(-2.0 / 3.0)


def test_numbers_that_are_typed_are_all_there_is_and_turning_keeps_a_raised_cue():
    session = game(cue=(0.0, 0.0))
    do(session, "elevate 30", "turn 5")
    assert session.aim.raised == 30.0
    do(session, "edit 1", "leave")
    assert session.aim.raised == 30.0
    do(session, "set side 1")
    assert session.aim.raised == session.aim.shot.climb == 0.0


def test_undo_gives_back_the_stroke_of_a_raised_cue():
    session = game(cue=(0.0, 0.0))
    do(session, "elevate 30")
    before = session.aim.texts[:], session.aim.shot
    do(session, "fire", "skip", "undo")
    assert (session.aim.texts, session.aim.shot) == before


@pytest.mark.parametrize("edition", [1, 2, 3])
def test_in_a_record_of_before_a_raised_cue_leaves_the_ball_on_the_cloth(edition):
    session = game(edition, cue=(0.0, 0.6))
    do(session, "set speed 3 follow 0 masse 0 side 0 angle -90", "tip 0.3 0.1", "elevate 40")
    assert session.aim.texts[0] == "3"
    assert session.aim.shot.masse > 0.0
    assert session.aim.shot.climb == 0.0
    assert len(session.aim.texts) == 5


def test_an_engine_that_knows_no_flight_plays_a_raised_cue_as_before():
    session = game(cue=(0.0, 0.0))
    do(session, "engine thesis", "tip 0.2 0", "elevate 30")
    assert session.aim.shot.climb == 0.0
    do(session, "fire")
    assert session.moving


def test_a_line_keeps_the_elevation_and_refuses_one_that_no_cue_has():
    session = Session(presets.table_world("medium"), table="medium")
    do(session, "elevate 30")
    line = lineup.of(session.world, "medium", session.aim.texts).line()
    assert list(lineup.read(line).texts) == session.aim.texts
    for bad in ("-1", "0", "x", f"{STEEPEST + 1}", "nan", "30,30"):
        with pytest.raises(lineup.LineError):
            lineup.read(line.replace(",30", f",{bad}"))


# -- room for the cue ------------------------------------------------------------------------------


def test_in_the_middle_of_the_table_a_cue_is_level():
    assert cue_room.needed(pool(cue=(0.0, 0.0)), "cue", 0.0) == 0.0


def test_a_ball_behind_raises_the_cue_until_it_passes_it_by_its_own_thickness():
    for away in (2.0 * RADIUS, 0.1, 0.3):
        world = pool(cue=(0.0, 0.0), other=(-away, 0.0))
        steep = radians(cue_room.needed(world, "cue", 0.0))
        assert away * sin(steep) == pytest.approx(RADIUS + cue_room.THICK, abs=1e-4)


def test_a_ball_in_front_or_beside_raises_no_cue_and_a_higher_tip_needs_less():
    for at in ((0.1, 0.0), (0.0, 0.06), (-0.1, 0.05)):
        assert cue_room.needed(pool(cue=(0.0, 0.0), other=at), "cue", 0.0) == 0.0
    world = pool(cue=(0.0, 0.0), other=(-0.1, 0.0))
    assert cue_room.needed(world, "cue", 0.0, up=0.4) < cue_room.needed(world, "cue", 0.0)


def test_a_cushion_behind_a_frozen_ball_raises_the_cue_and_one_in_front_does_not():
    world = tables.MATCH_CAROM.world()
    edge = world.table.length / 2 - world.table.radius
    world.add(Ball("white", (edge, 0.1)))
    assert 15.0 < cue_room.needed(world, "white", 180.0) < 40.0
    assert cue_room.needed(world, "white", 0.0) == 0.0


def test_aiming_raises_the_cue_over_a_ball_and_lowers_it_again_past_it():
    session = game(cue=(0.0, 0.0), other=(-0.1, 0.0))
    do(session, "set speed 2 follow 0 masse 0 side 0 angle 0")
    least = cue_room.needed(session.world, "cue", 0.0)
    assert session.aim.tip.elevation == least > 10.0
    assert session.aim.shot.climb < 0.0
    do(session, "tilt -5")
    assert session.aim.tip.elevation == least
    do(session, "set angle 90")
    assert session.aim.tip.elevation == pytest.approx(least - 5.0, abs=0.01)
    do(session, "elevate 0", "set angle 0", "set angle 90")
    assert session.aim.texts == ["2", "0", "0", "0", "90"]


# -- the rules -------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["snooker", "8-ball"])
@pytest.mark.parametrize("steep", [0, 45])
def test_a_jump_over_a_ball_is_a_foul_in_snooker_and_none_in_pool(name, steep):
    session = playing(name)
    first, second = ("red1", "red2") if name == "snooker" else ("b1", "b2")
    leave(session, **{"cue": (-0.6, 0.0), first: (-0.3, 0.0), second: (0.4, 0.0)})
    do(session, "set speed 5 follow 0 masse 0 side 0 angle 0", f"elevate {steep}", "fire", "skip")
    verdict = session.contest.verdict
    assert verdict.facts.hits[0] == (second if steep else first).removeprefix("b")
    assert verdict.foul == (name == "snooker" and steep == 45)
    assert (verdict.reason == "jumps") == verdict.foul


def test_the_preview_knows_the_foul_of_a_jump_in_snooker():
    session = playing("snooker")
    leave(session, cue=(-0.6, 0.0), red1=(-0.3, 0.0), red2=(0.4, 0.0))
    do(session, "set speed 5 follow 0 masse 0 side 0 angle 0")
    assert session.preview.fault == ""
    do(session, "elevate 45")
    assert session.preview.fault == "jumps"


# -- the picture -----------------------------------------------------------------------------------


def test_a_raised_cue_is_drawn_raised_before_the_stroke_and_in_it():
    session = game(cue=(0.0, 0.0))
    do(session, "elevate 40")
    assert cue_pose.pose(session, False).elevation == 40.0
    do(session, "fire")
    assert cue_pose.pose(session, False).elevation == 40.0
