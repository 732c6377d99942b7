"""The coach: ways to score, how sure they are, and how to hit them."""

import pickle
from dataclasses import replace
from math import asin, degrees, inf

import numpy as np
import pytest

from danggu.players import Attempt, Solution, solutions
from danggu.players.ahead import Ahead
from danggu.players.bench import Bench
from danggu.players.candidates import DIRECT
from danggu.players.draws import spread
from danggu.players.knockout import Contenders
from danggu.players.levels import EXPERT, PERFECT, Level
from danggu.players.outlook import outlook
from danggu.players.solution import Tip
from danggu.players.tolerances import thickness, tolerance, until
from danggu.rules import GAMES, Match, Player, Turn
from physics import Ball, Shot, World, simulate, tables

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


def test_a_large_budget_looks_at_the_positions_that_are_left() -> None:
    assert {way.after for way in found("three-cushion")} == {None}
    ways = found("four-ball", budget=40_000, most=2)
    assert len(ways) == 2
    for way in ways:
        assert way.after is not None
        assert 0.0 < way.after < 1.0
        assert way.worth > way.gain
    one = found("four-ball", budget=40_000, most=1, plies=1)
    assert one[0].after is None


def test_what_a_winning_stroke_leaves_is_not_looked_at() -> None:
    turn = Turn(score=9, target=10)
    world, rules = laid("three-cushion"), GAMES["three-cushion"]()
    ways = solutions(world, rules, turn, EXPERT, 40_000, most=1, compiled=True)
    assert ways[0].after is None


def test_the_outlook_is_better_where_balls_lie_well() -> None:
    bench = Bench(laid("straight-rail"), GAMES["straight-rail"](), Turn(), True)
    near = [[-0.5, 0.0], [-0.3, 0.05], [-0.3, -0.1]]
    far = [[-1.3, 0.6], [1.3, 0.6], [1.3, -0.6]]
    rng = np.random.default_rng(1)
    good, bad = outlook(bench, np.array([near, far]), DIRECT, EXPERT, rng)
    assert good > 0.9
    assert bad < 0.6


def test_even_numbers_fill_each_cell_of_a_grid() -> None:
    even = spread(1, 4000, np.random.default_rng(1))[0]
    for first, second in ((0, 2), (3, 4), (4, 5)):
        cells = (even[:, first] * 10).astype(int) * 10 + (even[:, second] * 10).astype(int)
        counts = np.bincount(cells, minlength=100)
        assert counts.min() >= 25  # 40 on average; at random one in two hundred would be below
        assert counts.max() <= 55


def test_few_positions_are_trusted_less_than_many() -> None:
    looked = Ahead(Contenders.of(np.zeros((3, 6)), [("a",), ("b",), ("c",)]))
    looked.count[:] = 4, 400, 400
    looked.total[:] = 0.9 * looked.count[0], 0.6 * 400, 0.4 * 400
    looked.square[:] = looked.total * looked.total / looked.count + 0.04 * looked.count
    after = looked.after
    mean = looked.total.sum() / looked.count.sum()
    assert abs(after - mean)[0] < 0.9 * (0.9 - mean)
    assert after[1:] == pytest.approx([0.6, 0.4], abs=0.01)


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


def test_a_table_where_a_ball_still_rolls_is_refused() -> None:
    world = laid("four-ball")
    world.strike("red1", Shot(speed=1.0, angle=0.0))
    with pytest.raises(ValueError, match="at rest"):
        solutions(world, GAMES["four-ball"](), Turn(), EXPERT, 10)


def test_a_ball_that_is_hit_directly_gives_its_width_as_tolerance_and_its_thickness() -> None:
    world = tables.match_carom()
    world.add(Ball("white", at=(0.0, 0.0)))
    world.add(Ball("red", at=(1.0, 0.0)))
    aim = Attempt(0.5 * HALF, 3.0)  # so that a quarter of the angle is left on one side
    hit = simulate(world, "white", aim.shot()).log.first("ball")
    found = tolerance(world, "white", aim, until("white", hit.time))
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


