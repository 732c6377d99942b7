"""Games as Gymnasium and PettingZoo have them."""

import doctest
import runpy
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

gymnasium = pytest.importorskip("gymnasium", reason="needs the extra `rl`")
pytest.importorskip("danggu.envs.versus", reason="needs the extra `rl`")

from gymnasium.utils.env_checker import check_env  # noqa: E402
from gymnasium.vector import AutoresetMode  # noqa: E402

from danggu import envs  # noqa: E402
from danggu.envs import IDS, Noise, Setup  # noqa: E402
from danggu.envs.versus import env  # noqa: E402
from danggu.rules import GAMES  # noqa: E402
from danggu.rules.verdict import Turn  # noqa: E402
from physics import Ball, simulate_many, tables  # noqa: E402

with warnings.catch_warnings():
    warnings.simplefilter("ignore", DeprecationWarning)  # of the games it tries itself with
    from pettingzoo.test import api_test, seed_test

CANNONS = [name for name, game in IDS.items() if game not in ("8-ball", "9-ball", "snooker")]
RACKED = sorted({*IDS} - {*CANNONS})


@pytest.mark.parametrize("name", IDS)
def test_gymnasium_finds_nothing_to_say_against_it(name):
    check_env(gymnasium.make(name, noise="club").unwrapped)


@pytest.mark.parametrize("game", IDS.values())
def test_pettingzoo_finds_nothing_to_say_against_a_match_of_two(game):
    api_test(env(game, limit=40), num_cycles=100)
    seed_test(lambda: env(game, limit=40, noise="expert"), num_cycles=30)


def alike(one, other):
    """Do two steps agree in every bit?"""
    assert all(np.array_equal(a, b) for a, b in zip(one[:-1], other[:-1], strict=True))
    infos, others = one[-1], other[-1]
    assert infos.keys() == others.keys()
    assert np.array_equal(infos["state"], others["state"], equal_nan=True)
    assert [*infos["reason"]] == [*others["reason"]]
    assert np.array_equal(infos["_state"], others["_state"])
    if "final_obs" in infos:
        mask = infos["_final_obs"]
        assert np.array_equal(mask, others["_final_obs"])
        pairs = zip(infos["final_obs"][mask], others["final_obs"][mask], strict=True)
        assert all(np.array_equal(a, b) for a, b in pairs)
        final, its = infos["final_info"], others["final_info"]
        assert np.array_equal(final["state"][mask], its["state"][mask], equal_nan=True)
        assert [*final["reason"][mask]] == [*its["reason"][mask]]


@pytest.mark.parametrize("mode", [AutoresetMode.NEXT_STEP, AutoresetMode.SAME_STEP])
@pytest.mark.parametrize("name", IDS)
def test_a_step_of_many_tables_is_a_step_of_each_bit_for_bit(name, mode):
    given = {"noise": "fastfiz", "limit": 3}
    for count in (1, 5):
        many = gymnasium.make_vec(name, num_envs=count, autoreset_mode=mode, **given)
        each = gymnasium.make_vec(
            name, num_envs=count, vectorization_mode="sync",
            vector_kwargs={"autoreset_mode": mode}, **given,
        )  # fmt: skip
        alike(many.reset(seed=5), each.reset(seed=5))
        many.action_space.seed(1)
        for _ in range(9):
            action = many.action_space.sample()
            alike(many.step(action), each.step(action))
        alike(many.reset(), each.reset())


def test_a_table_of_many_is_the_same_among_a_thousand_and_among_three():
    pytest.importorskip("numba")
    few, many = (
        gymnasium.make_vec(CANNONS[0], num_envs=count, noise="club") for count in (3, 1000)
    )
    assert np.array_equal(few.reset(seed=1)[0], many.reset(seed=1)[0][:3])
    many.action_space.seed(0)
    for _ in range(20):
        action = many.action_space.sample()
        assert np.array_equal(few.step(action[:3])[0], many.step(action)[0][:3])


@pytest.mark.parametrize("name", [CANNONS[0], "danggu/NineBall-v0"])
def test_the_interpreter_plays_the_same_strokes(name):
    pytest.importorskip("numba")
    compiled, plain = (
        gymnasium.make_vec(name, num_envs=4, noise="club", compiled=how) for how in (True, False)
    )
    alike(compiled.reset(seed=2), plain.reset(seed=2))
    compiled.action_space.seed(0)
    for _ in range(5):
        action = compiled.action_space.sample()
        alike(compiled.step(action), plain.step(action))


