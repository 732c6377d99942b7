"""Which contacts with a cushion count: by how far the ball had left it, and never by when."""

import json
from math import atan2, ceil, degrees, dist, inf
from pathlib import Path
from random import Random

import pytest

from danggu.rules.carom import Carom
from danggu.rules.stroke import LEFT, counts, stroke
from danggu.rules.verdict import Turn, Verdict
from game.session.action import Action
from game.session.commands import perform
from game.session.session import Session
from game.session.ticks import TICKS
from physics import Ball, EventDriven, Shot, TimeStepping, World, laws, simulate, tables
from tests.support.referee import watched

CASES = json.loads((Path(__file__).parents[1] / "data" / "near_cushions.json").read_text())
TABLE = tables.MATCH_CAROM
R, LENGTH, WIDTH = TABLE.radius, 0.5 * TABLE.length, 0.5 * TABLE.width


def laid(**balls: tuple[float, float]) -> World:
    world = TABLE.world()
    for name, at in balls.items():
        world.add(Ball(name, at=at, radius=R, mass=TABLE.mass))
    return world


def judged(after: World) -> Verdict:
    return Carom(3, bank=2).verdict(after.log.contacts(), Turn("white"))


def played(case: dict[str, object]) -> World:
    speed, angle, follow, masse, side = case["shot"]
    return simulate(laid(**case["balls"]), "white", Shot(speed, angle, follow, masse, side))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_a_stroke_near_a_cushion_is_worth_what_a_referee_gives(case):
    after = played(case)
    verdict = judged(after)
    assert (verdict.reason, verdict.points) == (case["reason"], case["points"])
    assert list(verdict.facts.path) == case["path"]
    assert watched(after, "white", LEFT).cannon(3) == (case["points"] > 0)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_the_panel_counts_as_the_rules_do(case):
    session = Session(laid(**case["balls"]), table="match")
    speed, angle, follow, masse, side = case["shot"]
    perform(session, Action("set", f"speed {speed} follow {follow} masse {masse} side {side}"))
    perform(session, Action("set", f"angle {angle}"))
    perform(session, Action("shoot"))
    perform(session, Action("skip"))
    done = stroke(session.world.log.contacts(), "white")
    assert session.counts == (len(done.hits()), done.cushions())
    second = max(done.hits().values(), default=0.0)
    perform(session, Action("scrub", ceil(second * TICKS)))
    assert session.counts == (2, judged(session.world).facts.cushions)


# -- a cushion that is not left


def test_a_ball_frozen_to_a_cushion_has_not_met_it_until_it_comes_back():
    along = simulate(laid(white=(0.0, -WIDTH + R)), "white", Shot(1.0, -30.0))
    assert along.log[0].wall == "south"
    assert "south" not in stroke(along.log.contacts(), "white").path()
    across = simulate(laid(white=(0.0, -WIDTH + R)), "white", Shot(3.0, 90.0))
    assert stroke(across.log.contacts(), "white").path()[:2] == ("north", "south")


def test_a_ball_that_spin_presses_into_a_cushion_touches_it_once():
    shot = Shot(1.0, follow=1.0, masse=6.0)  # along the cushion, 1.2 mm beside it
    after = simulate(laid(white=(-1.2, -WIDTH + R + 0.0012)), "white", shot)
    east = next(event.time for event in after.log if event.wall == "east")
    pressed = [event.away for event in after.log if event.wall == "south" and event.time < east]
    assert len(pressed) > 1
    assert max(pressed[1:]) < 1e-3
    assert stroke(after.log.contacts(), "white").path()[:2] == ("south", "east")


@pytest.mark.parametrize("gap", [0.5 * LEFT, 2.0 * LEFT])
def test_a_ball_that_starts_beside_a_cushion_meets_it_if_it_comes_from_farther_than_left(gap):
    after = simulate(laid(white=(0.0, -WIDTH + R + gap)), "white", Shot(3.0, -60.0))
    done = stroke(after.log.contacts(), "white")
    assert (done.path()[0] == "south") == (gap > LEFT)
    assert after.log[0].away == pytest.approx(gap, abs=1e-15)


# -- how far it had left: exactly


def test_how_far_a_ball_was_away_is_the_turning_point_of_its_parabola():
    """Struck straight off the cushion with draw: v²/2μg there, less than where the slip ends."""
    world = laid(white=(0.0, -WIDTH + R))
    after = simulate(world, "white", Shot(0.2, 90.0, follow=-3.0))
    hit = after.log[0]
    assert (hit.kind, hit.wall) == ("cushion", "south")
    assert hit.away == pytest.approx(0.04 / (2 * 0.212 * 9.81), rel=1e-12)


