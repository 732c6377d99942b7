"""Families on tables of any shape: pockets, jaws, tips, posts, arcs, corners that point inward."""

from cmath import rect
from collections.abc import Callable
from math import cos, pi, sin
from random import Random

from physics import Ball, Cloth, Pocket, Post, Shot, Wall, World, heading, laws
from physics.kernel.kinds import AIRBORNE
from physics.tables.pocket_tables import PYRAMID_12FT, SNOOKER_12FT, pool
from physics.wall import Obstacle

from .symmetry import ORDER, TURN, alike
from .trials import BALL_LAWS, CUSHION_LAWS, RADIUS, Finding, Trial, engine, gap, push

TABLES = (pool(9), pool(8), pool(7), SNOOKER_12FT, PYRAMID_12FT)
MIRROR = laws.RigidCushion(1.0, 0.0, 1.0)
LONG = 5.0  # s, where nothing comes to rest


def table(dice: Random, kind: int | None = None) -> World:
    """One of the tables with pockets, half of the time with other laws."""
    world = TABLES[dice.randrange(5) if kind is None else kind % 5].world()
    world.engine = engine()
    if dice.random() < 0.5:
        world.ball_law, world.cushion_law = dice.choice(BALL_LAWS), dice.choice(CUSHION_LAWS)
    return world


def inside(world: World, corners: tuple[complex, ...]) -> None:
    """Finding unless every ball on the cloth was in the polygon whenever something happened."""
    for ball in world.balls:
        for leg in world.log.legs(ball.name):
            if leg.phase < AIRBORNE and not within(corners, leg.position):
                raise Finding(f"ball {ball.name} has got out, to {leg.position}, at {leg.time!r}")


def within(corners: tuple[complex, ...], p: complex) -> bool:
    """Is the point in the polygon?"""
    odd, last = False, corners[-1]
    for corner in corners:
        if (corner.imag > p.imag) != (last.imag > p.imag):
            share = (p.imag - corner.imag) / (last.imag - corner.imag)
            odd ^= p.real < corner.real + share * (last.real - corner.real)
        last = corner
    return odd


def kept(corners: tuple[complex, ...]) -> Callable[[World], None]:
    """Runs to rest, or for a while where nothing rubs; nothing may have got out of the polygon."""

    def drive(world: World) -> None:
        world.run() if world.cloth.roll else world.run(LONG)
        inside(world, corners)

    return drive


def on(world: World) -> Trial:
    """A trial on a world that knows its table."""
    assert world.table is not None
    return Trial(world, kept(world.table.outline))


def games(k: int, dice: Random) -> Trial:
    """Balls anywhere on a table with pockets, frozen to rails, noses, facings, in jaws; a shot, or
    several, hard or soft."""
    world = table(dice, k)
    place(world, min(int(dice.expovariate(0.2)) + 1, 16), dice)
    for ball in world.balls[: dice.choice((1, 1, 1, 2, 16))]:
        push(ball, dice, dice.choice((0.3, 2.0, 8.0)))
    return on(world)


def leaps(k: int, dice: Random) -> Trial:
    """Jumps on tables with pockets, at rails, noses, facings and over holes, from near by too."""
    world = table(dice, k)
    place(world, dice.randrange(1, 6), dice)
    for ball in world.balls[: dice.choice((1, 1, 5))]:
        jump(world, ball, dice)
    return on(world)


def jump(world: World, ball: Ball, dice: Random) -> None:
    """Strike it, so that it flies unless it would be lifted into a nose."""
    clear = min(wall.distance(ball.position) for wall in world.walls) - ball.radius
    climb = dice.uniform(0.2, 2.0) if clear > 0.005 else 0.0
    world.strike(ball, Shot(dice.uniform(0.5, 6.0), dice.uniform(0.0, 360.0), climb=climb))


