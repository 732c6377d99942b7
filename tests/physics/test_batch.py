"""Batches: the digits of a batch are those of single shots, whoever does the work."""

from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from math import inf

import numpy as np
import pytest

from physics import (
    Ball,
    Cloth,
    EventBudgetError,
    EventDriven,
    Shot,
    Wall,
    World,
    laws,
    scenes,
    simulate,
    simulate_many,
    tables,
)
from tests.support.batches import same

numba = pytest.importorskip("numba", reason="compiled batches need the extra `fast`")


def fan(shots, speed=3.0):
    return [Shot(speed, 360.0 * k / shots, follow=0.5, side=1.5) for k in range(shots)]


def rack():
    world = scenes.rack15()
    world.stop()
    return world


def snooker():
    world = tables.match_carom()
    for k in range(22):
        world.add(Ball(f"{k}", at=(-1.2 + 0.23 * (k % 11), -0.3 + 0.55 * (k // 11))))
    return world


def frozen():
    """Balls that touch each other and a cushion."""
    world = tables.medium_carom()
    r = 0.03275
    world.add(Ball("0", at=(-0.6, 0.0)))
    for k in range(1, 5):
        world.add(Ball(f"{k}", at=(2 * r * k, 0.635 - r)))
    return world


def odd():
    """Slanted walls, unlike balls, every law that compiles in turn."""
    world = tables.thesis()
    world.add(Wall.through((0.9, -0.635), (1.224, -0.3)))
    world.add(Ball("0", at=(-0.6, 0.0)))
    world.add(Ball("1", at=(0.2, 0.1), radius=0.02, mass=0.1))
    world.add(Ball("2", at=(0.5, -0.2), radius=0.04, mass=0.4))
    return world


LAWS = [
    (laws.SmoothBall(), laws.CappedCushion()),
    (laws.RoughBall(0.95, 0.05), laws.RigidCushion()),
    (laws.RoughBall(), laws.RigidCushion(0.9, 0.2, 1.4)),
    (laws.RoughBall(), laws.MathavanCushion()),
    (laws.ThesisBall(), laws.ThesisCushion()),
]


@pytest.mark.parametrize("scene", [scenes.carom, rack, snooker, frozen, odd])
def test_compiled_interpreted_and_single_shots_agree_in_every_bit(scene):
    world, shots = scene(), fan(12, speed=5.0)
    first = world.balls[0]
    compiled = simulate_many(world, first, shots, compiled=True)
    interpreted = simulate_many(world, first, shots, compiled=False)
    for a, b in zip(compiled, interpreted, strict=True):
        assert np.array_equal(a, b)
    for k, shot in enumerate(shots[:4]):
        after = simulate(world, first, shot)
        assert [tuple(p) for p in compiled.positions[k]] == [ball.position for ball in after.balls]
        assert compiled.events[k] == len(after.log)
        assert compiled.times[k] == after.time


@pytest.mark.parametrize(("ball_law", "cushion_law"), LAWS)
def test_every_law_compiles_to_the_same_bits(ball_law, cushion_law):
    world = odd()
    world.ball_law, world.cushion_law = ball_law, cushion_law
    shots = fan(24)
    compiled = simulate_many(world, "0", shots, compiled=True)
    interpreted = simulate_many(world, "0", shots, compiled=False)
    assert np.array_equal(compiled.positions, interpreted.positions)


@pytest.mark.parametrize("pool", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_an_executor_changes_nothing_but_what_does_the_work(pool, monkeypatch):
    monkeypatch.setattr("physics.batch.many.CHUNK", 50)
    world, shots = scenes.carom(), fan(200)
    alone = simulate_many(world, "white", shots, compiled=True)
    with pool(2) as executor:
        together = simulate_many(world, "white", shots, executor=executor, compiled=True)
    for a, b in zip(alone, together, strict=True):
        assert np.array_equal(a, b)


def test_a_batch_begins_where_the_balls_lie_now():
    """Layouts are kept between batches, which must not be seen."""
    world, other = scenes.carom(), scenes.carom()
    first = simulate_many(world, "white", fan(3), compiled=True)
    for ball in world.balls:
        ball.position = ball.position[0], -ball.position[1]
    moved = simulate_many(world, "white", fan(3), compiled=True)
    assert not same(first, moved)
    assert same(first, simulate_many(other, "white", fan(3), compiled=True))
    for ball in world.balls:
        ball.position = ball.position[0], -ball.position[1]
    assert same(first, simulate_many(world, "white", fan(3), compiled=True))


def test_shots_may_be_an_array():
    world = scenes.carom()
    rows = np.array([[3.0, 10.0, 0.5, 0.0, 1.5], [2.0, -70.0, -1.0, 0.3, 0.0]])
    shots = [Shot(*row) for row in rows.tolist()]
    for a, b in zip(
        simulate_many(world, "white", rows), simulate_many(world, "white", shots), strict=True
    ):
        assert np.array_equal(a, b)


def test_no_shots_give_empty_arrays():
    outcomes = simulate_many(scenes.carom(), "white", [])
    assert outcomes.positions.shape == (0, 4, 2)
    assert outcomes.times.shape == outcomes.events.shape == (0,)


BAD = [(0, 0.0), (0, inf), (1, np.nan), (4, -inf), (2, 1e51)]


@pytest.mark.parametrize(("column", "value"), BAD)
def test_a_bad_shot_is_named(column, value):
    rows = np.array([[3.0, 10.0, 0.5, 0.0, 1.5]] * 3)
    rows[1, column] = value
    with pytest.raises(ValueError, match=r"shot 1: Shot\.\w+ must be .*not"):
        simulate_many(scenes.carom(), "white", rows)


def test_the_world_stays_as_it_is():
    world = scenes.carom()
    before = [(ball.position, ball.velocity, ball.spin) for ball in world.balls]
    simulate_many(world, "white", fan(3))
    assert [(ball.position, ball.velocity, ball.spin) for ball in world.balls] == before
    assert world.time == 0.0
    assert len(world.log) == 0


def test_too_many_events_are_an_error_and_carry_the_scene():
    world = scenes.carom()
    world.engine = EventDriven(budget=5)
    with pytest.raises(EventBudgetError) as caught:
        simulate_many(world, "white", fan(3))
    assert caught.value.scene is not None


def test_a_custom_law_runs_interpreted():
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: (complex(-0.9 * v.real, v.imag), roll, side)
    with pytest.raises(ValueError, match="interpreted"):
        simulate_many(world, "white", fan(1), compiled=True)
    assert simulate_many(world, "white", fan(2)).events.min() > 0


def test_the_game_and_single_shots_never_load_numba():
    import subprocess
    import sys

    code = (
        "import sys, physics; from physics import *;"
        "simulate(scenes.carom(), 'white', Shot(3.0, 10));"
        "assert 'numba' not in sys.modules and 'numpy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)


def alone(code):
    """Run it in a process of its own, in which no kernel is loaded yet."""
    import subprocess
    import sys

    start = "import sys, physics.batch.play as play\nfrom physics import *\n"
    start += "shots = [[3.0, 0.5 * k, 0.5, 0.0, 1.5] for k in range(600)]\n"
    end = "\nassert ('physics.compiled_kernel' in sys.modules) == loads"
    subprocess.run([sys.executable, "-c", start + code + end], check=True)


def test_few_shots_do_not_load_the_compiled_kernel_and_many_do():
    alone("simulate_many(scenes.carom(), 'white', shots); loads = False")
    alone("play.LOADING = 0.05; simulate_many(scenes.carom(), 'white', shots); loads = True")
    alone("play.LOADING = 0.05; simulate_many(scenes.carom(), 'white', shots[:9]); loads = False")


def test_a_kernel_that_is_loaded_plays_a_single_shot_too(monkeypatch):
    world = scenes.carom()
    simulate_many(world, "white", fan(1), compiled=True)
    from physics.batch import jobs

    monkeypatch.setattr(jobs.Job, "_interpreted", None)
    assert simulate_many(world, "white", fan(1)).events[0] > 0


def test_shots_that_were_played_to_decide_are_part_of_the_outcome(monkeypatch):
    world, shots, done = scenes.carom(), fan(40), []
    monkeypatch.setattr("physics.batch.jobs.loaded", lambda: False)
    monkeypatch.setattr("physics.batch.play.LOADING", 1e-3)
    first = simulate_many(world, "white", shots, contacts=9, progress=done.append)
    assert done == [16, 24]
    assert same(first, simulate_many(world, "white", shots, contacts=9, compiled=True))


def test_threads_that_share_a_world_do_not_share_its_arrays():
    world, shots = scenes.carom(), np.array([[3.0, k, 0.5, 0.0, 1.5] for k in range(3000)])
    simulate_many(world, "white", shots[:1], compiled=True)
    with ThreadPoolExecutor(4) as pool:
        pieces = list(
            pool.map(
                lambda k: simulate_many(world, "white", shots[k::8], compiled=True), range(8)
            )
        )
    whole = simulate_many(world, "white", shots, compiled=True)
    for k, piece in enumerate(pieces):
        assert np.array_equal(piece.positions, whole.positions[k::8])


def test_a_scene_that_has_changed_is_packed_again():
    world, shots = scenes.carom(), fan(24)
    simulate_many(world, "white", shots, compiled=True)
    changes = (
        lambda: setattr(world, "cloth", Cloth(slide=0.1)),
        lambda: setattr(world, "cushion_law", "mathavan"),
        lambda: world.add(Wall.through((0.9, -0.635), (1.224, -0.3))),
        lambda: world.add(Ball("new", at=(0.0, -0.4), radius=0.02)),
        lambda: setattr(world.ball("red"), "position", (0.4, 0.1)),
        lambda: setattr(world.ball("red"), "spin", (0.0, 0.0, 40.0)),
    )
    seen = [simulate_many(world, "white", shots, compiled=True)]
    for change in changes:
        change()
        seen.append(simulate_many(world, "white", shots, compiled=True))
        assert same(seen[-1], simulate_many(world, "white", shots, compiled=False))
        assert not same(seen[-1], seen[-2])


def test_a_cloth_without_friction_and_walls_has_no_traps():
    world = World(Cloth(0.0, 0.0, 0.0), laws.SmoothBall(1.0))
    world.add(Ball("a", at=(0.0, 0.0), velocity=(1.0, 0.0)))
    world.add(Ball("b", at=(1e3, 0.0)))
    world.run()
    assert [event.kind for event in world.log] == ["ball"]
    assert world.log[0].time == pytest.approx(1e3 - 0.0655, rel=1e-15)


def test_a_cluster_does_the_same_work():
    distributed = pytest.importorskip("distributed", reason="needs the extra `cluster`")
    world, shots = scenes.carom(), fan(60)
    alone = simulate_many(world, "white", shots, compiled=False)
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, processes=False, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        executor = client.get_executor()
        together = simulate_many(world, "white", shots, executor=executor, compiled=False)
    for a, b in zip(alone, together, strict=True):
        assert np.array_equal(a, b)
