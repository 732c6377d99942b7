"""Where the cushions, facings, noses and holes of a table are."""

import json
import re
from dataclasses import replace
from math import atan2, copysign, degrees, fsum, hypot, inf, nan, sqrt
from pathlib import Path

import pytest

from physics import Ball, Shot, ledger, simulate, tables
from physics.kernel.elementary import direction
from physics.tables.pocket_tables import (
    CORNER,
    INCH,
    PYRAMID_12FT,
    SIDE,
    SNOOKER_12FT,
    pool,
    pool_7ft,
    pool_8ft,
    pool_9ft,
    pyramid_12ft,
    snooker_12ft,
)
from tests.support.mirrors import aimed, pocketed

POOLS = [pool(9), pool(8), pool(7)]
ALL = [*POOLS, SNOOKER_12FT, PYRAMID_12FT]
WINDOWS = json.loads((Path(__file__).parents[1] / "data" / "pocket_windows.json").read_text())
EDGE = 3e-9  # inches: the file has nine decimals
EDGES = ("rail", "facing")  # what is straight of the cushions
CORNERS = ("north-east", "north-west", "south-west", "south-east")


def named(table):
    return table.name


def one(table, name, part):
    return next(thing for thing in table.obstacles if (thing.name, thing.part) == (name, part))


def mouth(table, pocket, sides):
    """The two vertices of a pocket, as its facings' lines and noses' lines have them."""
    facings = [one(table, f"{pocket} pocket, {side} facing", "facing").points for side in sides]
    x, y = 0.5 * table.length, 0.5 * table.width
    for (p, q), side in zip(facings, sides, strict=True):
        along = (q - p) / abs(q - p)
        if pocket in ("north", "south") or side in ("north", "south"):
            line = y if "north" in (side, pocket) else -y
            yield p + (line - p.imag) / along.imag * along
        else:
            line = x if side == "east" else -x
            yield p + (line - p.real) / along.real * along


@pytest.mark.parametrize("table", ALL, ids=named)
def test_a_mouth_is_measured_between_the_vertices_before_any_rounding(table):
    for corner in CORNERS:
        p, q = mouth(table, corner, corner.split("-"))
        assert abs(p - q) == pytest.approx(table.pockets.corner.width, abs=1e-14)
    for side in ("north", "south"):
        p, q = mouth(table, side, ("east", "west"))
        assert abs(p - q) == pytest.approx(table.pockets.side.width, abs=1e-14)


@pytest.mark.parametrize("table", ALL, ids=named)
def test_a_shelf_is_from_the_middle_of_the_mouth_to_the_hole_s_edge(table):
    x, y = 0.5 * table.length, 0.5 * table.width
    for pocket in CORNERS:
        vertices = list(mouth(table, pocket, pocket.split("-")))
        hole = one(table, f"{pocket} pocket", "hole")
        middle, corner = sum(vertices) / 2, complex(x, y)
        away = abs(hole.points[0] - middle) - hole.radius
        assert away == pytest.approx(table.pockets.corner.shelf, abs=1e-14)
        assert abs(middle.real) + abs(middle.imag) < corner.real + corner.imag
        assert abs(hole.points[0]) > abs(middle)
    (hole,), radius = one(table, "north pocket", "hole")[1:3]
    assert hole.real == 0.0
    assert hole.imag - radius - y == pytest.approx(table.pockets.side.shelf, abs=1e-15)


@pytest.mark.parametrize("table", POOLS, ids=named)
def test_pool_has_the_cut_angles_of_the_wpa(table):
    """142° and 104° between nose and facing, inside the rubber."""
    for name, expected in (
        ("north-east pocket, north facing", 142.0), ("north-east pocket, east facing", 142.0),
        ("south-west pocket, west facing", 142.0), ("north pocket, east facing", 104.0),
        ("south pocket, west facing", 104.0),
    ):  # fmt: skip
        ends = one(table, name, "facing").points
        along = ends[1] - ends[0]
        rail = 1.0 if "north facing" in name or " pocket, " not in name else 1j
        if name.startswith(("north pocket", "south pocket")):
            rail = 1.0
        between = degrees(abs(atan2((along / rail).imag, (along / rail).real))) % 180.0
        assert max(between, 180.0 - between) == pytest.approx(expected, abs=1e-12)


