"""The opponent of games with pockets: pots, position, safeties, breaks, levels."""

from dataclasses import replace
from random import Random

import pytest

from danggu.players.chances import Eye
from danggu.players.hand import hindrance
from danggu.players.levels import CLUB, EXPERT, MASTER, NOVICE, PERFECT, Level
from danggu.players.potter import Potter
from danggu.rules import GAMES
from danggu.rules.eight_ball import SOLIDS, STRIPES
from danggu.rules.match import Match, Player, Sheet
from danggu.rules.state import ANYWHERE, PLAY, SECOND
from physics import Ball, World, simulate, tables

from .frames import RACKS, placed, racked, thought

NINE = tables.pool(9)
SHORT = 120  # strokes tried: enough for what is looked for here


def lying(balls: dict[str, complex], game: str = "9-ball", **state) -> tuple[World, Match]:
    """A match in the middle of play, with balls where they are put; the cue ball is "cue"."""
    table = tables.SNOOKER_12FT if game == "snooker" else NINE
    world = table.world()
    for name, at in balls.items():
        world.add(Ball(name, (at.real, at.imag)))
    left = tuple(name for name in balls if name != "cue")
    match = Match.of(GAMES[game](), Player("a"), Player("b"))
    stands = replace(match.state, phase=PLAY, region="", left=left)
    sheets = (Sheet(strokes=3, innings=1),) * 2
    return world, replace(match, state=replace(stands, **state), sheets=sheets)


def played(world: World, match: Match, mind: Potter, rng: Random | None = None):
    """The verdict on the stroke as it is meant, or with an error, and the world after it."""
    plan = mind.plan if rng is None else mind.played(rng)
    match = match.called(plan.call)
    after = simulate(placed(world.copy(), match, plan), match.cue, plan.shot)
    return match.judged(after.log.contacts()), after


def made(world: World, match: Match, level: Level, strokes: int, effort: int = SHORT) -> int:
    """How many of its strokes score, of those with its error."""
    mind, rng = thought(world, match, level, 1, effort), Random(7)
    return sum(played(world, match, mind, rng)[0].made for _ in range(strokes))


STRAIGHT = [
    {"cue": 0.62 + 0.0j, "1": 0.82 + 0.2j, "9": -0.6 + 0.3j},
    {"cue": -0.1 + 0.0j, "1": -0.06 + 0.28j, "9": 0.9 - 0.3j},
    {"cue": -0.72 - 0.1j, "1": -0.92 - 0.3j, "9": 0.2 + 0.1j},
]


@pytest.mark.parametrize("lie", STRAIGHT, ids=["corner", "side", "other corner"])
def test_an_expert_pots_a_straight_ball_a_hand_away_nineteen_times_of_twenty(lie):
    world, match = lying(lie)
    assert made(world, match, EXPERT, 40) >= 38


def test_it_wins_with_the_last_ball():
    for game, lie, state in (
        ("9-ball", {"cue": 0.2 + 0.1j, "9": 0.7 + 0.3j}, {}),
        ("10-ball", {"cue": 0.2 + 0.1j, "10": 0.7 + 0.3j}, {}),
        ("8-ball", {"cue": 0.2 + 0.1j, "8": 0.7 + 0.3j, "9": -0.5 + 0.3j},
         {"groups": (SOLIDS, STRIPES)}),
    ):  # fmt: skip
        world, match = lying(lie, game, **state)
        verdict, _ = played(world, match, thought(world, match, MASTER, 1, SHORT))
        assert verdict.won, game


def test_it_combines_balls_or_plays_another_way_but_hits_the_lowest_first():
    world, match = lying({"cue": -0.4 + 0j, "3": 0.3 + 0.2j, "5": 0.9 + 0.4j, "9": 0.2 - 0.3j})
    verdict, _ = played(world, match, thought(world, match, MASTER, 1, SHORT))
    assert verdict.facts.hits[0] == "3"


