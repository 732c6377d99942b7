"""Tables and obstacles that cannot be are refused, by the name of what is wrong."""

from dataclasses import replace
from math import inf, nan
from types import SimpleNamespace

import pytest

from physics import Ball, Pocket, Post, Wall, World, tables
from physics.tables import PYRAMID_12FT, SNOOKER_12FT, pool

POOL = pool(9)
HUGE = replace(POOL.pockets.corner, hole=2.5)
LINES = [Wall.line(a, b, 1.0, name) for a, b, name in (
    (1, 0, "west"), (-1, 0, "east"), (0, 1, "south"), (0, -1, "north"))]  # fmt: skip
AT_ALL = {  # a table, what is wrong with it
    "a shelf that ends before the hole": (lambda: pool(9, shelf=90.0), "no ball .* shelf=90"),
    "a long shelf": (lambda: pool(8, shelf=0.3), "no ball of radius .* reaches .* shelf=0.3"),
    "a side shelf": (lambda: pool(7, side_shelf=0.5), "no ball of radius .* reaches .* shelf=0.5"),
    "a mouth as wide as a ball": (lambda: pool(9, corner_mouth=0.05715), "reaches .*0.05715"),
    "a side mouth": (lambda: pool(9, side_mouth=0.04), "reaches the hole of Mouth.width=0.04"),
    "facings that close": (lambda: pool(9, side_facing=44.0, side_shelf=0.05), "facing=44.0"),
    "balls too large": (lambda: replace(POOL, radius=0.06), "no ball of radius 0.06"),
    "a mouth that is no number": (lambda: pool(9, corner_mouth=nan), "Mouth.width must be finite"),
    "a shelf below zero": (lambda: pool(9, shelf=-1.0), "Mouth.shelf must not be negative"),
    "no such size": (lambda: pool(nan), "9, 8 or 7 ft, not nan"),
    "holes that overlap": (
        lambda: replace(POOL, pockets=replace(POOL.pockets, corner=HUGE)), "the holes of .* overlap"
    ),
    "a short table": (lambda: replace(POOL, length=0.9, width=0.5), "0.9 by 0.5 m: the rack has"),
    "short snooker": (lambda: replace(SNOOKER_12FT, length=2.4), "2.4 by 1.778 m: .*'black'"),
    "snooker of a metre": (
        lambda: replace(SNOOKER_12FT, length=1.0, pockets=None), "1.0 by .* would be off the table"
    ),
    "narrow snooker": (lambda: replace(SNOOKER_12FT, width=0.6), "'yellow' would be off the table"),
    "short pyramid": (lambda: replace(PYRAMID_12FT, length=0.9), "0.9 by 1.775 m: the rack has"),
}  # fmt: skip


@pytest.mark.parametrize("case", AT_ALL)
def test_a_table_that_cannot_be_played_on_is_refused_when_it_is_made(case):
    make, why = AT_ALL[case]
    with pytest.raises(ValueError, match=why):
        make()


def test_what_is_only_unusual_is_a_table():
    assert pool(9, shelf=0.2).world().balls == ()
    assert replace(SNOOKER_12FT, length=2.6).rack("snooker")
    assert replace(POOL, pockets=replace(POOL.pockets, corner=replace(HUGE, hole=0.5))).world()


