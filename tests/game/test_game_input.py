"""What people type that is no number, and what the command line refuses."""

import subprocess
import sys

import pygame
import pytest

from game import __main__ as entry
from game import options
from game.aim.entry import Fault, fault, typed
from game.input.captions import words
from game.replay import script
from game.ui.panels.parts import hint
from tests.support.players import an_app, enter, places, press, run_to_rest, write

BAD = [
    ("", "empty"),
    ("-", "number"),
    ("1.2.3", "number"),
    ("e", "number"),
    ("1e", "number"),
    ("+-3", "number"),
    ("nan", "finite"),
    ("inf", "finite"),
    ("-inf", "finite"),
    ("1e999", "finite"),
    ("1_000", "number"),
    ("0", "positive"),
    ("-2", "positive"),
    ("1e9", "most"),
    ("50.1", "most"),
]


@pytest.mark.parametrize(("text", "reason"), BAD)
def test_each_bad_speed_has_its_reason(text, reason):
    assert fault(0, text) == Fault(0, reason)


@pytest.mark.parametrize("text", ["50", "1e-3", "+2.5", ".5", "2.", "２．５", "3e0"])
def test_good_speeds_have_no_fault(text):
    assert fault(0, text) is None


@pytest.mark.parametrize("box", [1, 2, 3, 4])
def test_spins_and_angles_may_be_zero_or_negative(box):
    assert fault(box, "0") is None
    assert fault(box, "−3.5") is None


def test_full_width_digits_and_the_true_minus_become_plain():
    assert typed("２．５") == "2.5"
    assert typed("−１") == "-1"
    assert typed("２ m/s 가") == "2 m/s 가"  # to be seen and mended: "2" was not what was typed
    assert typed("1E3") == "1e3"


@pytest.mark.parametrize("text", ["", "-", "1.2.3", "0", "-2", "1e9"])
def test_a_bad_entry_says_wrong_input_and_moves_nothing_until_the_next_good_shot(text):
    app = an_app()
    before = places(app.session)
    enter(app, text, "0", "0", "0", "0")
    press(app, "return", "return")
    assert places(app.session) == before
    assert app.session.shots == 0
    said, error = hint(app.session, words("en"))
    assert error
    assert said.startswith("wrong input · V: ")
    press(app, "left")
    write(app, "2")
    assert hint(app.session, words("en"))[0] == "Corrected · press Enter again"
    press(app, *["return"] * 6)
    assert app.session.shots == 1
    assert not hint(app.session, words("en"))[1]


def test_the_upper_bound_is_stated():
    app = an_app()
    enter(app, "1e9", "0", "0", "0", "0")
    assert hint(app.session, words("en"))[0] == "wrong input · V: at most 50"


def test_the_text_that_was_wrong_is_kept_for_correction():
    app = an_app()
    enter(app, "1.2.3", "0", "0", "0", "0")
    press(app, "left")
    assert app.session.aim.texts[0] == "1.2.3"


def test_a_box_is_only_blamed_once_it_has_been_left():
    app = an_app()
    press(app, "right")
    write(app, "-")
    assert app.session.aim.shown_faults == []
    press(app, "return")
    assert [f.reason for f in app.session.aim.shown_faults] == ["number"]


def test_letters_stay_in_their_box_and_keep_it_from_being_shot():
    """They used to vanish, so that 2x5 was 25."""
    app = an_app()
    press(app, "right")
    write(app, "a2나\t.5?")
    assert app.session.aim.texts[0] == "a2나 .5?"
    press(app, "ctrl+return")
    assert app.session.shots == 0


def test_a_text_longer_than_a_box_is_cut():
    app = an_app()
    press(app, "right")
    write(app, "1" * 200)
    assert app.session.aim.texts[0] == "1" * 16


def test_the_hardest_shot_the_boxes_take_comes_to_rest():
    app = an_app()
    enter(app, "50", "-100", "100", "100", "77")
    press(app, "return")
    assert app.session.moving
    run_to_rest(app)


