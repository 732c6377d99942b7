"""How balls lie: touching, snookered, spotted, and among the lines of balkline."""

from math import asin, cos, dist, inf, pi, sin, sqrt

import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from danggu.rules import balkline
from danggu.rules.lie import snookered, touching
from danggu.rules.snooker import COLOURS
from danggu.rules.spots import along, carom_spots, colour_spots, respotted

D = 0.0525
CUE = (0.0, 0.0)


def test_balls_touch_that_are_a_diameter_apart():
    places = {"a": (0.0, 0.0), "b": (D, 0.0), "c": (D, 1.01 * D)}
    assert touching(places, D) == (("a", "b"),)


def test_a_ball_in_the_way_snookers_and_one_beside_it_does_not():
    ball = (1.0, 0.0)
    assert snookered(CUE, [ball], [(0.5, 0.0)], D)
    # the finest edges are met on ways that run D aside at the ball, so half of that in the middle
    assert snookered(CUE, [ball], [(0.5, 1.49 * D)], D)
    assert not snookered(CUE, [ball], [(0.5, 1.52 * D)], D)
    assert not snookered(CUE, [ball], [(-0.5, 0.0), (1.5, 0.0)], D)


def test_one_ball_on_that_is_free_is_enough():
    assert not snookered(CUE, [(1.0, 0.0), (0.0, 1.0)], [(0.5, 0.0)], D)
    assert snookered(CUE, [(1.0, 0.0), (0.0, 1.0)], [(0.5, 0.0), (0.0, 0.5)], D)


def test_a_ball_behind_the_ball_on_hides_nothing_until_its_edge_is_met_first():
    ball = (1.0, 0.0)
    assert not snookered(CUE, [ball], [(1.0 + 1.01 * D, 0.0)], D)
    assert snookered(CUE, [ball], [(1.0, 1.01 * D)], D)


places = st.tuples(st.floats(-1, 1), st.floats(-1, 1))


@given(places, places)
@example((0.671875, 0.6015625), (0.671875, 0.671875))
def test_snookered_is_what_a_fan_of_straight_ways_finds(ball, other):
    assume(min(dist(CUE, ball), dist(CUE, other), dist(ball, other)) > 1.01 * D)
    wide = asin(D / dist(CUE, ball))
    straight = complex(*ball)

    def reach(at, way):
        turned = complex(*at) * straight.conjugate() / abs(straight) * complex(cos(way), -sin(way))
        if turned.real < 0 or abs(turned.imag) > D:
            return inf
        return turned.real - sqrt(D**2 - turned.imag**2)

    # closest together at the edges, where what is hidden can be a sliver
    ways = [wide * cos(pi * (i + 0.5) / 1000) for i in range(1000)]
    blocked = sum(reach(other, way) < reach(ball, way) for way in ways)
    assume(blocked != 0 or not _nearly(ball, other))
    assert snookered(CUE, [ball], [other], D) == (blocked > 0)


def _nearly(ball, other):
    """Whether one way more or less of the fan decides."""
    more, less = 1.01 * D, 0.99 * D
    return snookered(CUE, [ball], [other], more) != snookered(CUE, [ball], [other], less)


# -- spots -----------------------------------------------------------------------------------------


def test_a_colour_goes_to_its_own_spot_else_to_the_highest_that_is_free():
    assert colour_spots(["blue"], []) == {"blue": "blue"}
    assert colour_spots(["blue"], ["blue"]) == {"blue": "black"}
    assert colour_spots(["blue"], ["blue", "black"]) == {"blue": "pink"}
    assert colour_spots(["blue"], COLOURS) == {"blue": ""}


def test_of_two_colours_the_higher_is_spotted_first():
    taken = ["blue", "brown", "black", "green", "yellow"]
    assert colour_spots(["brown", "blue"], taken) == {"blue": "pink", "brown": ""}