def place(world: World, balls: int, dice: Random, freely: bool = False) -> None:
    """Balls of the table anywhere there is room; half of them against something, unless freely."""
    assert world.table is not None
    x, y = 0.5 * world.table.length, 0.5 * world.table.width
    for k in range(balls):
        for _ in range(30):
            ball = Ball(f"{k}", (dice.uniform(-x, x), dice.uniform(-y, y)),
                        radius=world.table.radius, mass=world.table.mass)  # fmt: skip
            if not freely and dice.random() < 0.5:
                against(ball, dice.choice(world.walls), dice)
            if gap(ball, world) > -1e-15 and within(world.table.outline, complex(*ball.position)):
                world.add(ball)
                break


def against(ball: Ball, wall: Obstacle, dice: Random) -> None:
    """Put it so that it touches a wall, or the end of it, to rounding."""
    if not wall.pushes:
        return
    shape, r = wall.shape, ball.radius
    if wall.kind == "segment" and dice.random() < 0.6:
        p = shape.first + dice.random() * (shape.last - shape.first) + r * shape.normal
    elif wall.kind == "post":
        p = shape.centre + rect(shape.size + r, dice.uniform(-pi, pi))
    else:
        p = dice.choice((shape.first, shape.last)) + rect(r, dice.uniform(-pi, pi))
    ball.position = (p.real, p.imag)


