"""`python -m physics fit`: files in, a report and a table out."""

import numpy as np
import pytest

from physics import store, tracks
from physics.__main__ import main
from tests.support.table_of_tracks import case

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
    found = store.load(file)
    assert found.balls == ()
    assert len(found.walls) == 4
    for value, true in zip(
        (found.cloth.slide, found.cloth.roll, found.cushion_law.e, found.cushion_law.mu),
        given.truth, strict=True,
    ):  # fmt: skip
        assert value == pytest.approx(true, rel=0.02)
        assert f"{value:.5g}" in said
    assert picture.read_bytes()[:4] == b"\x89PNG"


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
