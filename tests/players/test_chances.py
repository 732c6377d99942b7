"""What a player sees of a table: which pots there are, and how likely each is."""

from math import cos, radians

import pytest

from danggu.players.chances import Eye
from danggu.players.levels import CLUB, EXPERT, LEVELS, MASTER
from physics import tables

NINE = tables.pool(9)
CORNER = "north-east pocket"


def seen(cue: complex, balls: dict[str, complex], level=EXPERT, targets=("1",)):
    ways = Eye(NINE, level).ways(cue, balls, targets)
    return {way.opening.hole.name: way for way in ways}


def test_a_ball_before_a_pocket_is_potted_there_and_not_backwards():
    found = seen(0.3 + 0.1j, {"1": 0.8 + 0.35j})
    assert max(found.values(), key=lambda way: way.chance).opening.hole.name == CORNER
    assert not {"north-west pocket", "south-west pocket"} & {*found}


def test_a_ball_in_the_way_of_either_ball_leaves_no_pot():
    lie = {"1": 0.8 + 0.35j}
    way = seen(0.3 + 0.1j, lie)[CORNER]
    at = lie["1"]
    assert CORNER not in seen(0.3 + 0.1j, {**lie, "2": 0.5 * (0.3 + 0.1j + way.ghost)})
    assert CORNER not in seen(0.3 + 0.1j, {**lie, "2": at + 0.12 * way.opening.way})
    assert CORNER in seen(0.3 + 0.1j, {**lie, "2": 0.5 + 0.5j})


def test_a_ball_beside_the_way_leaves_a_part_of_the_pocket():
    lie = {"1": 0.4 + 0.0j}
    plain = seen(0.0 - 0.2j, lie)[CORNER].opening
    side = plain.hole.middle - plain.way * 0.2 + 1j * plain.way * (NINE.radius * 2.4)
    partly = seen(0.0 - 0.2j, {**lie, "2": side})[CORNER].opening
    assert 0.2 * plain.half < partly.half < 0.9 * plain.half
    assert (partly.way * plain.way.conjugate()).imag < 0  # away from the ball that stands there


def test_thinner_farther_and_for_a_worse_player_a_pot_is_less_likely():
    def chance(cut: float, run: float, level) -> float:
        way = seen(-0.2 + 0j, {"1": 0.8 + 0.35j}, level)[CORNER]
        turn = complex(cos(radians(cut)), (1 - cos(radians(cut)) ** 2) ** 0.5)
        cue = way.ghost - run * way.opening.way * turn
        return seen(cue, {"1": 0.8 + 0.35j}, level)[CORNER].chance

    assert chance(0, 0.4, CLUB) > chance(40, 0.4, CLUB) > chance(60, 0.4, CLUB) > 0
    assert chance(0, 0.3, CLUB) > chance(0, 0.8, CLUB)
    ordered = [chance(20, 0.5, level) for level in LEVELS]
    assert ordered == sorted(ordered)


@pytest.mark.parametrize(("beside", "seen"), [(0.0, False), (0.3, False), (1.1, True), (2.5, True)])
def test_a_ball_can_be_hit_straight_unless_another_one_hides_all_of_it(beside, seen):
    eye = Eye(NINE, MASTER)
    line = (0.6 + 0.2j) / abs(0.6 + 0.2j)
    balls = {"1": 0.6 + 0.2j, "2": 0.2 * line + 1j * line * beside * eye.width}
    assert ("1" in eye.hittable(0j, balls, ("1",))) is seen
