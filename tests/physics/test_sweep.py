"""`python -m physics sweep`: ranges of shots in, tables out; and the progress of batches."""

import csv
import pickle
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

from physics import (
    EventBudgetError,
    EventDriven,
    Shot,
    TimeStepping,
    scenes,
    simulate,
    simulate_many,
)
from physics.__main__ import main
from physics.ranges import values


def rows(text):
    head, *lines = csv.reader(text.splitlines())
    return head, np.array(lines, float)


def test_a_sweep_is_the_batch_of_all_combinations(tmp_path, capsys):
    file, arrays = tmp_path / "out.csv", tmp_path / "out.dat"
    ranges = ["--speed", "2,3.5", "--angle", "-10:10:5", "--follow=0.5", "--side", "-1:1:1"]
    assert main(["sweep", "carom", *ranges, "--csv", str(file), "--npz", str(arrays)]) == 0
    shots = [
        Shot(speed, angle, follow=0.5, side=side)
        for speed in (2.0, 3.5) for angle in (-10, -5, 0, 5, 10) for side in (-1, 0, 1)
    ]  # fmt: skip
    wanted = simulate_many(scenes.carom(), "white", shots)
    head, table = rows(file.read_text())
    assert head[:10] == [
        "speed", "angle", "follow", "masse", "side", "climb", "time", "events", "white x", "white y"
    ]  # fmt: skip
    assert np.array_equal(table[:, 6], wanted.times)
    assert np.array_equal(table[:, 7], wanted.events)
    assert np.array_equal(table[:, 8:].reshape(30, 4, 2), wanted.positions)
    with np.load(arrays) as kept:
        assert kept["balls"].tolist() == ["white", "yellow", "red", "red 2"]
        assert np.array_equal(kept["shots"], table[:, :6])
        assert np.array_equal(kept["positions"], wanted.positions)
    printed = capsys.readouterr()
    assert printed.out == ""
    assert printed.err == (
        f"30 shots at white, {wanted.events.sum()} events; written to {arrays} and {file}\n"
    )


def test_jumps_are_swept_like_the_other_numbers(capsys):
    ranges = ["--speed", "2", "--angle", "0,1", "--climb", "-1:1.5:0.5"]
    assert main(["sweep", "carom", *ranges, "--csv", "-"]) == 0
    head, table = rows(capsys.readouterr().out)
    climbs = [-1.0, -0.5, 0.0, 0.5, 1.0, 1.5]
    assert table[:, head.index("climb")].tolist() == 2 * climbs
    shots = [Shot(2.0, angle, climb=climb) for angle in (0, 1) for climb in climbs]
    wanted = simulate_many(scenes.carom(), "white", shots)
    assert np.array_equal(table[:, 8:].reshape(12, 4, 2), wanted.positions)
    assert len(np.unique(wanted.times)) == 12  # the climb matters


@pytest.mark.parametrize("more", [["--threads", "2"], ["--processes", "2"]])
def test_what_does_the_work_changes_no_digit(more, capsys):
    ranges = ["sweep", "carom", "--speed", "3", "--angle", "0:330:30", "--csv", "-"]
    for engine in ([], ["--engine", "thesis", "--dt", "0.01"]):
        main([*ranges, *engine])
        alone = capsys.readouterr().out
        main([*ranges, *engine, *more])
        assert capsys.readouterr().out == alone
        assert alone.count("\n") == 13


def test_ball_law_and_engine_can_be_chosen(capsys):
    seen = set()
    for more in ([], ["--law", "thesis"], ["--engine", "thesis"], ["--ball", "red"]):
        assert main(["sweep", "carom", "--speed", "3", "--csv", "-", *more]) == 0
        seen.add(capsys.readouterr().out)
    assert len(seen) == 4


def test_a_range_has_both_its_ends():
    assert values("0:0.3:0.1") == [0.0, 0.1, 0.2, pytest.approx(0.3)]
    assert values("3:1:-1") == [3.0, 2.0, 1.0]
    assert values("2:2:5") == [2.0]
    assert values("1,-2,3e0") == [1.0, -2.0, 3.0]
    assert len(values("0:360:0.5")) == 721


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--speed", "fast"], "'fast' is no number"),
        (["--speed", "1:2"], "'1:2' is no number"),
        (["--speed", "1:2:0"], "no number, list 1,2,3 or range FROM:TO:STEP"),
        (["--speed", "1:2:-1"], "no number"),
        (["--speed", "nan:2:1"], "no number"),
        (["--speed", "1:inf:1"], "no number"),
        (["--speed", "0,1"], "shot 0: Shot.speed must be above zero"),
        (["--speed", "nan"], "Shot.speed must be"),
        (["--angle", "1"], "--speed"),
        (["--speed", "1", "--angle", "0:9000:1", "--side", "0:9000:1"], "81018001 shots are too"),
        (["--speed", "1", "--ball", "blue"], "no ball 'blue'"),
        (["--speed", "1", "--threads", "0"], "no whole number above zero"),
        (["--speed", "1", "--threads", "1", "--processes", "1"], "not allowed with"),
        (["--speed", "1", "--csv", "/nowhere/at/all.csv"], "/nowhere/at/all.csv"),
        (["--speed", "1", "--engine", "literal"], "never rests"),
        (["--speed", "1", "--climb", "high"], "'high' is no number"),
        (["--speed", "1", "--dt", "0.1"], "--dt 0.1: needs --engine thesis, literal"),
        (["--speed", "1", "--ball", ""], "argument --ball: must not be empty: ''"),
        (["--speed", "1", "--npz", ""], "argument --npz: must not be empty: ''"),
        (["--speed", "1", "--speed", "2"], "argument --speed: is there twice"),
        (["--speed", "1", "--csv", "a", "--npz", "./a"], "one file for both"),
        (["--speed", "1", "--processes", "100000"], "'100000' are too many: at most 1024"),
        (["--speed", "1", "--threads", "9" * 5000], "no whole number above zero"),
        (["--speed", "1", "--climb", "1", "--engine", "thesis"], "only balls on the table"),
        (["--speed", "1", "--contacts", "5"], "--contacts 5: needs --npz FILE"),
        (["--speed", "1", "--contacts", "-5"], "'-5' is no whole number above zero"),
        (["--speed", "1", "--contacts", "10001"], "'10001' are too many: at most 10000"),
        (["--speed", "1", "--dask", "a", "--threads", "1"], "not allowed with"),
    ],
)
def test_what_cannot_be_swept_is_said(arguments, message, capsys):
    try:
        code = main(["sweep", "carom", *arguments])
    except SystemExit as end:  # argparse
        code = end.code
    printed = capsys.readouterr()
    assert code == 2
    assert message in printed.err
    assert printed.out == ""


