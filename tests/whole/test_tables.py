"""The presets: sizes, balls, laws and cloths of the tables there are."""

import itertools
from dataclasses import replace

import pytest

from game.table import presets
from physics import Ball, Cloth, Shot, World, laws, simulate, tables

PRESETS = [tables.THESIS, tables.MEDIUM_CAROM, tables.MATCH_CAROM]


@pytest.mark.parametrize("preset", PRESETS, ids=repr)
def test_a_table_is_as_long_and_as_wide_as_it_says(preset):
    world = preset.world()
    assert [wall.name for wall in world.walls] == ["west", "east", "south", "north"]
    reach = 0.5 * preset.length, 0.5 * preset.width
    for wall, far in zip(world.walls, (reach[0], reach[0], reach[1], reach[1]), strict=True):
        assert wall.distance((0.0, 0.0)) == far
    white = world.add(Ball("white", at=(0.0, 0.0), radius=preset.radius, mass=preset.mass))
    after = simulate(world, white, Shot(4.0, 31.0))
    cushions = [event for event in after.log if event.kind == "cushion"]
    for event in cushions:
        wall = next(wall for wall in world.walls if wall.name == event.wall)
        assert wall.distance(event.point) == pytest.approx(0.0, abs=1e-15)
    assert len(cushions) >= 3


def test_the_thesis_table_is_the_thesis():
    preset = tables.THESIS
    assert (preset.length, preset.width) == (2.448, 1.270)
    assert (preset.radius, preset.mass) == (0.0655 / 2, 0.25)
    assert preset.cloth == Cloth(slide=0.2, roll=0.01, spin_decay=10.0, gravity=9.8)
    assert preset.ball_law == laws.ThesisBall(0.95)
    assert preset.cushion_law == laws.ThesisCushion(0.9, 0.1)


@pytest.mark.parametrize(
    ("preset", "size", "diameter", "mass", "noses"),
    [
        (tables.MEDIUM_CAROM, (2.54, 1.27), (0.0655, 0.0655), (0.25, 0.25), (0.038, 0.040)),
        (tables.MATCH_CAROM, (2.84, 1.42), (0.061, 0.0615), (0.205, 0.220), (0.036, 0.038)),
    ],
    ids=["medium", "match"],
)
def test_the_carom_tables_are_within_their_specifications(preset, size, diameter, mass, noses):
    assert (preset.length, preset.width) == size
    assert diameter[0] <= 2.0 * preset.radius <= diameter[1]
    assert mass[0] <= preset.mass <= mass[1]
    assert noses[0] <= preset.cushion_law.nose * preset.radius <= noses[1]
    assert preset.cloth is tables.MEASURED
    assert (preset.cushion_law.e, preset.cushion_law.mu) == (0.891, 0.242)
    assert (preset.ball_law.e, preset.ball_law.mu) == (0.946, "alciatore")


@pytest.mark.parametrize(("edition", "least"), [(1, 5.0), (2, 3.0)])
def test_cloths_stay_within_what_is_published_and_measured(edition, least):
    for cloth in tables.CLOTH_EDITIONS[edition].values():
        assert 0.15 <= cloth.slide <= 0.4
        assert 0.004 <= cloth.roll <= 0.015  # 0.0402 m/s² / g, measured at rest, is 0.0041
        # published are 5 to 15, but 4.3 is measured, on a cloth that is no longer new
        assert least <= cloth.spin_decay <= 15.0


@pytest.mark.parametrize("name", ["slide", "roll", "spin_decay"])
def test_in_all_coefficients_a_cloth_is_beyond_the_one_in_better_condition(name):
    found = [getattr(cloth, name) for cloth in tables.CLOTHS.values()]
    assert all(a < b for a, b in itertools.pairwise(found))


def test_side_lasts_longest_on_a_new_cloth_and_shortest_on_a_damp_one():
    """What is left of it at the far rail."""
    left = []
    for cloth in tables.CLOTHS.values():
        world = tables.match_carom()
        world.cloth = cloth
        white = world.add(Ball("white", at=(-1.2, 0.0)))
        hit = next(e for e in simulate(world, white, Shot(3.0, side=3.0)).log if e.wall == "east")
        left.append(hit.before[0].spin[2])
    assert left == sorted(left, reverse=True)
    assert left[0] > left[-1] + 5.0


def test_the_first_edition_of_cloths_never_changes():
    """Records of games are played on them."""
    first = tables.CLOTH_EDITIONS[1]
    assert {name: (c.slide, c.roll, c.spin_decay, c.gravity) for name, c in first.items()} == {
        "new": (0.15, 0.004, 5.0, 9.81), "measured": (0.212, 0.0045, 10.0, 9.81),
        "worn": (0.2, 0.01, 10.0, 9.81), "humid": (0.4, 0.015, 15.0, 9.81),
    }  # fmt: skip