def test_it_plays_where_numba_is_not_installed():
    code = (
        "import sys; sys.modules['numba'] = None; import importlib.util as u\n"
        "find = u.find_spec; u.find_spec = lambda n, *a: None if n == 'numba' else find(n, *a)\n"
        "import gymnasium, danggu.envs as e\n"
        "v = gymnasium.make_vec(next(iter(e.IDS)), num_envs=3); v.reset(seed=0)\n"
        "print(v.step(v.action_space.sample())[0].shape)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "(3, 6)\n"


def test_tables_that_are_not_reset_wait_until_they_are():
    vector = gymnasium.make_vec(CANNONS[0], num_envs=4, limit=1, autoreset_mode="Disabled")
    vector.reset(seed=0)
    _, _, over, late, _ = vector.step(vector.action_space.sample())
    assert (over | late).all()
    with pytest.raises(ValueError, match="table 0 must be reset"):
        vector.step(vector.action_space.sample())
    before = vector.unwrapped.hall.places.copy()
    mask = np.array([True, False, True, False])
    infos = vector.reset(options={"reset_mask": mask})[1]
    assert np.array_equal(infos["_state"], mask)
    assert np.array_equal((vector.unwrapped.hall.places != before).any(axis=(1, 2)), mask)
    with pytest.raises(ValueError, match="table 1 must be reset"):
        vector.step(vector.action_space.sample())


@pytest.mark.parametrize("name", CANNONS)
def test_the_reward_is_what_the_rules_say_of_the_same_shot(name):
    table = gymnasium.make(name).unwrapped
    table.action_space.seed(3)
    game, made = GAMES[IDS[name]](), 0
    _, info = table.reset(seed=4)
    for _ in range(60):
        before, action = info["state"], table.action_space.sample()
        _, reward, over, _, info = table.step(action)
        world = table.hall.world
        shot = shot_of(table, before, action)
        played = simulate_many(
            world, "white", [shot], positions=before[None], contacts=200, compiled=False
        )
        verdict = game.verdict(played.log(0), Turn("white"))
        assert (reward, over, info["reason"]) == (
            verdict.points, not verdict.made, verdict.reason,
        )  # fmt: skip
        made += verdict.made
        if over:
            info = table.reset()[1]
    assert made


def shot_of(table, state, action):
    """The shot that an action means, worked out for one ball at a time."""
    targets = range(2, 4) if len(state) == 4 else range(1, 3)
    target = state[targets[min(int((action[0] + 1.0) / 2.0 * len(targets)), len(targets) - 1)]]
    apart = target - state[0]
    reach = 2 * table.hall.world.table.radius
    half = np.arcsin(min(1.0, reach / np.sqrt((apart * apart).sum())))
    angle = np.degrees(np.arctan2(apart[1], apart[0]) + float(action[1]) * half)
    speed = np.exp(np.log(0.5) + 0.5 * (float(action[2]) + 1.0) * np.log(7.0 / 0.5))
    tip = 0.51 * action[3:].astype(float)
    tip = tip * (0.51 / max(0.51, np.sqrt((tip * tip).sum())))
    return speed, angle, 2.5 * speed * tip[1], 0.0, 2.5 * speed * tip[0]


def test_an_aim_at_a_ball_hits_it_wherever_it_is():
    table = gymnasium.make(CANNONS[0]).unwrapped
    table.reset(seed=0)
    for edge in (-0.999, -0.5, 0.0, 0.999):
        state = [[0.0, 0.0], [0.7, 0.3], [-0.8, -0.4]]
        table.reset(options={"state": state})
        reason = table.step(np.array([1.0, edge, 0.5, 0.0, 0.0]))[-1]["reason"]
        assert reason != "no_ball"
    table.reset(options={"state": state})
    ended = table.step(np.array([-1.0, 0.0, -1.0, 0.0, 0.0]))[-1]
    assert ended["state"][1][0] > 0.7  # the first number chose the yellow ball, full


def test_an_absolute_aim_is_a_direction():
    table = gymnasium.make(CANNONS[0], aim="absolute").unwrapped
    table.reset(options={"state": [[0.0, 0.0], [1.2, 0.0], [-1.2, 0.5]]}, seed=0)
    _, _, _, _, info = table.step(np.array([0.0, -1.0, -1.0, 0.0, 0.0]))
    assert info["reason"] == "no_ball"
    assert abs(info["state"][0][0]) < 1e-9
    assert info["state"][0][1] != 0.0


def test_noise_has_the_deviations_that_it_is_given():
    from danggu.envs.chance import Chance
    from danggu.envs.noise import Aims

    rows, n = np.arange(20_000), 20_000
    errors = Chance(np.arange(n, dtype=np.uint64) * 7919).normal(rows, 5)
    assert abs(errors.mean(axis=0)).max() < 4 / np.sqrt(n)
    assert abs(errors.std(axis=0) - 1.0).max() < 4 / np.sqrt(2 * n)
    noise = Noise(angle=0.5, share=0.02, speed=0.1, tip=1.0)
    aims = Aims(*(np.full(n, value) for value in (30.0, 3.0, 0.1, 0.2)))
    shots = noise.shots(aims, errors, 0.03)
    assert shots[:, 1].mean() == pytest.approx(30.0, abs=0.02)
    assert shots[:, 1].std() == pytest.approx(0.5, rel=0.03)
    assert shots[:, 0].std() == pytest.approx(0.16, rel=0.03)
    right, up = (shots[:, k] / shots[:, 0] / 2.5 for k in (4, 2))
    assert [right.std(), up.std()] == pytest.approx([1 / 30, 1 / 30], rel=0.03)
    assert not shots[:, 3].any()
    raised = envs.FASTFIZ.shots(aims, errors, 0.03)
    lifted = raised[:, 3] / raised[:, 4]  # a cue is never below level, so it curves to its side
    assert lifted.min() >= 0.0
    assert np.sqrt((lifted**2).mean()) == pytest.approx(np.radians(0.1), rel=0.03)
    assert (np.hypot(right, up) <= 0.51 + 1e-12).all()


def test_balls_that_are_down_are_flagged_and_nothing_observed_is_nan():
    table = gymnasium.make("danggu/NineBall-v0").unwrapped
    table.reset(seed=1)
    table.action_space.seed(1)
    down = 0
    for _ in range(40):
        seen, _, over, late, info = table.step(table.action_space.sample())
        balls = seen[:-2].reshape(10, 4)
        assert np.isfinite(seen).all()
        assert np.array_equal(balls[:, 2] == 0.0, np.isnan(info["state"][:, 0]))
        assert not balls[balls[:, 2] == 0.0].any()
        assert balls[:, 3].sum() == 1.0  # only the lowest ball is on
        down += (balls[:, 2] == 0.0).sum()
        if over or late:
            table.reset()
    assert down


@pytest.mark.parametrize("name", RACKED)
def test_a_rack_ends_by_the_rules_or_at_the_limit(name):
    table = gymnasium.make(name, limit=30).unwrapped
    table.reset(seed=3)
    table.action_space.seed(2)
    strokes, ends = 0, []
    while len(ends) < 3:
        _, _, over, late, _ = table.step(table.action_space.sample())
        strokes += 1
        if over or late:
            ends.append((over, late, strokes))
            strokes = 0
            table.reset()
    assert all(over != late and (over or strokes == 30) for over, late, strokes in ends)


def test_an_episode_may_go_on_after_a_miss_and_its_turn_may_end_with_one():
    table = gymnasium.make(CANNONS[0], inning=False, limit=4).unwrapped
    table.reset(seed=0)
    ends = [table.step(table.action_space.sample())[2:4] for _ in range(4)]
    assert ends == [(False, False)] * 3 + [(False, True)]
    rack = gymnasium.make("danggu/NineBall-v0", inning=True).unwrapped
    rack.reset(seed=0)
    rack.action_space.seed(0)
    for _ in range(50):
        _, _, over, _, info = rack.step(rack.action_space.sample())
        assert over == (info["reason"] != "potted")
        if over:
            rack.reset()


def test_in_a_match_of_two_the_turn_and_the_cue_ball_pass():
    match = env("three-cushion", target=3)
    match.reset(seed=0)
    first = match.agent_selection
    match.step(np.array([0.0, 1.0, -1.0, 0.0, 0.0], np.float32))
    assert match.agent_selection != first
    assert match.hall.order == [1, 0, 2]  # the yellow ball is first now
    x, y = match.infos[first]["state"]["yellow"]
    half = 0.5 * match.hall.world.table.length, 0.5 * match.hall.world.table.width
    assert match.observe(first)[:2] == pytest.approx([x / half[0], y / half[1]])
    assert match.infos[first]["score"] == 0


def test_a_table_of_ones_own_is_played_on():
    table = gymnasium.make("danggu/NineBall-v0", table=tables.pool_7ft()).unwrapped
    assert table.hall.world.table.length == tables.pool_7ft().table.length
    table.reset(seed=0)
    table.step(np.zeros(5))


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"game": "golf"}, "golf"),
        ({"noise": "lazy"}, "lazy"),
        ({"aim": "left"}, "left"),
        ({"limit": 0}, "limit must be a whole number above 0, not 0"),
        ({"speeds": (3.0, 1.0)}, "slower first"),
        ({"table": 3}, "world without balls, not 3"),
    ],
)
def test_what_cannot_be_is_named(given, message):
    with pytest.raises(ValueError, match=message):
        Setup(**{"game": "three-cushion", **given})