def test_a_sweep_keeps_contacts(tmp_path):
    file = tmp_path / "out.npz"
    ranges = ["--speed", "3", "--angle", "0:330:30"]
    assert main(["sweep", "carom", *ranges, "--contacts", "8", "--npz", str(file)]) == 0
    shots = [Shot(3.0, float(angle)) for angle in range(0, 360, 30)]
    wanted = simulate_many(scenes.carom(), "white", shots, contacts=8)
    with np.load(file) as found:
        assert np.array_equal(found["contacts"], wanted.contacts)
        assert np.array_equal(found["dropped"], wanted.dropped)
        assert found["walls"].tolist() == ["west", "east", "south", "north"]


def test_the_workers_of_a_scheduler_share_a_sweep(capsys, monkeypatch):
    distributed = pytest.importorskip("distributed", reason="needs the extra `cluster`")
    monkeypatch.setattr("physics.batch.many.CHUNK", 5)
    ranges = ["sweep", "carom", "--speed", "3", "--angle", "0:330:30", "--csv", "-"]
    main(ranges)
    alone = capsys.readouterr().out
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None,
        protocol="tcp://", host="127.0.0.1",
    ) as cluster:  # fmt: skip
        assert main([*ranges, "--dask", cluster.scheduler_address]) == 0
    assert capsys.readouterr().out == alone


def test_a_scheduler_that_is_not_there_is_said(capsys, monkeypatch):
    pytest.importorskip("distributed", reason="needs the extra `cluster`")
    monkeypatch.setattr("physics.ranges.REACHED", 0.2)
    assert main(["sweep", "carom", "--speed", "3", "--dask", "tcp://127.0.0.1:9"]) == 2
    assert "127.0.0.1:9" in capsys.readouterr().err
    assert main(["sweep", "carom", "--speed", "3", "--dask", "no address"]) == 2
    monkeypatch.setitem(__import__("sys").modules, "distributed", None)
    assert main(["sweep", "carom", "--speed", "3", "--dask", "tcp://127.0.0.1:9"]) == 2
    assert "needs the extra `cluster`" in capsys.readouterr().err


def test_a_long_sweep_shows_a_bar(capsys, monkeypatch):
    pytest.importorskip("tqdm")
    monkeypatch.setattr("physics.ranges.PATIENCE", 0.0)
    monkeypatch.setattr("physics.batch.many.CHUNK", 5)
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert main(["sweep", "carom", "--speed", "3", "--angle", "0:19:1"]) == 0
    assert "20.0/20.0" in capsys.readouterr().err


def test_without_a_terminal_or_without_tqdm_there_is_no_bar(capsys, monkeypatch):
    monkeypatch.setattr("physics.ranges.PATIENCE", 0.0)
    main(["sweep", "carom", "--speed", "3"])
    assert capsys.readouterr().err.count("\n") == 1
    monkeypatch.setitem(__import__("sys").modules, "tqdm", None)
    main(["sweep", "carom", "--speed", "3"])
    events = len(simulate(scenes.carom(), "white", Shot(3.0)).log)
    assert capsys.readouterr().err == f"1 shot at white, {events} events\n"


@pytest.mark.parametrize("engine", [EventDriven(), TimeStepping(0.02)])
@pytest.mark.parametrize("threads", [0, 2])
def test_a_batch_says_how_far_it_is(engine, threads, monkeypatch):
    monkeypatch.setattr("physics.batch.many.CHUNK", 30)
    world, done = scenes.carom(), []
    world.engine = engine
    shots = [Shot(3.0, float(k)) for k in range(70)]
    if threads:
        with ThreadPoolExecutor(threads) as pool:
            simulate_many(world, "white", shots, executor=pool, progress=done.append)
    else:
        simulate_many(world, "white", shots, progress=done.append)
    assert sum(done) == 70
    assert len(done) > 1


def test_an_engine_without_batches_may_share_the_work_too():
    world = scenes.carom()
    world.cluster_law = "hertz"
    shots = [Shot(3.0, float(k)) for k in range(3)]
    alone = simulate_many(world, "white", shots)
    with ProcessPoolExecutor(1) as pool:
        shared = simulate_many(world, "white", shots, executor=pool)
    for a, b in zip(alone, shared, strict=True):
        assert np.array_equal(a, b)


def test_a_budget_that_is_used_up_in_another_process_is_the_same_error():
    world = scenes.carom()
    world.engine = TimeStepping(0.02, budget=3)
    with ProcessPoolExecutor(1) as pool, pytest.raises(EventBudgetError) as caught:
        simulate_many(world, "white", [Shot(3.0)], executor=pool)
    again = pickle.loads(pickle.dumps(caught.value))
    assert str(again) == str(caught.value)
    assert again.scene == caught.value.scene
    assert again.scene["balls"]
