"""Whole frames of the computer against itself."""

import pytest

from danggu.players.levels import EXPERT, MASTER
from danggu.rules.match import Match
from danggu.rules.snooker import COLOUR
from danggu.rules.state import BREAK, SECOND, Call

from .frames import RACKS, Frame, frame

MOST = {"14.1": 250, "snooker": 400, "free-pyramid": 400, "dynamic-pyramid": 500,
        "combined-pyramid": 500}  # fmt: skip
TARGETS = {"14.1": 30}
CALLED = {"eight_ball", "ten_ball", "straight_pool"}
RUN_OUT = 46
"""A seed with which a master breaks and runs out in 9-ball."""


def may(match: Match, call: Call) -> bool:
    """Is no more declared than the game asks for?"""
    key, state = match.rules.key, match.state
    called = key in CALLED and (state.phase != BREAK or key == "straight_pool")
    named = called or (key == "snooker" and (state.free or state.on == COLOUR))
    return (
        (not call.ball or (named and call.ball in state.left))
        and (not (call.pocket or call.safety) or called)
        and (not call.push or (key in ("nine_ball", "ten_ball") and state.phase == SECOND))
        and (not call.cue or key == "free_pyramid")
    )


def check(played: Frame) -> None:
    assert played.match.finished
    assert all(may(stroke.match, stroke.plan.call) for stroke in played.strokes)
    share = sum(stroke.verdict.foul for stroke in played.strokes) / len(played.strokes)
    assert share < 0.3


def test_a_rack_of_nine_ball_comes_to_an_end():
    check(frame("9-ball", (MASTER, EXPERT), 3, effort=40, most=60))


@pytest.mark.stress
@pytest.mark.parametrize("level", [EXPERT, MASTER], ids=lambda level: level.key)
@pytest.mark.parametrize("game", RACKS)
def test_a_frame_of_each_game_comes_to_an_end(game, level):
    check(frame(game, (level, level), 1, 150, MOST.get(game, 150), TARGETS.get(game)))


@pytest.mark.stress
def test_a_master_runs_out_nine_ball_with_this_seed():
    played = frame("9-ball", (MASTER, MASTER), RUN_OUT, effort=300, alone=True)
    assert played.match.winner == 0
    assert all(stroke.verdict.made for stroke in played.strokes)
    assert sum(len(stroke.verdict.down) for stroke in played.strokes) == 9
