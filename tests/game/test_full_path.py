"""The full path is the whole stroke: no kiss and no foul stays hidden, until nothing counts."""

import json
from itertools import pairwise
from math import dist
from pathlib import Path
from random import Random

import pytest

from game.aim.preview import preview
from game.render.theme import ERROR
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.session.terms import FOUR_BALL, Terms
from game.table import lineup
from game.table.presets import table_world
from physics import Shot, simulate
from tests.support.players import FRAME, an_app, assert_same_as_anew

CASES = json.loads(
    (Path(__file__).parents[1] / "data" / "previews.json").read_text(encoding="utf-8")
)
R = 0.03275


def free(case, size=(1280, 720)):
    """The free table with a set-up and its shot."""
    app = an_app(size=size)
    app.perform(Action("line", CASES[case]["line"]))
    app.frame(FRAME)
    return app


def contacts(world, cue, shot):
    """All that meets in a shot, and the world after it."""
    after = simulate(world, cue, shot)
    return [c for c in after.log.contacts() if c.kind == "ball"], after


def shown(seen):
    """What meets in a preview, the first contact of the cue ball apart."""
    return [meeting.balls for meeting in seen.meetings]


def near(path, place):
    """How far a place is from the nearest point of a path, m."""
    p = complex(*place)
    best = min(abs(p - complex(*q)) for q in path)
    for a, b in pairwise(complex(*q) for q in path):
        if a != b:
            share = min(max(((p - a) / (b - a)).real, 0.0), 1.0)
            best = min(best, abs(p - a - share * (b - a)))
    return best


def lit(app, place, off):
    """How much the picture around a place of the table differs from the one without a path."""
    layout = app.view.sight.layout
    x, y = map(int, layout.to_screen(*place))
    spots = [(x + i, y + j) for i in range(-14, 15) for j in range(-14, 15)]
    return sum(app.canvas.surface.get_at(spot) != off.get_at(spot) for spot in spots)


@pytest.mark.parametrize("case", CASES)
def test_every_ball_that_the_cue_ball_meets_is_seen_to_be_met(case):
    app = free(case)
    seen, session = app.session.preview, app.session
    met, after = contacts(session.world, "white", session.aim.shot)
    own = [name for c in met if "white" in c.balls for name in c.balls if name != "white"]
    assert own == CASES[case]["met"]
    later = [next(n for n in pair if n != "white") for pair in shown(seen) if "white" in pair]
    assert [seen.contact.ball, *later] == own
    assert seen.beyond[-1] == pytest.approx(after.ball("white").position, abs=1e-6)
    assert seen.whole
    for ball in after.balls:
        if ball.name in seen.others:
            assert seen.others[ball.name][-1] == pytest.approx(ball.position, abs=1e-6)


@pytest.mark.parametrize("size", [(1280, 720), (640, 360)])
@pytest.mark.parametrize("case", CASES)
def test_the_picture_shows_what_is_met_and_every_path_to_its_end(case, size):
    app = free(case, size)
    seen = app.session.preview
    app.perform(Action("aids", "off"))
    app.frame(FRAME)
    off = app.canvas.surface.copy()
    app.perform(Action("aids", "full"))
    app.frame(FRAME)
    assert_same_as_anew(app)
    for meeting in seen.meetings:
        if "white" in meeting.balls:
            assert lit(app, meeting.places[meeting.balls.index("white")], off) > 40
    for path in (seen.beyond, *seen.others.values()):
        assert lit(app, path[-1], off) > 25


@pytest.mark.parametrize("seed", range(20))
def test_nothing_that_meets_is_left_out_and_every_path_leads_through_it(seed):
    rng, world = Random(seed), table_world("medium")
    shot = Shot(rng.uniform(1, 8), rng.uniform(0, 360), rng.uniform(-3, 6), 0.0, rng.uniform(-3, 3))
    seen = preview(world, "white", shot)
    met, _ = contacts(world, "white", shot)
    first = next((c for c in met if "white" in c.balls), None)
    assert shown(seen) == [c.balls for c in met if c is not first]
    paths = {"white": (*seen.way, *seen.beyond), **seen.others}
    for meeting in seen.meetings:
        assert dist(*meeting.places) == pytest.approx(2 * R, abs=1e-6)
        for name, place in zip(meeting.balls, meeting.places, strict=True):
            lies = world.ball(name).position
            assert near(paths.get(name, [lies]), place) < 1e-3
    assert {n for c in met for n in c.balls} <= {*paths}


# -- in a match the stroke counts until nothing can change its verdict


def match_with(case):
    app = an_app(size=(1280, 720), game="four-ball")
    found = lineup.read(CASES[case]["line"])
    lies = dict(found.balls)
    app.session.lay([lies[ball.name] for ball in app.session.world.balls])
    app.perform(Action("set", "speed {} follow {} masse {} side {} angle {}".format(*found.texts)))
    app.session.aim.texts = list(found.texts)  # all its digits
    app.frame(FRAME)
    return app


def test_a_foul_is_ringed_and_nothing_is_shown_after_it():
    app = match_with("both reds, and then the opponent's ball")
    seen = app.session.preview
    foul = seen.meetings[seen.foul]
    assert set(foul.balls) == {"white", "yellow"}
    assert seen.foul == len(seen.meetings) - 1
    assert not seen.whole
    x, y = app.view.sight.layout.to_screen(*foul.places[foul.balls.index("yellow")])
    ring = [app.screen.get_at((int(x + dx), int(y)))[:3] for dx in range(-20, 21)]
    assert min(sum(abs(a - b) for a, b in zip(pixel, ERROR, strict=True)) for pixel in ring) < 60
    app.perform(Action("fire"))
    app.perform(Action("skip"))
    assert app.session.contest.verdict.reason == "opponent_ball"


def test_the_first_contact_may_be_the_foul():
    session = Session(table_world("medium"))
    perform(session, Action("match", Terms(FOUR_BALL).line()))
    session.lay([(0.0, 0.0), (0.5, 0.0), (0.9, 0.4), (-0.9, 0.4)])
    perform(session, Action("set", "speed 2 angle 0"))
    assert session.preview.contact.ball == "yellow"
    assert session.preview.foul == -1
    assert session.preview.beyond == ()


def test_in_three_cushion_the_path_ends_with_the_second_ball():
    session = Session(table_world("match"))
    perform(session, Action("match", Terms("three-cushion", table="match").line()))
    for angle in range(360):
        perform(session, Action("set", f"speed 5 side 2 angle {angle}"))
        seen = session.preview
        own = [pair for pair in shown(seen) if "white" in pair]
        met, _ = contacts(session.world, "white", session.aim.shot)
        names = [n for c in met if "white" in c.balls for n in c.balls if n != "white"]
        if len({*names}) == 2 and names[0] == "red":
            assert not seen.whole
            assert seen.foul is None
            assert own == [c.balls for c in met if "white" in c.balls][1 : len(own) + 1]
            assert {n for pair in own for n in pair} - {"white", "red"} == {"yellow"}
            return
    raise AssertionError("no angle meets both balls")


def test_a_stroke_that_nothing_has_settled_is_shown_to_its_end():
    session = Session(table_world("medium"))
    perform(session, Action("match", Terms(FOUR_BALL).line()))
    assert session.preview.whole
    assert session.preview.foul is None