@pytest.mark.parametrize("table", ALL, ids=named)
def test_the_four_quarters_are_mirror_images_to_the_last_bit(table):
    """Points and radii; and names, with the directions exchanged."""

    def image(thing, sx, sy):
        flip = {}
        if sx < 0:
            flip |= {"east": "west", "west": "east"}
        if sy < 0:
            flip |= {"north": "south", "south": "north"}
        words = thing.name.replace("-", " - ").replace(",", " ,").split()
        name = " ".join(flip.get(word, word) for word in words)
        ends = frozenset((sx * p.real + 0.0, sy * p.imag + 0.0) for p in thing.points)
        name = name.replace(" - ", "-").replace(" ,", ",")
        return thing.kind, thing.part, name, thing.radius, ends

    plain = {image(thing, 1, 1) for thing in table.obstacles}
    assert len(plain) == len(table.obstacles)
    for sx, sy in ((-1, 1), (1, -1), (-1, -1)):
        assert {image(thing, sx, sy) for thing in table.obstacles} == plain


@pytest.mark.parametrize("table", ALL, ids=named)
def test_a_table_has_six_rails_six_holes_and_two_facings_at_each(table):
    parts = [thing.part for thing in table.obstacles]
    rounded = table.pockets.corner.rounding > 0.0
    counts = {part: parts.count(part) for part in ("rail", "facing", "nose", "hole")}
    assert counts == {"rail": 6, "facing": 12, "nose": 12 * rounded, "hole": 6}
    assert parts.count("back") == 6 + counts["nose"]
    named = [(thing.part, thing.name) for thing in table.obstacles]
    assert len({*named}) == len(named)


@pytest.mark.parametrize("table", ALL, ids=named)
def test_the_table_is_on_the_left_of_every_rail_and_the_pocket_of_every_facing(table):
    holes = {thing.name: thing.points[0] for thing in table.obstacles if thing.part == "hole"}
    for thing in table.obstacles:
        if thing.part in EDGES:
            p, q = thing.points
            to = 0j if thing.part == "rail" else holes[thing.name.split(",")[0]]
            assert ((q - p).conjugate() * (to - p)).imag > 0.0


@pytest.mark.parametrize("table", ALL, ids=named)
def test_rails_noses_and_facings_join_without_a_kink(table):
    """A round nose touches the line of its rail and that of its facing, where both end."""
    ends = [p for thing in table.obstacles if thing.part in EDGES for p in thing.points]
    for thing in table.obstacles:
        if thing.part == "nose":
            (centre,) = thing.points
            touching = [p for p in ends if abs(abs(p - centre) - thing.radius) < 1e-14]
            assert len(touching) == 2
            for line in (t.points for t in table.obstacles if t.part in EDGES):
                if {*line} & {*touching}:
                    along = (line[1] - line[0]) / abs(line[1] - line[0])
                    away = (along.conjugate() * (centre - line[0])).imag
                    assert away == pytest.approx(-thing.radius, abs=1e-12)
        if thing.part == "rail" and table.pockets.corner.rounding == 0.0:
            assert all(ends.count(p) == 2 for p in thing.points)


@pytest.mark.parametrize("table", [*ALL, tables.MATCH_CAROM], ids=named)
def test_an_outline_goes_round_the_table_once_anticlockwise_along_its_obstacles(table):
    edge = table.outline
    pairs = list(zip(edge, (*edge[1:], edge[0]), strict=True))
    area = sum((p.conjugate() * q).imag for p, q in pairs) / 2
    assert 1.0 < area / (table.length * table.width) < 1.03 or (
        table.pockets is None and area == table.length * table.width
    )
    sides = {frozenset(pair) for pair in pairs}
    for thing in table.obstacles:
        if thing.part in EDGES and thing.kind == "segment":
            assert frozenset(thing.points) in sides
    for p in edge:  # no bit of difference between its quarters
        assert p.conjugate() in edge
        assert -p.conjugate() in edge


def trial(case):
    """A 9 ft table with the pockets of a case, which is in inches."""
    spec = tables.Mouth(
        case["mouth"] * INCH, case["facing"], case["shelf"] * INCH, case["hole"] * INCH
    )
    return replace(
        POOLS[0], radius=case["ball_radius"] * INCH,
        pockets=replace(POOLS[0].pockets, **{case["pocket"]: spec}),
    )  # fmt: skip