def test_in_three_cushion_a_covered_spot_sends_a_ball_to_that_of_the_ball_on_it():
    spots = carom_spots("white", "yellow")
    assert respotted(["red"], spots, {"foot": "yellow"}) == {"red": "centre"}
    assert respotted(["red"], spots, {"foot": "yellow", "centre": "white"}) == {
        "red": "head"
    }
    assert respotted(["red", "white"], spots, {}) == {"red": "foot", "white": "head"}


def test_a_ball_is_spotted_as_near_to_the_start_of_its_line_as_others_let_it():
    start, end = (0.0, 0.0), (1.0, 0.0)
    assert along(start, end, [], D) == start
    assert along(start, end, [(0.0, 0.0)], D) == pytest.approx((D, 0.0))
    row = [(0.0, 0.0), (1.5 * D, 0.0)]
    assert along(start, end, row, D) == pytest.approx((2.5 * D, 0.0))
    assert along(start, end, [(i * D, 0.0) for i in range(50)], D) is None


@given(st.lists(st.tuples(st.floats(-0.1, 1.1), st.floats(-D, D)), max_size=12))
@example([(0.0, 0.05249999999999999)])
def test_a_spotted_ball_overlaps_no_other_and_no_nearer_place_is_free(others):
    at = along((0.0, 0.0), (1.0, 0.0), others, D)
    reach = 1.0 if at is None else at[0]
    if at is not None:
        assert all(dist(at, other) >= D * (1 - 1e-9) for other in others)
    for step in range(200):
        nearer = (reach * step / 200, 0.0)
        assert reach == 0 or any(dist(nearer, other) < D * (1 + 1e-9) for other in others)


# -- balkline --------------------------------------------------------------------------------------

ZONES = balkline.squares(2.84, 1.42, 0.47)


def test_the_lines_of_balkline_make_nine_zones_that_fill_the_table():
    assert len(ZONES) == 9
    for x in (-1.4, -0.9, 0.0, 1.0, 1.41):
        for y in (-0.7, 0.0, 0.3, 0.7):
            assert sum(area.holds((x, y)) for area in ZONES) == 1


def test_a_ball_on_a_line_is_in_both_zones_which_is_worse_for_the_player():
    line = -1.42 + 0.47
    for x in (line - 0.1, line + 0.1):
        assert balkline.zone(ZONES, [(line, 0.0)], [(x, 0.1)]).ends == balkline.IN


def test_two_balls_that_stay_have_not_left_and_one_that_comes_back_has():
    inside, outside, other = (-1.2, 0.0), (-0.5, 0.0), (-1.1, 0.1)
    assert balkline.zone(ZONES, [inside], [other]) == (balkline.IN, False)
    assert balkline.zone(ZONES, [inside, outside, inside], [other]) == (balkline.IN, True)
    assert balkline.zone(ZONES, [outside, inside], [other]) == (balkline.IN, True)
    assert balkline.zone(ZONES, [inside, outside], [other]).ends == balkline.ASTRIDE


def test_the_barred_corners_of_straight_rail_run_a_quarter_along_each_side():
    areas = balkline.corners(2.84, 1.42)
    assert len(areas) == 4
    for sx, sy in ((1, 1), (-1, 1), (-1, -1), (1, -1)):
        held = [area.holds((sx * 1.4, sy * 0.7)) for area in areas]
        assert sum(held) == 1
        assert sum(area.holds((sx * 0.72, sy * 0.7095)) for area in areas) == 1
        assert not any(area.holds((sx * 0.7, sy * 0.7)) for area in areas)
        assert not any(area.holds((sx * 1.065, sy * 0.53)) for area in areas)


def test_the_anchors_are_squares_at_the_cushions_halved_by_the_lines():
    areas = balkline.anchors(2.84, 1.42, 0.47)
    assert len(areas) == 8
    line = -1.42 + 0.47
    across = balkline.zone(areas, [(line - 0.05, 0.65)], [(line + 0.05, 0.6)])
    assert across == (balkline.IN, False)
    assert balkline.zone(ZONES, [(line - 0.05, 0.65)], [(line + 0.05, 0.6)]).ends != balkline.IN
    assert balkline.zone(areas, [(line, 0.5)], [(line, 0.65)]).ends == balkline.OUT