THINGS = {  # added to a square of lines with a post, a pocket and a ball: what is wrong
    "a line in front of another": (lambda: Wall.line(-1, 0.1, 0.8, "in"), "behind 'in' .* 'east'"),
    "lines as an L": (lambda: Wall.line(-1, -1, -0.1, "in"), "behind 'in' .* use Wall.segment"),
    "a line behind another": (lambda: Wall.line(1, 0, 2, "far"), "no ball can meet 'far'"),
    "a line with nothing inside": (lambda: Wall.line(1, 0, -3, "out"), "no place is inside"),
    "a pocket in a pocket": (lambda: Pocket((0.5, 0.1), 0.1, "b"), "'b' and 'hole' overlap"),
    "a segment of no length": (lambda: Wall.segment((0.1, 0.2), (0.1, 0.2)), "needs two points"),
    "a segment of too little": (lambda: Wall.segment((0, 0), (1e-200, 0)), "needs two points"),
    "an arc of no angle": (lambda: Wall.arc((0, 0), 1, 30, 30), "0 to 360 degrees"),
    "an arc all around and on": (lambda: Wall.arc((0, 0), 1, 0, 361), "0 to 360 degrees"),
    "an arc without radius": (lambda: Wall.arc((0, 0), 0.0, 0, 90), "Arc.radius must be above"),
    "a pocket without radius": (lambda: Pocket((0, 0), 0.0), "Pocket.radius must be above zero"),
    "a post inside out": (lambda: Post((0, 0), -0.1), "Post.radius must not be negative"),
    "a name that is a number": (lambda: Wall.segment((0, 0), (1, 0), 5), "name of a wall .* not 5"),
    "a post with such a name": (lambda: Post((0, 0), 0.1, 5), "name of a post must be text"),
    "a pocket with such a name": (lambda: Pocket((0, 0), 0.1, b"a"), "name of a pocket must be"),
    "a law that there is not": (lambda: Post((0, 0), 0.1, law="soft"), "unknown cushion law"),
    "nothing at all": (lambda: None, "a world takes a Ball or a Wall, Post or Pocket, not None"),
}  # fmt: skip
BAD = (nan, inf, -inf, "1", None, 1j, [1.0])
POINTS = [(bad, 0.0) for bad in BAD] + [(0.0, bad) for bad in BAD] + [(0.0,), (0, 0, 0), 5.0, None]
MAKERS = {
    "Wall.segment p": lambda p: Wall.segment(p, (3.0, 3.0)),
    "Wall.segment q": lambda p: Wall.segment((3.0, 3.0), p),
    "Wall.arc centre": lambda p: Wall.arc(p, 1.0, 0.0, 90.0),
    "Post.at": lambda p: Post(p, 0.1),
    "Pocket.at": lambda p: Pocket(p, 0.1),
}
NUMBERS = {
    "Arc.radius": lambda x: Wall.arc((0, 0), x, 0.0, 90.0),
    "Arc.start": lambda x: Wall.arc((0, 0), 1.0, x, 90.0),
    "Arc.end": lambda x: Wall.arc((0, 0), 1.0, 0.0, x),
    "Post.radius": lambda x: Post((0, 0), x),
    "Pocket.radius": lambda x: Pocket((0, 0), x),
}


def furnished():
    world = World()
    for line in LINES:
        world.add(line)
    world.add(Post((-0.5, 0.0), 0.1, "post"))
    world.add(Pocket((0.5, 0.0), 0.1, "hole"))
    world.add(Ball("a", at=(0.0, 0.5), velocity=(1.0, 0.3)))
    return world


@pytest.mark.parametrize("case", THINGS)
def test_an_obstacle_that_cannot_stand_is_refused_and_the_world_is_as_it_was(case):
    make, why = THINGS[case]
    world, untouched = furnished(), furnished()
    with pytest.raises(ValueError, match=why):
        world.add(make())
    for each in (world, untouched):
        each.run()
    assert world.walls == untouched.walls
    assert list(world.log) == list(untouched.log)


@pytest.mark.parametrize("name", MAKERS)
def test_no_obstacle_stands_at_what_is_no_point(name):
    for bad in POINTS:
        with pytest.raises(ValueError, match=f"{name} must be"):
            MAKERS[name](bad)


@pytest.mark.parametrize("name", NUMBERS)
def test_no_obstacle_has_a_size_that_is_no_number(name):
    for bad in BAD:
        with pytest.raises(ValueError, match=f"{name} must be"):
            NUMBERS[name](bad)


@pytest.mark.parametrize(
    ("thing", "at", "where"),
    [
        (Post((0.0, 0.0), 0.1, "post"), (0.12, 0.0), "in the post 'post'"),
        (Pocket((0.0, 0.0), 0.1, "hole"), (0.09, 0.0), "in the pocket 'hole'"),
        (Wall.segment((-1, 0), (1, 0), "bar"), (0.0, -0.01), "in the wall 'bar'"),
        (Wall.arc((0, 0), 1, 0, 360, "ring"), (0.99, 0.0), "in the wall 'ring'"),
        (Wall.line(1, 0, 0, "west"), (0.01, 0.0), "outside the wall 'west'"),
    ],
)
@pytest.mark.parametrize("first", ["thing", "ball"])
def test_a_ball_in_an_obstacle_is_refused_whichever_was_there_first(thing, at, where, first):
    world, ball = World(), Ball("a", at=at)
    for each in (thing, ball) if first == "thing" else (ball, thing):
        world.add(each)
    with pytest.raises(ValueError, match=where):
        world.run()
    assert (world.time, ball.position) == (0.0, at)
    ball.position = (3.0, 3.0)
    world.run()


@pytest.mark.parametrize("size", [-1.0, 0.0, nan, inf])
@pytest.mark.parametrize("name", ["radius", "mass"])
def test_a_world_takes_no_table_whose_balls_have_no_size(name, size):
    table = SimpleNamespace(**{"radius": 0.03, "mass": 0.2, name: size})
    with pytest.raises(ValueError, match=f"the {name} of a table's balls must be .* not {size!r}"):
        World(table=table)
    assert World(table=tables.MATCH_CAROM).table is tables.MATCH_CAROM


def test_a_side_of_a_table_may_be_moved_in():
    world = furnished()
    world.add(Wall.line(-1, 0, 0.8, "nearer"))
    world.run()
    walls = {event.wall for event in world.log if event.kind == "cushion"}
    assert "nearer" in walls
    assert "east" not in walls
