"""Custom laws: any callable may be one, and none can spoil a world."""

import doctest
import pickle
import warnings
from math import inf, nan
from pathlib import Path

import numpy as np
import pytest

from physics import (
    Ball,
    Cloth,
    EnergyGainWarning,
    EventBudgetError,
    EventDriven,
    Shot,
    TimeStepping,
    Wall,
    laws,
    scenes,
    simulate,
    simulate_many,
)
from tests.support.batches import same

SHOT = Shot(3.0, 60.0, follow=0.5, side=1.5)
RIGID, ROUGH = laws.RigidCushion(), laws.RoughBall()


def rigid(v, roll, side):
    return RIGID(v, roll, side)


def rough(v, roll, side, mass):
    return ROUGH(v, roll, side, mass)


def everything(world):
    """All that a world knows, as one text: no bit may change unseen."""
    bodies = [ball.body for ball in world.balls]
    clock = world.clock.epoch, world.clock.now, world.clock.disturbed, world.clock.moved
    scene = world.scene._replace(ties=None, grid=None)  # of which a run makes notes
    return repr((bodies, scene, clock, world.due, [*map(tuple, world.log)], world.log.mark()))


def test_the_example_of_the_documentation_works():
    page = Path(__file__).parents[2] / "docs" / "laws.md"
    failed, tried = doctest.testfile(str(page), module_relative=False, encoding="utf-8")
    assert failed == 0
    assert tried > 10


@pytest.mark.parametrize("world", [scenes.carom(), scenes.rack15(gap=0.0)], ids=repr)
def test_a_named_law_behind_a_function_gives_the_same_digits(world):
    named, custom = world.copy(), world.copy()
    named.ball_law, named.cushion_law = laws.RoughBall(), laws.RigidCushion()
    custom.cushion_law = rigid
    if len(world.balls) == 4:  # in a cluster, a custom law for pairs is asked pair by pair
        custom.ball_law = rough
    else:
        custom.ball_law = laws.RoughBall()
    a, b = (simulate(w, world.balls[0].name, SHOT) for w in (named, custom))
    assert [ball.position for ball in a.balls] == [ball.position for ball in b.balls]
    assert [event.time for event in a.log] == [event.time for event in b.log]


NONSENSE = [nan, None, (), (1j, 1j), (nan, 0j, 0.0), (1 + 0j, complex(0, inf), 0.0), ("a", 0, 0),
            (1.0, 0j, 1j), (1.0, 0j, 0.0, 0.0), ("1", 0, 0)]  # fmt: skip
NONSENSE_OF_PAIRS = [nan, None, (1.0,), (nan, 0j), (1.0, complex(nan, 0)), (1j, 0j), (-1.0, 0j),
                     (0.0, 0j), (1.0, 0j, 0j)]  # fmt: skip


@pytest.mark.parametrize("said", NONSENSE, ids=repr)
@pytest.mark.parametrize("going", [False, True])
def test_nonsense_from_a_cushion_law_is_refused_and_the_run_undone(said, going):
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: said
    world.strike("white", SHOT)
    if going:
        world.step(1e-3)
    before = everything(world)
    with pytest.raises(
        ValueError, match=r"cushion law <lambda>, at ball 'white', returned"
    ) as info:
        world.run()
    assert repr(said) in str(info.value)
    assert everything(world) == before


@pytest.mark.parametrize("said", NONSENSE_OF_PAIRS, ids=repr)
def test_nonsense_from_a_ball_law_is_refused_and_the_step_undone(said):
    world = scenes.carom()
    world.ball_law = lambda v, roll, side, mass: said
    world.strike("white", Shot(3.0))
    world.step(0.2)
    before = everything(world)
    with pytest.raises(ValueError, match="ball law <lambda>, at balls 'white' and 'yellow', ret"):
        world.step(0.3)
    assert everything(world) == before
    world.ball_law = "rough"
    world.run()
    assert world.at_rest


def test_a_law_may_answer_in_numpy_numbers():
    world, same = scenes.carom(), scenes.carom()
    same.cushion_law = RIGID
    world.cushion_law = lambda v, roll, side: np.array(RIGID(v, roll, side))
    world.ball_law = lambda *given: list(np.array(ROUGH(*given)))
    a, b = (simulate(w, "white", SHOT) for w in (world, same))
    assert [ball.position for ball in a.balls] == [ball.position for ball in b.balls]


def test_a_ball_that_is_let_into_the_wall_is_noticed():
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: (v, roll, side)
    world.strike("white", Shot(3.0, 90.0))
    with pytest.raises(ValueError, match="'white', lets it go on into the wall: it returned v ="):
        world.run()


