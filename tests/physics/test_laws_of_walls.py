"""Walls, and posts, with laws of their own: rails, facings and noses may differ."""

import pytest

from physics import (
    Ball,
    Cloth,
    Post,
    Shot,
    Wall,
    World,
    laws,
    sensitivity,
    simulate,
    simulate_many,
    store,
)
from tests.support import fifty
from tests.support.any_shape import R


def soft() -> World:
    """A table of lines, one wall of which is soft, and a post of yet another law."""
    world = World(Cloth(), "rough", laws.RigidCushion(0.9, 0.1, 1.2))
    for a, b, name in ((1, 0, "west"), (-1, 0, "east"), (0, 1, "south"), (0, -1, "north")):
        law = laws.RigidCushion(0.3, 0.4, 1.3) if name == "east" else None
        world.add(Wall.line(a, b, 0.7, name, law=law))
    world.add(Post((0.0, 0.3), 0.05, "post", law=laws.ThesisCushion(0.5, 0.2)))
    world.add(Ball("a", (0.0, 0.0), radius=R))
    world.add(Ball("b", (0.3, -0.3), radius=R))
    return world


def test_every_wall_follows_its_own_law():
    after = simulate(soft(), "a", Shot(5.0, 0.0))
    hits = {e.wall: e for e in after.log if e.kind == "cushion"}
    rolled = World(Cloth(), "rough", laws.RigidCushion(0.3, 0.4, 1.3))
    rolled.add(Wall.line(-1.0, 0.0, 0.7, "east"))
    rolled.add(Ball("a", (0.0, 0.0), radius=R))
    alike = next(e for e in simulate(rolled, "a", Shot(5.0, 0.0)).log if e.kind == "cushion")
    assert hits["east"].after == alike.after
    assert hits["west"].after[0].velocity[0] > 0.8 * hits["west"].closing


def test_batches_cells_fifty_digits_files_and_derivatives_know_laws_of_walls():
    world, shot = soft(), Shot(3.0, 33.0, side=0.5)
    after = simulate(world, "a", shot)
    assert {"east", "post"} <= {e.wall for e in after.log}
    again = simulate(store.loads(store.dumps(world)), "a", shot)
    assert again.walls == world.walls
    assert again.layout() == after.layout()
    rest, events = fifty.rest(struck(soft(), shot))
    assert events == len(after.log)
    assert complex(*after.ball("a").position) == pytest.approx(complex(rest[0]), abs=1e-10)
    slopes, step = sensitivity(world, "a", shot), 1e-6
    ends = [simulate(world, "a", Shot(3.0, 33.0 + d, side=0.5)) for d in (step, -step)]
    for k in (0, 1):
        change = (ends[0].ball("a").position[k] - ends[1].ball("a").position[k]) / (2 * step)
        assert slopes.rest[0, k, 1] == pytest.approx(change, rel=1e-4, abs=1e-6)
    pytest.importorskip("numba")
    fast = simulate_many(world, "a", [shot], compiled=True)
    assert tuple(fast.positions[0, 0]) == after.ball("a").position


def struck(world: World, shot: Shot) -> World:
    world.strike("a", shot)
    return world


def test_a_custom_law_of_a_wall_is_watched_and_cannot_be_saved():
    world = soft()
    world.add(
        Wall.segment((-0.2, -0.6), (0.2, -0.6), "odd", law=lambda v, roll, side: (v, roll, side))
    )
    with pytest.raises(ValueError, match="into the wall"):
        simulate(world, "a", Shot(2.0, 270.0))
    with pytest.raises(ValueError, match=r"'odd'.*custom"):
        store.dumps(world)
    with pytest.raises(ValueError, match="custom law"):
        simulate_many(world, "a", [Shot(1.0)], compiled=True)


def test_a_law_that_is_none_is_refused():
    for law in ("bouncy", laws.SmoothBall(), 3):
        with pytest.raises(ValueError, match="cushion law"):
            Post((0.0, 0.0), 0.1, law=law)
