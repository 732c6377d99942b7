"""The stress families: each a function of a number and a generator, which gives one trial."""

from cmath import rect
from math import nextafter, pi, radians
from random import Random

from physics import Ball, Cloth, Shot, Wall, World, laws, scenes

from .any_tables import breaks, games, images, leaps, noses, rattles, shapes, tips
from .driven import agitated, drift, landing, pi_digits, rejected, stepped
from .symmetry import symmetry
from .tight import tight
from .trials import (
    BALL_LAWS,
    CUSHION_LAWS,
    RADIUS,
    Family,
    Trial,
    apart,
    box,
    engine,
    push,
    scatter,
    world_of,
)


def shots(k: int, dice: Random) -> Trial:
    """Random shots on 1-22 balls, often frozen to others or cushions; all laws, odd walls.

    Nine of ten have a coarse floor, as driven contacts would otherwise take most of the time.
    """
    world = world_of(dice)
    world.engine = engine(1e-3 if k % 10 == 0 else 1e-2)
    balls = k // 50 % 22 + 1 if k % 50 == 0 else min(int(dice.expovariate(0.5)) + 1, 22)
    scatter(world, balls, dice, alike=dice.random() < 0.5)
    for ball in world.balls[: dice.choice((1, 1, 1, 2, 22))]:
        push(ball, dice, dice.choice((0.1, 1.0, 5.0)))
    return Trial(world)


GAPS = (0.0, 1e-12, 1e-11, 1e-10, 1e-9, 5e-9, 1e-8, 2e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3)


