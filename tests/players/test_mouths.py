"""How wide pockets are for a ball: what the engine says, and what is read from that."""

from cmath import phase, rect

import pytest

from danggu.players.mouths import AWAY, PACE, STEP, WIDEST, edges, gauge, holes, window
from physics import Ball, Pocket, Shot, heading, simulate, tables

NINE = tables.pool(9)


def drops(at: complex, way: complex, hole: str) -> bool:
    world = NINE.world()
    world.add(Ball("ball", (at.real, at.imag)))
    after = simulate(world, "ball", Shot(PACE, heading(way), follow=PACE))
    return bool(after.log.all("pocket", "ball", hole))


def test_each_hole_is_a_pocket_of_the_table_and_lies_behind_its_mouth():
    for table in (NINE, tables.SNOOKER_12FT, tables.PYRAMID_12FT):
        found = {wall.name: wall for wall in table.world().walls if isinstance(wall, Pocket)}
        assert {hole.name for hole in holes(table)} == {*found}
        for hole in holes(table):
            deep = (complex(*found[hole.name].at) - hole.middle) * hole.axis.conjugate()
            assert deep.real > 0
            assert abs(deep.imag) < 1e-12


def test_a_table_without_pockets_has_no_mouths():
    with pytest.raises(ValueError, match="no pockets"):
        holes(tables.MATCH_CAROM)


@pytest.mark.parametrize("kind", WIDEST)
def test_straight_at_it_a_mouth_is_its_own_mirror_image_and_takes_a_ball_less_wide(kind):
    right, left = edges(NINE, kind, 0)
    mouth = getattr(NINE.pockets, kind).width
    assert right == -left
    # the centre of a ball that meets no nose; a facing may send it in from a little farther out
    assert mouth / 2 - NINE.radius < left < mouth / 2


@pytest.mark.parametrize("kind", WIDEST)
def test_the_flatter_a_ball_comes_the_narrower_is_a_mouth(kind):
    wide = [edge[1] - edge[0] if edge else 0.0 for edge in gauge(NINE)[kind]]
    assert wide == sorted(wide, reverse=True)
    assert wide[-1] < 0.5 * wide[0]


@pytest.mark.parametrize("hole", holes(NINE), ids=lambda hole: hole.name)
@pytest.mark.parametrize("turn", [-1.3, 0.0, 2.4])
def test_from_elsewhere_a_ball_drops_in_the_middle_of_its_window_and_not_beyond(hole, turn):
    far = 1.5 * AWAY
    at = hole.middle - far * hole.axis * rect(1.0, turn * STEP * 3.141592653589793 / 180)
    way, right, left = window(gauge(NINE), hole, at)
    assert abs(phase(way * hole.axis.conjugate())) < 0.4
    for share, falls in ((0.5, True), (0.1, True), (0.9, True), (-0.4, False), (1.4, False)):
        aim = way * rect(1.0, right + share * (left - right))
        assert drops(at, aim, hole.name) is falls, share
