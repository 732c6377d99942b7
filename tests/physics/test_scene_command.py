"""`python -m physics scene`: what it prints, writes, draws and refuses."""

import builtins
import csv

import pytest

from physics import scenes, trace
from physics.__main__ import main


def test_a_scene_is_printed_event_by_event(capsys):
    assert main(["scene", "thesis_2"]) == 0
    lines = capsys.readouterr().out.splitlines()
    world = scenes.thesis_2()
    world.run()
    assert lines[0] == "thesis_2: 5 events in 8.9792 s, exact engine"
    assert len(lines) == 2 + len(world.log)
    assert lines[2].split() == ["1.2703", "cushion", "white,", "east", "0.8755", "->", "0.8053"]
    assert lines[-1].split() == ["8.9792", "rest", "white", "0.0000", "->", "0.0000"]


def test_law_and_engine_can_be_chosen(capsys):
    for options in (
        ["--law", "medium"], ["--law", "mathavan"], ["--engine", "thesis", "--dt", "0.02"], [],
    ):  # fmt: skip
        main(["scene", "thesis_2", "--until", "2", *options])
    printed = capsys.readouterr().out.split("thesis_2: ")
    assert len(set(printed)) == 5


def test_the_paths_are_written_at_the_wanted_rate(tmp_path, capsys):
    file = tmp_path / "paths.csv"
    assert main(["scene", "thesis_3a", "--until", "1", "--rate", "20", "--csv", str(file)]) == 0
    head, *rows = csv.reader(file.read_text().splitlines())
    world = scenes.thesis_3a()
    world.run(1.0)
    times, paths = trace(world, 20)
    assert head == ["time", "red x", "red y", "yellow x", "yellow y"]
    assert len(rows) == len(times) == 21
    assert [float(x) for x in rows[7]] == [times[7], *paths[7].flat]


@pytest.mark.parametrize("name", ["thesis_3b", "cradle", "pi_collisions"])
def test_a_picture_has_the_tables_shape(name, tmp_path, capsys):
    pytest.importorskip("matplotlib")
    file = tmp_path / "picture.png"
    options = ["--against", "literal"] if name == "thesis_3b" else []
    assert main(["scene", name, "--until", "1", "--png", str(file), *options]) == 0
    data = file.read_bytes()
    width, height = (int.from_bytes(data[k : k + 4], "big") for k in (16, 20))
    assert data[:4] == b"\x89PNG"
    assert width == 990
    if name == "thesis_3b":  # the table, 2.448 x 1.27 m, in its rails, and 1.25 inches of words
        assert height == pytest.approx(990 * (1.27 + 0.18) / (2.448 + 0.18) + 1.25 * 110, abs=1)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["thesis_4"], "no scene 'thesis_4': there are thesis_1, thesis_2, thesis_3a, thesis_3b"),
        (["thesis_1", "--engine", "literal"], "never rests"),
        (["thesis_1", "--engine", "thesis", "--dt", "0"], "TimeStepping.dt must be above zero"),
        (["thesis_1", "--until", "nan"], "nan"),
        (["thesis_1", "--until", "1", "--csv", "/nowhere/paths.csv"], "/nowhere/paths.csv"),
        (["thesis_1", "--csv", "paths.csv", "--rate", "-1"], "trace rate must be above zero"),
        (["thesis_1", "--csv", "paths.csv", "--rate", "1e9"], "--rate 1e+09: at most 1e+06"),
        (["thesis_1", "--rate", "9"], "--rate 9: needs --csv FILE"),
        (["thesis_1", "--against", "thesis"], "--against thesis: needs --png FILE"),
        (["thesis_1", "--dt", "0.1"], "--dt 0.1: needs --engine thesis, literal"),
        (["thesis_1", "--engine", "exact", "--dt", "0.1"], "--dt 0.1: needs --engine"),
        (["thesis_1", "--engine", "thesis", "--dt", "1e-300"], "--dt 1e-300: at least 1e-06 s"),
        (["thesis_1", "--csv", "a", "--png", "./a"], "--csv a and --png ./a: one file for both"),
        (["cradle", "--until", "1e15", "--csv", "paths.csv"], "Unable to allocate"),
    ],
)
def test_what_cannot_be_is_refused_in_a_line_with_exit_code_2(arguments, message, capsys):
    assert main(["scene", *arguments]) == 2
    printed = capsys.readouterr().err
    assert message in printed
    assert printed.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ["scene", "thesis_1", "--engine", "verlet"],
        ["scene", "thesis_1", "--csv", ""],
        ["scene", "thesis_1", "--png", " "],
        ["scene", "thesis_1", "--until", "1", "--until", "2"],
        ["scene", ""],
        ["scene"],
        [],
    ],
)
def test_a_wrong_option_is_refused_in_a_line_with_exit_code_2(arguments, capsys):
    with pytest.raises(SystemExit) as end:
        main(arguments)
    assert end.value.code == 2
    assert capsys.readouterr().err.count("\n") == 1


def test_without_matplotlib_a_picture_is_refused_with_what_to_install(
    monkeypatch, tmp_path, capsys
):
    real = builtins.__import__

    def without(name, *rest, **more):
        if name.startswith("matplotlib"):
            raise ImportError(name)
        return real(name, *rest, **more)

    monkeypatch.setattr(builtins, "__import__", without)
    file = tmp_path / "picture.png"
    assert main(["scene", "thesis_1", "--until", "1", "--png", str(file)]) == 2
    assert "pip install 'danggu[plot]'" in capsys.readouterr().err
    assert not file.exists()
