"""The opening positions and the shelf: on the table, apart, and complete."""

from itertools import combinations
from math import dist

import pytest

from danggu.players.levels import Attempt
from danggu.players.positions import SAGU, SHELF, THREE_CUSHION, Position, opening, spotted
from danggu.rules.carom import Carom
from danggu.rules.sagu import Sagu
from danggu.rules.verdict import Turn
from physics import Ball, simulate, tables

TABLES = [(2.448, 1.27, 0.03275), (2.54, 1.27, 0.03275), (2.84, 1.42, 0.03075)]
OPENINGS = [opening(game, cue) for game in (SAGU, THREE_CUSHION) for cue in ("white", "yellow")]
L, W = 2.84, 1.42
LONG = {"north", "south"}


@pytest.mark.parametrize(("length", "width", "radius"), TABLES)
@pytest.mark.parametrize("position", [*SHELF, *OPENINGS], ids=lambda p: f"{p.game}-{p.key}")
def test_balls_lie_on_the_table_and_apart(
    position: Position, length: float, width: float, radius: float
) -> None:
    lie = position.on(length, width)
    for x, y in lie.values():
        assert abs(x) < length / 2 - radius
        assert abs(y) < width / 2 - radius
    for a, b in combinations(lie.values(), 2):
        assert dist(a, b) > 2 * radius


@pytest.mark.parametrize("position", [*SHELF, *OPENINGS], ids=lambda p: f"{p.game}-{p.key}")
def test_a_position_has_the_balls_of_its_game(position: Position) -> None:
    balls = Sagu().balls if position.game == SAGU else Carom().balls
    assert sorted(position.balls) == sorted(balls)


def test_positions_of_one_game_have_different_keys() -> None:
    names = [(p.game, p.key) for p in SHELF]
    assert len(set(names)) == len(names)
    assert {game for game, _ in names} == {SAGU, THREE_CUSHION}


def test_three_cushion_opens_with_the_balls_on_the_spots_of_the_federation() -> None:
    lie = opening(THREE_CUSHION).on(L, W)
    assert lie["red"] == (L / 4, 0)
    assert lie["yellow"] == (-L / 4, 0)
    assert lie["white"] == pytest.approx((-L / 4, -0.1825))


def test_the_opening_of_four_ball_looks_the_same_from_both_ends() -> None:
    lie = opening(SAGU, "yellow").on(L, W)
    turned = {name: (-x, -y) for name, (x, y) in opening(SAGU, "white").on(L, W).items()}
    assert turned["white"] == pytest.approx(lie["white"])
    assert turned["red1"] == pytest.approx(lie["red2"])


def test_balls_off_the_table_come_back_on_their_spots() -> None:
    lie = {"white": (0.5, 0.5), "yellow": (9.0, 9.0), "red": (9.0, 9.0)}
    back = spotted(lie, ("red", "yellow"), "yellow", L, W, 0.0615)
    assert back == {"white": (0.5, 0.5), "red": (L / 4, 0), "yellow": (-L / 4, 0)}


def test_a_ball_whose_spot_is_covered_goes_to_the_next_free_one() -> None:
    lie = {"white": (L / 4, 0.03), "yellow": (1.0, 0.5), "red": (9.0, 9.0)}
    assert spotted(lie, ("red",), "yellow", L, W, 0.0615)["red"] == (-L / 4, 0)


@pytest.mark.parametrize("position", [*SHELF, *OPENINGS], ids=lambda p: f"{p.game}-{p.key}")
def test_the_answer_of_a_position_scores_the_way_it_says(position: Position) -> None:
    four = position.game == SAGU
    table = tables.MEDIUM_CAROM if four else tables.MATCH_CAROM_2
    world = table.world()
    for name, at in position.on(table.length, table.width).items():
        world.add(Ball(name, at=at, radius=table.radius, mass=table.mass))
    after = simulate(world, position.cue, Attempt(*position.answer).shot())
    turn = Turn(position.cue, opening=position.key == "opening")
    verdict = (Sagu() if four else Carom()).verdict(after.log, turn)
    assert verdict.made
    assert verdict.facts.path == position.way


def test_the_ways_are_the_shots_that_the_names_promise() -> None:
    ways = {p.key: p.way for p in SHELF}
    for key in ("follow", "draw", "stun", "gather", "rail_nurse"):
        assert ways[key] == ("red1", "red2")
    ups = {p.key: p.answer[3] for p in SHELF}
    assert ups["follow"] > 0.15 > -0.15 > ups["draw"]
    assert [len(ways[key]) for key in ("one_cushion", "two_cushions", "around")] == [3, 4, 6]
    assert ways["outside"][1] in LONG  # behind the ball: long, short, long
    assert ways["inside"][1] not in LONG  # in front of it: short, long, short
    assert set(ways["cross_table"][1:-1]) == LONG
    balls = {"white", "yellow", "red", "red1", "red2"}
    first = {
        key: next(i for i, what in enumerate(way) if what in balls) for key, way in ways.items()
    }
    assert (first["bank"], first["bank_one"], first["bank_three"]) == (1, 1, 3)