@pytest.mark.parametrize("engine", [EventDriven(), TimeStepping(1e-3), TimeStepping(1e-3, "rk4")])
def test_how_far_is_the_same_from_the_log_s_states(engine):
    world = laid(white=(0.3, -0.3), red=(0.5, -0.2))
    world.engine = engine
    log = simulate(world, "white", Shot(4.0, 31.0, follow=1.0, side=2.0)).log
    last = dict.fromkeys((wall.name for wall in world.walls), 0.0)
    walls = {wall.name: wall for wall in world.walls}
    for event in log:
        if event.kind == "cushion" and event.balls == ("white",):
            start, end = last[event.wall], event.time
            times = [start + (end - start) * k / 2000 for k in range(2001)]
            seen = max(walls[event.wall].distance(log.at(t)["white"].position) for t in times) - R
            assert event.away == pytest.approx(seen, abs=5e-3)
            assert event.away >= seen - 1e-9
            last[event.wall] = event.time


def test_contacts_and_events_say_the_same_also_after_the_log_was_cleared():
    world = laid(white=(0.3, -0.3))
    for _ in range(2):
        world.strike("white", Shot(4.0, 31.0))
        world.run()
        events = [event for event in world.log if event.kind == "cushion"]
        contacts = [met for met in world.log.contacts() if met.kind == "cushion"]
        assert [met.away for met in contacts] == [event.away for event in events]
        assert contacts[0].away > 0.1
        world.log.clear()


def test_what_rules_read_in_brief_says_the_same_of_what_counts():
    dice, pressed = Random("brief"), 0
    for _ in range(200):
        world, shot = near_rails(dice)
        log = simulate(world, "white", shot).log
        known = [
            contact._replace(away=inf if counts(contact) else 0.0) for contact in log.contacts()
        ]
        assert [*log.brief()] == known
        pressed += any(not counts(met) for met in known)
    assert pressed > 20


# -- against a referee that reads no event


def corner(dice: Random, law: laws.CushionLaw) -> tuple[World, Shot]:
    """The white alone, played about into a corner with any spin."""
    east, north = dice.choice((-1, 1)), dice.choice((-1, 1))
    at = east * dice.uniform(0.0, LENGTH - R), north * dice.uniform(0.0, WIDTH - R)
    world = laid(white=at)
    world.cushion_law = law
    bearing = degrees(atan2(north * (WIDTH - R) - at[1], east * (LENGTH - R) - at[0]))
    v = dice.uniform(0.5, 7.0)
    spins = {name: v * dice.uniform(-1.0, 1.0) for name in ("follow", "side", "masse")}
    if dice.random() < 0.5:
        spins["masse"] = 0.0
    return world, Shot(v, dice.gauss(bearing, 6.0), **spins)


def near_rails(dice: Random) -> tuple[World, Shot]:
    """All three balls within 8 cm of a rail, some frozen, and a stroke in any direction."""
    while True:
        places = [_by_a_rail(dice) for _ in range(3)]
        if min(dist(a, b) for i, a in enumerate(places) for b in places[:i]) >= 2.0 * R:
            break
    v = dice.uniform(2.0, 7.0)
    spins = {name: v * dice.uniform(-1.25, 1.25) for name in ("follow", "side")}
    world = laid(**dict(zip(("white", "red", "yellow"), places, strict=True)))
    return world, Shot(v, dice.uniform(-180.0, 180.0), **spins)


def _by_a_rail(dice: Random) -> tuple[float, float]:
    gap = dice.choice((0.0, dice.uniform(0.0, 2e-3), dice.uniform(0.0, 0.08)))
    x, y, side = LENGTH - R, WIDTH - R, dice.choice((-1, 1))
    if dice.random() < 2 / 3:
        return dice.uniform(-1.0, 1.0) * x, side * (y - gap)
    return side * (x - gap), dice.uniform(-1.0, 1.0) * y


def disagreements(shots: int) -> list[int]:
    """Shots into corners of which rules and referee do not count the same cushions."""
    dice, found = Random("corners"), []
    kinds = TABLE.cushion_law, laws.MathavanCushion(nose=TABLE.cushion_law.nose)
    for k in range(shots):
        after = simulate(*_struck(corner(dice, kinds[k % 2])))
        seen, done = watched(after, "white", LEFT), stroke(after.log.contacts(), "white")
        same = [name for _, name in seen.cushions] == list(done.path())
        if not same and not seen.close:
            found.append(k)
    return found


def _struck(scene: tuple[World, Shot]) -> tuple[World, str, Shot]:
    return scene[0], "white", scene[1]


def points(wanted: int) -> list[bool]:
    """Strokes near rails that rules or referee call a point: whether both do."""
    dice, found = Random("rails"), []
    while len(found) < wanted:
        after = simulate(*_struck(near_rails(dice)))
        verdict = judged(after)
        if len(verdict.facts.hits) < 2:
            continue
        seen = watched(after, "white", LEFT)
        if not seen.close and (verdict.made or seen.cannon(3)):
            found.append(verdict.made == seen.cannon(3))
    return found


def test_rules_and_referee_count_the_same_cushions_in_corners():
    assert disagreements(200) == []


def test_rules_and_referee_give_the_same_points_near_rails():
    assert all(points(10))


@pytest.mark.stress
def test_rules_and_referee_count_the_same_in_6000_shots_into_corners():
    assert disagreements(6000) == []


@pytest.mark.stress
def test_rules_and_referee_give_the_same_212_points_near_rails():
    assert all(points(212))