@pytest.mark.parametrize("case", WINDOWS["cases"], ids=lambda c: f"{c['geometry']} {c['angle']}")
@pytest.mark.parametrize("mirrored", [False, True])
def test_light_goes_in_through_the_window_that_alciatore_computed_and_no_wider(case, mirrored):
    """TP 3.5 and TP 3.6, on the geometry of the whole table, and at the other angle mirrored."""
    table = trial(case)
    pocket = {"side": "north", "corner": "north-east"}[case["pocket"]]
    axis = {"side": 90.0, "corner": 45.0}[case["pocket"]]
    half = 0.5 * table.pockets.corner.width * sqrt(0.5)
    x, y = 0.5 * table.length, 0.5 * table.width
    middle = complex(0.0, y) if case["pocket"] == "side" else complex(x - half, y - half)
    sign = -1.0 if mirrored else 1.0
    for edge, outwards in (("left", -1.0), ("right", 1.0)):
        for beyond in (-EDGE, EDGE):
            offset = sign * (case[edge] + outwards * beyond) * INCH
            found = aimed(table, middle, axis, sign * case["angle"], offset, 30.0 * INCH)
            assert (found == f"{pocket} pocket") == (beyond < 0.0), edge


@pytest.mark.parametrize("table", ALL, ids=named)
def test_a_ball_that_goes_straight_at_a_pocket_ends_in_it(table):
    x, y = 0.5 * table.length, 0.5 * table.width
    for corner in CORNERS:
        sx, sy = 1 if "east" in corner else -1, 1 if "north" in corner else -1
        start = complex(sx * (x - 0.5 * y), sy * 0.5 * y)
        way = complex(sx, sy) * sqrt(0.5)
        assert pocketed(table, start, way) == f"{corner} pocket"
    assert pocketed(table, 0j, 1j) == "north pocket"
    assert pocketed(table, 0j, -1j) == "south pocket"


@pytest.mark.parametrize("table", ALL, ids=named)
def test_light_never_leaves_a_table_but_through_a_hole(table):
    """A hole ends every way out: nothing passes beside it or between two segments."""
    ends = {pocketed(table, 0.1 + 0.2j, direction(0.91 * k), 300) for k in range(396)}
    assert ends - {None} == {f"{place} pocket" for place in (*CORNERS, "north", "south")}


def test_pool_is_in_the_middle_of_what_the_wpa_allows():
    for table, length in zip(POOLS, (100.0, 92.0, 78.0), strict=True):
        assert table.length == length * INCH
        assert table.width == 0.5 * table.length
        assert 2.0 * table.radius == 2.25 * INCH
        assert 0.156 <= table.mass <= 0.170
        assert 0.625 <= 0.5 * table.cushion_law.nose <= 0.645
        assert table.pockets == tables.Pockets(CORNER, SIDE)
    for given, least, most in (
        (CORNER.width, 4.5, 4.625), (SIDE.width, 5.0, 5.125),
        (CORNER.shelf, 1.0, 2.25), (SIDE.shelf, 0.0, 0.375),
    ):  # fmt: skip
        assert given / INCH == pytest.approx(0.5 * (least + most), rel=1e-15)


def test_what_is_varied_of_a_pool_table_is_what_is_asked_for_and_nothing_else():
    varied = pool(9, corner_mouth=0.115, side_mouth=0.128, shelf=0.03, facing=6.5)
    assert varied.pockets.corner == replace(CORNER, width=0.115, shelf=0.03, facing=6.5)
    assert varied.pockets.side == replace(SIDE, width=0.128)
    assert pool(9, side_shelf=0.0, side_facing=13.0).pockets.side == replace(
        SIDE, shelf=0.0, facing=13.0
    )


@pytest.mark.parametrize("bad", [10, "9", None, nan, [9], {}])
def test_a_pool_table_of_another_length_is_refused_by_its_length(bad):
    why = re.escape(f"a pool table is of 9, 8 or 7 ft, not {bad!r}")
    with pytest.raises(ValueError, match=why):
        pool(bad)


