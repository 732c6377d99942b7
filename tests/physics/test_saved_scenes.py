"""A scene with its shot, log and outcomes in a file, and played from there on the command line."""

import json

import numpy as np
import pytest

from physics import (
    Ball,
    Shot,
    ledger,
    scenes,
    sensitivity,
    simulate,
    simulate_many,
    store,
    tables,
)
from physics.__main__ import main
from physics.files.history import array_data, array_of
from physics.files.node import Node

SHOT = Shot(3.0, 1.0, follow=1.5, side=0.5)


def pool():
    world = tables.pool_9ft()
    for ball in world.table.rack("9-ball"):
        world.add(ball)
    world.add(Ball("white", at=(-0.6, 0.1)))
    return world


MADE = {
    "a carom shot": (scenes.carom, "white", SHOT),
    "a jump": (scenes.carom, "white", Shot(2.0, 10.0, climb=1.0)),
    "a break with clusters": (pool, "white", Shot(7.0, -4.3, follow=1.0)),
    "pressed on by spin": (lambda: scenes.cradle(4), "0", Shot(1.0, follow=5.0)),
}


@pytest.mark.parametrize("name", MADE)
def test_a_scene_comes_back_with_its_shot_and_its_whole_log(name, tmp_path):
    make, ball, shot = MADE[name]
    scene = store.Played.of(make(), ball, shot)
    store.save(scene, tmp_path / "scene.json")
    again = store.load(tmp_path / "scene.json")
    assert (again.ball, again.shot) == (ball, shot)
    assert [*map(tuple, again.log)] == [*map(tuple, scene.log)]
    assert [*ledger(again.log)] == [*ledger(scene.log)]
    assert again.log.at(0.7) == scene.log.at(0.7)
    after = again.after()
    assert [b.position for b in after.balls] == [b.position for b in scene.after().balls]
    assert [*map(tuple, after.log)] == [*map(tuple, again.log)]
    assert store.dumps(again) == store.dumps(scene)


def test_what_is_read_from_the_log_of_a_file_groups_clusters_as_before():
    log = store.Played.of(pool(), "white", Shot(7.0, -4.3)).log
    again = store.loads(store.dumps(store.Played(pool(), "white", Shot(7.0, -4.3), log))).log
    assert [again.begun(k) for k in range(len(log))] == [log.begun(k) for k in range(len(log))]
    assert [*again.contacts()] == [*log.contacts()]
    shared = [raw[-1] for raw in again._events if raw[-1] is not None]
    kept = [raw[-1] for raw in log._events if raw[-1] is not None]
    assert len({id(one[2]) for one in shared}) == len({id(one[2]) for one in kept})


def test_a_scene_keeps_the_outcomes_of_a_batch_and_its_shots():
    shots = [Shot(2.0, 30.0 * k) for k in range(9)]
    world = tables.pool_9ft()
    world.add(Ball("white", at=(-0.3, 0.1)))
    shots.append(Shot(3.0, 43.0))
    outcomes = simulate_many(world, "white", shots, compiled=False)
    scene = store.Played.batch(world, "white", shots, outcomes)
    again = store.loads(store.dumps(scene))
    assert again.shots[:, 1].tolist() == [shot.angle for shot in shots]
    for name, values in outcomes._asdict().items():
        kept = getattr(again.outcomes, name)
        if hasattr(values, "dtype"):
            assert kept.dtype == values.dtype
            assert np.array_equal(kept, values, equal_nan=kept.dtype.kind == "f")
        else:
            assert kept == values


def test_records_come_back_with_their_type():
    kind = np.dtype([("kind", "u1"), ("again", "?"), ("first", "i2"), ("time", "f8")], align=True)
    records = np.array([[(1, True, -3, 0.1), (2, False, 7, 1e-300)]], kind)
    text = json.dumps(array_data(records))
    again = array_of(Node(json.loads(text), "contacts"))
    assert again.dtype == kind
    assert (again == records).all()
    for wrong in ([["kind", "O"]], [["kind"]], "V2", 3):
        with pytest.raises(ValueError, match=r"^contacts: "):
            array_of(Node({**json.loads(text), "type": wrong}, "contacts"))


def test_a_log_of_another_world_is_refused():
    log = simulate(scenes.carom(), "white", SHOT).log
    with pytest.raises(ValueError, match="must be of its world"):
        store.dumps(store.Played(scenes.single(), log=log))


