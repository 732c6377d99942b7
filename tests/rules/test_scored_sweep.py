"""`python -m danggu sweep`: what ranges of shots are worth by the rules of a game."""

import csv

import numpy as np
import pytest

from danggu.__main__ import main, world_of
from danggu.players.errors import missed
from danggu.players.levels import CLUB
from danggu.rules import GAMES, RACKS
from danggu.rules.verdict import Turn
from danggu.scores import scores
from physics import Ball, Shot, scenes, simulate, store

FAN = ["sweep", "--game", "three-cushion", "--speed", "4,5", "--angle", "0:354:6", "--side", "2"]


def rows(text):
    head, *lines = csv.reader(text.splitlines())
    return head, np.array(lines, float)


def test_a_shot_is_worth_what_its_log_says(capsys):
    assert main([*FAN, "--csv", "-"]) == 0
    head, table = rows(capsys.readouterr().out)
    assert head[-3:] == ["points", "made", "fouls"]
    world, rules = world_of("opening", "three-cushion"), GAMES["three-cushion"]()
    for row in table:
        verdict = rules.verdict(simulate(world, "white", Shot(*row[:6])).log, Turn(cue="white"))
        assert row[6:].tolist() == [verdict.points, verdict.made, verdict.foul]
    assert 0 < table[:, 7].sum() < len(table)


def test_with_errors_it_is_worth_the_mean_of_its_copies(tmp_path, capsys):
    file = tmp_path / "map.npz"
    more = ["--noise", "club", "--copies", "20", "--seed", "3", "--npz", str(file)]
    assert main([*FAN, *more]) == 0
    assert f"written to {file}" in capsys.readouterr().err
    world, rules = world_of("opening", "three-cushion"), GAMES["three-cushion"]()
    with np.load(file) as found:
        shots, made = found["shots"], found["made"]
    copies = missed(shots, CLUB, 20, world.balls[0].radius, np.random.default_rng(3))
    for k in (0, 17, 50):
        logs = [simulate(world, "white", Shot(*row)).log for row in copies[20 * k : 20 * k + 20]]
        wins = [rules.verdict(log, Turn(cue="white")).made for log in logs]
        assert made[k] == pytest.approx(np.mean(wins), abs=1e-12)


def test_scores_takes_balls_and_shots_as_simulate_many_does():
    world, rules = world_of("opening", "three-cushion"), GAMES["three-cushion"]()
    table = np.array([[4.0, angle, 0.0, 0.0, 2.0, 0.0] for angle in range(0, 360, 6)])
    known = scores(world, "white", table, rules, level=CLUB, copies=5)
    assert known.made.any()
    for ball in ("white", world.ball("white")):
        for shots in (table, table[:, :5], table.tolist(), [Shot(*row) for row in table]):
            found = scores(world, ball, shots, rules, level=CLUB, copies=5)
            assert [column.tolist() for column in found] == [column.tolist() for column in known]
    assert not len(scores(world, "white", [], rules, level=CLUB).made)
    by_key = scores(world, "white", table, rules, level="club", copies=5)
    assert [column.tolist() for column in by_key] == [column.tolist() for column in known]
    with pytest.raises(ValueError, match="level must be a Level or one of"):
        scores(world, "white", table, rules, level="pro")


@pytest.mark.parametrize("level", [None, CLUB])
@pytest.mark.parametrize(
    "shots", [np.ones((3, 7)), np.ones(6), [[1.0, 2.0]]], ids=["seven", "flat", "two"]
)
def test_scores_refuses_what_is_no_table_of_shots(shots, level):
    world, rules = world_of("opening", "three-cushion"), GAMES["three-cushion"]()
    with pytest.raises(ValueError, match="rows of 5 or 6 numbers"):
        scores(world, "white", shots, rules, level=level)


@pytest.mark.parametrize("game", [game for game in GAMES if game not in (*RACKS, "free")])
def test_a_cannon_game_is_swept_from_its_opening(game, capsys):
    assert main(["sweep", "--game", game, "--speed", "4", "--angle", "0,180"]) == 0
    assert "2 shots at white" in capsys.readouterr().err


@pytest.mark.parametrize("workers", [["--threads", "2"], ["--processes", "2"]])
def test_what_does_the_work_changes_no_digit(workers, capsys):
    more = ["--noise", "expert", "--copies", "5", "--csv", "-"]
    main([*FAN, *more])
    alone = capsys.readouterr().out
    main([*FAN, *more, *workers])
    assert capsys.readouterr().out == alone


def test_the_workers_of_a_scheduler_share_it(capsys):
    distributed = pytest.importorskip("distributed", reason="needs the extra `cluster`")
    main([*FAN, "--csv", "-"])
    alone = capsys.readouterr().out
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None,
        protocol="tcp://", host="127.0.0.1",
    ) as cluster:  # fmt: skip
        main([*FAN, "--csv", "-", "--dask", cluster.scheduler_address])
    assert capsys.readouterr().out == alone


def test_a_shot_with_more_contacts_than_are_kept_is_judged_by_all_of_them(monkeypatch):
    world, rules = world_of("opening", "three-cushion"), GAMES["three-cushion"]()
    shots = np.array([[5.0, angle, 0.0, 0.0, 2.0, 0.0] for angle in range(0, 360, 10)], float)
    whole = scores(world, "white", shots, rules)
    monkeypatch.setattr("danggu.scores.KEPT", 2)
    for a, b in zip(scores(world, "white", shots, rules), whole, strict=True):
        assert np.array_equal(a, b)


def test_a_saved_world_and_a_scene_can_be_swept(tmp_path, capsys):
    world = scenes.carom()
    world.add(Ball("extra", at=(0.9, 0.4)))
    store.save(world, tmp_path / "world.json")
    for name in (str(tmp_path / "world.json"), "carom"):
        assert main(["sweep", name, *FAN[1:], "--ball", "yellow"]) == 0
        assert "120 shots at yellow" in capsys.readouterr().err
    store.save(Shot(2.0), tmp_path / "shot.json")
    assert main(["sweep", str(tmp_path / "shot.json"), *FAN[1:]]) == 2
    assert "shot.json holds no world" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--speed", "1"], "--game"),
        (["--game", "golf", "--speed", "1"], "golf"),
        (["--game", "snooker", "--speed", "1"], "no opening of snooker is known"),
        (["--game", "three-cushion", "--speed", "1", "--noise", "lazy"], "lazy"),
        (["--game", "three-cushion", "--speed", "1", "--copies", "3"], "need --noise"),
        (["--game", "three-cushion", "--speed", "1", "--ball", "blue"], "no ball 'blue'"),
        (["--game", "three-cushion", "--speed", "-1"], "Shot.speed must be above zero"),
        (
            ["--game", "three-cushion", "--speed", "1", "--noise", "club", "--copies", "99999999"],
            "too many",
        ),
        (["nowhere.json", "--game", "three-cushion", "--speed", "1"], "nowhere.json"),
    ],
)
def test_what_cannot_be_swept_is_said(arguments, message, capsys):
    try:
        code = main(["sweep", *arguments])
    except SystemExit as end:  # argparse
        code = end.code
    printed = capsys.readouterr()
    assert code == 2
    assert message in printed.err
    assert printed.out == ""


@pytest.mark.parametrize("copies", [0, -1, 1.5, True])
def test_copies_that_are_none_are_refused(copies):
    world, rules = world_of("opening", "three-cushion"), GAMES["three-cushion"]()
    with pytest.raises(ValueError, match="copies must be a whole number above 0, not"):
        scores(world, "white", np.ones((2, 6)), rules, level=CLUB, copies=copies)
