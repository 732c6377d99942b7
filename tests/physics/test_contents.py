"""A world made at once, what is taken out of it again, and the energy of what is in it."""

import pytest

from physics import (
    Ball,
    Cloth,
    Post,
    Shot,
    TimeStepping,
    Wall,
    World,
    ledger,
    scenes,
    simulate,
    tables,
)


def carom(*names):
    world = scenes.carom()
    for name in names:
        world.remove(name)
    return world


def test_a_world_is_made_with_its_walls_and_balls_at_once():
    wall = Wall.line(1.0, 0.0, 0.5, "west")
    world = World(Cloth(), balls=[Ball("white", (0.0, 0.0)), Ball("red", (0.3, 0.0))], walls=[wall])
    assert [ball.name for ball in world.balls] == ["white", "red"]
    assert world.walls == (wall,)
    with pytest.raises(ValueError, match="there is a ball 'white' already"):
        World(balls=[Ball("white", (0.0, 0.0)), Ball("white", (1.0, 0.0))])


@pytest.mark.parametrize("engine", [None, TimeStepping(1 / 180)])
def test_a_world_without_a_ball_goes_on_as_one_that_never_had_it(engine):
    table, shot = tables.MEDIUM_CAROM, Shot(3.0, 1.0, follow=1.5, side=0.5)
    never = table.world()
    for ball in scenes.carom().balls:
        if ball.name != "red":
            never.add(Ball(ball.name, ball.position))
    removed = carom("red")
    for world in (never, removed):
        if engine is not None:
            world.engine = engine
    after, expected = simulate(removed, "white", shot), simulate(never, "white", shot)
    assert [ball.position for ball in after.balls] == [ball.position for ball in expected.balls]
    assert [*map(tuple, after.log)] == [*map(tuple, expected.log)]


def test_the_others_roll_on_when_a_ball_is_taken_off_and_the_log_begins_again():
    world = scenes.carom()
    world.strike("white", Shot(1.0, 90.0))
    world.step(0.1)
    moving = world.ball("white").velocity
    taken = world.remove("yellow")
    assert len(world.log) == 0
    assert (world.log.names, world.time) == (["white", "red", "red 2"], 0.1)
    assert world.ball("white").velocity == moving
    world.run()
    assert world.log.first("cushion", "white", "north")
    assert taken.position == (0.6, 0.01)


def test_a_ball_that_was_taken_out_moves_on_in_another_world():
    world = scenes.carom()
    world.strike("white", Shot(1.0, 90.0, side=0.5))
    world.step(0.1)
    white = world.ball("white")
    was = white.position, white.velocity, white.spin
    assert world.remove(white) is white
    assert (white.position, white.velocity, white.spin) == was
    other = tables.medium_carom()
    other.add(white)
    other.run()
    assert other.log.first("cushion", "white", "north")
    world.add(Ball("white", (0.0, 0.0)))
    world.run()


def test_balls_among_cells_can_be_taken_out():
    world = scenes.rack15()
    for k in range(20):
        world.add(Ball(f"more {k}", (-1.1 + 0.07 * k, 0.5)))
    world.step(0.1)  # 36 balls: in cells
    for k in range(20):
        world.remove(f"more {k}")
    world.run()
    assert world.at_rest
    assert len(world.balls) == 16


def test_a_wall_that_is_taken_out_stops_nothing_any_more():
    world = tables.medium_carom()
    post = world.add(Post((0.5, 0.0), 0.05, name="post"))
    white = world.add(Ball("white", (0.0, 0.0)))
    assert simulate(world, white, Shot(2.0)).log.first("cushion").wall == "post"
    assert world.remove(post) is post
    assert simulate(world, white, Shot(2.0)).log.first("cushion").wall == "east"
    with pytest.raises(ValueError, match="there is no post Post"):
        world.remove(post)


def test_what_is_not_in_the_world_cannot_be_taken_out():
    world = scenes.carom()
    with pytest.raises(ValueError, match="there is no ball 'blue' in this world"):
        world.remove("blue")
    with pytest.raises(ValueError, match="is not in this world, but another ball of its name is"):
        world.remove(Ball("red", (0.0, 0.0)))
    assert len(world.balls) == 4


def test_a_law_cannot_take_a_ball_out():
    world = scenes.carom()
    world.cushion_law = lambda v, roll, side: world.remove("red")
    world.strike("white", Shot(3.0, 90.0))
    with pytest.raises(RuntimeError, match=r"used World\.remove"):
        world.run()
    assert len(world.balls) == 4


@pytest.mark.parametrize("shot", [Shot(3.0, 1.0, 1.5, 0.3, 0.5), Shot(2.0, 30.0, climb=1.0)])
def test_the_energy_of_a_world_is_what_the_ledger_has_left(shot):
    world = scenes.carom()
    assert world.energy == 0.0
    world.strike("white", shot)
    started = world.energy
    white = world.ball("white")
    roll = shot.follow**2 + shot.masse**2 + shot.side**2
    speed = shot.speed**2 + shot.climb**2
    assert started == pytest.approx(0.5 * white.mass * speed + 0.2 * white.mass * roll, rel=1e-14)
    whole = simulate(scenes.carom(), "white", shot)
    left = {entry.time: entry.energy for entry in ledger(whole.log)}  # the last of each
    for time in [*left][:9]:
        world.run(until=time)
        assert world.energy == pytest.approx(left[time], rel=1e-12)


def test_a_ball_in_the_air_has_stored_energy_and_one_that_is_gone_has_none():
    world = tables.pool_9ft()
    ball = world.add(Ball("1", (0.3, 0.0)))
    ball.height = 0.2
    assert world.energy == pytest.approx(ball.mass * world.cloth.gravity * 0.2)
    world.run()
    ball.position, ball.velocity = (-1.0, -0.365), (-1.0, -1.0)  # towards a corner
    world.run()
    assert ball.gone
    assert world.energy == 0.0
