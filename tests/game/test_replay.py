"""Records: the same game again at any frame rate, and how it is to watch one."""

import random
from dataclasses import replace

import pytest

from game.__main__ import new_game
from game.app import App
from game.computer.thinker import Thinker
from game.input.bindings import DEFAULTS
from game.replay.game_record import RecordError, Witness, digest, read
from game.replay.recorder import Recorder
from game.replay.replay import Replay, headless
from game.session.action import Action
from game.session.commands import perform
from game.session.terms import FOUR_BALL, SEATS, Contestant, Terms
from tests.support.players import FRAME, press, write
from tests.support.records import OPTIONS, lines, recorded, replayed, rewritten, shown

pytestmark = pytest.mark.usefixtures("undrawn")


@pytest.fixture(scope="module")
def record(tmp_path_factory):
    return recorded(tmp_path_factory.mktemp("record"))


# -- the same again ------------------------------------------------------------------------------


def test_a_record_has_a_header_actions_a_digest_for_each_shot_and_an_end(record):
    head, *found = lines(record)
    assert head["setup"]["seed"] == 7
    assert [line["shot"] for line in found if "shot" in line] == [1, 2, 3, 4, 5]
    assert found[0]["do"] == ["shoot"]
    assert set(found[-1]) == {"tick", "end"}
    ticks = [line["tick"] for line in found]
    assert ticks == sorted(ticks)


@pytest.mark.parametrize("fps", ["30", "60", "144"])
def test_a_record_comes_out_the_same_at_every_frame_rate(record, fps, capsys):
    assert shown(record, "--fps", fps) == 0
    assert "the same, shots: 5" in capsys.readouterr().out


def test_a_record_comes_out_the_same_without_a_window(record, capsys):
    assert replayed(record) == 0
    assert "the same, shots: 5" in capsys.readouterr().out


@pytest.mark.parametrize("substeps", ["1", "7"])
def test_substeps_are_taken_from_the_record_and_would_change_nothing(record, tmp_path, substeps):
    def change(found):
        found[0]["setup"]["substeps"] = int(substeps)

    assert replayed(rewritten(record, tmp_path, change)) == 0


def test_the_digest_tells_the_last_bit_but_not_the_sign_of_zero():
    session = new_game(OPTIONS)
    before, ball = digest(session), session.world.balls[0]
    x, y = ball.position
    ball.velocity = (-0.0, 0.0)
    assert digest(session) == before
    ball.position = (x * (1 + 2**-52), y)
    assert digest(session) != before


ANYTHING = [
    *(b.key for b in DEFAULTS.values()), "return", "ctrl+return", "shift+period", "shift+z", "tab",
    "escape", "ctrl+q", "shift+w", "return", "return",
]  # fmt: skip


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_whatever_is_pressed_can_be_replayed(tmp_path, seed):
    rng, path = random.Random(seed), tmp_path / "game.rec"
    session = new_game(OPTIONS)
    app = App(session, OPTIONS, journal=Recorder(str(path), OPTIONS, session))
    app.exports = app.view.labs.folder = tmp_path
    for _ in range(300):  # a fifth of the keys leaves nothing in a record
        if rng.random() < 0.3:
            write(app, rng.choice("0123456789.-"))
        else:
            press(app, rng.choice(ANYTHING))
        app.frame(rng.randrange(4 * FRAME))
    app.close()
    played = read(str(path), OPTIONS)
    replay = headless(played, new_game(played.setup))
    assert len(played.actions) > 50
    assert replay.state == "same", replay.verdict()


def test_every_way_a_shot_can_end_is_told_once():
    session, told = new_game(OPTIONS), []
    witness = Witness(session, lambda tick, found: told.append(found))

    def act(*names):
        for name in names:
            witness.before()
            perform(session, Action(name))
            witness.after()

    act("shoot")
    assert told == []
    session.advance(60 * FRAME)
    witness.passed()
    act("stop")
    assert len(told) == 1
    act("fire", "fire")
    assert len(told) == 2
    act("skip")
    assert len(told) == 3
    act("fire")
    session.advance(3000 * FRAME)
    witness.passed()
    witness.passed()
    assert len(told) == len(set(told)) == 4