def test_a_table_with_balls_is_refused():
    world = tables.match_carom()
    world.add(Ball("white", (0.0, 0.0)))
    with pytest.raises(ValueError, match="without balls"):
        Setup("three-cushion", table=world)


def test_actions_that_are_none_are_refused_and_change_nothing():
    table = gymnasium.make(CANNONS[0], noise="club").unwrapped
    table.reset(seed=0)
    before = table.hall.places.copy(), table.hall.chance.drawn.copy(), table.hall.strokes.copy()
    for action, message in ((np.zeros(4), r"\(1, 4\)"), (np.full(5, np.nan), "action 0 must be")):
        with pytest.raises(ValueError, match=message):
            table.step(action)
    after = table.hall.places, table.hall.chance.drawn, table.hall.strokes
    assert all(map(np.array_equal, before, after))


@pytest.mark.parametrize(
    ("state", "message"),
    [
        ([[0.0, 0.0], [0.0, 0.01], [0.5, 0.0]], "positions of shot 0"),
        ([[0.0, 0.0], [np.nan, np.nan], [0.5, 0.0]], "all balls on the table"),
        ([[0.0, 0.0]], r"\(1, 3, 2\), not \(1, 1, 2\)"),
    ],
)
def test_a_state_that_cannot_be_is_refused(state, message):
    table = gymnasium.make(CANNONS[0]).unwrapped
    with pytest.raises(ValueError, match=message):
        table.reset(options={"state": state})
    with pytest.raises(ValueError, match="without pockets"):
        gymnasium.make("danggu/NineBall-v0").unwrapped.reset(options={"state": state})


