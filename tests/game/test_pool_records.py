"""Records of games with pockets come out the same, computers and questions included."""

import pytest

from game.__main__ import new_game
from game.options import Options
from game.replay import game_record
from game.replay.recorder import Recorder
from game.replay.replay import headless
from game.session import terms
from game.session.action import Action
from game.session.commands import perform
from tests.support.racked_games import RACKED, played
from tests.support.sampling import mostly


class Recorded:
    """A session whose actions are written down."""

    def __init__(self, path, game):
        table = terms.DISCIPLINES[game].table
        options = Options(game=game, table=table, given=frozenset({"game", "table"}), seed=5)
        self.session = new_game(options)
        self.recorder = Recorder(str(path), options, self.session)


@pytest.mark.parametrize("game", mostly(RACKED, quick=("10-ball", "snooker")))
def test_a_record_of_a_match_with_pockets_comes_out_the_same(tmp_path, monkeypatch, game):
    path = tmp_path / "game.txt"
    made = Recorded(path, game)

    def noted(session, action):
        made.recorder.before(action)
        perform(session, action)
        made.recorder.after()

    monkeypatch.setattr("tests.support.racked_games.perform", noted)
    list(played(made.session, 11, 6))
    noted(made.session, Action("undo"))
    noted(made.session, Action("redo"))
    made.recorder.close()
    record = game_record.read(str(path), Options())
    replay = headless(record, new_game(record.setup))
    assert replay.state == "same"
    assert replay.session.world.layout() == made.session.world.layout()
    assert replay.session.contest.match == made.session.contest.match
