"""What the computer answers when a player is asked."""

from dataclasses import replace

import pytest

from danggu.players.answers import answer
from danggu.players.levels import CLUB, MASTER
from danggu.rules import GAMES, pool
from danggu.rules.match import Match
from danggu.rules.state import PLAY, Option, Question
from danggu.rules.stroke import Drop, Rail, Stroke, Touch
from physics import World

from .frames import racked
from .test_potter import lying


def asked(world: World, match: Match, done: Stroke) -> tuple[World, Match]:
    """The match after that stroke, with its question."""
    after = match.after(match.ruled(done))
    assert after.asked is not None
    return world, after


def hit(ball: str, *down: str, rails: int = 0) -> Stroke:
    touches = (Touch(0.5, ball, cushion=False),) if ball else ()
    drops = tuple(Drop(1.0, name, "north pocket") for name in down)
    met = tuple(Rail(1.0, str(k + 1), "east") for k in range(rails))
    return Stroke(touches, cue="cue", rails=met, pocketed=drops)


def snooker() -> tuple[World, Match]:
    world, match = racked("snooker")
    return world, replace(match, state=replace(match.state, region=""))


CASES = {
    "illegal break": lambda: asked(*racked("8-ball"), hit("1")),
    "scratch on the break": lambda: asked(*racked("8-ball"), hit("1", "cue", "3", rails=5)),
    "8 on the break": lambda: asked(*racked("8-ball"), hit("1", "8")),
    "8 and scratch on the break": lambda: asked(*racked("8-ball"), hit("1", "8", "cue")),
    "breaking foul": lambda: asked(*racked("14.1"), hit("1")),
    "miss": lambda: asked(*snooker(), hit("blue", rails=1)),
    "no ball": lambda: asked(*snooker(), hit("")),
    "own ball down": lambda: asked(*racked("dynamic-pyramid"), hit("1", "cue")),
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("level", [CLUB, MASTER], ids=lambda level: level.key)
def test_every_question_is_answered_with_one_of_its_options(case, level):
    world, match = CASES[case]()
    key = answer(world, match, level)
    assert key in [option.key for option in match.asked.options]
    match.answered(key)


def push(cue: complex) -> tuple[World, Match]:
    """After a push out that left the cue ball there."""
    lie = {"cue": cue, "1": 0.85 + 0.4j, "2": 0.75 + 0.3j, "9": -0.5 + 0.3j}
    world, match = lying(lie)
    state = replace(match.state, phase=PLAY)
    return world, replace(match, asked=pool.shoot_or_return(state))


def test_after_a_push_out_it_shoots_what_it_can_pot_and_gives_back_what_it_cannot_see():
    assert answer(*push(0.6 + 0.35j), MASTER) == "shoot"
    assert answer(*push(0.55 + 0.2j), MASTER) == pool.AGAIN


def test_of_balls_that_it_may_remove_it_leaves_itself_a_pot():
    world, match = racked("dynamic-pyramid")
    options = tuple(Option(name, True, replace(match.state, left=("1", "2"))) for name in "34")
    assert answer(world, replace(match, asked=Question(options)), MASTER) == "3"


def test_no_question_is_an_error():
    world, match = racked("9-ball")
    with pytest.raises(ValueError, match="no question"):
        answer(world, match, MASTER)
    assert match.rules.key == GAMES["9-ball"]().key
