"""The coach: ways to score, how sure they are, and how to hit them."""

import pickle
from dataclasses import replace
from math import asin, degrees, inf

import pytest

from danggu.players import Attempt, Solution, solutions
from danggu.players.levels import EXPERT, PERFECT, Level
from danggu.players.solution import Tip
from danggu.players.tolerances import thickness, tolerance
from danggu.rules import GAMES, Turn
from physics import Ball, World, simulate, tables

LIES = {
    "three-cushion": {"white": (-0.7, 0.1), "yellow": (0.3, 0.4), "red": (0.5, -0.3)},
    "one-cushion": {"white": (-0.7, 0.1), "yellow": (0.3, 0.4), "red": (0.5, -0.3)},
    "straight-rail": {"white": (-0.7, 0.1), "yellow": (0.3, 0.4), "red": (0.5, -0.3)},
    "four-ball": {
        "white": (-0.7, 0.1), "yellow": (-0.9, -0.4), "red1": (0.3, 0.4), "red2": (0.5, -0.3),
    },
}  # fmt: skip
HALF = degrees(asin(2 * 0.03075))  # of the angle under which a ball 1 m away is hit


def laid(game: str) -> World:
    world = tables.medium_carom() if game == "four-ball" else tables.match_carom()
    for name, at in LIES[game].items():
        world.add(Ball(name, at=at))
    return world


def found(game: str, level: Level = EXPERT, budget: int = 1500, **given: object) -> list[Solution]:
    return solutions(laid(game), GAMES[game](), Turn(), level, budget, compiled=True, **given)


@pytest.mark.parametrize("game", LIES)
def test_each_way_scores_as_it_is_meant_and_by_another_path(game: str) -> None:
    ways = found(game)
    assert ways
    assert len({way.path for way in ways}) == len(ways)
    for way in ways:
        log = simulate(laid(game), "white", way.shot).log
        verdict = GAMES[game]().verdict(log.contacts(), Turn())
        assert verdict.made
        assert verdict.facts.path == way.path
        hit = next(e for e in log if e.kind == "ball")
        assert way.thickness is not None
        assert way.thickness.ball in hit.balls


def test_the_outcome_depends_on_the_seed_and_can_be_sent_to_another_process() -> None:
    ways = found("three-cushion", seed=1)
    assert pickle.loads(pickle.dumps(ways)) == ways == found("three-cushion", seed=1)
    assert found("three-cushion", seed=2) != ways


def test_interpreted_it_finds_the_same() -> None:
    world, rules = laid("four-ball"), GAMES["four-ball"]()
    interpreted = solutions(world, rules, Turn(), EXPERT, 300, compiled=False)
    assert interpreted == found("four-ball", budget=300)
    assert interpreted


def test_a_search_leaves_the_table_as_it_is_and_spends_no_more_than_its_budget() -> None:
    world, rules = laid("one-cushion"), GAMES["one-cushion"]()
    before = {ball.name: ball.position for ball in world.balls}
    ways = solutions(world, rules, Turn(), EXPERT, 1000, compiled=True)
    assert {ball.name: ball.position for ball in world.balls} == before
    assert (len(world.log), world.time) == (0, 0)
    assert sum(way.copies for way in ways) <= 1000


def test_who_makes_no_errors_scores_always() -> None:
    assert {way.share for way in found("straight-rail", PERFECT)} == {1.0}


def test_where_nothing_scores_there_is_no_way() -> None:
    world = tables.match_carom()
    for name, at in {"white": (0.0, 0.0), "red": (0.5, 0.1)}.items():
        world.add(Ball(name, at=at))
    assert solutions(world, GAMES["three-cushion"](), Turn(), EXPERT, 200, compiled=True) == []


def test_a_table_without_its_ball_is_refused() -> None:
    with pytest.raises(ValueError, match="'white'"):
        solutions(tables.match_carom(), GAMES["three-cushion"](), Turn(), EXPERT)


def test_a_ball_that_is_hit_directly_gives_its_width_as_tolerance_and_its_thickness() -> None:
    world = tables.match_carom()
    world.add(Ball("white", at=(0.0, 0.0)))
    world.add(Ball("red", at=(1.0, 0.0)))
    aim = Attempt(0.5 * HALF, 3.0)  # so that a quarter of the angle is left on one side
    hit = simulate(world, "white", aim.shot()).log.first("ball")
    found = tolerance(world, "white", aim, hit.time)
    assert found is not None
    assert found.angle == pytest.approx((-1.5 * HALF, 0.5 * HALF), rel=2e-3)
    assert found.speed[1] == inf
    # it slides all the way: with δ more speed, the square v² of what is left grows by 2 · 9 δ
    left = hit.before["white"].speed ** 2
    assert found.speed[0] == pytest.approx(-left / 18.0, rel=1e-9)
    thick = thickness(world, "white", aim)
    assert thick is not None
    assert (thick.ball, thick.side) == ("red", "left")
    assert thick.eighths == pytest.approx(4.0, abs=0.01)


def test_a_shot_that_is_off_by_half_its_tolerance_still_scores() -> None:
    way = found("three-cushion", budget=4000)[0]
    assert way.tolerance is not None
    for turn in way.tolerance.angle:
        aim = replace(way.aim, angle=way.aim.angle + 0.5 * turn)
        log = simulate(laid("three-cushion"), "white", aim.shot()).log
        assert GAMES["three-cushion"]().verdict(log.contacts(), Turn()).made


@pytest.mark.parametrize(
    ("right", "up", "hour"),
    [(0.0, 0.4, 12), (0.4, 0.0, 3), (0.0, -0.4, 6), (-0.4, 0.0, 9), (0.3, 0.17, 2), (0.0, 0.0, 0)],
)
def test_the_hour_of_the_tip_is_that_of_a_clock_face(right: float, up: float, hour: int) -> None:
    assert Tip.of(right, up, 0.03075).hour == hour
