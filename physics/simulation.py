"""A shot played on a copy of the world, until all rest."""

from .ball import Ball
from .shot import Shot
from .world import World


def simulate(world: World, ball: Ball | str, shot: Shot) -> World:
    """A copy of the world, after the shot, all at rest; its log holds the shot.

    ball is one of the world's, or its name. The world itself stays as it is.
    """
    world.plan()
    after = world.fork(world.log.fresh())
    after.strike(ball, shot)
    after.run()
    return after
