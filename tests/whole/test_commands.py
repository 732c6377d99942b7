"""What the commands say and where: samples on the terminal, and what is missing from a set-up."""

import csv
import io

import pytest

from game.table import lineup, presets
from physics.__main__ import main


def test_a_scene_writes_its_samples_to_the_terminal_and_what_happens_beside_them(
    capsys, tmp_path, monkeypatch
):
    monkeypatch.chdir(tmp_path)
    assert main(["scene", "thesis_2", "--csv", "-"]) == 0
    out, err = capsys.readouterr()
    head, *rows = csv.reader(io.StringIO(out))
    assert head == ["time", "white x", "white y"]
    assert all(len([float(number) for number in row]) == 3 for row in rows)
    assert "events in" in err
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize("table", [*presets.TABLES, "cradle"])
def test_a_set_up_without_balls_is_refused_with_the_name_of_one(table):
    with pytest.raises(lineup.LineError) as refused:
        lineup.read(f"danggu1 {table}")
    first = lineup._table(table).balls
    assert refused.value.reason == "missing"
    assert refused.value.word.startswith(first[0].name if first else "white")