def change(data, *path):
    """The text with another value there."""
    *keys, last, value = path
    at = data
    for key in keys:
        at = at[key]
    at[last] = value
    return json.dumps(data)


@pytest.mark.parametrize(
    ("path", "words"),
    [(("ball", "blue"), "there is no ball 'blue'"),
     (("shot", "speed", -1.0), "Shot.speed must be above zero"),
     (("log", "legs", []), r"log\.legs must be of 4 balls, not 0"),
     (("log", "legs", 0, 0, 2, 7), r"log\.legs\[0\]\[0\]\[2\]"),
     (("log", "legs", 0, 0, 7, "flying"), "'flying'; it must be one of resting, rolling"),
     (("log", "legs", 0, 0, []), r"log\.legs\[0\]\[0\] must be 14 values, not 0"),
     (("log", "events", 0, 2, "bounce"), "'bounce'; it must be one of roll, rest"),
     (("log", "events", 1, 4, 17), "must be a number from 0 to 3, not 17"),
     (("log", "events", 1, 5, 10**6), r"log\.events\[1\]\[5\] must be a number from 0 to"),
     (("log", "events", 0, []), r"log\.events\[0\] must be 9 values"),
     (("log", "fields", ["a"]), r"log\.fields must be epoch, since"),
     (("danggu", "scenery"), '"world", "shot" or "scene"')],
)  # fmt: skip
def test_a_scene_that_cannot_be_read_says_where(path, words):
    data = json.loads(store.dumps(store.Played.of(scenes.carom(), "white", SHOT)))
    with pytest.raises(ValueError, match=words):
        store.loads(change(data, *path))


def test_outcomes_that_cannot_be_read_say_where():
    world = scenes.carom()
    outcomes = simulate_many(world, "white", [SHOT], compiled=False)
    text = store.dumps(store.Played.batch(world, "white", [SHOT], outcomes))
    for path in (("times", "type", "O"), ("times", "shape", [7]), ("times", "data", ["a"])):
        with pytest.raises(ValueError, match=r"^outcomes\.times"):
            store.loads(change(json.loads(text), "outcomes", *path))


def test_the_command_line_plays_a_scene_from_its_file(tmp_path, capsys):
    after = simulate(scenes.carom(), "white", SHOT)
    store.save(store.Played.of(scenes.carom(), "white", SHOT), tmp_path / "my.json")
    assert main(["scene", str(tmp_path / "my.json")]) == 0
    said = capsys.readouterr().out
    assert f"{len(after.log)} events in {after.time:.4f} s, exact engine" in said
    world = scenes.carom()
    world.strike("white", SHOT)
    store.save(world, tmp_path / "world.json")
    assert main(["scene", str(tmp_path / "world.json")]) == 0
    assert capsys.readouterr().out.split("\n")[1:] == said.split("\n")[1:]


def test_the_command_line_says_which_files_hold_no_scene(tmp_path, capsys):
    store.save(SHOT, tmp_path / "shot.json")
    (tmp_path / "bad.json").write_text("{}")
    for name, words in (
        ("shot.json", "a shot alone"), ("bad.json", "danggu is missing"), ("no.json", "No such"),
    ):  # fmt: skip
        assert main(["scene", str(tmp_path / name)]) == 2
        assert words in capsys.readouterr().err
    assert main(["scene", "nothing"]) == 2
    assert "no scene 'nothing': there are thesis_1" in capsys.readouterr().err


def test_a_picture_of_a_scene_in_a_file_is_drawn(tmp_path):
    pytest.importorskip("matplotlib")
    store.save(store.Played.of(scenes.carom(), "white", SHOT), tmp_path / "my.json")
    assert main(["scene", str(tmp_path / "my.json"), "--png", str(tmp_path / "my.png")]) == 0
    assert (tmp_path / "my.png").stat().st_size > 10_000


def test_a_scene_says_shortly_what_is_in_it():
    scene = store.Played.of(scenes.carom(), "white", Shot(3.0))
    said = f"Shot(speed=3.0) at white, <Log of {len(scene.log)} events>"
    assert repr(scene) == f"<Played with 4 balls: {said}>"
    assert sensitivity(scene.world, scene.ball, scene.shot).events[0].event == scene.log[0]