@pytest.mark.parametrize("what", ["position", "velocity", "spin"])
def test_a_law_that_moves_or_pushes_a_ball_itself_is_caught(what):
    world = scenes.carom()

    def pushy(v, roll, side):
        setattr(world.balls[2], what, (0.1, 0.2, 0.3)[: len(getattr(world.balls[2], what))])
        return RIGID(v, roll, side)

    world.cushion_law = pushy
    world.strike("white", SHOT)
    world.step(1e-3)
    before = everything(world)
    with pytest.raises(ValueError, match=r"cushion law pushy, at ball 'white', changed Ball.'red'"):
        world.run()
    assert everything(world) == before


USED = [
    ("add", lambda world: world.add(Ball("late", at=(0.9, 0.4)))),
    ("add", lambda world: world.add(Wall.line(1.0, 0.0, 1.0))),
    ("strike", lambda world: world.strike("red", SHOT)),
    ("strike", lambda world: world.strike("white", SHOT)),
    ("stop", lambda world: world.stop()),
    ("step", lambda world: world.step(0.01)),
    ("run", lambda world: world.run()),
    ("run", lambda world: world.run(until=world.time)),
    ("engine", lambda world: setattr(world, "engine", TimeStepping(0.01))),
    ("cloth", lambda world: setattr(world, "cloth", Cloth(slide=0.5))),
    ("ball_law", lambda world: setattr(world, "ball_law", "smooth")),
    ("cushion_law", lambda world: setattr(world, "cushion_law", "rigid")),
    ("cluster_law", lambda world: setattr(world, "cluster_law", "hertz")),
]


def settings(world):
    kept = world.engine, world.cloth, world.ball_law, world.cushion_law, world.cluster_law
    return *kept, world.walls, [ball.name for ball in world.balls], world.log.names


@pytest.mark.parametrize(("name", "use"), USED)
@pytest.mark.parametrize("engine", [EventDriven(), TimeStepping(dt=1 / 180)], ids=repr)
def test_a_law_that_uses_its_world_while_an_event_is_handled_is_refused(name, use, engine):
    world = scenes.carom()
    world.engine = engine

    def nosy(v, roll, side):
        use(world)
        return RIGID(v, roll, side)

    world.cushion_law = nosy
    world.strike("white", SHOT)
    world.step(1e-3)
    before, kept = everything(world), settings(world)
    with pytest.raises(RuntimeError, match=f"law nosy, at ball 'white', used World.{name}: a law"):
        world.run()
    assert (everything(world), settings(world)) == (before, kept)
    world.cushion_law = "rigid"
    use(world)  # only a law may not


def test_a_law_that_uses_the_world_of_a_batch_is_refused():
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: world.strike("red", SHOT)
    world.plan()
    before = everything(world)
    with pytest.raises(RuntimeError, match=r"cushion law <lambda>, at a ball, used World\.strike"):
        simulate_many(world, "white", [SHOT])
    assert everything(world) == before


def test_a_law_may_use_another_world_and_a_copy_of_its_own():
    world, other = scenes.carom(), scenes.carom()
    copies = []

    def curious(v, roll, side):
        copies.append(world.copy())
        copies[-1].cushion_law = "rigid"
        copies[-1].stop()
        other.strike("white", SHOT)
        other.step(0.01)
        return RIGID(v, roll, side)

    world.cushion_law = curious
    world.strike("white", SHOT)
    world.run()
    assert world.at_rest
    assert len(copies) == sum(event.kind == "cushion" for event in world.log)


def test_whatever_a_law_raises_the_world_is_as_it_was():
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: 1 / 0
    world.strike("white", SHOT)
    before = everything(world)
    with pytest.raises(ZeroDivisionError) as info:
        world.run()
    assert "cushion law <lambda>, at ball 'white'" in info.value.__notes__[0]
    assert everything(world) == before


def lively(v, roll, side):
    return complex(-1.1 * v.real, v.imag), roll, side


def test_a_law_that_gains_energy_gives_one_warning_with_the_amount():
    world = scenes.carom()
    world.cushion_law = lively
    world.strike("white", Shot(2.0, 90.0))
    with pytest.warns(EnergyGainWarning, match="cushion law lively, at ball 'white'") as caught:
        world.run(until=1.0)
    event = next(event for event in world.log if event.kind == "cushion")
    assert event.energy_lost < 0.0
    assert f"gained {-event.energy_lost:.3g} J" in str(caught[0].message)
    assert len(caught) == 1
    world.run(until=1.5)  # warnings are errors here: a second one would raise
    simulate(world, "white", SHOT)
    other = scenes.carom()
    other.cushion_law = lively
    with pytest.warns(EnergyGainWarning):  # another world
        simulate(other, "white", SHOT)


