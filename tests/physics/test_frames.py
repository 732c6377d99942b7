"""Logs and batches as columns, DataFrames and Datasets."""

import sys

import numpy as np
import pytest

from physics import (
    Shot,
    columns,
    ledger,
    scenes,
    simulate,
    simulate_many,
    to_pandas,
    to_xarray,
)
from physics.studies.frames import variables

SHOTS = [Shot(2.0, 36.0 * k, follow=0.5) for k in range(7)]
NAMES = ["white", "yellow", "red", "red 2"]


@pytest.fixture(scope="module")
def batch():
    return simulate_many(scenes.carom(), "white", SHOTS, compiled=False)


@pytest.fixture(scope="module")
def after():
    return simulate(scenes.carom(), "white", Shot(3.0, 1.0))


def test_the_columns_of_a_log_are_its_ledger(after):
    found, book = columns(after.log), ledger(after.log)
    assert {len(values) for values in found.values()} == {len(after.log)}
    assert [*zip(*(values.tolist() for values in found.values()), strict=True)] == [*book]
    assert columns(book).keys() == found.keys()


def test_the_columns_of_a_batch_are_its_shots_and_where_the_balls_lie(batch):
    found = columns(batch, SHOTS, NAMES)
    assert [*found][:8] == ["speed", "angle", "follow", "masse", "side", "climb", "time", "events"]
    assert found["angle"].tolist() == [shot.angle for shot in SHOTS]
    assert (found["red 2 y"] == batch.positions[:, 3, 1]).all()
    five = columns(batch, np.ones((7, 5)), NAMES)
    assert "climb" not in five
    assert [*columns(batch, balls=NAMES)][:3] == ["time", "events", "white x"]


def test_the_variables_of_a_batch_and_of_a_log_name_their_axes(batch, after):
    found = variables(batch, SHOTS, NAMES)
    assert found["data_vars"]["position"]["dims"] == ("shot", "ball", "axis")
    assert found["coords"]["ball"]["data"] == NAMES
    times = [0.1, 0.2, 0.7]
    moving = variables(after.log, times=times)
    for name, (dims, shape) in {
        "position": (("time", "ball", "axis"), (3, 4, 2)),
        "spin": (("time", "ball", "about"), (3, 4, 3)),
        "phase": (("time", "ball"), (3, 4)),
    }.items():
        assert moving["data_vars"][name]["dims"] == dims
        assert moving["data_vars"][name]["data"].shape == shape
    at = after.log.at(0.7)["yellow"]
    assert moving["data_vars"]["velocity"]["data"][2, 1] == pytest.approx(at.velocity)


@pytest.mark.parametrize(
    ("ask", "words"),
    [(lambda b, log: columns(3), "made of a Log, a Ledger or Outcomes, not 3"),
     (lambda b, log: columns(b, SHOTS[:2]), "shots must be those of the batch, 7, not"),
     (lambda b, log: columns(b, balls=["a"]), "balls must be 4 names, not 1"),
     (lambda b, log: variables(log), "has to be asked at times")],
)  # fmt: skip
def test_what_makes_no_table_is_refused(batch, after, ask, words):
    with pytest.raises(ValueError, match=words):
        ask(batch, after.log)


@pytest.mark.parametrize(("module", "make"), [("pandas", to_pandas), ("xarray", to_xarray)])
def test_without_the_library_an_error_says_what_to_install(monkeypatch, batch, module, make):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(ImportError, match=rf"needs {module}: pip install 'danggu\[frames\]'"):
        make(batch)


def test_a_dataframe_has_a_row_for_each_event_or_shot(batch, after):
    pytest.importorskip("pandas")
    frame = to_pandas(after.log)
    assert frame[frame.kind == "cushion"].impulse.sum() == pytest.approx(
        sum(event.impulse for event in after.log.all("cushion"))
    )
    assert to_pandas(batch, SHOTS, NAMES).shape == (7, 16)


def test_a_dataset_is_asked_by_the_names_of_its_axes(batch, after):
    pytest.importorskip("xarray")
    found = to_xarray(batch, SHOTS, NAMES)
    assert float(found.position.sel(ball="red", axis="y")[3]) == batch.positions[3, 2, 1]
    moving = to_xarray(after.log, times=[0.0, 0.5])
    assert str(moving.phase.sel(time=0.5, ball="red").item()) == "resting"
