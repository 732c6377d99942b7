"""Racks are legal, tight or as loose as asked for, and come out the same for the same seed."""

from math import inf, nan

import numpy as np
import pytest

from physics import Ball, Shot, World, laws, tables
from physics.tables.pocket_tables import PYRAMID_12FT, SNOOKER_12FT, pool
from physics.tables.racks import RACKS, chance

POOL = pool(9)
RACKED = [
    *((POOL, kind) for kind in ("8-ball", "9-ball", "10-ball", "14.1")),
    (SNOOKER_12FT, "snooker"), (PYRAMID_12FT, "pyramid"),
]  # fmt: skip
SEEDS = range(60)
EACH = pytest.mark.parametrize(("table", "kind"), RACKED, ids=[kind for _, kind in RACKED])


def lattice(table, kind, **options):
    """The balls that lie in rows, in the order of their rows."""
    return table.rack(kind, **options)[: len(RACKS[kind].order)]


def rows(table, kind, **options):
    """Names, row by row from the apex, each from the left."""
    balls = iter(lattice(table, kind, **options))
    return [[next(balls).name for _ in range(count)] for count in RACKS[kind].rows]


def gaps(balls):
    """Between all pairs, m, without the radii."""
    return [
        abs(complex(*a.position) - complex(*b.position)) - 2.0 * a.radius
        for k, a in enumerate(balls)
        for b in balls[:k]
    ]


@EACH
def test_a_tight_rack_touches_to_the_last_bit(table, kind):
    """15 balls have 30 contacts, 10 have 18, the diamond of 9 has 16."""
    apart = gaps(lattice(table, kind))
    touching = {15: 30, 10: 18, 9: 16}[len(RACKS[kind].order)]
    assert sum(abs(gap) < 1e-15 for gap in apart) == touching
    assert min(apart) > -1e-15
    assert min(gap for gap in apart if gap > 1e-15) > table.radius


@EACH
@pytest.mark.parametrize("gap", [0.0, 1e-4])
def test_a_rack_is_its_own_mirror_image_to_the_last_bit(table, kind, gap):
    spots = {ball.position for ball in lattice(table, kind, gap=gap)}
    assert {(x, -y) for x, y in spots} == spots


@EACH
def test_neighbours_of_a_loose_rack_are_as_far_apart_as_was_said(table, kind):
    apart = gaps(lattice(table, kind, gap=2e-4))
    touching = {15: 30, 10: 18, 9: 16}[len(RACKS[kind].order)]
    assert sorted(apart)[:touching] == pytest.approx([2e-4] * touching, abs=1e-15)


@EACH
def test_the_apex_is_on_its_spot_and_the_rack_behind_it(table, kind):
    balls = lattice(table, kind)
    spot = "pink" if kind == "snooker" else "foot"
    x, y = table.spots[spot]
    (apex, across), rest = balls[0].position, [ball.position[0] for ball in balls[1:]]
    assert across == y == 0.0
    assert min(rest) > apex
    if kind == "snooker":
        assert apex - x - 2.0 * table.radius == pytest.approx(5e-4, abs=1e-15)
    else:
        assert apex == x


def corners(names):
    return {int(name) >= 9 for name in names}


@pytest.mark.parametrize("seed", [None, *SEEDS])
def test_8_ball_has_the_8_in_the_middle_and_a_solid_and_a_stripe_in_the_corners(seed):
    rack = rows(POOL, "8-ball", seed=seed)
    assert rack[2][1] == "8"
    assert corners((rack[4][0], rack[4][4])) == {False, True}
    assert sorted(int(name) for row in rack for name in row) == list(range(1, 16))


@pytest.mark.parametrize("seed", [None, *SEEDS])
def test_9_ball_and_10_ball_have_the_1_in_front_and_the_last_in_the_middle(seed):
    for kind, last in (("9-ball", 9), ("10-ball", 10)):
        rack = rows(POOL, kind, seed=seed)
        assert rack[0] == ["1"]
        assert rack[2][1] == f"{last}"
        assert sorted(int(name) for row in rack for name in row) == list(range(1, last + 1))


def test_the_classical_pyramid_is_in_the_order_of_its_rules_whatever_the_seed():
    expected = [
        ["4"], ["5", "6"], ["7", "15", "8"], ["9", "14", "13", "10"], ["2", "1", "12", "11", "3"],
    ]  # fmt: skip
    assert rows(PYRAMID_12FT, "pyramid") == rows(PYRAMID_12FT, "pyramid", seed=3) == expected


def test_snooker_has_fifteen_reds_and_its_colours_on_their_spots():
    balls = {ball.name: ball.position for ball in SNOOKER_12FT.rack("snooker")}
    assert [name for name in balls if name.startswith("red")] == [f"red{k}" for k in range(1, 16)]
    assert {name: at for name, at in balls.items() if "red" not in name} == SNOOKER_12FT.spots
    assert len(balls) == 21


