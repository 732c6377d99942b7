"""`python -m physics fit`: files in, a report and a table out."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from physics import Ball, fit, store, tables, tracks
from physics.__main__ import main
from tests.support.table_of_tracks import UNKNOWN, case

DATA = Path(__file__).parents[1] / "data"
BALLS = ("white", "yellow", "red")


@pytest.fixture(scope="module")
def film(tmp_path_factory):
    """A file of four tracks, and the truth about them."""
    given, path = case(16, lost=0.05), tmp_path_factory.mktemp("film") / "tracks.csv"
    tracks.write(given.tracks, path, BALLS)
    return path, given


def arguments(path, *more):
    known = "cloth.spin_decay=4.3,ball.mu=0.05"
    return ["fit", str(path), "--table", "match1", "--set", known, *more]


def test_tracks_come_back_from_their_file(film):
    path, given = film
    assert tracks.balls(path) == [*BALLS]
    for track, again in zip(given.tracks, tracks.read(path, given.world), strict=True):
        assert np.array_equal(track.times, again.times)
        assert np.array_equal(track.positions, again.positions, equal_nan=True)


def test_it_reports_what_it_found_tests_it_and_writes_the_table(film, tmp_path, capsys):
    path, given = film
    file, picture = tmp_path / "table.json", tmp_path / "left.png"
    more = ("--hold", "1", "--preset", str(file), "--png", str(picture), "--struck", "white")
    assert main(arguments(path, *more)) == 0
    said = capsys.readouterr().out
    assert "3 tracks" in said
    assert "held out, with these values: misfit 0." in said
    world = store.load(file)
    assert world.balls == ()
    assert len(world.walls) == 4
    found = tables.load(file)
    assert found.name == "my table"
    assert (found.length, found.radius) == (2.84, 0.03075)
    for value, true in zip(
        (found.cloth.slide, found.cloth.roll, found.cushion_law.e, found.cushion_law.mu),
        given.truth, strict=True,
    ):  # fmt: skip
        assert value == pytest.approx(true, rel=0.02)
        assert f"{value:.5g}" in said
    assert picture.read_bytes()[:4] == b"\x89PNG"


def test_the_tracks_of_a_known_table_give_it_back_within_two_standard_deviations(tmp_path, capsys):
    """Four strokes at 50 Hz with 0.5 mm of noise and gaps, kept as data beside their truth."""
    path, mine = DATA / "tracks_of_known_table.csv", tmp_path / "mine.json"
    assert main(arguments(path, "--preset", str(mine), "--name", "hall, table 3")) == 0
    assert "4 tracks" in capsys.readouterr().out
    known, found = tables.load(DATA / "known_table.json"), tables.load(mine)
    assert found.name == "hall, table 3"
    assert found.ball_law == known.ball_law
    begun = tables.match_carom(edition=1)
    begun.cloth, begun.ball_law = replace(begun.cloth, spin_decay=4.3), known.ball_law
    for ball in BALLS:
        begun.add(Ball(ball, (-0.5 + 0.1 * BALLS.index(ball), 0.0)))
    again = fit(begun, tracks.read(path, begun), UNKNOWN)
    numbers = [
        (table.cloth.slide, table.cloth.roll, table.cushion_law.e, table.cushion_law.mu)
        for table in (known, found)
    ]
    assert (np.abs(np.subtract(*numbers)) < 2.0 * again.errors).all()
    assert numbers[1] == pytest.approx(tuple(again.values), rel=1e-12)


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (("--unknown", "cushion.x"), "'cushion.x' is no input of this world"),
        (("--unknown", "cloth.slide", "--share", "ball.e"), "share: 'ball.e' is none"),
        (("--hold", "9"), "--hold 9: there are 4 tracks"),
        (("--set", "nap=1"), "--set 'nap=1': NAME=VALUE, with cloth.slide"),
        (("--set", "cloth.slide=thick"), "--set 'cloth.slide=thick': 'thick' is no number"),
        (("--struck", "blue"), "there is no ball 'blue'"),
        (("--noise", "0"), "Track.noise must be above zero"),
        (("--table", "medium"), "wrong scale"),
    ],
)
def test_what_cannot_be_is_refused_with_a_message(film, capsys, more, message):
    command = arguments(film[0])[:4] if "--set" in more else arguments(film[0])
    options = command if "--table" not in more else command[:2] + command[4:]
    assert main([*options, *more]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "no columns such as 'white x'"),
        ("time,white x\n1,2\n", "no column 'white y'"),
        ("time,white x,white y\n1,2,three\n", "line 2: 'three' is no number"),
        ("time,white x,white y\n1,0,0\n0.5,0,0\n", "must be finite and grow"),
        ("time,white x,white y\n", "at least one track"),
    ],
)
def test_files_that_hold_no_tracks_are_refused(tmp_path, capsys, text, message):
    path = tmp_path / "tracks.csv"
    path.write_text(text)
    assert main(arguments(path)) == 2
    assert message in capsys.readouterr().err


def test_a_file_that_is_not_there_is_refused(tmp_path, capsys):
    assert main(arguments(tmp_path / "none.csv")) == 2
    assert "none.csv" in capsys.readouterr().err