def test_a_ball_runs_farther_on_new_cloth_and_draws_better():
    runs, draws = [], []
    for name in ("new", "worn", "humid"):
        world = tables.match_carom()
        world.cloth = tables.CLOTHS[name]
        white = world.add(Ball("white", at=(0.0, 0.0), radius=0.03075, mass=0.21))
        after = simulate(world, white, Shot(0.3, follow=0.3))
        runs.append(after.ball("white").position[0])
        # how much of a draw is left where a ball 0.5 m away would be met
        world.strike(white, Shot(3.0, follow=-3.0))
        while white.position[0] < 0.5:
            world.step(1e-3)
        draws.append(-white.spin[1])
    # v² / (2 μ g), as far as the rail allows
    assert runs == pytest.approx([0.09 / (2 * mu * 9.81) for mu in (0.004, 0.01, 0.015)], rel=1e-12)
    assert draws == sorted(draws, reverse=True)
    assert draws[0] > draws[2] + 10.0


@pytest.mark.parametrize(
    "shot",
    [Shot(2.0, follow=2.0), Shot(0.01), Shot(3.0), Shot(3.0, follow=4.0), Shot(3.0, follow=-2.0)],
)
def test_cloths_stand_in_the_order_in_which_a_ball_runs_farthest(shot):
    """Whatever it is struck with, and also in the time it takes."""
    far, long = [], []
    for cloth in tables.CLOTHS.values():
        world = World(cloth)
        world.add(Ball("white", at=(0.0, 0.0)))
        after = simulate(world, "white", shot)
        far.append(after.ball("white").position[0])
        long.append(after.time)
    assert [*tables.CLOTHS] == ["new", "measured", "hall", "worn", "humid"]
    assert far == sorted(far, reverse=True)
    assert long == sorted(long, reverse=True)
    assert len({*far}) == len({*long}) == 5


@pytest.mark.parametrize("preset", [tables.MEDIUM_CAROM, tables.MATCH_CAROM])
@pytest.mark.parametrize("angle", [0.0, 31.0, 77.0])
def test_a_new_cloth_stops_a_ball_later_than_the_table_s_own(preset, angle):
    times = []
    for key in ("new", "table", "worn", "humid"):
        world = preset.world()
        world.cloth = presets.cloth(key) or preset.cloth
        world.add(Ball("white", at=(0.0, 0.0), radius=preset.radius, mass=preset.mass))
        times.append(simulate(world, "white", Shot(4.0, angle)).time)
    assert times == sorted(times, reverse=True)


def test_an_edition_of_the_match_table_never_changes():
    first, second = (tables.match_carom(edition) for edition in (1, 2))
    assert (first.cloth, first.ball_law, first.cushion_law) == (
        Cloth(0.212, 0.0045, 10.0, 9.81), laws.RoughBall(0.946, "alciatore"),
        laws.RigidCushion(0.891, 0.242, 0.037 / 0.03075),
    )  # fmt: skip
    assert (second.cloth, second.ball_law, second.cushion_law) == (
        Cloth(0.212, 0.0045, 4.3, 9.81), laws.RoughBall(0.946, 0.05),
        laws.RigidCushion(0.871, 0.269, 0.037 / 0.03075, e_slope=-0.051),
    )  # fmt: skip
    assert first.walls == second.walls


def test_without_an_edition_the_match_table_is_the_one_nearest_to_real_strokes():
    """The medium one is that of before: of its second edition nothing has been measured."""
    assert tables.match_carom().table is tables.MATCH_CAROM_2
    assert tables.medium_carom().table is tables.MEDIUM_CAROM


def test_a_medium_table_of_a_hall_has_its_cloth_and_the_laws_that_were_measured():
    first, hall = (tables.medium_carom(edition) for edition in (1, 2))
    assert hall.cloth is tables.CLOTHS["hall"]
    assert hall.cushion_law == replace(
        tables.MATCH_CAROM_2.cushion_law, nose=first.cushion_law.nose
    )
    assert hall.ball_law == tables.MATCH_CAROM_2.ball_law
    assert first.walls == hall.walls


@pytest.mark.parametrize("edition", [0, 3, "2"])
def test_an_edition_that_there_is_not_is_refused(edition):
    with pytest.raises(ValueError, match=f"edition must be one of 1, 2, not {edition!r}"):
        tables.match_carom(edition)
    with pytest.raises(ValueError, match=f"medium_carom edition must be .*, not {edition!r}"):
        tables.medium_carom(edition)
