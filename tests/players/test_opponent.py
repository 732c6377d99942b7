"""The opponent: what it finds, how it keeps its time, and how it misses."""

from collections.abc import Iterator
from functools import cache
from itertools import pairwise
from random import Random
from statistics import fmean, pstdev

import pytest

from danggu.players.levels import (
    CLUB,
    EXPERT,
    LEVELS,
    MASTER,
    MISCUE,
    NOVICE,
    PERFECT,
    Attempt,
    Level,
)
from danggu.players.opponent import FRESH, Intent, Opponent
from danggu.players.positions import SAGU, SHELF, Position, opening
from danggu.rules.carom import Carom
from danggu.rules.match import Match, Player
from danggu.rules.sagu import Sagu
from danggu.rules.verdict import Verdict
from physics import Ball, Shot, World, simulate, tables

RADIUS = 0.03275
SHORT = 200  # aims: enough for a point in every position here, and quick


def laid(position: Position) -> World:
    table = tables.MEDIUM_CAROM if position.game == SAGU else tables.MATCH_CAROM
    world = table.world()
    for name, at in position.on(table.length, table.width).items():
        world.add(Ball(name, at=at, radius=table.radius, mass=table.mass))
    return world


def begun(position: Position) -> Match:
    """A match after its opening stroke, with the first player at the table."""
    match = Match.of(Sagu() if position.game == SAGU else Carom(), Player("kim", 9))
    return match.after(Verdict("one_ball"))


def shelf(key: str) -> Position:
    return next(p for p in SHELF if p.key == key)


def opponent(key: str, level: Level = EXPERT, seed: int = 1, effort: int = SHORT) -> Opponent:
    position = shelf(key)
    return Opponent(laid(position), begun(position), level, seed, effort)


def thought_out(thinker: Opponent) -> Intent:
    while not thinker.think(1.0):
        pass
    return thinker.intent


def test_the_outcome_depends_on_the_seed_and_not_on_the_budgets() -> None:
    at_once = opponent("stun")
    bit_by_bit = opponent("stun")
    while not bit_by_bit.think(0.0):
        pass
    assert thought_out(at_once) == bit_by_bit.intent
    assert at_once.execute(Random(7)) == bit_by_bit.execute(Random(7))
    assert thought_out(opponent("stun", seed=2)).aim != at_once.intent.aim


@pytest.mark.parametrize(("budget", "simulations"), [(0.0, 1), (0.5, 1), (2.5, 3), (10.0, 10)])
def test_it_stops_with_the_simulation_that_ends_its_budget(budget: float, simulations: int) -> None:
    thinker = opponent("stun")
    assert not thinker.think(budget, clock=lambda: float(thinker.tried))
    assert thinker.tried == simulations


def test_it_has_an_intent_before_it_thinks_and_can_play_it() -> None:
    thinker = opponent("stun")
    assert (thinker.intent.verdict, thinker.intent.copies) == (None, 0)
    assert thinker.execute(Random(1)).speed > 0


def test_thinking_leaves_the_table_as_it_is() -> None:
    position = shelf("stun")
    world = laid(position)
    before = {ball.name: ball.position for ball in world.balls}
    thought_out(Opponent(world, begun(position), EXPERT, effort=50))
    assert {ball.name: ball.position for ball in world.balls} == before
    assert (len(world.log), world.time) == (0, 0)


@pytest.mark.parametrize("key", ["gather", "rail_nurse", "stun", "outside", "inside", "bank_one"])
def test_it_finds_a_point_in_simple_positions(key: str) -> None:
    thinker = opponent(key, PERFECT)
    intent = thought_out(thinker)
    assert intent.verdict is not None
    assert intent.verdict.made
    assert (intent.share, intent.copies) == (1.0, FRESH)
    assert thinker.execute(Random(1)) == intent.shot


def test_it_opens_three_cushion_on_the_red() -> None:
    position = opening("three_cushion")
    match = Match.of(Carom(), Player("kim"))
    intent = thought_out(Opponent(laid(position), match, EXPERT, effort=SHORT))
    assert intent.verdict is not None
    assert intent.verdict.made
    assert intent.verdict.facts.hits[0] == "red"