def test_it_plays_for_position_and_a_novice_does_not():
    world, match = lying({"cue": 0.35 + 0.15j, "1": 0.85 + 0.4j, "2": -0.8 + 0.3j, "9": 0.1 - 0.4j})
    eye, left = Eye(NINE, MASTER), []
    for level in (NOVICE, MASTER):
        mind = Potter(world, match, level, 1, 300)
        while not mind.think(1.0):
            pass
        verdict, after = played(world, match, mind)
        assert verdict.made
        balls = {ball.name: complex(*ball.position) for ball in after.balls if not ball.gone}
        cue = balls.pop("cue")
        left.append(max((way.chance for way in eye.ways(cue, balls, ("2",))), default=0.0))
    assert left[1] > 0.9
    assert left[1] > left[0] + 0.2


def test_without_a_pot_it_leaves_the_next_player_none():
    lie = {"cue": 0.9 - 0.55j, "1": -0.4 - 0.6j, "5": 0.3 - 0.3j, "7": -0.7 - 0.3j, "9": 0.2 + 0.2j}
    world, match = lying(lie)
    eye = Eye(NINE, MASTER)
    mind = thought(world, match, MASTER, 1, 250)
    verdict, after = played(world, match, mind)
    balls = {ball.name: complex(*ball.position) for ball in after.balls if not ball.gone}
    ways = eye.ways(balls.pop("cue"), balls, ("1",))
    assert not verdict.foul
    assert not mind.chosen.pots
    assert max((way.chance for way in ways), default=0.0) < 0.5 * eye.usual()


def test_snookered_it_finds_a_way_by_a_cushion():
    hidden = {"cue": -0.8 + 0.1j, "1": 0.6 + 0.1j, "5": -0.7 + 0.1j, "9": 0.1 - 0.4j}
    world, match = lying(hidden)
    assert not Eye(NINE, MASTER).hittable(-0.8 + 0.1j, {"1": 0.6 + 0.1j, "5": -0.7 + 0.1j}, ("1",))
    verdict, _ = played(world, match, thought(world, match, MASTER, 1, 300))
    assert not verdict.foul


def test_snookered_after_the_break_it_pushes_out():
    ring = {
        str(k): -0.8 + 0.1j + 0.0643 * w
        for k, w in (
            (5, 1 + 0j),
            (6, 0.5 + 0.87j),
            (7, 0.5 - 0.87j),
            (8, -0.5 + 0.87j),
            (4, -0.5 - 0.87j),
        )
    }
    world, match = lying(
        {"cue": -0.8 + 0.1j, "1": 0.9 + 0.1j, **ring, "9": 0.1 - 0.4j}, phase=SECOND
    )
    mind = thought(world, match, MASTER, 1, 300)
    assert mind.plan.call.push
    assert played(world, match, mind)[0].question is not None


def test_a_bank_is_played_where_no_ball_goes_straight():
    # the ball before the cushion has two others beside its ways, and the pockets behind it
    lie = {"cue": 0.0 - 0.2j, "8": 0.05 + 0.35j}
    shut = {"9": 0.02 + 0.5j, "10": 0.55 + 0.49j, "11": -0.5 + 0.49j}
    world, match = lying({**lie, **shut}, "8-ball", groups=(SOLIDS, STRIPES))
    assert not [*Eye(NINE, PERFECT).ways(lie["cue"], {**shut, "8": lie["8"]}, ("8",))]
    mind = thought(world, match, PERFECT, 1, 250)
    verdict, after = played(world, match, mind)
    rails = [c for c in after.log.contacts() if c.kind == "cushion" and c.balls == ("8",)]
    assert verdict.won
    assert rails


@pytest.mark.parametrize("game", RACKS)
def test_the_break_of_each_game_is_legal_and_placed_where_it_may_be(game):
    world, match = racked(game)
    mind = thought(world, match, MASTER, 2, 20)
    plan = mind.plan
    assert plan.place is not None
    assert hindrance(world, match.cue, plan.place, match.state.region) is None
    verdict, _ = played(world, match, mind)
    assert not verdict.foul
    assert not verdict.lost


