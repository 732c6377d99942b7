"""A ball that joins a world in which shots were played is looked at like those there before it."""

import pytest

from physics import Ball, EventDriven, Shot, TimeStepping, World, simulate, tables

ENGINES = [EventDriven(), TimeStepping(1 / 180)]


def played(engine) -> World:
    """A table on which a shot has come to rest."""
    world = tables.medium_carom()
    world.engine = engine
    world.add(Ball("white", at=(-0.6, 0.0)))
    world.add(Ball("red", at=(0.6, 0.01)))
    world.strike("white", Shot(0.2, angle=90.0))
    world.run()
    return world


@pytest.mark.parametrize("engine", ENGINES, ids=repr)
@pytest.mark.parametrize(
    ("at", "why"), [((0.6, 0.02), "overlap"), ((5.0, 0.0), "is outside the wall 'east'")]
)
def test_a_ball_added_where_it_does_not_fit_is_refused_in_a_world_that_has_run(engine, at, why):
    world = played(engine)
    world.add(Ball("late", at=at))
    with pytest.raises(ValueError, match=f"late.*{why}"):
        world.run()
    with pytest.raises(ValueError, match=f"late.*{why}"):
        simulate(world, "white", Shot(1.0))


@pytest.mark.parametrize("moving", [False, True])
def test_a_ball_may_be_added_where_it_fits_at_any_moment(moving):
    world = played(EventDriven())
    if moving:
        world.strike("white", Shot(1.0, angle=180.0))
        world.step(0.1)
    world.add(Ball("late", at=(0.0, 0.5)))
    world.run()
    assert world.ball("late").position == (0.0, 0.5)


@pytest.mark.parametrize("first", [29, 30, 31, 39])
def test_balls_added_after_a_shot_are_met_as_if_they_had_been_there_from_the_start(first):
    def row(world: World, balls: range) -> None:
        for k in balls:
            world.add(Ball(f"{k}", at=(0.2 * k, 0.0)))

    late, early = World(), World()
    row(late, range(first))
    simulate(late, "0", Shot(1.0))
    row(late, range(first, 40))
    row(early, range(40))
    ends = []
    for world in (late, early):
        after = simulate(world, "39", Shot(4.0, angle=180.0))
        ends.append([ball.position for ball in after.balls])
    assert ends[0] == ends[1]
    assert ends[0][38] != (0.2 * 38, 0.0)
