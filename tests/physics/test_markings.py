"""Spots, lines and regions of the tables, as their rules have them."""

from dataclasses import replace

import pytest

from physics import tables
from physics.tables import markings
from physics.tables.pocket_tables import INCH, PYRAMID_12FT, SNOOKER_12FT, pool
from physics.tables.table import KINDS

POOL = pool(9)
ALL = [tables.THESIS, tables.MEDIUM_CAROM, tables.MATCH_CAROM, POOL, SNOOKER_12FT, PYRAMID_12FT]


@pytest.mark.parametrize("table", ALL, ids=lambda table: table.name)
def test_spots_lie_on_the_bed_and_mirrored_about_the_long_axis(table):
    spots = set(table.spots.values())
    assert {(x, -y) for x, y in spots} == spots
    assert all(table.regions["anywhere"].contains(at) for at in spots)


@pytest.mark.parametrize("table", ALL, ids=lambda table: table.name)
def test_the_bed_is_where_a_ball_fits_between_the_cushions(table):
    bed = table.regions["anywhere"]
    x, y = 0.5 * table.length - table.radius, 0.5 * table.width - table.radius
    for sx in (1, -1):
        for sy in (1, -1):
            assert bed.contains((sx * x, sy * y))
            assert not bed.contains((sx * (x + 1e-8), sy * y))
            assert not bed.contains((sx * x, sy * (y + 1e-8)))


def test_pool_has_its_spots_at_the_quarters_and_the_head_string_is_not_in_the_kitchen():
    """WPA 8.1: behind the head string is up to it, "not including the head string"."""
    assert POOL.spots == {
        "head": (-25.0 * INCH, 0.0), "centre": (0.0, 0.0), "foot": (25.0 * INCH, 0.0)
    }  # fmt: skip
    assert POOL.head_string == -25.0 * INCH
    kitchen = POOL.regions["kitchen"]
    assert not kitchen.contains(POOL.spots["head"])
    assert kitchen.contains((-25.0 * INCH - 1e-12, 0.3))
    assert not kitchen.contains((-50.0 * INCH, 0.0))  # in the cushion


def test_snooker_has_the_spots_of_its_rules():
    """Section 1: baulk line 737 mm, D 292 mm, black 324 mm; pink between the blue and the top."""
    west, east = -3.569 / 2, 3.569 / 2
    spots = SNOOKER_12FT.spots
    assert SNOOKER_12FT.head_string == pytest.approx(west + 0.737, abs=1e-15)
    assert spots["blue"] == (0.0, 0.0)
    assert spots["pink"][0] == pytest.approx(east / 2, abs=1e-15)
    assert spots["black"][0] == pytest.approx(east - 0.324, abs=1e-15)
    assert spots["green"] == (spots["brown"][0], 0.292)  # on the left, seen from baulk
    assert spots["yellow"] == (spots["brown"][0], -0.292)


def test_the_d_is_the_half_of_a_disc_towards_baulk_with_its_edge():
    region, (x, _) = SNOOKER_12FT.regions["D"], SNOOKER_12FT.spots["brown"]
    for name in ("yellow", "green", "brown"):
        assert region.contains(SNOOKER_12FT.spots[name])
    assert region.contains((x - 0.292, 0.0))
    assert not region.contains((x + 1e-8, 0.0))
    assert not region.contains((x - 0.2, 0.22))
    assert SNOOKER_12FT.regions["baulk"].contains((x - 0.2, 0.22))


def test_carom_has_the_spots_of_the_opening_shot_beside_the_head_spot():
    """7 3/16 inches: 182.56 mm, in the UMB's rules 182.5."""
    spots = tables.MATCH_CAROM.spots
    assert spots["head"] == (-0.71, 0.0)
    assert spots["left"] == (-0.71, 0.1825)
    assert spots["right"] == (-0.71, -0.1825)
    assert spots["left"][1] / INCH == pytest.approx(7 + 3 / 16, abs=0.003)


def test_a_pyramid_has_a_house_behind_the_front_spot():
    house, (x, _) = PYRAMID_12FT.regions["house"], PYRAMID_12FT.spots["head"]
    assert x == PYRAMID_12FT.head_string == -0.25 * 3.55
    assert house.contains((x, 0.5))
    assert not house.contains((x + 1e-8, 0.5))


def test_every_kind_has_markings_and_no_other():
    assert tuple(markings.MARKINGS) == KINDS
    with pytest.raises(ValueError, match=r"Table\.kind must be one of carom, .* not 'bar'"):
        replace(POOL, kind="bar")


def test_sizes_of_snooker_and_pyramid_are_within_their_rules():
    """3569 × 1778 ± 13 mm, 52.5 ± 0.05 mm; 3550 × 1775 ± 50 mm, 68 to 68.5 mm, nose 42 mm."""
    assert (SNOOKER_12FT.length, SNOOKER_12FT.width, 2 * SNOOKER_12FT.radius) == (
        3.569, 1.778, 0.0525,
    )  # fmt: skip
    assert (PYRAMID_12FT.length, PYRAMID_12FT.width) == (3.55, 1.775)
    assert 0.068 <= 2.0 * PYRAMID_12FT.radius <= 0.0685
    assert PYRAMID_12FT.cushion_law.nose * PYRAMID_12FT.radius == pytest.approx(0.042, abs=1e-15)
    assert 0.072 <= PYRAMID_12FT.pockets.corner.width <= 0.073
    assert 0.082 <= PYRAMID_12FT.pockets.side.width <= 0.083
