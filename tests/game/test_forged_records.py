"""Records written by hand: each is played, or refused in a line that names file and value."""

from pathlib import Path

import pytest

from game.replay import replay
from game.replay.game_record import LATEST, RecordError, read
from game.session.commands import COMMANDS, RECORDED, TABLE
from tests.support.forgeries import forged
from tests.support.records import OPTIONS, replayed, shown

DATA = Path(__file__).parents[1] / "data" / "records"
SAID = {
    "unknown_language": "line 2: language takes one of 'en', 'ko', not 'xx'",
    "colours_of_the_viewer": "line 2: there is no action ['colours', 'zz']",
    "play_letters": "line 2: play takes 5 numbers as text, not 'a b c d e'",
    "unknown_sheet": "line 2: sheet takes one of '', 'settings', 'menu', 'shelf', 'rules'",
    "volume_text": "line 2: there is no action ['volume', 'x']",
    "volume_number": "line 2: there is no action ['volume', 0]",
    "tick_of_400_digits": "line 3: tick is 100000",
    "scrub_far": "line 3: scrub takes a whole number from 0 to 4294967296, not 10000000000",
}
PLAYED = ("name_with_line_separators",)


def assert_refused(path, code, said, err):
    assert code == 2
    assert err.startswith(f"danggu: {path}")
    assert said in err
    assert len(err.splitlines()) == 1
    assert len(err) < 600


@pytest.mark.parametrize("play", [replayed, shown])
@pytest.mark.parametrize("path", sorted(DATA.glob("*.rec")), ids=lambda path: path.stem)
def test_a_record_that_once_ended_the_game_does_so_no_more(path, play, capsys):
    code = play(path)
    out, err = capsys.readouterr()
    if path.stem in PLAYED:
        assert code == 0
        assert "the same" in out
    else:
        assert_refused(path, code, SAID[path.stem], err)


def test_a_record_may_hold_every_command_but_the_players_own_and_the_end():
    assert {command.name for command in TABLE if command.own} == OWN
    assert COMMANDS.keys() - RECORDED.keys() == OWN | {"quit"}


OWN = {
    "mute", "still", "both", "fan", "graphs", "compare", "export", "volume", "aids", "level",
    "colours", "diamonds", "full", "bind", "unbind",
}  # fmt: skip
"""What a player chooses for seeing and hearing, and what is written for one."""
HEAD = '{"format":"danggu record","version":1,"with":"x","ticks":65536,"setup":%s}\n'
END = '{"tick":%s,"end":"0"}\n'
BAD = {
    "a tick of half": (HEAD % "{}" + '{"tick":0.5,"do":["fire"]}\n', "line 2: tick is 0.5"),
    "no tick": (HEAD % "{}" + '{"do":["fire"]}\n', "line 2: tick is missing"),
    "a tick that is true": (HEAD % "{}" + '{"tick":true,"do":["fire"]}\n', "tick is True"),
    "a tick below zero": (HEAD % "{}" + '{"tick":-5,"do":["fire"]}\n', "tick is -5"),
    "a tick that is late": (HEAD % "{}" + END % (LATEST + 1), f"tick is {LATEST + 1}"),
    "a tick without end": (HEAD % "{}" + END % "1e999", "tick is inf"),
    "a tick that is none": (HEAD % "{}" + END % "NaN", "tick is nan"),
    "nothing done": (HEAD % "{}" + '{"tick":1}\n', 'one of "do", "shot" and "end"'),
    "two things done": (HEAD % "{}" + '{"tick":1,"do":["fire"],"end":"0"}\n', 'one of "do"'),
    "an action that is text": (HEAD % "{}" + '{"tick":1,"do":"fire"}\n', "not 'fire'"),
    "an empty action": (HEAD % "{}" + '{"tick":1,"do":[]}\n', "not []"),
    "a list as an action": (HEAD % "{}" + '{"tick":1,"do":[["fire"]]}\n', "no action [['fire']"),
    "a number as a digest": (HEAD % "{}" + '{"tick":1,"end":0}\n', "end must be text, not 0"),
    "no digest": (HEAD % "{}" + '{"tick":1,"shot":1}\n', "digest must be text, not missing"),
    "quit": (HEAD % "{}" + '{"tick":1,"do":["quit"]}\n', "no action ['quit'"),
    "setup that is a list": (HEAD % "[]", "line 1: setup is []"),
    "lists in lists": (HEAD % ('{"seed":%s}' % ("[" * 800 + "]" * 800)), "line 1: seed is "),
    "lists in an action": (
        HEAD % "{}" + '{"tick":1,"do":["type",%s]}\n' % ("[" * 800 + "]" * 800),
        "line 2: type takes text",
    ),
    "half a seed": (HEAD % '{"seed":0.5}', "line 1: seed is 0.5"),
    "a seed of many digits": (HEAD % '{"seed":"%s"}' % ("9" * 5000), "line 1: argument --seed"),
    "an empty scene": (HEAD % '{"scene":""}', "line 1: argument --scene"),
    "a broken set-up": (HEAD % '{"setup":"danggu1 medium white=9,9"}', "white lies outside"),
    "three players": (HEAD % '{"game":"four-ball","players":3}', "players must be 1 or 2, not 3"),
    "a name that cannot be drawn": (
        HEAD % r'{"game":"four-ball","players":"a\u0000b"}',
        r"contain a NUL: 'a\x00b'",
    ),
    "half a character": (
        HEAD % r'{"game":"four-ball","players":"\ud800"}',
        r"can be drawn, not '\ud800'",
    ),
    "another kind of tick": (
        (HEAD % "{}").replace("65536", "60"),
        "version 1 with 60 ticks, this is version 1 with 65536",
    ),
    "an option with a break of lines": (HEAD % r'{"a\nb":1}', r"unknown setup: 'a\nb'"),
    "a value with a break of lines": (HEAD % r'{"table":"a\u2028b"}', "line 1: argument --table"),
    "a line that is cut off and not the last": (HEAD % "{}" + '{"tick":1\n' + END % 5, "line 2"),
}


