"""A family in which a world and its image must do the same.

Mirrors, half turns, the order of the balls and the hour change signs and places only, not digits,
and so must agree bit for bit. A quarter turn moves every wall and every rounding, as any other turn
does: there the difference is multiplied at every hit of a ball or of what is round, so it is
compared before the second; and nothing touches at first, as rounding would decide which of two
contacts of one instant comes first. Steps that follow from the outcome, as in Mathavan's law, are
other ones then. In another order only balls may touch: a cushion and a ball touched at one instant
are taken as the balls are listed, so what comes after such an instant is not compared.
"""

from cmath import rect
from collections.abc import Callable
from itertools import pairwise
from math import degrees, inf, pi
from random import Random
from typing import NamedTuple

from physics import Ball, Pocket, Post, Wall, World, laws, scenes
from physics.wall import Obstacle

from .trials import Finding, Trial, push, scatter, world_of

ORDER, HOUR, TURN = 2, 3, 4
EXACT, INTEGRATED = 1e-9, 3e-5  # m: how far apart a world and its image may be, once turned
Map = Callable[[complex], complex]


class Image(NamedTuple):
    """of: where it puts a vector. hand: -1 for a mirror, which turns spins. turned: degrees."""

    of: Map
    hand: float = 1.0
    turned: float = 0.0

    def thing(self, wall: Obstacle) -> Obstacle:
        """An obstacle in its place in the image."""

        def at(p: complex) -> tuple[float, float]:
            q = self.of(p)
            return q.real, q.imag

        if isinstance(wall, Wall):
            return Wall(self.of(wall.normal), wall.offset, wall.name, wall.law)
        shape, law = wall.shape, {"law": wall.own_law} if wall.pushes else {}
        if wall.kind == "segment":
            ends = (shape.first, shape.last) if self.hand > 0.0 else (shape.last, shape.first)
            return Wall.segment(*map(at, ends), wall.name, **law)
        if wall.kind == "arc":
            ends = wall.start, wall.end  # type: ignore[attr-defined]
            if self.hand < 0.0:
                ends = -ends[1], -ends[0]
            return Wall.arc(at(shape.centre), shape.size, *(x + self.turned for x in ends),
                            wall.name, **law)  # fmt: skip
        made = Post if wall.pushes else Pocket
        return made(at(shape.centre), shape.size, wall.name, **law)


MIRROR, HALF = Image(lambda z: z.conjugate(), -1.0), Image(lambda z: -z, 1.0, 180.0)
SAME = Image(lambda z: z)


def image(world: World, of: Image, order: list[int]) -> World:
    """The world with everything where the image has it, and its balls in that order."""
    other = World(world.cloth, world.ball_law, world.cushion_law, world.engine, discs=world.discs)
    for wall in world.walls:
        other.add(of.thing(wall))
    for ball in (world.balls[i] for i in order):
        p, v = of.of(complex(*ball.position)), of.of(complex(*ball.velocity))
        w = of.hand * of.of(complex(*ball.spin[:2]))
        spin = (w.real, w.imag, of.hand * ball.spin[2])
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
    return alike(world, kind, dice)


def alike(world: World, kind: int, dice: Random) -> Trial:
    """The world beside its image of that kind."""
    order = list(range(len(world.balls)))
    if kind == ORDER:
        dice.shuffle(order)
    angle = dice.uniform(-pi, pi)
    turn = rect(1.0, angle)
    turned = Image(lambda z: turn * z, 1.0, degrees(angle))
    of = (MIRROR, HALF, SAME, SAME, turned)[kind]

    def drive(world: World) -> None:
        other = _later(world) if kind == HOUR else image(world, of, order)
        until = inf
        if kind in (ORDER, TURN):
            until = (second_hit if kind == TURN else one_instant)(world.copy())
        for each in (world, other):
            each.run(until)
        compare(world, other, of.of, tolerance(world) if kind == TURN else 0.0)

    return Trial(world, drive)


def _reordered_rack(world: World, dice: Random) -> None:
    """Order decides rounding in a cluster, so the digits are few once the balls have met again."""
    order = list(range(len(world.balls)))
    dice.shuffle(order)
    other = image(world, SAME, order)
    world.run(0.16)
    other.run(0.16)
    compare(world, other, SAME.of, 1e-9)


def second_hit(world: World) -> float:
    """When a ball hits what is round, or an end, for the second time, or a second has passed."""
    world.run(1.0)
    lines = {wall.name for wall in world.walls if wall.kind == "line"}
    hits = [
        event.time for event in world.log
        if event.kind == "ball" or (event.kind == "cushion" and event.wall not in lines)
    ]  # fmt: skip
    return 0.5 * (hits[0] + hits[1]) if len(hits) > 1 else 1.0


def one_instant(world: World) -> float:
    """A little before a cushion and something else are first met at one instant; or inf."""
    world.run()
    met = [(contact.time, contact.wall is not None) for contact in world.log.brief()]
    for (time, cushion), (again, wall) in pairwise(met):
        if time == again and (cushion or wall):
            return 0.5 * (time + max((t for t, _ in met if t < time), default=0.0))
    return inf


def tolerance(world: World) -> float:
    """m: as far apart as turned worlds may be."""
    return INTEGRATED if isinstance(world.cushion_law, laws.MathavanCushion) else EXACT


def compare(world: World, other: World, of: Map, tolerance: float) -> None:
    for ball in world.balls:
        p, q = of(complex(*ball.position)), complex(*other.ball(ball.name).position)
        if abs(p - q) > tolerance:
            raise Finding(f"ball {ball.name} is {abs(p - q):.2e} m from its image")
