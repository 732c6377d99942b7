"""A light ball between a heavy one and a wall, and contacts that neither press nor close."""

import pytest

from physics import Ball, Cloth, Wall, World, laws


def squeezed(restitution):
    """A heavy ball comes along a wall's normal and squeezes a light one out along the wall."""
    world = World(
        Cloth(0.0, 0.0, 0.0), laws.SmoothBall(restitution), laws.RigidCushion(0.0, 0.0, 1.0)
    )
    world.add(Wall.line(1.0, 0.0, 0.0))
    world.add(Ball("light", at=(0.031, 0.0), radius=0.03, mass=0.02))
    world.add(Ball("heavy", at=(0.15, 0.004), velocity=(-8.0, 0.0), radius=0.03, mass=20.0))
    world.run(until=0.05)
    return world


@pytest.mark.parametrize("restitution", [0.5, 0.99, 1.0])
def test_what_is_squeezed_out_along_a_smooth_wall_keeps_momentum_along_it(restitution):
    world = squeezed(restitution)
    assert abs(sum(ball.mass * ball.velocity[1] for ball in world.balls)) < 1e-12
    assert len(world.log) < 300


def test_perfectly_elastic_balls_are_squeezed_out_like_nearly_elastic_ones():
    (there, _), (here, _) = (
        [ball.velocity[1] for ball in squeezed(e).balls] for e in (0.99, 1.0)
    )
    assert here == pytest.approx(there, rel=0.01)


def test_balls_that_touch_and_neither_press_nor_close_do_not_meet_for_ever():
    world = World(Cloth(), laws.ThesisBall(0.0))
    spots = [
        ((0.05138391566037187, 0.012556610464342588), (-0.01, 0.0), 0.03),
        ((0.08138391566037187, 0.06451813469140891), (-8.0, 0.0), 0.03),
        ((0.014641569518624165, -0.05108299984244667), (0.0, 0.0), 0.045),
    ]
    for name, (at, velocity, radius) in zip("abc", spots, strict=True):
        world.add(Ball(name, at=at, velocity=velocity, radius=radius, mass=0.2))
    world.run()
    assert len(world.log) < 100