def test_every_place_that_the_rules_leave_open_is_as_likely_for_a_ball_as_any_other():
    """2000 seeds: the 1 is in each of fourteen places 143 times, ± 4 standard deviations."""
    counts = dict.fromkeys(range(15), 0)
    for seed in range(2000):
        names = [ball.name for ball in POOL.rack("14.1", seed=seed)]
        counts[names.index("1")] += 1
    assert all(abs(count - 2000 / 15) < 4 * (2000 / 15) ** 0.5 for count in counts.values())


@EACH
def test_the_same_seed_gives_the_same_rack_and_another_one_another(table, kind):
    def laid(seed):
        return [(b.name, b.position) for b in table.rack(kind, disorder=1e-4, seed=seed)]

    assert laid(7) == laid(7)
    assert len({tuple(laid(seed)) for seed in SEEDS}) == len(SEEDS)


@EACH
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_disordered_rack_has_no_overlap_and_no_ball_farther_off_than_was_said(table, kind, seed):
    gap, disorder = 5e-5, 2e-4
    balls = table.rack(kind, gap=gap, disorder=disorder, seed=seed)
    assert min(gaps(balls)) >= gap - 1e-15
    tidy = lattice(table, kind, gap=gap + 2.0 * disorder, seed=seed)
    shift = disorder if kind == "snooker" else 0.0
    off = [
        abs(complex(*a.position) - shift - complex(*b.position))
        for a, b in zip(balls, tidy, strict=False)
    ]
    assert 0.0 < min(off) < 0.5 * disorder < max(off) <= disorder * (1.0 + 1e-12)


def test_chance_is_splitmix64():
    """The first outputs for the seed 1234567, as published with the algorithm, in 53 bits."""
    published = (6457827717110365317, 3203168211198807973, 9817491932198370423)
    draw = chance(1234567)
    assert [next(draw) for _ in published] == [(n >> 11) * 2.0**-53 for n in published]


@EACH
def test_a_rack_can_be_broken(table, kind):
    """Between long cushions, as far as worlds have no pockets."""
    world = tables.Table(
        table.length, table.width, table.radius, table.mass, table.cloth, laws.RoughBall(),
        table.cushion_law,
    ).world()  # fmt: skip
    cue = world.add(Ball("cue", at=(-0.4 * table.length, 0.1)))
    for ball in table.rack(kind):
        world.add(ball)
    assert {ball.radius for ball in world.balls} == {table.radius}
    world.strike(cue, Shot(7.0, 0.0))
    world.run()
    assert world.at_rest


def test_a_tight_rack_struck_in_the_middle_opens_symmetrically():
    """On an endless cloth, to rounding: the balls run up to thirty metres."""
    world = World(POOL.cloth, table=POOL)
    world.add(Ball("cue", at=(0.0, 0.0)))
    for ball in POOL.rack("14.1"):
        world.add(ball)
    world.strike("cue", Shot(6.0))
    world.run()
    ends = [complex(*ball.position) for ball in world.balls]
    assert max(min(abs(p.conjugate() - q) for q in ends) for p in ends) < 1e-12


@pytest.mark.parametrize("bad", [nan, inf, -1e-6, "tight", None])
def test_a_gap_and_a_disorder_that_cannot_be_are_refused_by_name(bad):
    with pytest.raises(ValueError, match="rack gap must"):
        POOL.rack("9-ball", gap=bad)
    with pytest.raises(ValueError, match="rack disorder must"):
        POOL.rack("9-ball", disorder=bad, seed=1)


@pytest.mark.parametrize("bad", [1.5, "1", True, [1]])
def test_a_seed_is_a_whole_number(bad):
    with pytest.raises(ValueError, match="rack seed must be a whole number, not"):
        POOL.rack("9-ball", seed=bad)


def test_disorder_needs_a_seed():
    with pytest.raises(ValueError, match=r"rack disorder 0\.001 needs a seed"):
        POOL.rack("9-ball", disorder=0.001)


def test_a_rack_of_another_game_is_refused_with_those_that_there_are():
    with pytest.raises(ValueError, match="pool 9 ft: no rack 'snooker': there is 8-ball, 9-ball,"):
        POOL.rack("snooker")
    with pytest.raises(ValueError, match="match carom: no rack '8-ball': there is none"):
        tables.MATCH_CAROM.rack("8-ball")


def test_a_seed_may_be_one_of_numpy_s():
    laid = [[ball.name for ball in POOL.rack("8-ball", seed=kind(4))] for kind in (int, np.int64)]
    assert laid[0] == laid[1]


@pytest.mark.parametrize(
    ("table", "kind", "how", "why"),
    [
        (POOL, "8-ball", {"gap": 10.0}, "'9' would be off the table at"),
        (POOL, "9-ball", {"disorder": 1.0, "seed": 3}, "would be off the table at"),
        (SNOOKER_12FT, "snooker", {"gap": 0.097}, "would overlap 'black'"),
    ],
)
def test_a_rack_that_a_table_has_no_room_for_is_refused(table, kind, how, why):
    with pytest.raises(ValueError, match=f"the rack has no room: .*{why}"):
        table.rack(kind, **how)
