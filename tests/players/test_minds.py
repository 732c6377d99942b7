"""What an opponent is asked for: a stroke with its call, a place in hand, an answer."""

from random import Random

import pytest

from danggu.players.answers import answer
from danggu.players.hand import hindrance, usual
from danggu.players.levels import EXPERT, PERFECT
from danggu.players.minds import mind
from danggu.players.potter import Potter
from danggu.rules import RACKS
from danggu.rules.match import Match
from danggu.rules.state import ANYWHERE, KITCHEN, Option, Question
from danggu.rules.verdict import Verdict
from physics import simulate

from .frames import racked


@pytest.mark.parametrize("game", RACKS)
def test_an_opponent_of_each_game_has_a_stroke_a_call_and_a_place(game):
    world, match = racked(game)
    thinker = mind(world, match, EXPERT, 1, 20)
    assert isinstance(thinker, Potter)
    while not thinker.think(0.0):
        pass
    plan = thinker.played(Random(2))
    assert plan.shot.speed > 0
    if plan.place is not None:
        assert hindrance(world, match.cue, plan.place, match.state.region) is None
        world.ball(match.cue).position = plan.place
    after = simulate(world, match.called(plan.call).cue, plan.shot)
    assert isinstance(match.called(plan.call).judged(after.log.contacts()), Verdict)


def test_the_plan_does_not_depend_on_how_long_each_thought_is():
    world, match = racked("9-ball")
    plans = []
    for budget in (0.0, 10.0):
        thinker = mind(world, match, PERFECT, 3, 20)
        while not thinker.think(budget):
            pass
        plans.append(thinker.plan)
    assert plans[0] == plans[1]


def test_a_question_is_answered_with_one_of_its_options():
    world, match = racked("8-ball")
    options = Option("accept", True, match.state), Option("rerack", True, match.state, 15)
    asked = Match(
        match.rules, match.players, match.sheets, state=match.state, asked=Question(options)
    )
    assert answer(world, asked, EXPERT) in ("accept", "rerack")
    with pytest.raises(ValueError, match="no question"):
        answer(world, match, EXPERT)


def test_a_ball_in_hand_is_placed_in_its_region_and_beside_what_lies_there():
    world, _ = racked("8-ball")
    x, y = world.table.spots["head"]
    assert usual(world, "cue", ANYWHERE) == (x, y)
    world.ball("1").position = (x, y)
    assert hindrance(world, "cue", (x, y), ANYWHERE).ball == "1"
    found = usual(world, "cue", KITCHEN)
    assert hindrance(world, "cue", found, KITCHEN) is None
    assert hindrance(world, "cue", (0.1, 0.0), KITCHEN).why == "region"
