"""Records that come out differently or cannot be read, and what is said about them."""

import pytest

from game import __main__ as entry
from tests.support.records import recorded, replayed, rewritten, shown

pytestmark = pytest.mark.usefixtures("undrawn")


@pytest.fixture(scope="module")
def record(tmp_path_factory):
    return recorded(tmp_path_factory.mktemp("record"))


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
    "an unknown table": (setup(table="moon"), "moon"),
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
