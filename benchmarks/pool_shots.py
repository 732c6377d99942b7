"""A nine-foot pool table, and balls to break or to play."""

from random import Random

from physics import Ball, Shot, World, laws, tables
from physics.tables.pocket_tables import CORNER as CORNERS
from physics.tables.pocket_tables import SIDE as SIDES

TABLE = tables.pool(9)
X, Y, RADIUS = 0.5 * TABLE.length, 0.5 * TABLE.width, TABLE.radius
CORNER, SIDE = CORNERS.width, SIDES.width  # between the points where rails turn into facings
SHOT = Shot(2.5, 27.0, follow=0.5, side=0.5)
BREAK = Shot(9.0, 0.3)


def table(cushion: laws.CushionLaw | None = None) -> World:
    """An empty table."""
    world = TABLE.world()
    world.cushion_law = cushion or world.cushion_law
    return world


def put(world: World, name: str, x: float, y: float) -> None:
    world.add(Ball(name, (x, y)))


def rack(gap: float = 1e-5) -> World:
    """Ten balls before the break of 9-ball."""
    world = table()
    put(world, "cue", -0.5 * X, 0.012)
    for ball in TABLE.rack("9-ball", gap=gap):
        world.add(ball)
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