def test_the_room_shows_its_public_names_and_no_other():
    assert dir(envs) == [*envs.__all__]
    assert all(getattr(envs, name) is not None for name in envs.__all__)
    with pytest.raises(AttributeError, match="nothing"):
        _ = envs.nothing


def test_nothing_is_imported_before_it_is_used():
    code = "import sys, danggu.rules; print({'gymnasium', 'numpy'} & {*sys.modules})"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "set()\n"


def test_the_examples_of_the_page_are_what_they_say():
    page = Path(__file__).parents[2] / "docs" / "environments.md"
    failed, tried = doctest.testfile(str(page), module_relative=False)
    assert failed == 0
    assert tried > 10


@pytest.mark.parametrize("name", [CANNONS[0], "danggu/Snooker-v0"])
def test_what_an_action_would_bring_can_be_tried_and_changes_nothing(name):
    table = gymnasium.make(name).unwrapped
    table.reset(seed=6)
    table.action_space.seed(6)
    actions = np.array([table.action_space.sample() for _ in range(20)])
    drawn = table.hall.chance.drawn.copy()
    found = table.hall.tried(0, actions)
    assert np.array_equal(table.hall.chance.drawn, drawn)
    for k in range(3):
        again = gymnasium.make(name).unwrapped
        again.reset(seed=6)
        info = again.step(actions[k])[-1]
        assert info["reason"] == found.reason[k]


def test_the_example_of_a_program_that_learns_does():
    pytest.importorskip("numba")
    learning = runpy.run_path(str(Path(__file__).parents[2] / "docs" / "learning.py"))
    shares = [*learning["learned"](150, tables=512)]
    assert np.mean(shares[-30:]) > 1.2 * np.mean(shares[:30])


def test_a_match_of_two_leaves_the_sound_of_the_process_alone():
    code = (
        "import os; os.environ['SDL_AUDIODRIVER'] = 'dummy'; import danggu.envs.versus;"
        "print(os.environ['SDL_AUDIODRIVER'])"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split()[-1] == "dummy"