@pytest.mark.parametrize("why", BAD)
def test_what_no_game_has_written_is_refused_with_its_place(why, tmp_path, capsys):
    text, said = BAD[why]
    path = tmp_path / "x.rec"
    path.write_text(text, encoding="utf-8")
    assert_refused(path, replayed(path), said, capsys.readouterr().err)


@pytest.mark.parametrize(
    ("before", "after"),
    [("", "\ufeff"), ("\n", "\r\n"), ("\n", "\n\n"), ("가", "\u2028\u2029\x85"), ('"x"', "7")],
)
def test_what_another_editor_makes_of_a_record_is_played(before, after, tmp_path, capsys):
    path = tmp_path / "x.rec"
    text = HEAD % '{"game":"four-ball","players":"가,나"}' + '{"tick":1,"do":["skip"]}\n'
    text = text.replace(before, after) if before else after + text
    path.write_bytes(text.encode())
    assert replayed(path) == 0
    assert "cut off" in capsys.readouterr().out


@pytest.mark.parametrize("cut", [1, 2, 3])
def test_a_record_cut_off_within_a_character_is_played_as_far_as_it_goes(cut, tmp_path):
    data = (HEAD % "{}" + '{"tick":1,"do":["type","가').encode()
    path = tmp_path / "x.rec"
    path.write_bytes(data[:-cut])
    assert replayed(path) == 0


def test_shots_that_never_end_take_no_time_without_a_window(tmp_path, capsys, monkeypatch):
    path = tmp_path / "x.rec"
    for scene in ("cradle", "pi_collisions"):
        path.write_text(HEAD % f'{{"scene":"{scene}"}}' + END % LATEST)
        assert replayed(path) == 3
    capsys.readouterr()
    path.write_text(HEAD % '{"scene":"cradle","engine":"thesis"}' + END % LATEST)
    monkeypatch.setattr(replay, "LONGEST_ROLL", 60.0)
    assert_refused(path, replayed(path), "still roll 60 s later", capsys.readouterr().err)


def test_a_shot_that_never_ends_is_not_scrubbed_to_its_end(tmp_path):
    path = tmp_path / "x.rec"
    scrubs = '{"tick":1,"do":["scrub",4294967296]}\n' * 3
    path.write_text(HEAD % '{"scene":"cradle"}' + scrubs + END % 2)
    assert shown(path) == 3


@pytest.mark.parametrize("start", range(0, 150, 10))
def test_forged_records_are_played_or_refused_without_a_window(start, tmp_path, capsys):
    for seed in range(start, start + 10):
        assert_orderly(seed, replayed, tmp_path, capsys)


@pytest.mark.parametrize("start", range(1000, 1012, 3))
def test_forged_records_are_shown_or_refused(start, tmp_path, capsys):
    def play(path):
        return shown(path, "--fps", "5")

    for seed in range(start, start + 3):
        assert_orderly(seed, play, tmp_path, capsys)


@pytest.mark.stress
def test_very_many_forged_records_are_played_or_refused(tmp_path, capsys):
    for seed in range(10_000, 14_000):
        assert_orderly(seed, replayed, tmp_path, capsys)


def assert_orderly(seed, play, tmp_path, capsys):
    path = tmp_path / f"{seed}.rec"
    path.write_bytes(forged(seed))
    code = play(path)
    err = capsys.readouterr().err
    assert code in (0, 2, 3), seed
    if code == 2:
        assert_refused(path, code, "", err)


def test_a_record_says_nothing_about_the_viewers_options(tmp_path):
    path = tmp_path / "x.rec"
    path.write_text(HEAD % '{"size":"9x9"}')
    with pytest.raises(RecordError, match="unknown setup: 'size'"):
        read(str(path), OPTIONS)
