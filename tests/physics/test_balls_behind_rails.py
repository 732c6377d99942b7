"""A ball that is put down behind the rail of a table with pockets is refused, and one in a mouth
is not."""

import numpy as np
import pytest

from physics import Ball, Shot, simulate_many, tables

TABLES = (tables.pool_9ft, tables.pool_7ft, tables.snooker_12ft, tables.pyramid_12ft)


def behind(table):
    """Places behind the rails and their facings: right behind, and anywhere beyond."""
    x, y, r = 0.5 * table.length, 0.5 * table.width, table.radius
    yield from ((x + 2 * r, 0.3 * y), (0.5 * x, y + 3 * r), (-9.0, 9.0), (-x - 2 * r, 0.0))
    yield (0.0, -y - 0.5)
    yield (3.0 * x, 0.0)


@pytest.mark.parametrize("made", TABLES, ids=lambda made: made.__name__)
def test_a_ball_behind_a_rail_is_refused_by_its_name_and_stays_out_of_the_play(made):
    for at in behind(made().table):
        world = made()
        world.add(Ball("lost", at=at))
        with pytest.raises(ValueError, match=r"'lost'.* is outside the table"):
            world.run()
        assert world.time == 0.0


@pytest.mark.parametrize("made", TABLES, ids=lambda made: made.__name__)
def test_a_ball_in_the_mouth_of_a_pocket_may_lie_there(made):
    world = made()
    pocket = next(w for w in world.walls if w.kind == "pocket" and w.name == "north pocket")
    at = (0.0, pocket.shape.centre.imag - pocket.radius - 1e-4)  # at the edge of the hole
    assert at[1] > 0.5 * world.table.width
    world.add(Ball("hanging", at=at))
    world.run()
    assert world.ball("hanging").position == at


def test_a_batch_refuses_places_behind_a_rail_with_the_number_of_the_shot():
    world = tables.pool_9ft()
    cue = world.add(Ball("cue", at=(0.0, 0.0)))
    good, bad = [(0.1, 0.1)], [(9.0, 9.0)]
    with pytest.raises(ValueError, match=r"positions of shot 1: .*'cue'.* is outside the table"):
        simulate_many(world, cue, [Shot(2.0)] * 2, positions=np.array([good, bad]))
    assert simulate_many(world, cue, [Shot(2.0)], positions=np.array([good])).events[0] > 0


def test_where_walls_were_taken_away_a_ball_may_lie_beyond():
    world = tables.pool_9ft()
    world.remove(next(wall for wall in world.walls if wall.name == "east"))
    world.add(Ball("far", at=(1.6, 0.0)))
    world.run()
    assert world.ball("far").position == (1.6, 0.0)
