"""Records: the same game again at any frame rate, and what is said when it is not the same."""

import json
import random
from dataclasses import replace

import pytest
from players import FRAME, press, write

from game import __main__ as entry
from game.__main__ import new_game
from game.actions import Action
from game.app import App
from game.fixture import FOUR_BALL, SEATS, Fixture, Seat
from game.keys import DEFAULTS
from game.options import Options
from game.record import Recorder, RecordError, Witness, digest, read
from game.replay import Replay, headless
from game.thinker import Thinker
from game.ui.view import View

OPTIONS = replace(Options(), size=(640, 360), frames=10**6)
SHOTS = """
0.10 key return
1.37 key right
1.37 text 2
1.37 key return
1.37 text 0
1.37 key return
1.37 text 1
1.37 key return
1.37 text -1
1.37 key return
1.37 text 200
1.37 key return
1.50 key return
12.0 key l
12.1 key ctrl+return
13.0 key p
13.5 key p
14.0 key f1
14.3 key f1
15.3 key space
15.4 key down
15.5 key ctrl+return
15.9 key r
16.0 key e
16.1 key ctrl+return
16.4 key end
16.7 key ctrl+return
17.2 quit
"""


@pytest.fixture(scope="module", autouse=True)
def _undrawn():
    """Drawing changes nothing, and takes most of the time."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(View, "draw", lambda view, surface: [])
        yield


@pytest.fixture(scope="module")
def record(tmp_path_factory):
    """A record of shots that come to rest, are cut off by the next, stopped, undone and skipped."""
    folder = tmp_path_factory.mktemp("record")
    script = folder / "script.txt"
    script.write_text(SHOTS, encoding="utf-8")
    path = folder / "game.rec"
    said = ["--script", str(script), "--record", str(path), "--seed", "7"]
    assert entry.main([*said, "--size", "640x360", "--frames", "100000"]) == 0
    return path


def lines(path):
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def rewritten(path, folder, change):
    """A copy of a record in which `change` has been made to its lines."""
    found = lines(path)
    change(found)
    copy = folder / "changed.rec"
    copy.write_text("".join(json.dumps(line) + "\n" for line in found), encoding="utf-8")
    return copy


def replayed(path):
    """The exit code of a replay without a window."""
    return entry.main(["--replay", str(path), "--headless"])


def shown(path, *more):
    """The exit code of a replay in a window."""
    return entry.main(["--replay", str(path), "--size", "640x360", "--frames", "100000", *more])


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
    game = new_game(OPTIONS)
    before, ball = digest(game), game.world.balls[0]
    x, y = ball.position
    ball.velocity = (-0.0, 0.0)
    assert digest(game) == before
    ball.position = (x * (1 + 2**-52), y)
    assert digest(game) != before


ANYTHING = [
    *(b.key for b in DEFAULTS.values()), "return", "ctrl+return", "shift+period", "shift+z", "tab",
    "escape", "ctrl+q", "shift+w", "return", "return",
]  # fmt: skip


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_whatever_is_pressed_can_be_replayed(tmp_path, seed):
    rng, path = random.Random(seed), tmp_path / "game.rec"
    game = new_game(OPTIONS)
    app = App(game, OPTIONS, journal=Recorder(str(path), OPTIONS, game))
    for _ in range(250):
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
    game, told = new_game(OPTIONS), []
    witness = Witness(game, lambda tick, found: told.append(found))

    def act(*names):
        for name in names:
            witness.before()
            game.perform(Action(name))
            witness.after()

    act("shoot")
    assert told == []
    game.advance(60 * FRAME)
    witness.passed()
    act("stop")
    assert len(told) == 1
    act("fire", "fire")
    assert len(told) == 2
    act("skip")
    assert len(told) == 3
    act("fire")
    game.advance(3000 * FRAME)
    witness.passed()
    witness.passed()
    assert len(told) == len(set(told)) == 4


def test_the_present_is_caught_up_with_at_the_same_tick_at_every_frame_rate():
    """A shot looked at once more while it runs goes on where it was, whatever frames are left."""
    ends = set()
    steps = ("shoot", 20), ("faster -1", 20), ("home", 0), ("pause", 60), ("stop", 0)
    for frame in (FRAME, 2 * FRAME, 7 * FRAME // 3):
        game = new_game(OPTIONS)
        for said, frames in steps:
            name, *value = said.split()
            game.perform(Action(name, *map(int, value)))
            left = frames * FRAME
            while left:
                game.advance(min(frame, left))
                left -= min(frame, left)
        ends.add(digest(game))
    assert len(ends) == 1


def test_a_match_against_the_computer_is_replayed_without_its_thinking(tmp_path, monkeypatch):
    path, game = tmp_path / "game.rec", new_game(OPTIONS)
    app = App(game, OPTIONS, journal=Recorder(str(path), OPTIONS, game))
    seats = (Seat(), Seat(level=SEATS[1]))
    app.perform(Action("match", Fixture(FOUR_BALL, seats).line()))
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


# -- not the same --------------------------------------------------------------------------------


def test_the_first_shot_that_differs_is_named(record, tmp_path, capsys):
    def change(found):
        shots = [line for line in found if "shot" in line]
        shots[2]["digest"] = shots[3]["digest"] = "0" * 32

    changed = rewritten(record, tmp_path, change)
    assert replayed(changed) == 3
    assert "shot 3 of 5 came out differently" in capsys.readouterr().err
    assert shown(changed) == 3
    assert "recorded with danggu" in capsys.readouterr().err


def test_another_angle_by_a_hair_is_noticed_in_its_shot(record, tmp_path, capsys):
    def change(found):
        typed = [line for line in found if line.get("do", [""])[0] == "type"]
        assert "".join(line["do"][1] for line in typed) == "201-1200"
        typed[-1]["do"][1] = "0.0000000001"

    assert replayed(rewritten(record, tmp_path, change)) == 3
    assert "shot 2 of 5" in capsys.readouterr().err


def test_another_seed_is_noticed_where_balls_were_placed_by_it(record, tmp_path, capsys):
    def change(found):
        found[0]["setup"]["seed"] = 8

    assert replayed(rewritten(record, tmp_path, change)) == 3
    assert "shot 4 of 5" in capsys.readouterr().err


def test_another_end_is_noticed(record, tmp_path, capsys):
    def change(found):
        found[-1]["end"] = "0" * 32

    assert replayed(rewritten(record, tmp_path, change)) == 3
    assert "the balls' end did not" in capsys.readouterr().err


# -- broken --------------------------------------------------------------------------------------


def header(**changes):
    def change(found):
        found[0].update(changes)

    return change


def setup(**changes):
    def change(found):
        found[0]["setup"].update(changes)

    return change


def line(number, **changes):
    def change(found):
        found[number].update(changes)

    return change


BROKEN = {
    "another format": (header(format="chess"), "not a record of this game"),
    "a later version": (header(version=2), "version 2"),
    "no setup": (lambda found: found[0].pop("setup"), "line 1"),
    "an unknown table": (setup(table="snooker"), "snooker"),
    "an unknown option": (setup(gravity=1.6), "gravity"),
    "a seed that is none": (setup(seed="x"), "seed"),
    "an unknown action": (line(1, do=["dance"]), "dance"),
    "a value too many": (line(1, do=["shoot", 1, 2]), "line 2"),
    "a value of the wrong kind": (line(1, do=["edit", "x"]), "edit"),
    "a tick that goes back": (line(3, tick=-1), "line 4"),
    "a tick that is none": (line(3, tick="soon"), "line 4"),
    "a line that is none": (lambda found: found.insert(4, []), "line 5"),
    "more after the end": (lambda found: found.append(found[1] | {"tick": 10**9}), "after the end"),
}


@pytest.mark.parametrize("why", BROKEN)
@pytest.mark.parametrize("window", [True, False])
def test_a_broken_record_is_refused_with_a_message(record, tmp_path, capsys, why, window):
    change, said = BROKEN[why]
    changed = rewritten(record, tmp_path, change)
    code = shown(changed) if window else replayed(changed)
    out, err = capsys.readouterr()
    assert code == 2
    assert out == ""
    assert err.startswith("danggu: ")
    assert said in err
    assert len(err.splitlines()) == 1


@pytest.mark.parametrize("content", [b"", b"\n", b"hello", b"\xff\xfe\x00", b"[1]", b"[" * 99999])
def test_a_file_that_is_no_record_is_refused(tmp_path, capsys, content):
    path = tmp_path / "x.rec"
    path.write_bytes(content)
    assert replayed(path) == 2
    assert str(path) in capsys.readouterr().err


def test_a_record_that_is_not_there_and_one_that_cannot_be_written_are_refused(tmp_path, capsys):
    assert replayed(tmp_path / "none.rec") == 2
    assert "cannot read record" in capsys.readouterr().err
    assert entry.main(["--record", str(tmp_path / "no" / "x.rec"), "--frames", "1"]) == 2
    assert "cannot write record" in capsys.readouterr().err


@pytest.mark.parametrize("said", [["--headless"], ["--record", "a", "--replay", "b"]])
def test_options_that_make_no_sense_together_are_refused(said):
    with pytest.raises(SystemExit) as left:
        entry.main(said)
    assert left.value.code == 2


def test_a_record_that_was_cut_off_is_played_as_far_as_it_goes(record, tmp_path, capsys):
    cut = tmp_path / "cut.rec"
    text = record.read_text(encoding="utf-8")
    cut.write_text(text[: text.index('"shot": 3') + 20], encoding="utf-8")
    assert replayed(cut) == 0
    assert "the record was cut off" in capsys.readouterr().out


def test_every_line_is_in_the_file_as_soon_as_it_has_happened(tmp_path):
    path = tmp_path / "game.rec"
    game = new_game(OPTIONS)
    app = App(game, OPTIONS, journal=Recorder(str(path), OPTIONS, game))
    press(app, "return")
    assert [line["do"] for line in lines(path)[1:]] == [["shoot"]]
    app.close()


# -- watching ------------------------------------------------------------------------------------


@pytest.fixture
def watched(record):
    options = replace(OPTIONS, frames=None)
    played = read(str(record), options)
    game = new_game(played.setup)
    return App(game, played.setup, journal=Replay(played, game))


def test_a_replay_can_be_held_and_goes_on(watched):
    for _ in range(30):
        watched.frame(FRAME)
    press(watched, "p")
    tick = watched.game.tick
    for _ in range(30):
        watched.frame(FRAME)
    assert watched.game.tick == tick
    assert watched.game.notice.key == "replay.paused"
    press(watched, "space")
    watched.frame(FRAME)
    assert watched.game.tick > tick


def test_nothing_that_is_pressed_or_typed_reaches_the_game_of_a_replay(watched):
    for name in ("down", "r", "e", "right", "return", "f1", "f3", "3"):
        press(watched, name)
    write(watched, "5")
    while not watched.replay.done:
        watched.frame(20 * FRAME)
    assert watched.replay.state == "same"
    assert watched.game.notice.key == "replay.same"
    assert not watched.game.over


def test_escape_leaves_a_replay_and_the_verdict_says_how_far_it_was(watched):
    press(watched, "escape")
    assert watched.game.over
    assert watched.replay.verdict() == "left after 0 of 5 shots, the same so far"


def test_an_action_that_cannot_be_done_names_its_tick(record):
    played = read(str(record), OPTIONS)
    replay = Replay(played, new_game(played.setup))
    with pytest.raises(RecordError, match="tick 0"):
        replay.perform(Action("dance"))
