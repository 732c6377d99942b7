"""A family in which a world and its image must do the same.

Mirrors, half turns, the order of the balls and the hour change signs and places only, not digits,
and so must agree bit for bit. A quarter turn moves every wall and every rounding, as any other turn
does: there the difference is multiplied at every ball hit, so it is compared before the second; and
nothing touches at first, as rounding would decide which of two contacts of one instant comes first.
In another order only balls may touch: a cushion and a ball touched at one instant are taken as the
balls are listed.
"""

from cmath import rect
from collections.abc import Callable
from math import pi
from random import Random

from physics import Ball, Wall, World, scenes

from .trials import Finding, Trial, push, scatter, world_of

ORDER, HOUR, TURN = 2, 3, 4
Image = Callable[[complex], complex]


def image(world: World, of: Image, hand: float, order: list[int]) -> World:
    """The world with every vector turned by `of`; hand is -1 for a mirror, which turns spins."""
    other = World(world.cloth, world.ball_law, world.cushion_law, world.engine, discs=world.discs)
    for wall in world.walls:
        normal = of(wall.normal)
        other.add(Wall(normal, wall.offset, wall.name))
    for ball in (world.balls[i] for i in order):
        p, v = of(complex(*ball.position)), of(complex(*ball.velocity))
        w = hand * of(complex(*ball.spin[:2]))
        spin = (w.real, w.imag, hand * ball.spin[2])
        other.add(Ball(ball.name, (p.real, p.imag), (v.real, v.imag), spin, ball.radius, ball.mass))
    return other


def _later(world: World) -> World:
    other = world.copy()
    states = [(b.velocity, b.spin) for b in other.balls]
    other.stop()
    other.run(world.time + 123.456)
    for ball, (velocity, spin) in zip(other.balls, states, strict=True):
        ball.velocity, ball.spin = velocity, spin
    return other


def symmetry(k: int, dice: Random) -> Trial:
    """Mirrored, turned, in another order, at another time; every sixth a rack that touches."""
    if k % 6 == 5:
        return Trial(scenes.rack15(0.0), lambda world: _reordered_rack(world, dice))
    kind = k % 6
    world = world_of(dice)
    scatter(world, dice.randrange(1, 9), dice, freely=kind in (ORDER, TURN))
    for ball in world.balls[:2]:
        push(ball, dice, 3.0)
    order = list(range(len(world.balls)))
    if kind == ORDER:
        dice.shuffle(order)
    turn = rect(1.0, dice.uniform(-pi, pi))
    images: tuple[tuple[Image, float], ...] = (
        (lambda z: z.conjugate(), -1.0), (lambda z: -z, 1.0),
        (lambda z: z, 1.0), (lambda z: z, 1.0), (lambda z: turn * z, 1.0),
    )  # fmt: skip
    of, hand = images[kind]

    def drive(world: World) -> None:
        other = _later(world) if kind == HOUR else image(world, of, hand, order)
        until = second_hit(world.copy()) if kind == TURN else None
        for each in (world, other):
            each.run() if until is None else each.run(until)
        compare(world, other, of, 1e-9 if kind == TURN else 0.0)

    return Trial(world, drive)


def _reordered_rack(world: World, dice: Random) -> None:
    """Order decides rounding in a cluster, so the digits are few once the balls have met again."""
    order = list(range(len(world.balls)))
    dice.shuffle(order)
    other = image(world, lambda z: z, 1.0, order)
    world.run(0.16)
    other.run(0.16)
    compare(world, other, lambda z: z, 1e-9)


def second_hit(world: World) -> float:
    """When two balls hit each other for the second time, or a second of time has passed."""
    world.run(1.0)
    hits = [event.time for event in world.log if event.kind == "ball"]
    return 0.5 * (hits[0] + hits[1]) if len(hits) > 1 else 1.0


def compare(world: World, other: World, of: Image, tolerance: float) -> None:
    for ball in world.balls:
        p, q = of(complex(*ball.position)), complex(*other.ball(ball.name).position)
        if abs(p - q) > tolerance:
            raise Finding(f"ball {ball.name} is {abs(p - q):.2e} m from its image")