def racked(game: str) -> tuple[World, Turn]:
    """Three balls on a pool table, in the middle of a rack."""
    world = tables.pool_9ft()
    for name, at in {
        "cue": (-0.5, 0.2),
        "1": (0.3, -0.2),
        "9": (0.0, 0.45),
        "8": (0.9, 0.3),
    }.items():
        world.add(Ball(name, at=at))
    match = Match.of(GAMES[game](), Player("kim"), Player("lee"))
    state = replace(match.state, phase="", region="", left=("1", "8", "9"))
    return world, replace(match, state=state).turn


@pytest.mark.parametrize("game", ["9-ball", "8-ball"])
def test_with_pockets_each_way_pots_its_ball_where_it_says(game: str) -> None:
    world, turn = racked(game)
    ways = solutions(world, GAMES[game](), turn, EXPERT, 4000, compiled=True, most=3)
    assert ways
    for way in ways:
        log = simulate(world, "cue", way.shot).log
        verdict = GAMES[game]().verdict(log.contacts(), replace(turn, call=way.call))
        assert verdict.made
        drops = {(e.balls[0], e.wall) for e in log if e.kind == "pocket"}
        assert way.path in drops
        assert way.after is None or 0.0 <= way.after <= 1.0
    if game == "9-ball":
        assert {way.path[0] for way in ways} == {"1"}
    else:
        assert ways[0].call.ball == ways[0].path[0]


def test_a_game_with_pockets_is_refused_on_a_table_without() -> None:
    world = tables.match_carom()
    world.add(Ball("cue", at=(0.0, 0.0)))
    with pytest.raises(ValueError, match="pockets"):
        solutions(world, GAMES["9-ball"](), Turn("cue"), EXPERT)


@pytest.mark.parametrize(
    ("name", "value"),
    [("budget", 0), ("most", 0), ("plies", 3), ("seed", -1), ("seed", None), ("seed", 1.5)],
)
def test_what_cannot_be_asked_for_is_refused_by_name(name: str, value: object) -> None:
    with pytest.raises(ValueError, match=f"{name} must be .*, not {value}"):
        solutions(laid("four-ball"), GAMES["four-ball"](), Turn(), EXPERT, **{name: value})


def test_the_smallest_budget_finds_nothing_and_fails_at_nothing() -> None:
    for budget in (1, 2, 10):
        assert len(found("four-ball", budget=budget)) <= 1


def test_a_level_may_be_named_by_its_key_and_a_wrong_one_is_refused_with_all_names() -> None:
    table, rules = laid("three-cushion"), GAMES["three-cushion"]()
    by_key = solutions(table, rules, Turn(), "expert", 400, compiled=False)
    assert by_key == solutions(table, rules, Turn(), EXPERT, 400, compiled=False)
    for wrong in ("pro", "", 0.35, None):
        with pytest.raises(ValueError, match="level must be a Level or one of novice, club"):
            solutions(table, rules, Turn(), wrong, 400)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("rules", "turn"),
    [("snooker", Turn()), (type(GAMES["snooker"]()), Turn()), (GAMES["snooker"](), "white")],
)
def test_rules_and_turns_that_are_none_are_refused(rules: object, turn: object) -> None:
    with pytest.raises(ValueError, match="solutions needs rules such as"):
        solutions(laid("three-cushion"), rules, turn, EXPERT)  # type: ignore[arg-type]


def test_a_way_is_shown_in_a_line() -> None:
    aim, tip = Attempt(10.0, 2.0), Tip.of(0.2, 0.1, 0.03)
    way = Solution(("red", "east"), aim, 0.5, 100, 0.5, None, 0.5, None, tip, None)
    assert repr(way) == "<Solution red east: 50 % ±5, tip 2 o'clock, 0.56 tips>"