def test_a_pair_law_that_gains_energy_gives_a_warning_with_the_amount():
    world = scenes.carom()
    world.ball_law = lambda v, roll, side, mass: (2.2 * mass * v.real, 0.05j)
    world.strike("white", Shot(3.0, 0.4, side=1.0))
    with pytest.warns(EnergyGainWarning, match="balls 'white' and 'yellow'") as caught:
        world.run(until=0.5)
    event = next(event for event in world.log if event.kind == "ball")
    assert f"gained {-event.energy_lost:.3g} J" in str(caught[0].message)


def test_a_warning_that_is_an_error_undoes_the_run_too():
    world = scenes.carom()
    world.cushion_law = lively
    world.strike("white", SHOT)
    before = everything(world)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(EnergyGainWarning):
            world.run()
    assert everything(world) == before


def test_no_named_law_warns_and_those_that_bend_physics_say_so():
    for law in (
        laws.ThesisCushion(), laws.CappedCushion(), laws.RigidCushion(), laws.MathavanCushion()
    ):  # fmt: skip
        v, roll, _ = law(-1 + 0j, 0j, 0.0)  # a ball that does not turn
        assert law.creates_energy is (abs(v) ** 2 + 0.4 * abs(roll) ** 2 > 1.0)
    for law in (laws.ThesisBall, laws.SmoothBall, laws.RoughBall):
        assert law().loses_momentum is (law is laws.ThesisBall)
    world = scenes.thesis_2()
    world.run()  # warnings are errors here


def test_a_law_that_forgets_to_part_is_helped():
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: (complex(0.0, v.imag), roll, side)
    world.strike("white", Shot(1.0, 80.0, follow=1.0))
    world.run()
    assert world.at_rest


def test_a_copy_watches_its_own_balls():
    world = scenes.carom()
    held = []

    def meddling(v, roll, side):
        held[0].balls[1].position = (0.3, 0.3)
        return RIGID(v, roll, side)

    world.cushion_law = meddling
    world.strike("white", SHOT)
    copy = world.copy()
    held.append(copy)
    before = everything(copy)
    with pytest.raises(ValueError, match="changed"):
        copy.run()
    assert everything(copy) == before


def test_a_batch_names_the_law_and_can_go_to_another_process():
    world = scenes.carom()
    world.cushion_law = rigid
    plain = scenes.carom()
    plain.cushion_law = RIGID
    pickle.loads(pickle.dumps(world.scene))
    shots = [Shot(3.0, float(angle)) for angle in range(0, 360, 40)]
    assert same(*(simulate_many(w, "white", shots) for w in (world, plain)))
    world.cushion_law = lambda v, roll, side: (nan, roll, side)
    with pytest.raises(ValueError, match="cushion law <lambda>"):
        simulate_many(world, "white", shots)


def test_fixed_steps_are_watched_as_well():
    world = scenes.carom()
    world.engine = TimeStepping(dt=1 / 180)
    world.cushion_law = lambda v, roll, side: (nan, roll, side)
    world.strike("white", SHOT)
    before = everything(world)
    with pytest.raises(ValueError, match="cushion law <lambda>, at ball 'white', returned"):
        world.run()
    assert everything(world) == before


def test_a_budget_that_is_used_up_is_not_undone():
    world = scenes.carom()
    world.engine = EventDriven(budget=3)
    world.cushion_law = rigid
    world.strike("white", SHOT)
    with pytest.raises(EventBudgetError):
        world.run()
    assert len(world.log) == 4


def test_many_balls_with_cells_are_put_back_too():
    world = scenes.carom()
    for k in range(40):
        x, y = -1.2 + 0.075 * (k % 10), -0.55 + 0.075 * (k // 10)
        world.add(Ball(f"{k}", at=(x, y)))
    calls = []

    def fails_late(v, roll, side):
        calls.append(v)
        return (nan, roll, side) if len(calls) == 5 else RIGID(v, roll, side)

    world.cushion_law = fails_late
    world.strike("white", Shot(3.0, 60.0))
    before = everything(world)
    with pytest.raises(ValueError, match="returned"):
        world.run()
    assert everything(world) == before
    calls.extend([0j] * 10)
    after = simulate(world, "white", SHOT)
    assert after.at_rest