def racks(k: int, dice: Random) -> Trial:
    """A triangle of fifteen at every gap, struck head-on or not, with every law."""
    world = scenes.rack15(GAPS[k % len(GAPS)], dice.choice((0.1, 1.0, 8.0, 30.0)))
    world.engine = engine()
    world.ball_law = BALL_LAWS[k // len(GAPS) % len(BALL_LAWS)]
    if k >= 2 * len(GAPS) * len(BALL_LAWS):
        world.strike("cue", Shot(8.0, dice.uniform(-5.0, 5.0), follow=dice.uniform(-8.0, 8.0)))
    return Trial(world)


QUARTERS = (0.0, 90.0, 180.0, 270.0)


def cradles(k: int, dice: Random) -> Trial:
    """Newton's cradle at every angle: exact quarters, beside them by a bit, every degree."""
    degrees = (*QUARTERS, *(nextafter(q, 400.0) for q in QUARTERS), *range(360))[k % 368]
    cloth = (None, Cloth(0.0, 0.0, 0.0))[k // 368 % 2]
    row = scenes.cradle(2 + k % 7, float(degrees))
    row.engine = engine(dice.choice((1e-3, 1e-4)) if cloth is None else dice.choice((0.0, 1e-3)))
    row.ball_law = dice.choice((laws.SmoothBall(1.0), laws.SmoothBall(), laws.RoughBall()))
    if cloth is None:
        return Trial(row)
    row.cloth = cloth
    return Trial(row, lambda world: world.run(1.0))


def touching(k: int, dice: Random) -> Trial:
    """Two to four balls in a heap that touches, each pushed into the others or away from them."""
    world = world_of(dice, walls=k % 2 == 0)
    first = world.add(Ball("0", at=(dice.uniform(-0.1, 0.1), dice.uniform(-0.1, 0.1))))
    start, turn = dice.uniform(-pi, pi), dice.choice((pi / 3, pi / 2, 2.5))
    for i in range(dice.randrange(1, 4)):
        p = complex(*first.position) + rect(2.0 * RADIUS, start + i * turn)
        world.add(Ball(f"{i + 1}", at=(p.real, p.imag)))
    for ball in world.balls:
        toward = complex(*ball.position) - complex(*first.position)
        v = dice.choice((0.0, 1.0, -1.0, 1e-9, -1e-9)) * (toward or rect(1.0, start)) / RADIUS
        ball.velocity = (v.real, v.imag)
        if dice.random() < 0.5:
            roll = dice.choice((-1.0, 1.0)) * (toward or rect(1.0, start)) / RADIUS
            ball.spin = (-roll.imag / RADIUS, roll.real / RADIUS, dice.uniform(-100.0, 100.0))
    return Trial(world)


def jumps(k: int, dice: Random) -> Trial:
    """Balls that jump, fall, and are hit in the air: under all laws, within walls at odd angles."""
    world = world_of(dice)
    scatter(world, k % 16 + 1, dice, freely=dice.random() < 0.5)
    for ball in world.balls:
        if dice.random() < 0.6:
            push(ball, dice, dice.choice((0.3, 3.0)))
        if dice.random() < 0.6:
            room = min(wall.distance(ball.position) - ball.radius for wall in world.walls)
            if room > 0.005:  # otherwise it may be lifted into a nose
                ball.height = dice.choice((0.0, dice.uniform(0.0, 0.1)))
            ball.climb = dice.gauss(0.0, 1.2)
    return Trial(world)


def frozen(k: int, dice: Random) -> Trial:
    """A ball that touches a cushion: driven into it, along it, with spin; some with a neighbour."""
    world = world_of(dice, walls=False)
    normal = rect(1.0, dice.choice((0.0, 0.5 * pi, dice.uniform(-pi, pi))))
    world.add(Wall.line(normal.real, normal.imag, dice.choice((0.0, 0.7)), "rail"))
    world.add(Wall.line(-normal.real, -normal.imag, 1.5, "far"))
    world.cushion_law = CUSHION_LAWS[k % len(CUSHION_LAWS)]
    p = (world.walls[0].offset + RADIUS) * normal + dice.uniform(-1.0, 1.0) * 1j * normal
    ball = world.add(Ball("0", at=(p.real, p.imag)))
    v = dice.choice((-1.0, 0.0, 1j, 1e-9 - 1j, -1e-9 + 1j, -1e-3)) * normal
    ball.velocity = (v.real, v.imag)
    roll = dice.choice((0.0, 1.0, 3.0, 1e-6)) * dice.choice((-1.0, 1j, -1.0 + 1j)) * normal
    ball.spin = (-roll.imag / RADIUS, roll.real / RADIUS, dice.choice((0.0, 50.0, -50.0)))
    if k % 2:
        q = p + 2.0 * RADIUS * normal * rect(1.0, dice.uniform(-1.5, 1.5))
        world.add(Ball("1", at=(q.real, q.imag), velocity=(-normal.real, -normal.imag)))
    return Trial(world)


def sandwich(k: int, dice: Random) -> Trial:
    """A ball between a ball and a cushion, touching both or nearly, pinched or struck."""
    world = world_of(dice, walls=False)
    for wall in box():
        world.add(wall)
    world.cushion_law = CUSHION_LAWS[k % len(CUSHION_LAWS)]
    world.ball_law = BALL_LAWS[k // 2 % len(BALL_LAWS)]
    gap = dice.choice((0.0, 0.0, 1e-12, 1e-9, 1e-6, 1e-3))
    x, y = 1.27 - RADIUS - gap, dice.choice((0.0, 0.3, 0.635 - RADIUS))
    world.add(Ball("0", at=(x, y)))
    slant = dice.choice((0.0, 0.0, dice.uniform(0.0, 1.2)))
    q = complex(x, y) - (2.0 * RADIUS + dice.choice((0.0, gap))) * rect(1.0, slant)
    pinch = world.add(Ball("1", at=(q.real, q.imag)))
    v = dice.choice((0.0, 1e-9, 1.0, 10.0))
    pinch.velocity = (v, dice.choice((0.0, v)))
    pinch.spin = (0.0, dice.choice((0.0, 100.0)), dice.choice((0.0, 100.0)))
    if dice.random() < 0.5:
        q -= 4.0 * RADIUS
        world.add(Ball("2", at=(q.real, q.imag), velocity=(3.0, 0.0)))
    return Trial(world)


def corners(k: int, dice: Random) -> Trial:
    """Into a corner at 45 degrees and beside it by 1e-2 ... 1e-15 rad; square, acute and blunt."""
    off = dice.choice((-1.0, 1.0)) * 10.0 ** -(k % 14 + 2) if k % 15 else 0.0
    opening = dice.choice((90.0, 90.0, 90.0, 60.0, 30.0, 10.0, 120.0, 175.0))
    world = world_of(dice, walls=False)
    world.cushion_law = CUSHION_LAWS[k // 15 % len(CUSHION_LAWS)]
    half = 0.5 * radians(opening)
    for side, name in ((-1.0, "right"), (1.0, "left")):
        n = rect(1.0, pi + side * (0.5 * pi - half))
        world.add(Wall.line(n.real, n.imag, 0.0, name))
    world.add(Wall.line(1.0, 0.0, 1.5 / half, "back"))
    x = -(RADIUS / abs(rect(1.0, half).imag)) - dice.choice((0.0, 0.1, 1.0)) / half
    ball = world.add(Ball("0", at=(x - 1e-15 / half, 0.0)))
    v = dice.choice((1e-6, 1.0, 10.0)) * rect(1.0, off)
    ball.velocity = (v.real, v.imag)
    ball.spin = (0.0, dice.choice((0.0, 1.0, 3.0)) * abs(v) / RADIUS, dice.choice((0.0, 30.0)))
    return Trial(world)


def speeds(k: int, dice: Random) -> Trial:
    """The same few balls at 1e-9 to 1e3 m/s; a ball at 1e3 m/s needs lossy cushions to end soon."""
    world = world_of(dice)
    world.cushion_law = dice.choice((laws.RigidCushion(), laws.RigidCushion(0.9, 0.1, 1.4)))
    scatter(world, dice.randrange(1, 8), dice, alike=k % 2 == 0)
    push(world.balls[0], dice, 10.0 ** (k % 13 - 9))
    spin = world.balls[0].spin
    world.balls[0].spin = (0.1 * spin[0], 0.1 * spin[1], spin[2])
    return Trial(world)


def grazing(k: int, dice: Random) -> Trial:
    """Past a ball by ± 1e-3 ... 1e-18 of the sum of radii, straight or on an arc, at any angle."""
    world = World(Cloth(), BALL_LAWS[k % len(BALL_LAWS)], engine=engine())
    turn = rect(1.0, dice.choice((0.0, 0.5 * pi, dice.uniform(-pi, pi))))
    off = 2.0 * RADIUS * (1.0 + dice.choice((-1.0, 1.0, 0.0)) * 10.0 ** -dice.randrange(3, 19))
    p, v = complex(-0.5, off) * turn, dice.choice((0.1, 1.0, 10.0)) * turn
    world.add(Ball("0", at=(p.real, p.imag), velocity=(v.real, v.imag)))
    roll = v * (1.0 if dice.random() < 0.5 else 1.0 + 1j * dice.uniform(-1.0, 1.0))
    world.balls[0].spin = (-roll.imag / RADIUS, roll.real / RADIUS, 0.0)
    world.add(Ball("1", at=(0.0, 0.0)))
    if k % 3 == 0:
        q = 1j * turn * 2.0 * off
        world.add(Ball("2", at=(q.real, q.imag)))
    return Trial(world)


def convoys(k: int, dice: Random) -> Trial:
    """Balls in line with equal velocities, touching or not: they stay together or apart."""
    world = world_of(dice)
    turn = rect(1.0, dice.choice((0.0, dice.uniform(-pi, pi))))
    v = dice.choice((1e-3, 1.0, 5.0)) * turn * rect(1.0, dice.choice((0.0, 0.0, 1.0)))
    gap = dice.choice((0.0, 1e-12, 1e-6, 1e-2))
    for i in range(dice.randrange(2, 6)):
        p = (i - 2) * (2.0 * RADIUS + gap) * turn
        ball = world.add(Ball(f"{i}", at=(p.real, p.imag), velocity=(v.real, v.imag)))
        roll = v * dice.choice((1.0, 1.0, 0.0)) if k % 2 else v
        ball.spin = (-roll.imag / RADIUS, roll.real / RADIUS, 0.0)
    return Trial(world)


def heaps(k: int, dice: Random) -> Trial:
    """Touching balls or discs, of many sizes and masses, in a random cluster that another hits."""
    law, vmin = BALL_LAWS[k % len(BALL_LAWS)], dice.choice((1e-3, 1e-4))
    world = World(Cloth(), law, engine=engine(vmin), discs=k // len(BALL_LAWS) % 2 == 1)
    scatter_heap(world, dice)
    p = rect(0.8, dice.uniform(-pi, pi))
    v = -dice.choice((0.5, 5.0, 50.0)) * p
    world.add(
        Ball("cue", at=(p.real, p.imag), velocity=(v.real, v.imag), mass=dice.choice((0.25, 10.0)))
    )
    return Trial(world)


def scatter_heap(world: World, dice: Random) -> None:
    """Up to a dozen balls, each touching one or two of those before."""
    world.add(Ball("0", at=(0.0, 0.0)))
    for k in range(1, dice.randrange(3, 13)):
        radius = dice.choice((RADIUS, dice.uniform(0.02, 0.05)))
        for _ in range(30):
            other = dice.choice(world.balls)
            ball = Ball(f"{k}", (0.0, 0.0), radius=radius)
            p = complex(*other.position) + rect(apart(world, other, ball), dice.uniform(-pi, pi))
            near = min(abs(p - complex(*b.position)) - apart(world, b, ball) for b in world.balls)
            if near > -1e-15:
                world.add(
                    Ball(f"{k}", (p.real, p.imag), radius=radius, mass=dice.uniform(0.05, 1.0))
                )
                break


def springs(k: int, dice: Random) -> Trial:
    """Touching or nearly touching scenes of other families, by the law of Hertz."""
    trial = (heaps, touching, sandwich, racks, cradles)[k % 5](k // 5, dice)
    e = dice.choice((None, 1.0, 0.9, dice.uniform(0.01, 1.0)))
    trial.world.cluster_law = laws.HertzCluster(e, dice.choice((0.0, 1e-8, 1e-6, 1e-4)))
    return trial


# name: (family, trials in the long run, trials in the short run)
FAMILIES: dict[str, tuple[Family, int, int]] = {
    "shots": (shots, 100_000, 300),
    "racks": (racks, 400, 13),
    "cradles": (cradles, 736, 40),
    "touching": (touching, 2000, 60),
    "frozen": (frozen, 3000, 100),
    "sandwich": (sandwich, 1500, 60),
    "tight": (tight, 5000, 60),
    "corners": (corners, 3000, 90),
    "speeds": (speeds, 2600, 39),
    "grazing": (grazing, 5000, 150),
    "convoys": (convoys, 600, 30),
    "heaps": (heaps, 2000, 40),
    "springs": (springs, 2000, 40),
    "jumps": (jumps, 5000, 48),
    "rejected": (rejected, 1000, 70),
    "stepped": (stepped, 240, 12),
    "landing": (landing, 500, 20),
    "agitated": (agitated, 1000, 30),
    "symmetry": (symmetry, 2000, 50),
    "pool games": (games, 5000, 30),
    "pool jumps": (leaps, 5000, 40),
    "pool breaks": (breaks, 600, 6),
    "rattles": (rattles, 5000, 60),
    "noses": (noses, 5000, 60),
    "tips": (tips, 5000, 70),
    "shapes": (shapes, 5000, 40),
    "images": (images, 5000, 50),
    "drift": (drift, 2, 0),
    "pi": (pi_digits, 4, 3),
}