REFUSED = [
    ["--nonsense"],
    ["--scene", "nowhere"],
    ["--table", "round"],
    ["--engine", "magic"],
    ["--law", "murphy"],
    ["--lang", "xx"],
    ["--size", "big"],
    ["--size", "10x10"],
    ["--fps", "0"],
    ["--substeps", "0"],
    ["--frames", "-1"],
    ["--frames", "nan"],
    ["--seed", "x"],
    ["--script", "/nowhere/at/all"],
]


@pytest.mark.parametrize("arguments", REFUSED, ids=" ".join)
def test_the_command_line_refuses_with_a_message_and_code_2(arguments, capsys):
    try:
        code = entry.main(arguments)
    except SystemExit as stop:
        code = stop.code
    said = capsys.readouterr().err
    assert code == 2
    assert arguments[-1] in said
    assert "Traceback" not in said


BROKEN = [
    ("soon key return", "line 1"),
    ("0 key nokey", "nokey"),
    ("0 dance", "dance"),
    ("0 text", "text"),
    ("-1 key a", "negative"),
    ("1 key a\n0.5 key b", "line 2"),
    ("0 click 1 x", "click"),
    ("nan key a", "nan"),
    ("inf key a", "inf"),
]


@pytest.mark.parametrize(("text", "blamed"), BROKEN)
def test_a_broken_script_is_refused_with_its_line(text, blamed):
    with pytest.raises(script.ScriptError, match=blamed):
        script.parse(text)


def test_a_script_from_another_editor_is_read_line_by_line(tmp_path):
    path = tmp_path / "script.txt"
    path.write_bytes("\ufeff0 key a\r\n\r\n1 text a\u2028b\x85\r\n".encode())
    first, second = script.read(str(path)).due(10**9)
    assert first.events[0].key == pygame.K_a
    assert "".join(event.text for event in second.events) == "a b"


def test_a_script_that_is_no_text_is_refused(tmp_path, capsys):
    path = tmp_path / "picture.txt"
    path.write_bytes(b"\xff\xfe\x00")
    assert entry.main(["--script", str(path)]) == 2
    assert str(path) in capsys.readouterr().err


def test_a_screenshot_that_cannot_be_written_is_reported(tmp_path, capsys):
    path = tmp_path / "none" / "x.png"
    assert entry.main(["--frames", "1", "--screenshot", str(path)]) == 2
    assert str(path) in capsys.readouterr().err


@pytest.mark.parametrize("name", ["x.foo", "x", "png", "x.png.gz"])
def test_a_picture_of_a_kind_that_cannot_be_written_is_refused_before_anything(capsys, name):
    with pytest.raises(SystemExit) as stop:
        entry.main(["--frames", "1", "--screenshot", name])
    assert stop.value.code == 2
    assert repr(name) in capsys.readouterr().err


@pytest.mark.parametrize("end", options.PICTURES)
def test_every_kind_of_picture_that_is_offered_is_that_kind(tmp_path, end):
    path = tmp_path / ("X" + end.upper())
    assert entry.main(["--frames", "1", "--size", "640x360", "--screenshot", str(path)]) == 0
    begins = {".png": b"\x89PNG", ".jpg": b"\xff\xd8", ".jpeg": b"\xff\xd8", ".bmp": b"BM"}
    assert path.read_bytes().startswith(begins.get(end, b"\0\0"))


def test_help_documents_the_script_format(capsys):
    with pytest.raises(SystemExit) as stop:
        entry.main(["--help"])
    assert stop.value.code == 0
    assert "SECONDS text TEXT" in capsys.readouterr().out


def test_version_names_pygame(capsys):
    assert entry.main(["--version"]) == 0
    assert "pygame" in capsys.readouterr().out


@pytest.mark.parametrize("delay", [0.0, 0.6])
def test_sigterm_ends_the_game_with_code_0(delay):
    code = (
        "import os, signal, sys, threading, game.__main__ as entry\n"
        "play = entry._play\n"
        "def late(options):\n"
        f"    threading.Timer({delay}, os.kill, (os.getpid(), signal.SIGTERM)).start()\n"
        "    return play(options)\n"
        "entry._play = late\n"
        "sys.exit(entry.main([]))\n"
    )
    assert subprocess.run([sys.executable, "-c", code], timeout=30).returncode == 0