@pytest.mark.parametrize("bad", [nan, inf, "5", None, -1.0])
@pytest.mark.parametrize("name", ["corner_mouth", "side_mouth", "shelf", "facing"])
def test_a_pocket_that_cannot_be_is_refused_by_name(name, bad):
    with pytest.raises(ValueError, match=r"Mouth\.(width|shelf|facing)"):
        pool(9, **{name: bad})


@pytest.mark.parametrize("size", [{"corner_mouth": 0.9}, {"side_mouth": 2.4}])
def test_pockets_that_leave_no_room_for_a_rail_are_refused(size):
    with pytest.raises(ValueError, match="no room for Pockets"):
        pool(9, **size)


@pytest.mark.parametrize("bad", [3, "wide", [CORNER, SIDE], CORNER])
def test_what_are_no_pockets_is_refused(bad):
    with pytest.raises(ValueError, match=r"Table\.pockets must be Pockets, not"):
        replace(tables.MATCH_CAROM, pockets=bad)
    with pytest.raises(ValueError, match="Pockets takes two of Mouth, not"):
        tables.Pockets(CORNER, tables.MATCH_CAROM)


def test_facings_that_close_by_half_a_right_angle_are_refused():
    with pytest.raises(ValueError, match=r"Mouth\.facing must be below 45, not 45"):
        pool(9, facing=45.0)


@pytest.mark.parametrize(
    "mouth",
    [
        replace(CORNER, width=0.26), replace(CORNER, hole=0.015),
        replace(CORNER, rounding=0.4), replace(CORNER, facing=0.0, width=0.2),
    ],
)  # fmt: skip
def test_a_pocket_that_a_ball_could_leave_beside_its_hole_is_refused(mouth):
    """Just wide enough is taken: beside the middle of the hole a ball is over it everywhere."""
    with pytest.raises(ValueError, match="could pass beside the hole of Mouth"):
        replace(POOLS[0], pockets=tables.Pockets(mouth, SIDE))
    ball, straight = POOLS[0].radius, replace(CORNER, facing=0.0)
    for width, taken in ((1.999, True), (2.001, False)):
        wide = replace(straight, width=width * (CORNER.hole + ball))
        if taken:
            replace(POOLS[0], pockets=tables.Pockets(wide, SIDE))
        else:
            with pytest.raises(ValueError, match="could pass"):
                replace(POOLS[0], pockets=tables.Pockets(wide, SIDE))


def test_a_table_that_is_made_longer_has_its_pockets_at_its_ends():
    table = replace(POOLS[0], length=3.0)
    assert one(table, "east", "rail").points[0].real == 1.5
    assert hypot(*table.spots["foot"]) == 0.75


@pytest.mark.parametrize(
    "made", [pool_9ft, pool_8ft, pool_7ft, snooker_12ft, pyramid_12ft], ids=lambda f: f.__name__
)
def test_a_ball_rolled_straight_at_a_pocket_drops_into_it(made):
    pockets = [wall for wall in made().walls if wall.kind == "pocket"]
    assert len(pockets) == 6
    for pocket in pockets:
        x, y = pocket.at
        way = complex(copysign(1.0, x) if abs(x) > 0.1 else 0.0, copysign(1.0, y))
        start = complex(x, y) - 0.5 / abs(way) * way
        world = made()
        world.add(Ball("a", at=(start.real, start.imag)))
        shot = Shot(2.0, degrees(atan2(way.imag, way.real)), follow=2.0)
        after = simulate(world, "a", shot)
        assert [(event.kind, event.wall) for event in after.log] == [("pocket", pocket.name)]
        assert after.ball("a").phase == "pocketed"


def test_a_nine_ball_break_keeps_its_ledger_and_leaves_each_ball_on_the_table_or_down():
    world = pool_9ft()
    for ball in world.table.rack("9-ball"):
        world.add(ball)
    world.add(Ball("cue", at=world.table.spots["head"]))
    down = 0
    for k in range(12):
        after = simulate(world, "cue", Shot(9.0, 0.5 * k - 3.0))
        assert {ball.phase for ball in after.balls} <= {"resting", "pocketed"}
        down += sum(event.kind == "pocket" for event in after.log)
        entries = list(ledger(after.log))
        lost = fsum(entry.energy_lost + entry.cloth_lost for entry in entries)
        given = 0.5 * world.table.mass * 9.0**2
        assert lost + entries[-1].energy == pytest.approx(given, abs=1e-12)
    assert down >= 6
