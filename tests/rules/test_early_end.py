"""Shots that end when the stroke is settled: the verdicts stay, and so does all until then."""

import numpy as np
import pytest

from danggu.rules import GAMES, RACKS, Carom, Sagu
from danggu.rules.verdict import Turn
from danggu.scores import scores
from physics import Ball, Shot, TimeStepping, simulate, simulate_many, tables
from tests.support.batches import same
from tests.support.scattered import LIMIT, places, shots_at, world_of

FEW, MANY, KEPT = 2000, 100_000, 400
CAROM = {
    "three-cushion": GAMES["three-cushion"](), "one-cushion": Carom(cushions=1, bank=2),
    "straight-rail": Carom(cushions=0), "umb": Carom(umb=True, penalty=2), "four-ball": Sagu(),
}  # fmt: skip


def both(name, count, rng, **how):
    """The same shots to rest and to where they are settled: outcomes, turns' rules."""
    rules = CAROM[name]
    world = world_of("four-ball" if name == "four-ball" else "three-cushion")
    found = places(world, count, rng)
    table, cue = shots_at(found, rng), rules.cues[0]
    how |= {"positions": found, "contacts": KEPT}
    until = rules.enough(Turn(cue=cue), [ball.name for ball in world.balls])
    ends = ((), until)
    return [simulate_many(world, cue, table, until=end, **how) for end in ends]


def alike(name, whole, early):
    """Every verdict of every turn; returns how many shots ended early."""
    known = whole.dropped == 0  # a ball that creeps along a cushion may meet it 1000 times
    assert known.mean() > 0.999
    for opening in (False, True):
        turn = Turn(cue=CAROM[name].cues[0], opening=opening)
        verdicts = [CAROM[name].verdicts(outcomes, turn) for outcomes in (whole, early)]
        for a, b in zip(*verdicts, strict=True):
            assert np.array_equal(a[known], b[known])
    return int((early.events < whole.events).sum())


@pytest.mark.parametrize("name", CAROM)
def test_a_shot_that_ends_when_it_is_settled_has_the_same_verdict(name):
    pytest.importorskip("numba")
    assert alike(name, *both(name, FEW, np.random.default_rng(5))) > 10


@pytest.mark.stress
@pytest.mark.parametrize("name", CAROM)
def test_a_hundred_thousand_shots_have_it(name):
    pytest.importorskip("numba")
    rng = np.random.default_rng(6)
    assert all(alike(name, *both(name, LIMIT, rng)) > 100 for _ in range(MANY // LIMIT))


def test_until_then_it_is_the_same_shot_and_compiled_too():
    pytest.importorskip("numba")
    rng = np.random.default_rng(7).bit_generator.state
    made = []
    for compiled in (False, True):
        chance = np.random.default_rng()
        chance.bit_generator.state = rng
        made.append(both("straight-rail", 150, chance, compiled=compiled))
    (whole, early), (_, compiled) = made
    assert same(early, compiled)
    shorter = np.flatnonzero(early.events < whole.events)
    assert len(shorter)
    for shot in shorter:
        kept = early.log(shot)
        assert kept == whole.log(shot)[: len(kept)]
        assert kept[-1].time <= early.times[shot] < whole.times[shot]


def line():
    world = tables.match_carom()
    for name, x in (("white", -0.5), ("yellow", 0.0), ("red", 0.5)):
        world.add(Ball(name, at=(x, 0.3)))
    return world


def test_positions_are_those_of_the_moment_in_which_it_ends():
    world, shot = line(), Shot(3.0, 0.5, follow=3.0)
    early = simulate_many(world, "white", [shot], contacts=20, until=["yellow"], compiled=False)
    after = simulate(world, "white", shot)
    time, hit = early.times[0], after.log.first("ball", "white", "yellow").time
    then = next(event.time for event in after.log if event.time > hit)
    assert time == then < after.time
    states = after.log.at([time])
    for k, name in enumerate(early.balls):
        place = states[name].position[0]
        assert early.positions[0, k] == pytest.approx(place, abs=1e-12)


def test_a_ball_in_the_air_may_still_leave_so_the_shot_goes_on():
    world = line()
    jumps = [Shot(4.0, angle, climb=climb) for angle in (0.0, 0.5) for climb in (0.0, 1.0, 2.0)]
    how = {"contacts": 60, "compiled": False}
    early = simulate_many(world, "white", jumps, until=["yellow"], **how)
    turn = Turn(cue="white")
    off = Carom(cushions=0).verdicts(simulate_many(world, "white", jumps, **how), turn)
    assert np.array_equal(off.foul, Carom(cushions=0).verdicts(early, turn).foul)


@pytest.mark.parametrize(
    ("how", "said"),
    [
        ({"until": ["green"], "contacts": 9}, "until 'green': the other balls are yellow, red"),
        ({"until": ["white"], "contacts": 9}, "until 'white'"),
        ({"until": ["red"]}, "until= needs contacts="),
    ],
)
def test_what_no_shot_can_wait_for_is_refused(how, said):
    with pytest.raises(ValueError, match=said):
        simulate_many(line(), "white", [Shot(2.0)], **how)


def test_an_engine_that_plays_shot_by_shot_ends_none_early():
    world = line()
    world.engine = TimeStepping(1e-3)
    with pytest.raises(ValueError, match="until= needs the engine EventDriven"):
        simulate_many(world, "white", [Shot(2.0)], until=["red"], contacts=9)


@pytest.mark.parametrize("game", GAMES)
def test_scores_are_the_same_with_and_without_an_early_end(game):
    world = world_of(game)
    table = np.zeros((24, 6))
    table[:, 0], table[:, 1] = 3.0, 15.0 * np.arange(24)
    cue = "cue" if game in RACKS else GAMES[game]().cues[0]
    whole, early = (scores(world, cue, table, GAMES[game](), early=e) for e in (False, True))
    for a, b in zip(whole, early, strict=True):
        assert np.array_equal(a, b)