def test_the_present_is_caught_up_with_at_the_same_tick_at_every_frame_rate():
    """A shot looked at once more while it runs goes on where it was, whatever frames are left."""
    ends = set()
    steps = ("shoot", 20), ("faster -1", 20), ("home", 0), ("pause", 60), ("stop", 0)
    for frame in (FRAME, 2 * FRAME, 7 * FRAME // 3):
        session = new_game(OPTIONS)
        for said, frames in steps:
            name, *value = said.split()
            perform(session, Action(name, *map(int, value)))
            left = frames * FRAME
            while left:
                session.advance(min(frame, left))
                left -= min(frame, left)
        ends.add(digest(session))
    assert len(ends) == 1


def test_a_match_against_the_computer_is_replayed_without_its_thinking(tmp_path, monkeypatch):
    path, session = tmp_path / "game.rec", new_game(OPTIONS)
    app = App(session, OPTIONS, journal=Recorder(str(path), OPTIONS, session))
    seats = (Contestant(), Contestant(level=SEATS[1]))
    app.perform(Action("match", Terms(FOUR_BALL, seats).line()))
    for _ in range(6):
        press(app, "return")
        app.frame(FRAME)
        press(app, "end")
    app.close()
    played = read(str(path), OPTIONS)
    assert "play" in [action.name for _, action in played.actions]
    monkeypatch.setattr(Thinker, "think", None)
    replay = headless(played, new_game(played.setup))
    assert replay.state == "same", replay.verdict()
    assert len(played.shots) > 2
    shown = new_game(played.setup)
    app = App(shown, played.setup, journal=Replay(played, shown))
    while not app.replay.done:
        app.frame(5 * FRAME)
    assert app.replay.state == "same", app.replay.verdict()


def test_every_line_is_in_the_file_as_soon_as_it_has_happened(tmp_path):
    path = tmp_path / "game.rec"
    session = new_game(OPTIONS)
    app = App(session, OPTIONS, journal=Recorder(str(path), OPTIONS, session))
    press(app, "return")
    assert [line["do"] for line in lines(path)[1:]] == [["shoot"]]
    app.close()


# -- watching ------------------------------------------------------------------------------------


@pytest.fixture
def watched(record):
    options = replace(OPTIONS, frames=None)
    played = read(str(record), options)
    session = new_game(played.setup)
    return App(session, played.setup, journal=Replay(played, session))


def test_a_replay_can_be_held_and_goes_on(watched):
    for _ in range(30):
        watched.frame(FRAME)
    press(watched, "p")
    tick = watched.session.tick
    for _ in range(30):
        watched.frame(FRAME)
    assert watched.session.tick == tick
    assert watched.session.notice.key == "replay.paused"
    press(watched, "space")
    watched.frame(FRAME)
    assert watched.session.tick > tick


def test_nothing_that_is_pressed_or_typed_reaches_the_game_of_a_replay(watched):
    for name in ("down", "r", "e", "right", "return", "f1", "f3", "3"):
        press(watched, name)
    write(watched, "5")
    while not watched.replay.done:
        watched.frame(20 * FRAME)
    assert watched.replay.state == "same"
    assert watched.session.notice.key == "replay.same"
    assert not watched.session.over


def test_escape_leaves_a_replay_and_the_verdict_says_how_far_it_was(watched):
    press(watched, "escape")
    assert watched.session.over
    assert watched.replay.verdict() == "left after 0 of 5 shots, the same so far"


def test_an_action_that_cannot_be_done_names_its_tick(record):
    played = read(str(record), OPTIONS)
    replay = Replay(played, new_game(played.setup))
    with pytest.raises(RecordError, match="tick 0"):
        replay.perform(Action("dance"))