def test_a_ball_in_hand_is_put_where_a_pot_is_easy():
    lie = {"cue": -1.1 + 0.5j, "1": 0.7 + 0.1j, "2": 0.1 + 0.3j, "9": -0.6 - 0.3j}
    world, match = lying(lie, region=ANYWHERE)
    mind, rng = thought(world, match, EXPERT, 1, SHORT), Random(7)
    assert mind.plan.place is not None
    assert hindrance(world, "cue", mind.plan.place, ANYWHERE) is None
    assert sum(played(world, match, mind, rng)[0].made for _ in range(20)) >= 15


def test_in_snooker_it_names_a_colour_and_hits_it():
    spots = {name: complex(*at) for name, at in tables.SNOOKER_12FT.spots.items()}
    lie = {"cue": 1.2 + 0.3j, "red1": 0.6 - 0.5j, **spots}
    world, match = lying(lie, "snooker", on="colour")
    mind = thought(world, match, MASTER, 1, SHORT)
    verdict, _ = played(world, match, mind)
    assert mind.plan.call.ball in spots
    assert not verdict.foul
    assert verdict.facts.hits[0] == mind.plan.call.ball


def test_in_free_pyramid_any_ball_may_be_the_one_that_is_played():
    world, match = racked("free-pyramid")
    at = {"3": (0.9, 0.3), "4": (1.4, 0.72)}
    for ball in world.balls:
        if ball.name in at:
            ball.position = at[ball.name]
    world.ball("cue").position = (-1.5, 0.0)
    state = replace(match.state, phase=PLAY, region="")
    match = replace(match, state=state, sheets=(Sheet(strokes=1, innings=1),) * 2)
    mind = thought(world, match, MASTER, 1, 80)
    assert mind.plan.call.cue not in ("", "cue")
    assert not played(world, match, mind)[0].foul


def test_the_plan_depends_on_the_seed_and_not_on_the_budgets():
    world, match = lying({"cue": -0.9 + 0.35j, "1": 1.2 + 0.02j, "5": 0.5 - 0.1j, "9": -0.3 + 0j})
    at_once, bit_by_bit = (Potter(world, match, EXPERT, 4, SHORT) for _ in range(2))
    while not at_once.think(10.0):
        pass
    while not bit_by_bit.think(0.0):
        pass
    assert at_once.plan == bit_by_bit.plan
    assert at_once.share == bit_by_bit.share
    assert at_once.played(Random(3)) == bit_by_bit.played(Random(3))


def test_it_has_a_plan_before_it_thinks_and_thinks_in_steps_of_one_stroke():
    world, match = lying(STRAIGHT[0])
    mind = Potter(world, match, EXPERT, 1, 60)
    assert mind.plan.shot.speed > 0
    assert mind.share is None
    before = -1
    while not mind.think(0.0):
        assert mind.tried - before <= 1 or before < 0  # it first measures the table
        before = mind.tried
    assert mind.tried <= 60 + 15 + 1  # what it plays is measured after the search
    assert 0.0 <= mind.share <= 1.0


def test_thinking_leaves_the_table_as_it_is():
    world, match = racked("9-ball")
    before = {ball.name: ball.position for ball in world.balls}
    thought(world, match, EXPERT, 1, 40)
    assert {ball.name: ball.position for ball in world.balls} == before
    assert len(world.log) == 0


def test_better_levels_pot_more():
    rng, lies = Random(11), []
    while len(lies) < 5:
        at = {
            name: complex(rng.uniform(-1.1, 1.1), rng.uniform(-0.5, 0.5))
            for name in ("cue", "1", "9")
        }
        ways = [*Eye(NINE, MASTER).ways(at["cue"], {"1": at["1"], "9": at["9"]}, ("1",))]
        if min(abs(at["cue"] - at["1"]), abs(at["9"] - at["1"])) > 0.1 and ways:
            lies.append(at)
    rates = [
        sum(made(*lying(lie), level, 8, 40) for lie in lies)
        for level in (NOVICE, CLUB, EXPERT, MASTER)
    ]
    assert rates == sorted(rates)
    assert rates[-1] > 2 * rates[0]
