"""Tables of any shape, made of segments, with balls as of pool."""

from physics import Ball, Cloth, Pocket, Wall, World, laws

R = 0.028575
ICE = Cloth(0.0, 0.0, 0.0)
MIRROR = laws.RigidCushion(1.0, 0.0, 1.0)
CORNERS = (-1.0 - 0.5j, 1.0 - 0.5j, 1.0 + 0.5j, -1.0 + 0.5j)


def xy(p: complex) -> tuple[float, float]:
    return p.real, p.imag


def polygon(world: World, corners, names="abcdefgh") -> World:
    """Segments around, anticlockwise."""
    for k, p in enumerate(corners):
        world.add(Wall.segment(xy(p), xy(corners[(k + 1) % len(corners)]), names[k]))
    return world


def box(cloth: Cloth | None = None, law="rigid") -> World:
    """A table of four segments."""
    return polygon(World(cloth, "rough", law), CORNERS, ("south", "east", "north", "west"))


def pool() -> World:
    """A box with holes in its corners and balls about them."""
    world = box()
    for k, p in enumerate(CORNERS):
        world.add(Pocket(xy(0.98 * p), 0.07, f"hole {k}"))
    for k in range(5):
        world.add(Ball(f"{k}", (0.3 * k - 0.5, 0.1 * k - 0.2), radius=R, mass=0.17))
    return world