def test_it_closes_four_ball_off_three_cushions() -> None:
    position = shelf("one_cushion")
    match = Match.of(Sagu(), Player("kim", 1)).after(Verdict("both_reds", 1, passes=False))
    intent = thought_out(Opponent(laid(position), match, EXPERT, effort=SHORT))
    assert intent.verdict is not None
    assert (intent.verdict.reason, intent.verdict.won) == ("both_reds_3c", True)


def test_where_it_finds_no_point_it_avoids_the_foul() -> None:
    world = tables.medium_carom()
    for name, at in {"white": (0.0, 0.0), "red1": (0.5, 0.1), "yellow": (-0.5, 0.2)}.items():
        world.add(Ball(name, at=at))
    intent = thought_out(Opponent(world, begun(shelf("stun")), EXPERT, effort=40))
    assert intent.verdict is not None
    assert intent.verdict.reason == "one_red"


def test_a_table_without_its_ball_is_refused() -> None:
    with pytest.raises(ValueError, match="white"):
        Opponent(tables.medium_carom(), begun(shelf("stun")), EXPERT)


# Levels

KEYS = ("follow", "two_cushions", "outside", "bank_three")
STROKES = 40


@cache
def record(level: Level) -> tuple[float, float]:
    """The mean share that was expected over some positions, and the share that came true."""
    expected: list[float] = []
    made: list[bool] = []
    for key in KEYS:
        thinker = opponent(key, level)
        expected.append(thought_out(thinker).share)
        made += outcomes(key, thinker)
    return fmean(expected), fmean(made)


def outcomes(key: str, thinker: Opponent) -> Iterator[bool]:
    world, match, rng = laid(shelf(key)), begun(shelf(key)), Random(99)
    for _ in range(STROKES):
        after = simulate(world, match.cue, thinker.execute(rng))
        yield match.judged(after.log).made


def test_a_better_level_scores_more() -> None:
    made = [record(level)[1] for level in (NOVICE, EXPERT, MASTER)]
    assert made == sorted(made)
    assert made[-1] > 1.5 * made[0]


@pytest.mark.parametrize("level", [NOVICE, EXPERT], ids=lambda level: level.key)
def test_what_it_expects_comes_true(level: Level) -> None:
    expected, made = record(level)
    n = len(KEYS)
    deviation = (0.25 / (n * FRESH) + 0.25 / (n * STROKES)) ** 0.5  # at most, of the difference
    assert abs(expected - made) < 4 * deviation


def test_levels_are_named_and_ordered_from_the_largest_error_to_none() -> None:
    assert [level.key for level in LEVELS] == ["novice", "club", "expert", "master", "perfect"]
    for worse, better in pairwise(LEVELS):
        assert (worse.angle, worse.speed, worse.tip) > (better.angle, better.speed, better.tip)


def test_errors_have_the_stated_deviations() -> None:
    rng, aim = Random(5), Attempt(30.0, 2.0, 0.1, -0.1)
    missed = [CLUB.missed(aim, rng, RADIUS) for _ in range(4000)]
    # 4000 draws give a deviation to 1/sqrt(8000) = 1.1 %; four of those
    assert pstdev(m.angle for m in missed) == pytest.approx(CLUB.angle, rel=0.045)
    assert pstdev(m.speed / 2.0 for m in missed) == pytest.approx(CLUB.speed, rel=0.045)
    assert pstdev(m.right * RADIUS * 1e3 for m in missed) == pytest.approx(CLUB.tip, rel=0.045)
    assert fmean(m.angle for m in missed) == pytest.approx(30.0, abs=4 * CLUB.angle / 4000**0.5)


def test_an_error_never_makes_a_miscue_or_a_stroke_without_speed() -> None:
    wild = Level("wild", 9.0, 3.0, 40.0)
    rng = Random(1)
    for _ in range(500):
        aim = wild.missed(Attempt(0.0, 1.0, 0.4, 0.2), rng, RADIUS)
        assert (aim.right**2 + aim.up**2) ** 0.5 <= MISCUE + 1e-12
        assert aim.speed > 0


def test_a_tip_two_fifths_up_rolls_at_once_and_right_of_the_centre_spins_to_the_left() -> None:
    assert Attempt(10.0, 2.0, up=0.4).shot() == Shot(2.0, 10.0, follow=2.0)
    assert Attempt(10.0, 2.0, right=0.4).shot() == Shot(2.0, 10.0, side=2.0)