def breaks(k: int, dice: Random) -> Trial:
    """Every rack on its table, tight or loose, struck from behind the line."""
    world = table(dice, (0, 0, 1, 2, 3, 4)[k % 6])
    stands = world.table
    assert stands is not None
    kind = stands.racks[k // 6 % len(stands.racks)]
    for ball in stands.rack(kind, dice.choice((0.0, 0.0, 1e-9, 1e-5, 1e-4)),
                            dice.choice((0.0, 1e-5)), k):  # fmt: skip
        world.add(ball)
    assert stands.head_string is not None
    at = stands.head_string - 0.1, 0.37 * dice.random() * stands.width
    cue = world.add(Ball("cue", at=at))
    apex = min(world.balls[:-1], key=lambda ball: ball.position[0])
    if stands.kind == "snooker":
        apex = world.ball("red1")
    aim = complex(*apex.position) - complex(*cue.position)
    way = heading(aim) + dice.uniform(-1.0, 1.0)
    world.strike(cue, Shot(dice.uniform(1.0, 12.0), way, *(dice.uniform(-6.0, 6.0) for _ in "123"),
                           climb=dice.choice((0.0, 0.0, 0.3))))  # fmt: skip
    return on(world)


def rattles(k: int, dice: Random) -> Trial:
    """Into the jaws of every pocket at every offset and angle, softly and hard, with spin, between
    cushions that are mirrors, or dead, or rub."""
    world = table(dice, k)
    stands = world.table
    assert stands is not None
    world.cushion_law = CUSHION_LAWS[k % len(CUSHION_LAWS)] if k % 3 else MIRROR
    hole = dice.choice([wall.shape for wall in world.walls if not wall.pushes])
    axis = complex(hole.centre.real or 0.0, hole.centre.imag)
    axis = complex(axis.real / abs(axis.real) if axis.real else 0.0, axis.imag / abs(axis.imag))
    axis /= abs(axis)
    way = axis * rect(1.0, dice.uniform(-1.2, 1.2))
    p = hole.centre + dice.uniform(-1.5, 1.5) * hole.size * 1j * way - dice.uniform(0.2, 0.4) * way
    if not within(stands.outline, p):
        p = hole.centre - 0.3 * axis
    ball = world.add(Ball("0", at=(p.real, p.imag)))
    if gap(ball, world) < 0.0:
        ball.position = (0.0, 0.0)
    v = dice.choice((0.1, 1.0, 9.0)) * way
    ball.velocity, roll = (v.real, v.imag), dice.choice((0.0, 1.0, -2.0)) * v
    r = ball.radius
    ball.spin = (-roll.imag / r, roll.real / r, dice.choice((0.0, 100.0, -100.0)))
    return on(world)


def noses(k: int, dice: Random) -> Trial:
    """Balls frozen on noses, facings and in jaws, pushed into them, along them, by bits or hard;
    some with a neighbour that touches or strikes them."""
    world = table(dice, k)
    stands = world.table
    assert stands is not None
    solid = [wall for wall in world.walls if wall.pushes and "pocket" in (wall.name or "")]
    for _ in range(100):
        ball = Ball("0", (0.0, 0.0), radius=stands.radius, mass=stands.mass)
        against(ball, dice.choice(solid), dice)
        if gap(ball, world) > -1e-15 and within(stands.outline, complex(*ball.position)):
            break
    else:
        ball.position = (0.0, 0.0)
    world.add(ball)
    away = min((w for w in solid), key=lambda w: w.distance(ball.position)).facing(ball.position)
    v = dice.choice((0.0, 1e-9, 1e-3, 1.0, 6.0)) * dice.choice((-1, 1j, -1 + 1e-9j, 1e-12 - 1j))
    v *= away
    ball.velocity, roll = (v.real, v.imag), dice.choice((0.0, 2.0)) * rect(1.0, 6.3 * dice.random())
    ball.spin = (-roll.imag / ball.radius, roll.real / ball.radius, dice.choice((0.0, 80.0)))
    p = complex(*ball.position) + rect(2.0 * ball.radius, dice.uniform(-pi, pi))
    other = Ball("1", (p.real, p.imag), radius=stands.radius, mass=stands.mass)
    if k % 2 and gap(other, world) > -1e-15 and within(stands.outline, p):
        world.add(other)
        push(other, dice, dice.choice((0.0, 3.0)))
    return on(world)


BESIDE = (0.0, 1e-17, 1e-16, 1e-15, 1e-12, 1e-9, 1e-3)


def tips(k: int, dice: Random) -> Trial:
    """Rolled along, at and past the ends of walls, or dropped there, beside them by bits."""
    bend = dice.choice((0.0, 1e-9, 0.3, 0.5 * pi, 0.61 * pi, -0.3, -1.0, pi - 0.1))
    turn = rect(1.0, dice.choice((0.0, dice.uniform(-pi, pi))))
    world = World(dice.choice((Cloth(), Cloth(0.0, 0.0, 0.0))), "rough", engine=engine())
    world.cushion_law = CUSHION_LAWS[k % len(CUSHION_LAWS)]
    for p, q in ((-1.0 + 0j, 0j), (0j, rect(1.0, -bend))):
        p, q = p * turn, q * turn
        world.add(Wall.segment((q.real, q.imag), (p.real, p.imag)))
    off = dice.choice((-1.0, 1.0)) * BESIDE[k % len(BESIDE)]
    side = 1.0 if dice.random() < 0.7 else dice.choice((0.0, 0.5, -1.0))
    p, v = complex(-0.3, side * RADIUS + off) * turn, turn
    if k % 3 == 0:
        p, v = complex(off, 0.4) * turn, -1j * turn
    elif side not in (1.0, -1.0):
        p, v = complex(0.8, side * RADIUS + off) * turn, -turn
    ball = world.add(Ball("0", (p.real, p.imag)))
    if gap(ball, world) < -1e-15:  # where the second wall bends towards it
        p -= turn * (0.1 - 0.5j)
        ball.position = (p.real, p.imag)
    v *= dice.choice((1e-3, 0.5, 5.0))
    ball.velocity = (v.real, v.imag)
    ball.spin = (dice.choice((0.0, 60.0)), dice.choice((0.0, -60.0)), dice.choice((0.0, 50.0)))
    if k % 5 == 0:
        ball.height, ball.climb = 0.3, 0.0
    return Trial(world, lambda world: world.run(LONG))


def shapes(k: int, dice: Random) -> Trial:
    """An L, a stadium, a star or a ring, with posts, arcs and a hole in it, and balls of all
    sizes."""
    corners, world = MAKERS[k % len(MAKERS)](dice)
    world.engine = engine(1e-2 if k % 2 else 1e-3)
    world.ball_law, world.cushion_law = dice.choice(BALL_LAWS), dice.choice(CUSHION_LAWS)
    for n in range(dice.randrange(4)):
        p = rect(dice.uniform(0.0, 0.5), dice.uniform(-pi, pi))
        kind = dice.choice(("post", "point", "arc", "hole"))
        thing: Obstacle = Post((p.real, p.imag), dice.uniform(0.01, 0.06), f"post {n}")
        if kind == "point":
            thing = Post((p.real, p.imag), 0.0, f"point {n}")
        elif kind == "arc":
            start = 0.25 * dice.randrange(1440)  # so that half a turn more is exact
            end = start + 0.25 * dice.randrange(40, 1400)
            size = dice.choice((0.01, 0.05, 0.3))
            thing = Wall.arc((p.real, p.imag), size, start, end, f"arc {n}")
        elif kind == "hole" and n == 0:
            thing = Pocket((p.real, p.imag), 0.05, "hole")
        world.add(thing)
    scatter_inside(world, corners, dice)
    for ball in world.balls[: dice.choice((1, 2, 9))]:
        push(ball, dice, dice.choice((0.3, 3.0)))
    return Trial(world, kept(corners))


def scatter_inside(world: World, corners: tuple[complex, ...], dice: Random) -> None:
    for k in range(dice.randrange(1, 9)):
        radius, mass = dice.choice(((RADIUS, 0.25), (0.02, 0.05), (0.01, 0.25)))
        for _ in range(30):
            ball = Ball(f"{k}", (dice.uniform(-1.3, 1.3), dice.uniform(-1.3, 1.3)), radius=radius,
                        mass=mass)  # fmt: skip
            if dice.random() < 0.4:
                against(ball, dice.choice(world.walls), dice)
            if gap(ball, world) > -1e-15 and within(corners, complex(*ball.position)):
                world.add(ball)
                break


def closed(corners: tuple[complex, ...]) -> World:
    world = World()
    for k, p in enumerate(corners):
        q = corners[(k + 1) % len(corners)]
        world.add(Wall.segment((p.real, p.imag), (q.real, q.imag), f"side {k}"))
    return world


def ell(dice: Random) -> tuple[tuple[complex, ...], World]:
    corners = (-1 - 1j, 1 - 1j, 1 + 0j, 0j, 0 + 1j, -1 + 1j)
    return corners, closed(corners)


def star(dice: Random) -> tuple[tuple[complex, ...], World]:
    n = dice.randrange(5, 9)
    corners = tuple(
        dice.uniform(0.6, 1.3) * complex(cos(2.0 * pi * k / n), sin(2.0 * pi * k / n))
        for k in range(n)
    )
    return corners, closed(corners)


def stadium(dice: Random) -> tuple[tuple[complex, ...], World]:
    """Round ends; the polygon is a little larger than they are."""
    world = World()
    world.add(Wall.segment((-0.5, -0.5), (0.5, -0.5), "south"))
    world.add(Wall.arc((0.5, 0.0), 0.5, -90.0, 90.0, "east"))
    world.add(Wall.segment((0.5, 0.5), (-0.5, 0.5), "north"))
    world.add(Wall.arc((-0.5, 0.0), 0.5, 90.0, 270.0, "west"))
    ends = [rect(0.5, pi * (t - 16.0) / 32.0) for t in range(33)]
    return tuple([p + 0.5 for p in ends] + [-p - 0.5 for p in ends]), world


def ring(dice: Random) -> tuple[tuple[complex, ...], World]:
    world = World()
    world.add(Wall.arc((0.0, 0.0), 1.0, 0.0, 360.0, "ring"))
    return tuple(rect(1.0, 0.02 * pi * t) for t in range(100)), world


MAKERS = (ell, stadium, star, ring)


def images(k: int, dice: Random) -> Trial:
    """A table of any shape and its image: mirrored, turned, in another order, at another time."""
    kind = k % 5
    world = table(dice, k) if k // 5 % 2 else shapes(k // 5, dice).world
    freely = kind in (ORDER, TURN)
    if world.table is not None:
        place(world, dice.randrange(1, 9), dice, freely)
    elif freely:  # as many balls as there are, but apart
        world = MAKERS[k % len(MAKERS)](dice)[1]
        world.add(Ball("0", (-0.3, -0.2), radius=0.02))
        world.add(Ball("1", (0.2, -0.25), radius=0.02))
    for ball in world.balls[:2]:
        push(ball, dice, 3.0)
    return alike(world, kind, dice)
