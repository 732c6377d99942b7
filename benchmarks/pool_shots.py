"""A nine-foot pool table: segments with facings, six holes, and balls to break or to play."""

from math import sqrt
from random import Random

from physics import Ball, Pocket, Shot, Wall, World, direction, laws, tables

INCH = 0.0254
X, Y = 50.0 * INCH, 25.0 * INCH
RADIUS, MASS = 1.125 * INCH, 0.17
CORNER, SIDE = 4.5625 * INCH, 5.0625 * INCH  # between the points where rails turn into facings
FACING = 0.11  # m long
SHOT = Shot(2.5, 27.0, follow=0.5, side=0.5)
BREAK = Shot(9.0, 0.3)


def table(cushion: laws.CushionLaw | None = None) -> World:
    """An empty table: middle of the tolerances, points as noses."""
    world = World(
        tables.MEASURED, laws.RoughBall(), cushion or laws.RigidCushion(0.85, 0.2, nose=1.27)
    )
    corner, side = CORNER / sqrt(2.0), 0.5 * SIDE
    for s in (1, -1):  # and its image, turned by half a turn
        for p, q, first, last in (
            (complex(corner - X, -Y), complex(-side, -Y), 38.0, 76.0),
            (complex(side, -Y), complex(X - corner, -Y), 76.0, 38.0),
            (complex(X, corner - Y), complex(X, Y - corner), 38.0, 38.0),
        ):
            along = s * (q - p) / abs(q - p)
            segment(world, s * p - FACING * along * direction(first), s * p)
            segment(world, s * p, s * q)
            segment(world, s * q, s * q + FACING * along * direction(-last))
        for k, x in enumerate((X - 0.5 * corner, 0.5 * corner - X)):
            out = complex(1 - 2 * k, 1) / sqrt(2.0)
            hole(world, s * (complex(x, Y - 0.5 * corner) + 4.25 * INCH * out), 2.75 * INCH)
        hole(world, s * complex(0.0, Y + 3.1875 * INCH), 3.0 * INCH)
    return world


def segment(world: World, p: complex, q: complex) -> None:
    world.add(Wall.segment((p.real, p.imag), (q.real, q.imag), f"wall {len(world.walls)}"))


def hole(world: World, at: complex, radius: float) -> None:
    world.add(Pocket((at.real, at.imag), radius, f"hole {len(world.walls)}"))


def put(world: World, name: str, x: float, y: float) -> None:
    world.add(Ball(name, (x, y), radius=RADIUS, mass=MASS))


def rack(gap: float = 1e-5) -> World:
    """Sixteen balls before the break."""
    world = table()
    put(world, "cue", -0.5 * X, 0.012)
    pitch = 2.0 * RADIUS + gap
    for row in range(5):
        for k in range(row + 1):
            put(world, f"{row} {k}", 0.5 * X + row * pitch * 0.75**0.5, pitch * (k - 0.5 * row))
    return world


def midgame(balls: int = 6, seed: int = 1, cushion: laws.CushionLaw | None = None) -> World:
    """Balls anywhere, the cue ball among them."""
    dice, world = Random(seed), table(cushion)
    spots: list[complex] = []
    while len(spots) < balls:
        p = complex(dice.uniform(-1, 1) * (X - RADIUS), dice.uniform(-1, 1) * (Y - RADIUS))
        if all(abs(p - q) > 2.0 * RADIUS for q in spots):
            put(world, "cue" if not spots else f"{len(spots)}", p.real, p.imag)
            spots.append(p)
    return world


def pool_shot() -> World:
    """A shot in mid-game."""
    world = midgame()
    world.strike("cue", SHOT)
    return world


def pool_break() -> World:
    """A break with pockets."""
    world = rack()
    world.strike("cue", BREAK)
    return world
