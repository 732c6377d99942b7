"""Rule cases that were written from the federations' texts hold, and their reader can fail."""

import doctest
import json
from copy import deepcopy
from pathlib import Path

import pytest

from tests.rules import cases
from tests.rules.grammar import read

DATA = Path(__file__).parents[1] / "data"
FILES = ("rules_cases.json", "more_rules_cases.json")
ALL = [(name, case) for name in FILES for case in cases.cases(DATA / name)]
IDS = [f"{name.removesuffix('rules_cases.json')}{case['id']}" for name, case in ALL]


@pytest.mark.parametrize(("name", "case"), ALL, ids=IDS)
def test_a_case_holds(name, case):
    assert cases.wrong(case) == ""


@pytest.mark.parametrize(("name", "case"), ALL, ids=IDS)
def test_a_case_of_which_anything_else_is_expected_fails(name, case):
    for key, value in case["expected"].items():
        if key == "note":
            continue
        spoilt = deepcopy(case)
        spoilt["expected"][key] = "x" if not isinstance(value, str) else value + "x"
        assert key in cases.wrong(spoilt)


def test_all_cases_hold_and_the_command_says_so(capsys):
    assert cases.main([str(DATA / FILES[0])]) == 0
    assert capsys.readouterr().out == "79 of 79 cases hold, 0 fail\n"


def test_the_command_names_each_case_that_fails(tmp_path, capsys):
    listed = deepcopy([case for _, case in ALL[:3]])
    listed[1]["expected"] = {"points": 77, "colour": "red"}
    listed[2]["stroke_events"] = ["cue>1", "what?"]
    path = tmp_path / "cases.json"
    path.write_text(json.dumps({"cases": listed}))
    assert cases.main([str(path)]) == 1
    lines = capsys.readouterr().out.splitlines()
    for line, case, why in zip(lines, listed[1:], ("'colour'", "'what?' is no"), strict=False):
        assert line.startswith(f"{case['id']}: ")
        assert why in line
    assert lines[2:] == ["1 of 3 cases hold, 2 fail"]


UNREADABLE = [
    (None, "No such file"),
    ("{", "no JSON"),
    ("[" * 100_000, "no JSON"),
    ("\xff", "no JSON"),
    ("{}", "no list of cases"),
    ('{"cases": {}}', "no list of cases"),
    ("[]", "no list of cases"),
    ("7", "no list of cases"),
    ("[7]", "case 1 is no object"),
    ('[{"id": "a"}]', "case a needs 'game', a str"),
    ('[{"id": "a", "game": "snooker", "situation": [], "stroke_events": [], "expected": {}}]',
     "needs 'situation', a dict"),
    ('[{"id": "a", "game": "snooker", "situation": {}, "stroke_events": [1], "expected": {}}]',
     "an event is a string"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "why"), UNREADABLE)
def test_a_file_that_holds_no_cases_is_refused_with_the_reason(tmp_path, capsys, text, why):
    path = tmp_path / "cases.json"
    if text is not None:
        path.write_bytes(text.encode("latin-1"))
    assert cases.main([str(path)]) == 2
    assert why in capsys.readouterr().err


def test_without_a_file_the_command_says_how_it_is_called(capsys):
    assert cases.main([]) == 2
    assert "usage" in capsys.readouterr().err


def test_a_game_that_there_is_not_fails_by_its_name():
    case = {**ALL[0][1], "game": "croquet"}
    assert "'croquet'" in cases.wrong(case)


def test_brackets_belong_to_the_event_before_them_however_they_were_split():
    events = ["white|N(into", "the", "frozen", "cushion,", "no", "massé)", "white>red"]
    written = read(events, {"white": "N"})
    assert written.remarks == ["into the frozen cushion, no massé"]
    assert [(entry.kind, entry.away) for entry in written.log] == [
        ("cushion", 0.0),
        ("ball", float("inf")),
    ]
    assert read(["cue:jumps(yellow)"]).acts == [("cue", "jumps", "yellow")]


def test_the_page_of_the_rules_shows_what_they_say():
    page = Path(__file__).parents[2] / "docs" / "rules.md"
    assert doctest.testfile(str(page), module_relative=False).failed == 0


def test_two_balls_hit_at_one_instant_are_both_first():
    assert read(["cue|", "cue>red1+blue", "cue>red2"]).stroke("cue").first == ("red1", "blue")


def test_a_list_of_unlike_things_that_is_expected_fails_and_ends_nothing():
    case = {**ALL[0][1], "expected": {"spot": ["1", 1, None]}}
    assert "not ['1', 1, None]" in cases.wrong(case)


def test_two_cases_of_one_name_that_fail_are_two_failures(tmp_path, capsys):
    case = {**ALL[0][1], "expected": {"points": 99}}
    path = tmp_path / "cases.json"
    path.write_text(json.dumps([case, case]))
    assert cases.main([str(path)]) == 1
    assert "0 of 2 cases hold, 2 fail" in capsys.readouterr().out
